//! Co-simulation of FMI 3.0 beside that of 2.0.

use super::*;
use crate::fmi2;
use crate::variables::{Place, Slot};

/// The same calls in both versions: outputs after each step, bit for bit.
#[test]
fn a_flight_has_the_bits_that_it_has_in_fmi_2() {
    let (two, three) = (fmi2::tests::Flying::new(), Fmu::new(Kind::CoSimulation));
    let settings = [("airspeed", 130.0), ("heading", 0.4), ("actuator.elevator.frequency", 20.0)];
    two.set(&settings);
    assert_eq!(three.set(&settings), Status::Ok);
    two.initialise(-0.5);
    assert_eq!(three.initialise(-0.5), Status::Ok, "{:?}", three.log);
    let outputs = reals(&three.table, |row| matches!(row.slot, Place::Common(Slot::Output(_))));
    let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    let same = |when: &str| {
        let [two, three] = [two.get(&outputs), three.get_references(&outputs).unwrap()];
        assert_eq!(bits(two), bits(three), "{when}");
    };
    same("at the start");
    let mut time = -0.5;
    let mut fly = |step: usize| {
        // On and off the grid of 10 ms.
        let size = [0.01, 0.007, 0.02, 0.0013][step % 4];
        let angle = 0.03 * libm::sin(step as f64);
        let inputs = [
            ("elevator", angle),
            ("aileron", 0.2 * angle),
            ("wind_down", 10.0 * angle),
            ("wind_rate_down", 5.0),
        ];
        two.set(&inputs);
        assert_eq!(three.set(&inputs), Status::Ok);
        two.step(time, size);
        assert_eq!(three.step(time, size), Status::Ok, "{:?}", three.log);
        time += size;
        time
    };
    for step in 0..60 {
        fly(step);
        same(&format!("after step {step}"));
    }
    let mut state = null_mut();
    // SAFETY: the instance is alive, the place is there.
    assert_eq!(unsafe { fmi3GetFMUState(three.instance, &mut state) }, Status::Ok);
    let here = three.get_references(&outputs).unwrap();
    for step in 60..70 {
        fly(step);
    }
    same("later");
    // SAFETY: the state is of the instance.
    assert_eq!(unsafe { fmi3SetFMUState(three.instance, state) }, Status::Ok);
    assert_eq!(bits(three.get_references(&outputs).unwrap()), bits(here));
    // SAFETY: as above; it is not used after this.
    assert_eq!(unsafe { fmi3FreeFMUState(three.instance, &mut state) }, Status::Ok);
}

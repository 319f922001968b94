//! Model exchange of FMI 3.0 beside that of 2.0: the same numbers through other functions.

use super::*;
use crate::fmi2;

fn states(fmu: &Fmu) -> Vec<f64> {
    let mut count = 0;
    // SAFETY: the instance is alive, the places are there and the array is as long as said.
    unsafe {
        assert_eq!(fmi3GetNumberOfContinuousStates(fmu.instance, &mut count), Status::Ok);
        let mut x = vec![0.0; count];
        assert_eq!(fmi3GetContinuousStates(fmu.instance, x.as_mut_ptr(), count), Status::Ok);
        x
    }
}

fn rates(fmu: &Fmu) -> Vec<f64> {
    let mut rates = vec![0.0; fmu.table.states().len()];
    // SAFETY: the instance is alive, the array is as long as said.
    let status = unsafe { fmi3GetContinuousStateDerivatives(fmu.instance, rates.as_mut_ptr(), rates.len()) };
    assert_eq!(status, Status::Ok, "{:?}", fmu.log);
    rates
}

#[test]
fn states_and_rates_have_the_bits_that_they_have_in_fmi_2() {
    let two = fmi2::tests::exchange::Exchange::flying(jet(), &[("heading", 0.4), ("airspeed", 140.0)]);
    let three = Fmu::new(Kind::ModelExchange);
    assert_eq!(three.set(&[("heading", 0.4), ("airspeed", 140.0)]), Status::Ok);
    assert_eq!(three.initialise(0.0), Status::Ok, "{:?}", three.log);
    let mut flags = [9_u8; 5];
    let [needed, ends, nominals, values, defined] = &mut flags;
    let (mut time, mut indicators) = (f64::NAN, 9);
    // SAFETY: the instance is alive, the places are there.
    unsafe {
        let i = three.instance;
        assert_eq!(fmi3EvaluateDiscreteStates(i), Status::Ok);
        let status = fmi3UpdateDiscreteStates(i, needed, ends, nominals, values, defined, &mut time);
        assert_eq!(status, Status::Ok);
        assert_eq!(fmi3GetNumberOfEventIndicators(i, &mut indicators), Status::Ok);
        // In Event Mode a state may be set by its variable.
        assert_eq!(three.set(&[("rate.y", 0.01)]), Status::Ok);
        assert_eq!(fmi3EnterContinuousTimeMode(i), Status::Ok);
    }
    assert_eq!((flags, indicators), ([0; 5], 0));
    two.set(&[("rate.y", 0.01), ("elevator", 0.02), ("wind_rate_down", 2.0)]);
    assert_eq!(three.set(&[("elevator", 0.02), ("wind_rate_down", 2.0)]), Status::Ok);
    let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    assert_eq!(bits(two.states()), bits(states(&three)));
    assert_eq!(bits(two.rates()), bits(rates(&three)));
    let x: Vec<f64> = states(&three).iter().map(|x| x + 1e-4).collect();
    two.set_states(0.1, &x);
    // SAFETY: the instance is alive, the array is as long as said.
    unsafe {
        assert_eq!(fmi3SetTime(three.instance, 0.1), Status::Ok);
        assert_eq!(fmi3SetContinuousStates(three.instance, x.as_ptr(), x.len()), Status::Ok);
        let [mut events, mut ends] = [9, 9];
        assert_eq!(fmi3CompletedIntegratorStep(three.instance, 1, &mut events, &mut ends), Status::Ok);
        assert_eq!((events, ends), (0, 0));
    }
    assert_eq!(bits(two.rates()), bits(rates(&three)));
    let known = three.reference("modal.q[1]");
    let unknowns: Vec<u32> = three.table.rates().collect();
    let mut changes = vec![0.0; unknowns.len()];
    let n = unknowns.len();
    // SAFETY: as above.
    let status = unsafe {
        fmi3GetDirectionalDerivative(
            three.instance,
            unknowns.as_ptr(),
            n,
            &known,
            1,
            &1.0,
            1,
            changes.as_mut_ptr(),
            n,
        )
    };
    assert_eq!(status, Status::Ok, "{:?}", three.log);
    assert_eq!(bits(changes), bits(two.derivatives(&unknowns, known)));
    assert_eq!(three.get("time"), 0.1);
}

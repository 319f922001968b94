//! Trims that nobody could fly are told as such, and stand.

use std::sync::Arc;

use flexible_aircraft::aircraft::{Bound, Bounds, Support, TunnelAir};
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{LimitExceeded, LimitedQuantity, PlantSettings};

use crate::support::{ELEVATOR, eight_symmetric, jet};

/// What a trim of the jet is warned of: the quantities and the words.
fn warnings(settings: &Settings) -> Vec<(LimitedQuantity, String)> {
    let flight = Simulation::new(jet(), settings, 0.0).unwrap();
    flight
        .limits_exceeded()
        .iter()
        .map(|exceeded| (exceeded.quantity.clone(), exceeded.to_string()))
        .collect()
}

/// The jet's nominal trim is within the usual limits; at 55 m/s it needs more elevator than a circle has.
#[test]
fn a_trim_that_nobody_could_fly_is_warned_of_and_stands() {
    assert_eq!(warnings(&Settings::of(&jet())), []);
    let slow = Settings::from(PlantSettings { airspeed: 55.0, ..PlantSettings::of(&jet()) });
    let mut flight = Simulation::new(jet(), &slow, 0.0).unwrap();
    let elevator = flight.trim().pitch_control;
    let expected = format!(
        "elevator {elevator:.4} rad ({:.1}°) is below -0.5236 rad (-30.0°), the usual limit, for the aircraft file gives none",
        elevator.to_degrees()
    );
    let found = warnings(&slow);
    assert!(found.contains(&(LimitedQuantity::Control("elevator".to_owned()), expected)), "{found:?}");
    assert!(found.iter().any(|(quantity, _)| *quantity == LimitedQuantity::AngleOfAttack), "{found:?}");
    assert_eq!(flight.outputs().controls[ELEVATOR], elevator);
}

/// 0.7 of the speed of sound at 7620 m, 308.1 m/s by the standard atmosphere, is 215.7 m/s.
#[test]
fn mach_0_7_is_worth_a_warning() {
    let warned = |airspeed: f64| {
        let warnings =
            warnings(&Settings::from(PlantSettings { airspeed, mode_count: 4, ..PlantSettings::of(&jet()) }));
        warnings.into_iter().any(|(quantity, text)| {
            quantity == LimitedQuantity::Mach
                && text.starts_with("Mach number 0.7")
                && text.contains("above 0.700, ")
        })
    };
    assert!(!warned(215.0) && warned(217.0));
}

/// At 127 m/s the jet trims with −0.2343 rad of elevator and 23 716 N per engine [theory: thesis-runs.trims].
#[test]
fn limits_of_the_aircraft_file_count_in_place_of_the_usual_ones_and_change_no_flight() {
    let settings = eight_symmetric();
    let mut limited = (*jet()).clone();
    limited.controls[ELEVATOR].limits = Bounds { minimum: Bound::Given(-0.2), maximum: Bound::Given(0.2) };
    limited.limits.thrust.maximum = Bound::Given(20_000.0);
    let mut flights = [jet(), Arc::new(limited)].map(|model| Simulation::new(model, &settings, 0.0).unwrap());
    let texts = flights[1].limits_exceeded().iter().map(ToString::to_string).collect::<Vec<_>>();
    let [elevator, thrust] = texts.as_slice() else { panic!("{texts:?}") };
    assert!(
        elevator.starts_with("elevator -0.23")
            && elevator.ends_with(" is below -0.2000 rad (-11.5°), the aircraft file's limit"),
        "{elevator}"
    );
    assert!(
        thrust.starts_with("thrust per engine 23")
            && thrust.ends_with(" N is above 20000 N, the aircraft file's limit"),
        "{thrust}"
    );
    let [free, limited] = flights.each_mut().map(|flight| {
        flight.advance_to(0.1).unwrap();
        flight.outputs().clone()
    });
    assert_eq!(free, limited);
}

#[test]
fn negative_thrust_is_beyond_the_usual_limits_and_any_positive_one_is_not() {
    let thrust = jet().limits.thrust;
    assert_eq!(thrust.exceeded_by(-1.0), Some(Bound::Usual(0.0)));
    assert_eq!([0.0, 1e6].map(|thrust_| thrust.exceeded_by(thrust_)), [None, None]);
}

/// What is clamped uses neither surfaces nor engines; the flow that it meets may be more than it bears.
#[test]
fn a_clamped_aircraft_is_warned_of_the_flow_alone() {
    let mut clamped = (*jet()).clone();
    (clamped.support, clamped.mount.y) = (Support::Clamped, 0.3);
    (clamped.limits.thrust.minimum, clamped.controls[ELEVATOR].limits.minimum) =
        (Bound::Given(100.0), Bound::Given(0.1));
    clamped.tunnel_air = Some(TunnelAir { density: 1.2, temperature: 288.15 });
    let settings = Settings::from(PlantSettings { airspeed: 60.0, ..PlantSettings::of(&clamped) });
    let flight = Simulation::new(Arc::new(clamped.clone()), &settings, 0.0).unwrap();
    let exceeded = flight.limits_exceeded();
    assert_eq!(
        exceeded.iter().map(|exceeded| exceeded.quantity.clone()).collect::<Vec<_>>(),
        [LimitedQuantity::AngleOfAttack]
    );
    let warning = LimitExceeded::warning(exceeded, &clamped, &settings.plant).unwrap();
    assert!(
        warning.starts_with("the trim at 60 m/s in air of 1.2 kg/m³ stands, but angle of attack 0.3000 rad"),
        "{warning}"
    );
    assert_eq!(LimitExceeded::warning(&[], &clamped, &settings.plant), None);
}

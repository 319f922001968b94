use super::endurance::{typical_section, wing};
use super::surface::{Saved, fit_checksum};
use super::*;
use crate::sealed::HEADER;

#[test]
fn a_state_before_the_flight_brings_values_and_life_cycle_back() {
    let fmu = Fmu::initialising();
    assert_eq!(fmu.set(&[("elevator", 0.1), ("airspeed", 150.0)]), Status::Ok);
    let saved = Saved::of(&fmu);
    assert_eq!(fmu.reset(), Status::Ok);
    assert_eq!(saved.restore(), Status::Ok);
    assert_eq!((fmu.get("elevator"), fmu.get("airspeed")), (0.1, 150.0));
}

/// Not even that the aircraft was trimmed for it.
#[test]
fn a_saved_state_tells_nothing_of_a_refused_call() {
    let fmu = Fmu::initialising();
    assert_eq!(fmu.set(&[("wind_north", 1e200)]), Status::Ok, "{:?}", fmu.log);
    let before = Saved::of(&fmu).bytes();
    assert_eq!(fmu.get_references(&[reference("loads.wing_root_right.bending")]), Err(Status::Error));
    fmu.assert_refused(&["is not finite"]);
    assert!(Saved::of(&fmu).bytes() == before);
}

#[test]
fn damaged_truncated_and_foreign_bytes_are_refused_with_a_reason() {
    let fmu = Fmu::initialising();
    let bytes = Saved::of(&fmu).bytes();
    for i in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[i] ^= 0x10;
        assert!(Saved::from_bytes(&fmu, &damaged).is_err(), "byte {i}");
        assert!(Saved::from_bytes(&fmu, &bytes[..i]).is_err(), "length {i}");
    }
    assert!(Saved::from_bytes(&fmu, &bytes[..bytes.len() - 1]).is_err());
    fmu.assert_refused(&["serialised state", &bytes.len().to_string()]);
    let mut longer = bytes.clone();
    longer.push(0);
    assert!(Saved::from_bytes(&fmu, &longer).is_err());
    assert!(Saved::from_bytes(&fmu, &bytes).is_ok());
}

#[test]
fn the_state_of_another_aircraft_is_refused() {
    let model = typical_section();
    let (unpacked, guid) = (Unpacked::of(&model.to_bytes(), "wing"), guid(&model));
    let wing = wing(&unpacked, &guid);
    let saved = Saved::of(&wing);
    let fmu = Fmu::flying();
    assert!(Saved::from_bytes(&fmu, &saved.bytes()).is_err());
    fmu.assert_refused(&["serialised state", "another aircraft or another version"]);
    let before = fmu.outputs();
    // SAFETY: component and state are alive; that they do not belong together is what is tested.
    assert_eq!(unsafe { fmi2SetFMUstate(fmu.component, saved.state) }, Status::Error);
    fmu.assert_refused(&["fmi2SetFMUstate", "not of this FMU"]);
    assert_eq!(fmu.outputs(), before);
}

#[test]
fn a_buffer_too_small_and_null_states_are_refused() {
    let fmu = Fmu::initialising();
    let saved = Saved::of(&fmu);
    let mut byte = 0;
    // SAFETY: component and state are alive; NULL is what is tested.
    unsafe {
        assert_eq!(fmi2SerializeFMUstate(fmu.component, saved.state, &mut byte, 1), Status::Error);
        assert_eq!(fmi2SetFMUstate(fmu.component, null_mut()), Status::Error);
        assert_eq!(fmi2GetFMUstate(fmu.component, null_mut()), Status::Error);
        assert_eq!(fmi2FreeFMUstate(fmu.component, null_mut()), Status::Ok);
    }
}

/// As fmusim 0.0.39 does: the state itself where the address of its handle belongs, and once more the other way round.
#[test]
fn a_state_in_place_of_its_address_is_left_alone_and_the_address_is_no_state() {
    let fmu = Fmu::flying();
    let saved = Saved::of(&fmu);
    let bytes = saved.bytes();
    // SAFETY: component and state are alive, and a state begins with a word that can be read as a handle.
    unsafe {
        assert_eq!(fmi2FreeFMUstate(fmu.component, saved.state.cast()), Status::Ok);
        assert_eq!(fmi2GetFMUstate(fmu.component, saved.state.cast()), Status::Error);
    }
    fmu.assert_refused(&["fmi2GetFMUstate", "found a state, expected the address of one"]);
    assert_eq!(saved.bytes(), bytes);
    assert_eq!(saved.restore(), Status::Ok);

    let mut handle = saved.state;
    let address: FmuState = (&raw mut handle).cast();
    assert_no_state(&fmu, address);
    assert_eq!(saved.restore(), Status::Ok);
}

/// What can be read as a word at an address is refused wherever a state belongs.
fn assert_no_state(fmu: &Fmu, address: FmuState) {
    let (mut size, mut byte) = (0, 0);
    // SAFETY: the component is alive; what is no state can be read as a word.
    let statuses = unsafe {
        [
            fmi2SetFMUstate(fmu.component, address),
            fmi2SerializedFMUstateSize(fmu.component, address, &mut size),
            fmi2SerializeFMUstate(fmu.component, address, &mut byte, 1),
        ]
    };
    assert_eq!(statuses, [Status::Error; 3]);
    fmu.assert_refused(&["fmi2SerializeFMUstate", "found something else than a state"]);
}

/// What stands behind the handle is nobody's business: words that would make a state with the handle before them.
#[test]
fn the_address_of_a_null_handle_is_no_state() {
    let fmu = Fmu::flying();
    let mut handle_and_more: [FmuState; 4] = [null_mut(); 4];
    let address: FmuState = handle_and_more.as_mut_ptr().cast();
    assert_no_state(&fmu, address);
}

#[test]
fn saving_into_a_present_state_replaces_it() {
    let fmu = Fmu::initialising();
    let mut saved = Saved::of(&fmu);
    let present = saved.state;
    assert_eq!(fmu.set(&[("rudder", 0.2)]), Status::Ok);
    // SAFETY: component and state are alive.
    assert_eq!(unsafe { fmi2GetFMUstate(fmu.component, &mut saved.state) }, Status::Ok);
    assert_eq!(saved.state, present);
    assert_eq!(fmu.set(&[("rudder", 0.0)]), Status::Ok);
    assert_eq!(saved.restore(), Status::Ok);
    assert_eq!(fmu.get("rudder"), 0.2);
}

#[test]
fn a_flight_goes_on_from_a_saved_state_bit_for_bit() {
    let fmu = Fmu::flying();
    let step = |fmu: &Fmu, i: u32| {
        assert_eq!(fmu.set(&[("elevator", 0.01 * f64::from(i % 3))]), Status::Ok);
        assert_eq!(fmu.step(0.01 * f64::from(i), 0.01), Status::Ok, "{:?}", fmu.log);
    };
    (0..10).for_each(|i| step(&fmu, i));
    let saved = Saved::of(&fmu);
    let bytes = saved.bytes();
    let at_saving = fmu.outputs();
    (10..20).for_each(|i| step(&fmu, i));
    let expected = fmu.outputs();
    assert_ne!(at_saving, expected);

    assert_eq!(saved.restore(), Status::Ok, "{:?}", fmu.log);
    assert_eq!(fmu.outputs(), at_saving);
    (10..20).for_each(|i| step(&fmu, i));
    assert_eq!(fmu.outputs(), expected);

    let other = Fmu::new();
    let carried = Saved::from_bytes(&other, &bytes).unwrap();
    assert_eq!(carried.restore(), Status::Ok, "{:?}", other.log);
    (10..20).for_each(|i| step(&other, i));
    assert_eq!(other.outputs(), expected);
}

/// Where a saved state has its life-cycle state, time, start time, tolerance and stop time.
const STATE: usize = HEADER;
const TIME: usize = 33;
const START: usize = 41;
const TOLERANCE: usize = 50;
const STOP: usize = 58;
/// Before the parameters.
const BEFORE_PARAMETERS: usize = 79;

/// Where a saved state has its flight, and where that has its time in cells of 10 ms, first input and rate.
fn flight_places() -> [usize; 4] {
    let table = VariableTable::new(jet());
    let bytes = |variable: &Variable| match (variable.slot, variable.kind) {
        (Slot::Parameter(_), Type::Real) => 8,
        (Slot::Parameter(_), Type::Integer | Type::Enumeration(_)) => 4,
        (Slot::Parameter(_), Type::Boolean) => 1,
        (Slot::Input(_) | Slot::Output(_), _) => 0,
    };
    let parameters: usize = table.iter().map(|(_, variable)| bytes(variable)).sum();
    let flight = BEFORE_PARAMETERS + parameters + 1;
    let time = flight + 10;
    let input = time + 11 * 8;
    [flight, time, input, input + 12 * 8]
}

/// Bytes with some of them replaced and a checksum that fits.
fn forged(bytes: &[u8], at: usize, replacement: &[u8]) -> Vec<u8> {
    let mut forged = bytes.to_vec();
    forged[at..at + replacement.len()].copy_from_slice(replacement);
    fit_checksum(&mut forged);
    forged
}

#[test]
fn forged_states_with_a_right_checksum_are_refused_and_change_nothing() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.set(&[("elevator", 0.02)]), Status::Ok);
    assert_eq!(fmu.step(0.0, 0.25), Status::Ok);
    let bytes = Saved::of(&fmu).bytes();
    let [flight, flight_time, input, rate] = flight_places();
    assert_eq!(bytes[input..input + 8], 0.02_f64.to_le_bytes(), "the layout has changed");
    for (time, number) in [(TIME, 0.25_f64), (flight_time, 25.0)] {
        assert_eq!(bytes[time..time + 8], number.to_le_bytes(), "the layout has changed");
    }
    let before = fmu.outputs();
    let stop = |stop: f64| [&[1], stop.to_le_bytes().as_slice()].concat();
    for (at, replacement, reason) in [
        (STATE, vec![4], "broke"),
        (STATE, vec![0], "outside the experiment"),
        (STATE, vec![9], "damaged"),
        (TIME, f64::NAN.to_le_bytes().to_vec(), "time: found NaN"),
        (TIME, 1e300_f64.to_le_bytes().to_vec(), "outside the experiment"),
        (TIME, 0.5_f64.to_le_bytes().to_vec(), "at another time"),
        (START, 0.5_f64.to_le_bytes().to_vec(), "outside the experiment"),
        (START, f64::NEG_INFINITY.to_le_bytes().to_vec(), "start time"),
        (TOLERANCE - 1, [&[1], 2.0_f64.to_le_bytes().as_slice()].concat(), "tolerance"),
        (STOP, stop(f64::NAN), "stop time"),
        (STOP, stop(0.1), "outside the experiment"),
        (STOP, vec![2], "damaged"),
        (flight - 1, vec![2], "damaged"),
        (flight - 1, vec![0], "damaged"),
        (flight, vec![2], "which equations fly"),
        (flight, vec![0], "its length"),
        (flight + 1, vec![0], "its length"),
        (flight + 2, vec![0, 0, 0, 0], "sub-steps"),
        (flight_time, 50_f64.to_le_bytes().to_vec(), "at another time"),
        (flight_time, 0.5_f64.to_le_bytes().to_vec(), "times are out of range"),
        (input, f64::NAN.to_le_bytes().to_vec(), "not finite"),
        (rate, f64::INFINITY.to_le_bytes().to_vec(), "not finite"),
    ] {
        let saved = Saved::from_bytes(&fmu, &forged(&bytes, at, &replacement)).unwrap();
        assert_eq!(saved.restore(), Status::Error, "{at}: {replacement:?}");
        fmu.assert_refused(&["fmi2SetFMUstate", reason]);
        assert_eq!(fmu.outputs(), before);
    }
    let saved = Saved::from_bytes(&fmu, &forged(&bytes, STOP, &stop(0.25))).unwrap();
    assert_eq!(saved.restore(), Status::Ok, "{:?}", fmu.log);
}

#[test]
fn a_state_in_flight_without_a_flight_is_refused() {
    let fmu = Fmu::initialising();
    let bytes = Saved::of(&fmu).bytes();
    for state in [2, 3] {
        let saved = Saved::from_bytes(&fmu, &forged(&bytes, STATE, &[state])).unwrap();
        assert_eq!(saved.restore(), Status::Error);
        fmu.assert_refused(&["its flight is missing"]);
    }
}

/// The shortest of many times that something took, s.
pub(super) fn shortest(mut action: impl FnMut(u32)) -> f64 {
    let once = |i| {
        let begun = std::time::Instant::now();
        action(i);
        begun.elapsed().as_secs_f64()
    };
    (0..300).map(once).fold(f64::INFINITY, f64::min)
}

#[test]
fn saving_a_state_costs_a_small_part_of_flying_10_ms() {
    for aileron in [0.0, 1e-3] {
        let fmu = Fmu::flying();
        assert_eq!(fmu.set(&[("aileron", aileron)]), Status::Ok);
        let [elevator] = ["elevator"].map(reference);
        let flying = shortest(|i| {
            let time = 0.01 * f64::from(i);
            assert_eq!(fmu.set_references(&[elevator], &[1e-3 * f64::from(i % 2)]), Status::Ok);
            assert_eq!(fmu.step(time, 0.01), Status::Ok);
        });
        let mut saved = Saved::of(&fmu);
        let saving = shortest(|_| {
            // SAFETY: component and state are alive.
            assert_eq!(unsafe { fmi2GetFMUstate(fmu.component, &mut saved.state) }, Status::Ok);
        });
        let restoring = shortest(|_| assert_eq!(saved.restore(), Status::Ok));
        println!(
            "{} bytes: flying 10 ms {:.2} µs, saving {:.2} µs, restoring {:.2} µs",
            saved.bytes().len(),
            1e6 * flying,
            1e6 * saving,
            1e6 * restoring
        );
        assert!(saving < 0.2 * flying, "{saving} {flying}");
    }
}

/// What a state is read into and written from: the same bytes again, before the flight, on the grid, within a cell, while inputs
/// ramp, and when the whole aircraft flies.
#[test]
fn a_state_that_was_restored_is_saved_as_the_same_bytes() {
    let fmu = Fmu::initialising();
    assert_eq!(fmu.set(&[("wind_down", 0.3)]), Status::Ok);
    let mut states = vec![Saved::of(&fmu).bytes()];
    assert_eq!(fmu.exit(), Status::Ok);
    states.push(Saved::of(&fmu).bytes());
    let (elevator, rate) = (reference("elevator"), 0.01);
    // SAFETY: the component is alive, the arrays have one element.
    let rated = unsafe { fmi2SetRealInputDerivatives(fmu.component, &elevator, 1, &1, &rate) };
    assert_eq!([rated, fmu.step(0.0, 0.013)], [Status::Ok; 2]);
    states.push(Saved::of(&fmu).bytes());
    assert_eq!(fmu.step(0.013, 0.007), Status::Ok);
    states.push(Saved::of(&fmu).bytes());
    assert_eq!(fmu.get("elevator"), 0.01 * 0.02);
    assert_eq!([fmu.set(&[("rudder", 0.01)]), fmu.step(0.02, 0.005)], [Status::Ok; 2]);
    states.push(Saved::of(&fmu).bytes());
    for (i, bytes) in states.iter().enumerate().rev() {
        for other in [&fmu, &Fmu::new()] {
            let saved = Saved::from_bytes(other, bytes).unwrap();
            assert_eq!(saved.restore(), Status::Ok, "{i}: {:?}", other.log);
            assert_eq!(Saved::of(other).bytes(), *bytes, "{i}");
        }
    }
    let lengths: Vec<usize> = states.iter().map(Vec::len).collect();
    let [beside, half, half_in_cell, half_again, whole_in_cell] = lengths[..] else { panic!("{lengths:?}") };
    assert!(beside < half && half < half_in_cell && half_in_cell < whole_in_cell, "{lengths:?}");
    assert_eq!(half_again, half);
}

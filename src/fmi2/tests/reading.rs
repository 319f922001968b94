//! Outputs have the same bits whether they are read alone, one after the other in any order, or all at once.

use super::surface::Saved;
use super::*;

/// In flight with everything that stands between an importer and the aircraft: gust and turbulence, actuators at their limits, engines
/// that lag, sensors.
fn with_everything(is_even: bool, sampled: bool) -> Fmu {
    let fmu = Fmu::new();
    for (name, item) in [("gust.shape", 2), ("turbulence.spectrum", 3), ("sensor.delay", 2)] {
        assert_eq!(fmu.set_integer(name, item), Status::Ok);
    }
    assert_eq!(fmu.set_boolean("sensor.enabled", c_int::from(sampled)), Status::Ok);
    let parameters = [
        ("gust.start", 0.02),
        ("gust.direction", if is_even { 0.0 } else { 0.5 }),
        ("actuator.elevator.frequency", 40.0),
        ("actuator.elevator.rate_limit", 0.5),
        ("actuator.rudder.maximum", 0.02),
        ("engine.left.time_constant", 0.3),
        ("engine.right.time_constant", if is_even { 0.3 } else { 0.2 }),
        ("sensor.period", 0.02),
        ("sensor.time_constant", 0.03),
        ("sensor.noise.attitude", 1e-3),
        ("sensor.noise.specific_force", 1e-2),
        ("sensor.noise.position", 1.0),
    ];
    assert_eq!(fmu.set(&parameters), Status::Ok);
    assert_eq!([fmu.set_up(None, 0.0, None), fmu.enter(), fmu.exit()], [Status::Ok; 3], "{:?}", fmu.log);
    fmu
}

/// Passes an FMU on where it stands at the start, within a cell of time and at its end, before and after inputs are set.
fn at_some_instants(fmu: &Fmu, mut check: impl FnMut(&str)) {
    check("at the start");
    let even = [("elevator", -0.1), ("thrust_left", 3e3), ("thrust_right", 3e3), ("wind_down", -1.0)];
    assert_eq!((fmu.set(&even), fmu.set_rates(&[("elevator", 1, -1.0)])), (Status::Ok, Status::Ok));
    check("under other inputs");
    assert_eq!(fmu.step(0.0, 0.053), Status::Ok);
    check("within a cell");
    assert_eq!(fmu.step(0.053, 0.007), Status::Ok);
    check("at the end of a cell");
    assert_eq!(fmu.set(&[("rudder", 0.05), ("aileron", 0.02)]), Status::Ok);
    check("under inputs on one side");
    assert_eq!(fmu.step(0.06, 0.021), Status::Ok);
    check("after them");
}

/// The bits of one output.
fn alone(fmu: &Fmu, (reference, kind): (u32, Type)) -> u64 {
    match kind {
        Type::Boolean => fmu.get_booleans(&[reference]).unwrap()[0] as u64,
        _ => fmu.get_references(&[reference]).unwrap()[0].to_bits(),
    }
}

#[test]
fn every_output_read_alone_or_after_any_other_is_what_it_is_among_all() {
    let table = VariableTable::new(jet());
    let of = |kind: Type| outputs_of(&table, kind).into_iter().map(move |reference| (reference, kind));
    let outputs: Vec<(u32, Type)> = of(Type::Real).chain(of(Type::Boolean)).collect();
    let name = |(reference, _): (u32, Type)| &table.get(reference).unwrap().name;
    for (is_even, sampled) in [(true, true), (false, false)] {
        let fmu = with_everything(is_even, sampled);
        at_some_instants(&fmu, |instant| {
            // Nothing of the instant is known to one that goes back to it.
            let saved = Saved::of(&fmu);
            let expected: Vec<((u32, Type), u64)> = outputs.iter().copied().zip(fmu.outputs()).collect();
            for &(output, bits) in &expected {
                assert_eq!(saved.restore(), Status::Ok);
                assert_eq!(alone(&fmu, output), bits, "{} alone {instant}", name(output));
            }
            assert_eq!(saved.restore(), Status::Ok);
            for &(output, bits) in &expected {
                assert_eq!(alone(&fmu, output), bits, "{} forwards {instant}", name(output));
            }
            assert_eq!(saved.restore(), Status::Ok);
            for &(output, bits) in expected.iter().rev() {
                assert_eq!(alone(&fmu, output), bits, "{} backwards {instant}", name(output));
            }
        });
    }
}

#[test]
fn channels_of_sensors_that_are_off_have_the_bits_of_what_they_mirror() {
    let table = VariableTable::new(jet());
    let channels: Vec<(u32, u32, &str)> = table
        .iter()
        .filter(|(_, variable)| matches!(variable.slot, Slot::Output(_)))
        .filter_map(|(channel, variable)| {
            let mirrored = variable.name.strip_prefix("sensor.")?;
            Some((channel, table.reference(mirrored).unwrap(), mirrored))
        })
        .collect();
    assert_eq!(channels.len(), 13 + 6 * jet().stations.len());
    let fmu = with_everything(false, false);
    at_some_instants(&fmu, |instant| {
        let read = |references: Vec<u32>| fmu.get_references(&references).unwrap();
        let found = read(channels.iter().map(|(channel, ..)| *channel).collect());
        let mirrored = read(channels.iter().map(|(_, mirrored, _)| *mirrored).collect());
        for ((found, mirrored), (.., name)) in found.iter().zip(&mirrored).zip(&channels) {
            assert_eq!(found.to_bits(), mirrored.to_bits(), "{name} {instant}");
        }
    });
}

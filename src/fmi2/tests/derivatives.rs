use super::*;
use crate::variables::Slot;

impl Fmu {
    fn derivatives(&self, unknowns: &[u32], knowns: &[u32], direction: &[f64]) -> Result<Vec<f64>, Status> {
        let mut changes = vec![0.0; unknowns.len()];
        // SAFETY: the component is alive, the arrays are as long as the counts say.
        let status = unsafe {
            fmi2GetDirectionalDerivative(
                self.component,
                unknowns.as_ptr(),
                unknowns.len(),
                knowns.as_ptr(),
                knowns.len(),
                direction.as_ptr(),
                changes.as_mut_ptr(),
            )
        };
        if status == Status::Ok { Ok(changes) } else { Err(status) }
    }
}

fn references(wanted: impl Fn(Slot) -> bool) -> Vec<u32> {
    VariableTable::new(jet()).iter().filter(|(_, v)| wanted(v.slot)).map(|(r, _)| r).collect()
}

/// In a steady climb with surfaces deflected and wind, so that nothing is zero by symmetry.
fn disturbed() -> Fmu {
    let fmu = Fmu::flying();
    let inputs = [
        ("elevator", -0.02),
        ("rudder", 0.01),
        ("aileron_symmetric", 0.03),
        ("wind_east", 4.0),
        ("wind_down", -2.0),
    ];
    assert_eq!(fmu.set(&inputs), Status::Ok);
    assert_eq!(fmu.step(0.0, 0.35), Status::Ok);
    fmu
}

#[test]
fn derivatives_of_every_output_agree_with_central_differences_for_every_input() {
    let fmu = disturbed();
    let outputs = references(|slot| matches!(slot, Slot::Output(_)));
    for input in references(|slot| matches!(slot, Slot::Input(_))) {
        let analytic = fmu.derivatives(&outputs, &[input], &[1.0]).unwrap();
        let at = fmu.get_references(&[input]).unwrap()[0];
        let table = VariableTable::new(jet());
        let name = &table.get(input).unwrap().name;
        let step = match name {
            name if name.starts_with("thrust") => 100.0,
            name if name.starts_with("wind_rate") => 1.0,
            _ => 1e-3,
        };
        let [ahead, behind] = [step, -step].map(|step| {
            assert_eq!(fmu.set_references(&[input], &[at + step]), Status::Ok);
            fmu.get_references(&outputs).unwrap()
        });
        assert_eq!(fmu.set_references(&[input], &[at]), Status::Ok);
        let differences: Vec<f64> = ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * step)).collect();
        let largest = differences.iter().fold(0.0_f64, |max, x| max.max(x.abs()));
        assert!(largest > 0.0, "{name}");
        for ((output, analytic), difference) in outputs.iter().zip(&analytic).zip(&differences) {
            let scale = difference.abs().max(1e-4 * largest);
            let error = (analytic - difference).abs() / scale;
            assert!(error < 1e-6, "d {}/d {name}: {analytic} {difference}", table.get(*output).unwrap().name);
        }
    }
}

#[test]
fn derivatives_vanish_exactly_where_the_model_description_says_that_nothing_depends() {
    let fmu = disturbed();
    let table = VariableTable::new(jet());
    for (reference, variable) in table.iter() {
        let Slot::Output(slot) = variable.slot else { continue };
        let dependencies = table.dependencies(slot);
        for input in references(|slot| matches!(slot, Slot::Input(_))) {
            let derivative = fmu.derivatives(&[reference], &[input], &[1.0]).unwrap()[0];
            let name = &table.get(input).unwrap().name;
            assert!(derivative == 0.0 || dependencies.contains(&input), "d {}/d {name}", variable.name);
        }
    }
}

#[test]
fn a_direction_of_several_inputs_adds_up_and_scales() {
    let fmu = disturbed();
    let outputs =
        ["acceleration.z", "station.wing_tip_left.specific_force.z", "surface.elevator"].map(reference);
    let knowns = ["elevator", "wind_down"].map(reference);
    let one = |i: usize| fmu.derivatives(&outputs, &knowns[i..=i], &[1.0]).unwrap();
    let (elevator, wind) = (one(0), one(1));
    for scale in [1e-12, 1.0, 1e9] {
        let together = fmu.derivatives(&outputs, &knowns, &[2.0 * scale, -3.0 * scale]).unwrap();
        for ((together, elevator), wind) in together.iter().zip(&elevator).zip(&wind) {
            let expected = scale * (2.0 * elevator - 3.0 * wind);
            assert!((together - expected).abs() < 1e-8 * expected.abs(), "{together} {expected}");
        }
    }
    assert_eq!(fmu.derivatives(&outputs, &knowns, &[0.0, 0.0]), Ok(vec![0.0; 3]));
}

#[test]
fn asking_for_derivatives_leaves_the_flight_alone() {
    let (asked, silent) = (disturbed(), disturbed());
    asked.derivatives(&[reference("load_factor.z")], &[reference("elevator")], &[1.0]).unwrap();
    for fmu in [&asked, &silent] {
        assert_eq!(fmu.step(0.35, 0.2), Status::Ok);
    }
    assert_eq!(asked.outputs(), silent.outputs());
}

#[test]
fn derivatives_are_there_in_initialisation_mode_and_refused_for_what_is_no_output_or_no_input() {
    let fmu = Fmu::initialising();
    let (output, input) = (reference("surface.elevator"), reference("elevator"));
    assert!((fmu.derivatives(&[output], &[input], &[1.0]).unwrap()[0] - 1.0).abs() < 1e-12);
    for (unknown, known, direction, parts) in [
        (input, input, 1.0, ["`elevator`", "not an output"]),
        (output, reference("airspeed"), 1.0, ["`airspeed`", "not an input"]),
        (reference("model"), input, 1.0, ["`model`", "a Real"]),
        (output, 100_000, 1.0, ["100000", "no such variable"]),
        (output, input, f64::NAN, ["`elevator`", "NaN"]),
    ] {
        assert_eq!(fmu.derivatives(&[unknown], &[known], &[direction]), Err(Status::Error));
        fmu.assert_refused(&parts);
    }
}

//! Aircraft with other controls than the jet: their FMUs have inputs and outputs by the names of their files, in the order
//! of the files, and fly with the bits of the library.

use std::path::Path;
use std::sync::Arc;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft_packaging::Package;
use flexible_aircraft_packaging::c_abi::{Fmu, Instance};

use super::package;

const MODES: usize = 8;

/// The angle of a control at a time; those with the same number move alike.
fn angle(number: usize, time: f64) -> f64 {
    0.02 * ((1.5 + number as f64) * time).sin()
}

#[test]
fn fmus_have_the_names_of_the_file_and_the_bits_of_the_library() {
    for (file, controls) in [
        ("v-tail", "pitch_tail yaw_tail aileron"),
        ("elevons", "elevator aileron"),
        (
            "eight-flaps",
            "elevator flap_right_1 flap_left_1 flap_right_2 flap_left_2 flap_right_3 flap_left_3 flap_right_4 flap_left_4",
        ),
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/data/{file}.toml"));
        let folder = tempfile::tempdir().unwrap();
        let archive = folder.path().join("aircraft.fmu");
        Package { aircraft: path.clone(), mode_count: MODES.into(), ..package() }.write(&archive).unwrap();
        let fmu = Fmu::open(&archive).unwrap();
        let controls: Vec<&str> = controls.split(' ').collect();
        let inputs = fmu.variables(&controls).unwrap();
        assert_eq!(inputs, (0..controls.len() as u32).collect::<Vec<_>>(), "{file}");

        let model = Arc::new(ReducedModel::new(&Aircraft::read(&path).unwrap(), MODES).unwrap());
        let flight = Simulation::new(Arc::clone(&model), &Settings::of(&model), 0.0).unwrap();
        let mut instance = fmu.instantiate(file).unwrap();
        instance.initialise(0.0, None).unwrap();
        assert_trimmed_alike(&fmu, &mut instance, &flight, &model);
        assert_same_bits(file, &fmu, &mut instance, flight, &model);
    }
}

/// Controls with a role have an output of the angle that the trim found, others are at rest there.
fn assert_trimmed_alike(fmu: &Fmu, instance: &mut Instance<'_>, flight: &Simulation, model: &ReducedModel) {
    for (control, trimmed) in model.controls.iter().zip(flight.trim().angles(&model.controls)) {
        let trim = fmu.variable(&format!("trim.{}", control.name));
        assert_eq!(trim.is_ok(), control.role.is_some(), "{}", control.name);
        let mut value = [0.0];
        if let Ok(trim) = trim {
            instance.get_real(&[trim], &mut value).unwrap();
        }
        assert_eq!(value[0].to_bits(), trimmed.to_bits(), "{}", control.name);
    }
}

/// Flies FMU and library side by side, pairs of flaps moving alike at first, then apart.
fn assert_same_bits(
    file: &str,
    fmu: &Fmu,
    instance: &mut Instance<'_>,
    mut flight: Simulation,
    model: &ReducedModel,
) {
    let names: Vec<&str> = model.controls.iter().map(|control| control.name.as_str()).collect();
    let surfaces: Vec<String> = names.iter().map(|name| format!("surface.{name}")).collect();
    let (inputs, surfaces) = (fmu.variables(&names).unwrap(), fmu.variables(&surfaces).unwrap());
    let watched = ["rate.x", "rate.y", "rate.z", "load_factor.z", "deflection.tip_left.up"];
    let watched = fmu.variables(&watched).unwrap();
    let trimmed = flight.trim().angles(&model.controls).collect::<Vec<_>>();
    let still = Inputs::zero(model);
    for step in 0..60 {
        let time = 0.01 * f64::from(step);
        let number = |control: usize| if step < 30 { control.div_ceil(2) } else { control };
        let moved: Vec<f64> = (0..names.len()).map(|control| angle(number(control), time)).collect();
        instance.set_real(&inputs, &moved).unwrap();
        flight.set_inputs(&Inputs { controls: moved.clone(), ..still.clone() }, &still);
        if file == "eight-flaps" {
            flight.advance_to(time + 0.005).unwrap();
            assert_eq!(flight.is_symmetric(), step < 30, "{step}");
        }
        instance.do_step(time, 0.01).unwrap();
        flight.advance_to(time + 0.01).unwrap();

        let (mut acting, mut found) = (vec![0.0; names.len()], [0.0; 5]);
        instance.get_real(&surfaces, &mut acting).unwrap();
        instance.get_real(&watched, &mut found).unwrap();
        let here = flight.outputs();
        let up = -here.deflections[1].displacement.z;
        let expected = [here.rate.x, here.rate.y, here.rate.z, here.load_factor.z, up];
        assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits), "{file} after {step}");
        assert_eq!(acting, here.controls, "{file} after {step}");
        let sums: Vec<f64> = trimmed.iter().zip(&moved).map(|(trimmed, moved)| trimmed + moved).collect();
        assert_eq!(acting, sums, "{file} after {step}");
    }
}

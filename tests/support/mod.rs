//! The jet and its flights, shared by the tests.

pub mod beams;
pub mod encounter;
pub mod kane;
pub mod linearised;
pub mod plain_loads;
pub mod plain_points;
pub mod plain_sections;
pub mod planar;
pub mod redescribed;
pub mod response;
pub mod ritz;
pub mod rod;
pub mod strip;
pub mod wash_out;

use std::path::Path;
use std::sync::{Arc, OnceLock};

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::{Configuration, Fidelity};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::{ModeSelection, Outputs, PlantSettings};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::Vector3;

/// The generic business jet with as many modes as its FMU has.
pub fn jet() -> Arc<ReducedModel> {
    static JET: OnceLock<Arc<ReducedModel>> = OnceLock::new();
    Arc::clone(JET.get_or_init(|| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
        Arc::new(ReducedModel::new(&Aircraft::read(&path).unwrap(), ReducedModel::USUAL_MODES).unwrap())
    }))
}

/// Places of the jet's controls among its inputs.
pub const ELEVATOR: usize = 0;
pub const AILERON: usize = 1;
pub const AILERON_SYMMETRIC: usize = 2;
pub const RUDDER: usize = 3;

/// Inputs at zero but for the angles of some controls.
pub fn angles(model: &ReducedModel, moved: &[(usize, f64)]) -> Inputs {
    let mut inputs = Inputs::zero(model);
    for &(control, angle) in moved {
        inputs.controls[control] = angle;
    }
    inputs
}

/// The jet's stations, in the order of its file.
pub fn station(name: &str) -> usize {
    jet().stations.iter().position(|station| station.name == name).unwrap()
}

/// Upward deflection of a station, m.
pub fn up(outputs: &Outputs, name: &str) -> f64 {
    -outputs.deflections[station(name)].displacement.z
}

/// Longitudinal cases use the eight lowest symmetric modes [theory: structure.mode-count].
pub fn eight_symmetric() -> Settings {
    Settings::from(PlantSettings {
        mode_selection: ModeSelection::Symmetric,
        mode_count: 8,
        ..PlantSettings::of(&jet())
    })
}

/// One-tenth of the stiffness, at which the jet bends by metres, in steady inflow.
pub fn soft(fidelity: Fidelity) -> Configuration {
    Configuration {
        fidelity,
        stiffness_scale: 0.1,
        structural_damping: 0.0,
        inflow_states: 0,
        temperature_offset: 0.0,
        tunnel_flow: Vector3::zeros(),
    }
}

/// The 2-3-1-1 of [theory: thesis-runs.inputs] at a time, before its filter: 0.05 rad, unit 0.7 s, from 1 s, nose-up first.
pub fn two_three_one_one(time: f64) -> f64 {
    const STEPS: [(f64, f64); 4] = [(2.0, -0.05), (5.0, 0.05), (6.0, -0.05), (7.0, 0.05)];
    let units = (time - 1.0) / 0.7;
    if units < 0.0 {
        return 0.0;
    }
    STEPS.iter().find(|(end, _)| units < *end).map_or(0.0, |(_, angle)| *angle)
}

/// The rudder doublet of [theory: thesis-runs.inputs] at a time, before its filter: 0.05 rad, 2 s each way, from 1 s.
pub fn doublet(time: f64) -> f64 {
    match time {
        1.0..3.0 => 0.05,
        3.0..5.0 => -0.05,
        _ => 0.0,
    }
}

/// Flies `seconds` in steps of 10 ms under inputs made from the command through the filter 1/(0.05 s + 1);
/// returns the outputs at every step.
pub fn fly(
    settings: &Settings,
    seconds: f64,
    command: impl Fn(f64) -> f64,
    apply: impl Fn(&mut Inputs, f64),
) -> Vec<Outputs> {
    const STEP: f64 = 0.01;
    let mut simulation = Simulation::new(jet(), settings, 0.0).unwrap();
    let (mut inputs, rates) = (Inputs::zero(&jet()), Inputs::zero(&jet()));
    let mut filtered = 0.0;
    let mut history = vec![simulation.outputs().clone()];
    for step in 0..(seconds / STEP).round() as usize {
        let time = step as f64 * STEP;
        apply(&mut inputs, filtered);
        simulation.set_inputs(&inputs, &rates);
        simulation.advance_to(time + STEP).unwrap();
        history.push(simulation.outputs().clone());
        let target = command(time);
        filtered = target + (filtered - target) * libm::exp(-STEP / 0.05);
    }
    history
}

/// The derivative at 0 of a smooth function, of the eighth order in the step.
pub fn derivative_of_eighth_order<T>(step: f64, function: impl Fn(f64) -> T) -> T
where
    T: std::ops::Sub<Output = T> + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>,
{
    let difference =
        |steps: f64, weight: f64| (function(steps * step) - function(-steps * step)) * (weight / step);
    difference(1.0, 0.8)
        + difference(2.0, -0.2)
        + difference(3.0, 4.0 / 105.0)
        + difference(4.0, -1.0 / 280.0)
}

/// The derivative at 0 of a polynomial of degree ≤ 4, whatever the step.
pub fn derivative(step: f64, f: impl Fn(f64) -> f64) -> f64 {
    (8.0 * (f(step) - f(-step)) - (f(2.0 * step) - f(-2.0 * step))) / (12.0 * step)
}

/// Numbers between −1 and 1 that look random and are the same everywhere (splitmix64; Steele, Lea, Flood 2014).
pub fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as f64 / u64::MAX as f64 * 2.0 - 1.0
    }
}

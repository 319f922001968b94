//! What controls do at once: angular accelerations of the rigid aircraft in its trim by the angle of each. (What a wing gives way is no
//! mistake in a sign, and the first moment of an elastic aircraft is that of its parts.)

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::symmetry::Plants;
use nalgebra::Vector3;

/// To both sides of the trim, rad.
const STEP: f64 = 1e-2;

/// What each control of a free aircraft does, rad/s² by rad about body axes; none where its rigid form has no trim.
pub fn of(model: &ReducedModel, settings: &PlantSettings) -> Option<Vec<Vector3<f64>>> {
    let settings = PlantSettings { fidelity: Fidelity::Rigid, ..*settings };
    let plants = Plants::under(model, &settings).ok()?;
    let trimmed = plants.trim(&settings.trim_condition()).ok()?;
    let (plant, trim) = (plants.whole(), trimmed.trims.whole());
    let mut workspace = plant.workspace();
    let mut at = |control: usize, departure: f64| {
        let mut controls = trim.controls.clone();
        controls.angles[control] += departure;
        plant.outputs_at(&trim.state, &controls, &mut workspace).angular_acceleration
    };
    let slope = |control: usize| (at(control, STEP) - at(control, -STEP)) / (2.0 * STEP);
    Some((0..model.controls.len()).map(slope).collect())
}

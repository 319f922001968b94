//! What stands in an aircraft file once it is expanded: mass and how it is spread, reference lengths, how many parts there are.

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::{Joint, ReferenceLengths};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::{Matrix3, Vector3};

/// Of the undeformed aircraft, in body axes.
pub struct Facts {
    pub name: String,
    /// kg.
    pub mass: f64,
    /// m from O.
    pub centre_of_mass: Vector3<f64>,
    /// Inertia matrix about the centre of mass, kg m².
    pub about_centre: Matrix3<f64>,
    /// About O, kg m².
    pub about_origin: Matrix3<f64>,
    pub reference: Option<ReferenceLengths>,
    /// The components that reference lengths are of where the file does not give them; none where it gives all.
    pub wing: Vec<String>,
    /// Whether the file gives any of them.
    pub gives_some: bool,
    /// What there is, and how many of it; hinges where there are any.
    pub counts: Vec<(&'static str, usize)>,
    /// What joints join, and which rotations they share.
    pub joints: Vec<String>,
}

impl Facts {
    pub fn new(aircraft: &Aircraft, model: &ReducedModel) -> Self {
        let integrals = &model.integrals;
        let centre_of_mass = integrals.first_moment / integrals.mass;
        let arm = centre_of_mass.cross_matrix();
        let given = aircraft.reference;
        let given = [given.chord, given.area, given.span];
        let wing = aircraft.wing().filter(|_| given.contains(&None));
        let sides = wing.into_iter().chain(wing.and_then(|wing| aircraft.components[wing].image));
        Facts {
            name: aircraft.name.clone(),
            mass: integrals.mass,
            centre_of_mass,
            about_centre: integrals.inertia + arm * arm * integrals.mass,
            about_origin: integrals.inertia,
            reference: aircraft.reference_lengths(),
            wing: sides.map(|side| aircraft.components[side].name.clone()).collect(),
            gives_some: given.iter().any(Option::is_some),
            counts: counts(aircraft),
            joints: aircraft.joints.iter().map(joint).collect(),
        }
    }
}

/// A joint for people.
fn joint(joint: &Joint) -> String {
    let axes = ["x", "y", "z"].into_iter().zip(joint.rotations);
    let shared: Vec<&str> = axes.filter_map(|(axis, shared)| shared.then_some(axis)).collect();
    match shared.as_slice() {
        [] => format!("{joint} is a pin"),
        [_, _, _] => format!("{joint} is rigid"),
        some => format!("{joint} shares rotations about {}", some.join(" and ")),
    }
}

fn counts(aircraft: &Aircraft) -> Vec<(&'static str, usize)> {
    let mut counts = vec![
        ("components", aircraft.components.len()),
        ("elements", aircraft.beams.len()),
        ("bays", aircraft.bays.len()),
        ("strips", aircraft.strips.len()),
        ("controls", aircraft.controls.len()),
        ("engines", aircraft.engines.len()),
        ("stations", aircraft.stations.len()),
        ("cuts", aircraft.cuts.len()),
    ];
    let hinges = aircraft.beams.iter().filter(|beam| beam.hinge.is_some()).count();
    counts.extend((hinges > 0).then_some(("hinges", hinges)));
    counts
}

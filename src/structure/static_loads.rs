//! The static loads whose strains the load modes have, as forces and moments on the nodal unknowns of the undeformed
//! structure [theory: load-modes.loads]. Their sizes do not matter.

use nalgebra::{DVector, Vector3};
use serde::{Deserialize, Serialize};

use crate::aircraft::{Aircraft, Attachment, FlapEffect, Strip};

use super::ModeFamily;
use super::assembly::Structure;
use super::mirror::Reflection;

/// What is left of an incidence, relative to unit motion of the air, where there should be none.
const ROUNDING: f64 = 1e-12;

/// The part of a static load that acts in one family of modes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StaticLoad {
    /// Symmetric, antisymmetric, or of a structure without mirror plane.
    pub family: ModeFamily,
    /// Generalised force on each packaged mode.
    pub forces: Vec<f64>,
}

/// One column for each load: lift by unit incidence of each component or mirrored pair of them, vertical inertia, lift by
/// unit roll rate, side force by unit sideslip, lift of the flaps by each control.
pub(super) fn static_loads(structure: &Structure, mirror: Option<&Reflection>) -> Vec<DVector<f64>> {
    let aircraft = structure.aircraft;
    let all: Vec<usize> = (0..aircraft.strips.len()).collect();
    let mut loads: Vec<_> = lifting_bodies(aircraft, mirror)
        .iter()
        .map(|strips| lift(structure, strips, |normal, _| normal.z))
        .collect();
    loads.push(vertical_inertia(structure));
    loads.push(lift(structure, &all, |normal, position| normal.dot(&Vector3::x().cross(position))));
    loads.push(lift(structure, &all, |normal, _| normal.y));
    loads.extend((0..aircraft.controls.len()).map(|control| lift_by_control(structure, control)));
    loads
}

/// The strips of each component and its mirror image together, where those are two; without a mirror of each component.
///
/// What lies in the mirror plane has little lift, and what has adds no strain that its neighbours lack.
fn lifting_bodies(aircraft: &Aircraft, mirror: Option<&Reflection>) -> Vec<Vec<usize>> {
    let component = |beam: usize| aircraft.beams[beam].component.as_str();
    let image = |beam: usize, mirror: &Reflection| {
        let end = mirror.image(aircraft.beams[beam].nodes[1]);
        aircraft.beams.iter().position(|other| other.nodes[1] == end)
    };
    let mut bodies: Vec<([&str; 2], Vec<usize>)> = Vec::new();
    for (index, strip) in aircraft.strips.iter().enumerate() {
        let beam = strip.attachment.beam;
        let other = mirror.and_then(|mirror| image(beam, mirror)).map_or("", component);
        let mut names = [component(beam), other];
        names.sort_unstable();
        match bodies.iter_mut().find(|(known, _)| *known == names) {
            Some((_, strips)) => strips.push(index),
            None => bodies.push((names, vec![index])),
        }
    }
    bodies.into_iter().filter(|([one, other], _)| one != other).map(|(_, strips)| strips).collect()
}

/// Lift of strips in air that meets each with an incidence of its own, given its normal n and its position.
fn lift(
    structure: &Structure,
    strips: &[usize],
    incidence: impl Fn(&Vector3<f64>, &Vector3<f64>) -> f64,
) -> DVector<f64> {
    let mut load = NodalLoad::new(structure);
    for strip in strips.iter().map(|&index| &structure.aircraft.strips[index]) {
        let (normal, place) = (strip.forward.cross(&strip.span), strip.attachment);
        let position = structure.geometry[place.beam].position(place.fraction);
        let incidence = incidence(&normal, &position);
        if incidence.abs() < ROUNDING * (1.0 + position.norm()) {
            continue;
        }
        let lift = strip.lift_slope * strip.semichord * strip.width * incidence;
        let mut moment = lift * quarter_chord_arm(strip);
        if strip.moment_slope != 0.0 {
            moment += 2.0 * strip.moment_slope * strip.semichord * strip.semichord * strip.width * incidence;
        }
        load.add(place, -lift * normal, moment * strip.span);
    }
    load.forces
}

/// Gravity in the body z direction on every bay.
fn vertical_inertia(structure: &Structure) -> DVector<f64> {
    let mut load = NodalLoad::new(structure);
    for bay in &structure.aircraft.bays {
        let weight = bay.mass * Vector3::z();
        load.add(bay.attachment, weight, bay.offset.cross(&weight));
    }
    load.forces
}

/// Lift of the flaps that a control moves.
fn lift_by_control(structure: &Structure, control: usize) -> DVector<f64> {
    let mut load = NodalLoad::new(structure);
    for strip in &structure.aircraft.strips {
        if let Some(flap) = &strip.flap {
            let (normal, effect) = (strip.forward.cross(&strip.span), FlapEffect::new(flap));
            let size = strip.semichord * strip.width * flap.gains[control];
            let moment = quarter_chord_arm(strip) * effect.lift + strip.semichord * effect.moment;
            load.add(strip.attachment, -size * effect.lift * normal, size * moment * strip.span);
        }
    }
    load.forces
}

/// Distance of the elastic axis behind the quarter chord, b/2 + d, m.
fn quarter_chord_arm(strip: &Strip) -> f64 {
    0.5 * strip.semichord + strip.elastic_axis_aft_of_midchord
}

/// Forces and moments at sections, collected on the nodal unknowns by the elements' own interpolation.
struct NodalLoad<'s> {
    structure: &'s Structure<'s>,
    forces: DVector<f64>,
}

impl<'s> NodalLoad<'s> {
    fn new(structure: &'s Structure) -> Self {
        NodalLoad { structure, forces: DVector::zeros(structure.unknowns()) }
    }

    /// Adds a force and a moment about the elastic axis, body axes.
    fn add(&mut self, place: Attachment, force: Vector3<f64>, moment: Vector3<f64>) {
        let (displacement, rotation) = self.structure.geometry[place.beam].section(place.fraction);
        let nodal = displacement.transpose() * force + rotation.transpose() * moment;
        self.structure.add_nodal(place.beam, &nodal, &mut self.forces);
    }
}

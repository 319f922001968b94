//! What is shown of an aircraft, moment after moment: where its sections are and how they stand, what acts, by what it is coloured.

use flexible_aircraft::equations::SectionLoads;
use flexible_aircraft::flight::Simulation;
use flexible_aircraft::plant::Outputs;
use flexible_aircraft::strips::Resultant;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::watched::Watched;

use super::airframe::Airframe;

/// Numbers of a pose: place and quaternion.
pub const POSE: usize = 7;

/// Where a colour is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    Strips,
    Sections,
}

/// By what strips or sections are coloured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    pub name: &'static str,
    pub label: &'static str,
    pub unit: &'static str,
    pub place: Place,
}

/// That of strips, N/m.
pub const LIFT: Quantity = Quantity { name: "lift", label: "lift", unit: "N/m", place: Place::Strips };
/// rad.
pub const TWIST: Quantity =
    Quantity { name: "twist", label: "twist, nose-up", unit: "rad", place: Place::Sections };
/// m/s².
pub const ACCELERATION: Quantity = Quantity {
    name: "acceleration",
    label: "upward specific force; 9.81 in level flight",
    unit: "m/s²",
    place: Place::Sections,
};

/// A component of section loads, and how it is read.
type Load = (Quantity, fn(&SectionLoads) -> f64);

/// Section loads by component.
pub const LOADS: [Load; 6] = [
    (load("bending", "bending moment", "N m"), |loads| loads.bending),
    (load("torsion", "torsion, nose-up", "N m"), |loads| loads.torsion),
    (load("shear", "shear force, upwards", "N"), |loads| loads.shear),
    (load("bending_chordwise", "chordwise bending moment", "N m"), |loads| loads.bending_chordwise),
    (load("shear_chordwise", "chordwise shear force", "N"), |loads| loads.shear_chordwise),
    (load("axial", "axial force, outboard", "N"), |loads| loads.axial),
];

const fn load(name: &'static str, label: &'static str, unit: &'static str) -> Quantity {
    Quantity { name, label, unit, place: Place::Sections }
}

/// All frames of a show; matrices row by row.
#[derive(Clone, Debug, Default)]
pub struct Recording {
    pub frames: usize,
    /// Of each section, body axes.
    pub poses: Vec<f64>,
    /// That of O and of the body axes on the earth.
    pub body: Vec<f64>,
    /// rad.
    pub controls: Vec<f64>,
    /// N.
    pub thrust: Vec<f64>,
    /// Of the air at O, earth axes, m/s.
    pub wind: Vec<f64>,
    pub colours: Vec<(Quantity, Vec<f64>)>,
    /// A column each.
    pub charts: Vec<Vec<f64>>,
}

impl Recording {
    /// Takes what stands in a flight, section loads and lift among it.
    pub fn look(&mut self, airframe: &Airframe, charted: &[Watched], simulation: &mut Simulation) {
        let strips = simulation.strip_loads();
        let instant = simulation.instant_with_loads();
        self.charts.resize(charted.len(), Vec::new());
        for (values, output) in self.charts.iter_mut().zip(charted) {
            values.push(output.slot.number(instant));
        }
        self.take(airframe, &instant.outputs, &strips);
    }

    /// Takes outputs, and what the air does to each strip.
    pub fn take(&mut self, airframe: &Airframe, outputs: &Outputs, strips: &[Resultant]) {
        let body = quaternion(&outputs.quaternion);
        self.body.extend(outputs.position.iter());
        let before = self.body.len().checked_sub(POSE);
        let before =
            before.filter(|_| self.frames > 0).map(|at| [0, 1, 2, 3].map(|part| self.body[at + part]));
        self.body.extend(continued(outputs.quaternion, before));
        self.take_poses(airframe, outputs, &body);
        self.controls.extend(&outputs.controls);
        self.thrust.extend(&outputs.thrust);
        self.wind.extend(outputs.wind.iter());
        self.take_colours(airframe, outputs, (strips, &body));
        self.frames += 1;
    }

    fn take_poses(&mut self, airframe: &Airframe, outputs: &Outputs, body: &UnitQuaternion<f64>) {
        let before = self.poses.len().checked_sub(POSE * airframe.sections.len());
        for (number, (section, station)) in airframe.sections.iter().zip(airframe.at_sections()).enumerate() {
            // As the placement says, without the digits that a long way costs.
            let position = section.position + outputs.deflections[station].displacement;
            let turn = body.inverse() * quaternion(&outputs.placements[station].quaternion);
            let before = before.map(|row| [3, 4, 5, 6].map(|part| self.poses[row + POSE * number + part]));
            let parts = turn.coords;
            self.poses.extend(position.iter());
            self.poses.extend(continued([parts.w, parts.x, parts.y, parts.z], before));
        }
    }

    fn take_colours(
        &mut self,
        airframe: &Airframe,
        outputs: &Outputs,
        (strips, body): (&[Resultant], &UnitQuaternion<f64>),
    ) {
        let stations = || airframe.at_sections();
        self.colour(TWIST, stations().map(|station| outputs.deflections[station].twist));
        self.colour(ACCELERATION, stations().map(|station| -outputs.sensors[station].specific_force.z));
        if strips.len() == airframe.strips.len() {
            let lift = (0..strips.len()).map(|strip| {
                let station = airframe.named[0] + airframe.strips[strip];
                let turn = body.inverse() * quaternion(&outputs.placements[station].quaternion);
                lift(airframe, strip, &turn, &strips[strip])
            });
            self.colour(LIFT, lift);
        }
        if let Some(loads) = outputs.loads.known() {
            for (quantity, value) in LOADS {
                let at = |section| {
                    // What no sum tells is shown as nothing: a note says so.
                    let Some(([inner, outer], share)) = airframe.cuts_around(section) else { return 0.0 };
                    value(&loads[inner]) * (1.0 - share) + value(&loads[outer]) * share
                };
                self.colour(quantity, (0..airframe.sections.len()).map(at));
            }
        }
    }

    /// Adds the values of a moment.
    pub fn colour(&mut self, quantity: Quantity, values: impl Iterator<Item = f64>) {
        match self.colours.iter_mut().find(|(other, _)| *other == quantity) {
            Some((_, colour)) => colour.extend(values),
            None => self.colours.push((quantity, values.collect())),
        }
    }

    /// From the least to the greatest value of a colour.
    pub fn range(&self, name: &str) -> Option<[f64; 2]> {
        let (_, values) = self.colours.iter().find(|(quantity, _)| quantity.name == name)?;
        values
            .iter()
            .map(|&value| [value; 2])
            .reduce(|[low, high], [value, _]| [low.min(value), high.max(value)])
    }
}

/// What lifts a strip, towards its suction side, N/m.
fn lift(airframe: &Airframe, strip: usize, turn: &UnitQuaternion<f64>, load: &Resultant) -> f64 {
    let strip = &airframe.aircraft.strips[strip];
    let up: Vector3<f64> = -strip.forward.cross(&strip.span);
    load.force.dot(&(turn * up)) / strip.width
}

fn quaternion(parts: &[f64; 4]) -> UnitQuaternion<f64> {
    let [w, x, y, z] = *parts;
    UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z))
}

/// The same turn with the sign that goes on from the one before; the scalar is not negative at first.
fn continued(parts: [f64; 4], before: Option<[f64; 4]>) -> [f64; 4] {
    let before = before.unwrap_or([1.0, 0.0, 0.0, 0.0]);
    let along: f64 = parts.iter().zip(&before).map(|(one, other)| one * other).sum();
    if along < 0.0 { parts.map(|part| -part) } else { parts }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use flexible_aircraft::ReducedModel;
    use flexible_aircraft::aircraft::Fidelity;
    use flexible_aircraft::flight::Settings;
    use flexible_aircraft::plant::PlantSettings;

    use super::super::airframe::tests::jet;
    use super::*;

    #[test]
    fn a_turn_goes_on_with_the_sign_that_it_had() {
        let turned = [-0.8, 0.6, 0.0, 0.0];
        assert_eq!(continued(turned, None), [0.8, -0.6, 0.0, 0.0]);
        assert_eq!(continued(turned, Some([-0.7, 0.7, 0.1, 0.0])), turned);
    }

    #[test]
    fn poses_are_those_of_the_stations_and_lift_carries_the_weight_at_every_level() {
        let airframe = Airframe::new(&jet());
        let model = Arc::new(ReducedModel::new(&airframe.aircraft, 6).unwrap());
        for fidelity in Fidelity::ALL {
            let plant = PlantSettings { fidelity, mode_count: 6, ..PlantSettings::of(&model) };
            let mut flight = Simulation::new(Arc::clone(&model), &Settings::from(plant), 0.0).unwrap();
            flight.advance_to(0.05).unwrap();
            let mut recording = Recording::default();
            recording.look(&airframe, &[], &mut flight);
            let outputs = flight.outputs().clone();
            let body = quaternion(&[3, 4, 5, 6].map(|part| recording.body[part]));
            for (section, &station) in airframe.stations.iter().zip(&[0, 1]) {
                let pose = &recording.poses[POSE * section..][..POSE];
                let place = outputs.position + body * Vector3::new(pose[0], pose[1], pose[2]);
                let away = (place - outputs.placements[station].position).norm();
                assert!(away < 1e-9, "{} {away}", fidelity.name());
            }
            let (_, lift) = recording.colours.iter().find(|(colour, _)| *colour == LIFT).unwrap();
            let wings = airframe.aircraft.strips.iter().zip(lift);
            let wings = wings.filter(|(strip, _)| strip.span.y.abs() > 0.9);
            let sum: f64 = wings.map(|(strip, lift)| strip.width * lift).sum();
            let weight = model.integrals.mass * model.gravity;
            assert!((sum / weight - 1.0).abs() < 0.03, "{} {}", fidelity.name(), sum / weight);
        }
    }
}

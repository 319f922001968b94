//! The joints of the skeleton: one for each section that is drawn, and one below it for each flap that hangs there.

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::Strip;
use nalgebra::Vector3;
use serde_json::{Value, json};

use super::super::airframe::{Airframe, Section};
use super::super::flap::Flap;
use super::super::outline::Outline;
use super::super::scene::thickness;
use super::shape::Shape;
use super::strips::Slice;
use super::{axes, bodies};
use crate::describe::surfaces;
use crate::numbers::short;

/// Joints and what hangs on them.
pub struct Joints<'a> {
    pub airframe: &'a Airframe,
    pub outlines: Vec<Outline>,
    /// Behind the joints of all sections.
    pub flaps: Vec<FlapJoint>,
}

/// The joint of a flap, in the middle of its hinge.
pub struct FlapJoint {
    pub strip: usize,
    pub section: usize,
    /// On the undeformed aircraft, from the section, body axes, m.
    pub offset: Vector3<f64>,
    pub flap: Flap,
}

impl<'a> Joints<'a> {
    pub fn of(airframe: &'a Airframe) -> Self {
        let aircraft = &airframe.aircraft;
        let outlines = Outline::of_all(aircraft);
        let joint = |(strip, outline): (usize, &Outline)| {
            let flap = Flap::of(aircraft, strip, outline)?;
            let offset = (flap.hinge[0] + flap.hinge[1]) * 0.5;
            Some(FlapJoint { strip, section: airframe.strips[strip], offset, flap })
        };
        let flaps = outlines.iter().enumerate().filter_map(joint).collect();
        Joints { airframe, outlines, flaps }
    }

    /// Where they are on the undeformed aircraft, body axes, m.
    pub fn places(&self) -> Vec<Vector3<f64>> {
        let sections: Vec<Vector3<f64>> =
            self.airframe.sections.iter().map(|section| section.position).collect();
        let flaps: Vec<Vector3<f64>> =
            self.flaps.iter().map(|joint| sections[joint.section] + joint.offset).collect();
        [sections, flaps].concat()
    }

    /// Of sections: that of the first station there, else how far along their component they are, in elements from its root.
    pub fn names(&self) -> Vec<String> {
        let Airframe { aircraft, sections, stations, .. } = self.airframe;
        let name = |(number, section): (usize, &Section)| {
            let station = stations.iter().position(|at| *at == number);
            station.map_or_else(
                || format!("{} {}", aircraft.components[section.component].name, short(section.along)),
                |station| aircraft.stations[station].name.clone(),
            )
        };
        sections.iter().enumerate().map(name).collect()
    }

    /// Of a flap, unlike those of all sections.
    pub fn flap_name(&self, joint: &FlapJoint) -> String {
        let beam = self.airframe.aircraft.strips[joint.strip].attachment.beam;
        format!("{} strip {} flap", self.airframe.aircraft.beams[beam].component, joint.strip + 1)
    }

    /// By which outputs a flap turns about which axis.
    pub fn flap_extras(&self, joint: &FlapJoint) -> Value {
        let controls = joint.flap.gains.iter();
        let gains = controls
            .map(|&(control, gain)| (self.airframe.aircraft.controls[control].name.clone(), json!(gain)));
        json!({
            "controls": Value::Object(gains.collect()),
            "axis": triple(&joint.flap.axis),
        })
    }

    /// The skin of all, hung on the joints.
    pub fn shape(&self) -> Shape {
        let mut shape = Shape::new();
        for (number, (outline, &section)) in self.outlines.iter().zip(&self.airframe.strips).enumerate() {
            let strip = &self.airframe.aircraft.strips[number];
            if is_in_a_body(&self.airframe.aircraft, strip) {
                continue;
            }
            let flap = self.flaps.iter().position(|joint| joint.strip == number);
            let hinge = strip.flap.as_ref().map_or(1.0, |flap| flap.hinge);
            let slice = Slice {
                outline,
                place: self.airframe.sections[section].position,
                thickness: thickness(&self.airframe.aircraft, strip),
                joint: section,
                flap: flap.map(|flap| (hinge, self.airframe.sections.len() + flap)),
            };
            slice.add_to(&mut shape);
        }
        bodies::add(self.airframe, &mut shape);
        shape
    }

    /// The section on which a joint hangs, or which it is.
    pub fn section(&self, joint: usize) -> usize {
        let flap = joint.checked_sub(self.airframe.sections.len());
        flap.map_or(joint, |flap| self.flaps[flap].section)
    }
}

/// Whether a strip lies across a body, which is drawn in its place.
pub fn is_in_a_body(aircraft: &Aircraft, strip: &Strip) -> bool {
    let component = aircraft.component_of(strip.attachment.beam);
    component.is_some_and(|component| !surfaces::is_lifting(aircraft, component))
}

/// A vector in the axes of glTF, with digits of single precision.
pub fn triple(vector: &Vector3<f64>) -> [f64; 3] {
    axes::turned(vector).map(digits).into()
}

/// The shortest number that is the same in single precision.
pub fn digits(number: f64) -> f64 {
    // PROOF: what is written as a number is read as one; the number itself stands in for any doubt.
    format!("{:e}", number as f32 + 0.0).parse().unwrap_or(number)
}

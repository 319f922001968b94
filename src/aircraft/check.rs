//! What only shows in the whole: names used twice, nothing that weighs, no mirror image, a tunnel's air around what flies.

use nalgebra::Vector3;

use super::document::Located;
use super::error::{Place, Problem, Report};
use super::expand::Assembly;
use super::geometry::Side;
use super::model::{AIRSPEEDS, Aircraft, Attachment, Beam, Engine, MassBay, Support};
use super::schema::FileSpec;

/// Components (mirror images among them), engines and stations have names of their own.
pub(super) fn names(file: &FileSpec, report: &Report) {
    let components = file.components.iter().flat_map(|c| std::iter::once(&c.name).chain(&c.mirror));
    distinct("component", components, report);
    distinct("engine", file.engines.iter().map(|engine| &engine.name), report);
    distinct("station", file.stations.iter().map(|station| &station.name), report);
}

fn distinct<'s>(kind: &str, names: impl Iterator<Item = &'s Located<String>>, report: &Report) {
    let mut seen: Vec<&str> = Vec::new();
    for name in names {
        if seen.contains(&name.value.as_str()) {
            let found = format!("found the name \"{}\" a second time", name.value);
            let allowed = format!("a name that no other {kind} has is allowed");
            report.add(Problem::DuplicateName, &name.place, found, allowed);
        }
        seen.push(&name.value);
    }
}

/// A free aircraft moves through the standard atmosphere, its attitude is found.
pub(super) fn support(file: &FileSpec, report: &Report) {
    if file.support.value == Support::Clamped {
        return;
    }
    if !AIRSPEEDS.contains(&file.airspeed.value) {
        let found = format!("found {}", file.airspeed.value);
        let allowed = "an airspeed in m/s from 1 to 400 is allowed, with support = \"clamped\" from 0 on";
        report.add(Problem::OutOfRange, &file.airspeed.place, found, allowed);
    }
    let air = file.tunnel_air.as_ref().map(|air| &air.place);
    let mount = file.mount.as_ref().map(|mount| &mount.place);
    for place in air.into_iter().chain(mount) {
        let allowed = "support = \"clamped\" is allowed with it";
        report.add(Problem::Contradiction, place, "found it with support = \"free\"", allowed);
    }
}

/// Something has mass.
pub(super) fn mass(aircraft: &Aircraft, report: &Report) {
    if aircraft.bays.is_empty() {
        let place = Place { span: 0..0, field: "component".to_owned() };
        let allowed = "at least one distributed_mass or point_masses is needed";
        report.add(Problem::NoMass, &place, "found no mass on any component", allowed);
    }
}

/// The structure is its own image in y = 0: nodes, beams, bays, engines.
pub(super) fn symmetry(assembly: &Assembly, file: &FileSpec, report: &Report) {
    let mirror = Mirror::of(&assembly.aircraft);
    let aircraft = &assembly.aircraft;
    let complain = |place: &Place, what: String| {
        let found = format!("found {what} without mirror image in y = 0, while symmetric = true");
        let allowed = "a structure that is its own mirror image is allowed, or symmetric = false";
        report.add(Problem::NotSymmetric, place, found, allowed);
    };
    let component = |bay: &MassBay| &aircraft.beams[bay.attachment.beam].component;
    let mut lonely_components: Vec<&String> = Vec::new();
    for (beam, place) in aircraft.beams.iter().zip(&assembly.beam_places) {
        let known = lonely_components.contains(&&beam.component);
        if !known && !aircraft.beams.iter().any(|b| mirror.beams(beam, b)) {
            lonely_components.push(&beam.component);
            complain(place, format!("the component \"{}\"", beam.component));
        }
    }
    let mut told: Vec<&Place> = Vec::new();
    for (bay, place) in aircraft.bays.iter().zip(&assembly.bay_places) {
        let known = lonely_components.contains(&component(bay)) || told.contains(&place);
        if !known && !aircraft.bays.iter().any(|b| mirror.bays(bay, b)) {
            told.push(place);
            complain(place, format!("a mass of {} kg", bay.mass));
        }
    }
    for (engine, spec) in aircraft.engines.iter().zip(&file.engines) {
        if !aircraft.engines.iter().any(|e| mirror.engines(engine, e)) {
            complain(&spec.name.place, format!("the engine \"{}\"", engine.name));
        }
    }
}

/// Compares parts with the mirror images of others.
struct Mirror<'a> {
    aircraft: &'a Aircraft,
    /// Lengths that differ by less are equal, m.
    slack: f64,
}

impl<'a> Mirror<'a> {
    fn of(aircraft: &'a Aircraft) -> Self {
        let size = aircraft.nodes.iter().map(Vector3::norm).fold(0.0, f64::max);
        Mirror { aircraft, slack: 1e-9 * size }
    }

    fn places(&self, one: Vector3<f64>, other: Vector3<f64>) -> bool {
        (Side::Mirrored.vector(one) - other).norm() <= self.slack
    }

    fn position(&self, attachment: Attachment) -> Vector3<f64> {
        let [from, to] = self.aircraft.beams[attachment.beam].nodes.map(|node| self.aircraft.nodes[node]);
        from + (to - from) * attachment.fraction
    }

    fn beams(&self, one: &Beam, other: &Beam) -> bool {
        let node = |beam: &Beam, end: usize| self.aircraft.nodes[beam.nodes[end]];
        let y_axes = Side::Mirrored.vector(one.y_axis).cross(&other.y_axis).norm();
        (0..2).all(|end| self.places(node(one, end), node(other, end)))
            && y_axes <= 1e-9
            && same(one.axial_stiffness, other.axial_stiffness)
            && same(one.torsional_stiffness, other.torsional_stiffness)
            && same(one.bending_stiffness_y, other.bending_stiffness_y)
            && same(one.bending_stiffness_z, other.bending_stiffness_z)
    }

    fn bays(&self, one: &MassBay, other: &MassBay) -> bool {
        let inertia = Side::Mirrored.inertia(one.inertia) - other.inertia;
        self.places(self.position(one.attachment), self.position(other.attachment))
            && self.places(one.offset, other.offset)
            && same(one.mass, other.mass)
            && inertia.norm() <= 1e-9 * one.inertia.norm()
    }

    fn engines(&self, one: &Engine, other: &Engine) -> bool {
        self.places(self.position(one.attachment), self.position(other.attachment))
            && self.places(one.offset, other.offset)
            && (Side::Mirrored.vector(one.direction) - other.direction).norm() <= 1e-9
    }
}

fn same(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-9 * one.abs()
}

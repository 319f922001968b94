//! What only shows in the whole: names used twice, nothing that weighs, no mirror image, a tunnel's air around what flies.

use nalgebra::Vector3;

use super::branches::{Branches, CLOSE, one_to_one};
use super::coupling::{Coupling, Hinge, Spring};
use super::document::Located;
use super::error::{Place, Problem, Report};
use super::expand::Assembly;
use super::format::allowed::FLIGHT_SPEED;
use super::format::places::{ANGULAR_MOMENTUM, TORQUE, TRIM_SHARE};
use super::geometry::Side;
use super::model::{Aircraft, Attachment, Beam, Engine, MassBay, Support};
use super::schema::{EngineSpec, FileSpec};

/// Controls, components (mirror images among them), engines, stations and cuts have names of their own.
pub(super) fn names(file: &FileSpec, report: &Report) {
    let components = file.components.iter().flat_map(|c| std::iter::once(&c.name).chain(&c.mirror));
    distinct("component", components, report);
    distinct("control", file.controls.iter().map(|spec| &spec.name), report);
    distinct("engine", file.engines.iter().map(|engine| &engine.name), report);
    distinct("station", file.stations.iter().map(|station| &station.name), report);
    distinct("cut", file.cuts.iter().map(|cut| &cut.name), report);
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
    if !FLIGHT_SPEED.range.contains(file.airspeed.value) {
        let found = format!("found {}", file.airspeed.value);
        let allowed = format!("{}, with support = \"clamped\" from 0 on", FLIGHT_SPEED.text());
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

/// The structure is its own image in y = 0: nodes, beams, joints, bays, engines.
pub(super) fn symmetry(assembly: &Assembly, file: &FileSpec, report: &Report) {
    let aircraft = &assembly.aircraft;
    let mirror = Mirror::of(aircraft);
    let complain = |place: &Place, what: String| {
        let found = format!("found {what} without mirror image in y = 0, while symmetric = true");
        let allowed = "a structure that is its own mirror image is allowed, or symmetric = false";
        report.add(Problem::NotSymmetric, place, found, allowed);
    };
    let mut lonely_components: Vec<&String> = Vec::new();
    for (beam, place) in aircraft.beams.iter().zip(&assembly.beam_places) {
        if mirror.images[beam.nodes[1]].is_none() && !lonely_components.contains(&&beam.component) {
            lonely_components.push(&beam.component);
            complain(place, format!("the component \"{}\"", beam.component));
        }
    }
    let mut told: Vec<&Place> = Vec::new();
    for (joint, place) in aircraft.joints.iter().zip(&assembly.joint_places) {
        let is_lonely = joint.ends.iter().any(|end| lonely_components.contains(&&end.component));
        if !is_lonely && !aircraft.is_mirrored(joint, &mirror.images) {
            complain(place, joint.to_string());
        }
    }
    let bays = pair_off(&aircraft.bays, |one, other| mirror.bays(one, other));
    for ((bay, place), image) in aircraft.bays.iter().zip(&assembly.bay_places).zip(bays) {
        let component = &aircraft.beams[bay.attachment.beam].component;
        if image.is_none() && !lonely_components.contains(&component) && !told.contains(&place) {
            told.push(place);
            complain(place, format!("a mass of {} kg", bay.mass));
        }
    }
    let engines =
        pair_off(&aircraft.engines, |one, other| mirror.engines(one, other) && run_mirrored(one, other));
    for ((engine, spec), image) in aircraft.engines.iter().zip(&file.engines).zip(engines) {
        let Engine { name, .. } = engine;
        let mut in_place = aircraft.engines.iter().filter(|other| mirror.engines(engine, other));
        match (image, in_place.next()) {
            (Some(_), _) => {}
            (None, None) => complain(&spec.name.place, format!("the engine \"{name}\"")),
            (None, Some(other)) => {
                let odd = odd_engines((engine, spec), other);
                if odd.is_empty() {
                    // The other one is the image of a third.
                    complain(&spec.name.place, format!("the engine \"{name}\""));
                }
                for OddEngine { place, found, allowed } in odd {
                    report.add(Problem::NotSymmetric, place, found, allowed);
                }
            }
        }
    }
}

/// Some engine has thrust in trims, where there are any.
pub(super) fn trim_shares(aircraft: &Aircraft, file: &FileSpec, report: &Report) {
    let Some(first) = file.engines.first() else { return };
    if aircraft.engines.iter().all(|engine| engine.trim_share == 0.0) {
        let place = first.name.place.clone();
        let found = "found trim_share = 0 of all engines: none has thrust in trims";
        report.add(Problem::OutOfRange, &place, found, "more than 0 is allowed of one at least");
    }
}

/// Whether engines that are mirror images by their places are so by what they do: axes of rotation turn the other way in a mirror.
fn run_mirrored(one: &Engine, other: &Engine) -> bool {
    what_runs(one).into_iter().zip(image_of(what_runs(other))).all(|(one, image)| same(one, image))
}

/// Torque, angular momentum, share of the thrust.
fn what_runs(engine: &Engine) -> [f64; 3] {
    [engine.torque, engine.angular_momentum, engine.trim_share]
}

/// Seen in a mirror; 0 and not −0.
fn image_of([torque, angular_momentum, trim_share]: [f64; 3]) -> [f64; 3] {
    [0.0 - torque, 0.0 - angular_momentum, trim_share]
}

/// A field of an engine that is no mirror image: what is found and what is allowed.
struct OddEngine<'s> {
    place: &'s Place,
    found: String,
    allowed: String,
}

/// Everything in which an engine is no mirror image of another, or of itself.
fn odd_engines<'s>((one, spec): (&Engine, &'s EngineSpec), other: &Engine) -> Vec<OddEngine<'s>> {
    let places = [&spec.torque.place, &spec.angular_momentum.place, &spec.trim_share.place];
    let fields = [&TORQUE, &ANGULAR_MOMENTUM, &TRIM_SHARE].map(|field| field.name).into_iter().zip(places);
    let numbers = what_runs(one).into_iter().zip(what_runs(other)).zip(image_of(what_runs(other)));
    let odd = fields.zip(numbers).filter(|(_, ((found, _), image))| !same(*found, *image));
    odd.map(|((field, place), ((found, of_other), image))| {
        let found = format!("found {field} = {found} of the engine \"{}\"", one.name);
        let (found, allowed) = if one.name == other.name {
            (format!("{found} in the plane y = 0"), "0 is allowed there".to_owned())
        } else {
            let found = format!("{found}, and {of_other} of its mirror image \"{}\"", other.name);
            (found, format!("{image} is allowed"))
        };
        let [found, allowed] = [found + ", while symmetric = true", allowed + ", or symmetric = false"];
        OddEngine { place, found, allowed }
    })
    .collect()
}

/// The image of each part, if it has one: itself or another, each taken once.
fn pair_off<T>(parts: &[T], mirrors: impl Fn(&T, &T) -> bool) -> Vec<Option<usize>> {
    let mut images = vec![None; parts.len()];
    for one in 0..parts.len() {
        if images[one].is_none() {
            let mut others = std::iter::once(one).chain(one + 1..parts.len());
            let found = others.find(|&other| images[other].is_none() && mirrors(&parts[one], &parts[other]));
            if let Some(other) = found {
                (images[one], images[other]) = (Some(other), Some(one));
            }
        }
    }
    images
}

/// Compares parts with the mirror images of others.
struct Mirror<'a> {
    aircraft: &'a Aircraft,
    branches: Branches,
    /// The image of each node, by the beams that lead there.
    images: Vec<Option<usize>>,
    /// Lengths that differ by less are equal, m.
    slack: f64,
}

impl<'a> Mirror<'a> {
    fn of(aircraft: &'a Aircraft) -> Self {
        let size = aircraft.nodes.iter().map(Vector3::norm).fold(0.0, f64::max);
        let branches = Branches::of(aircraft);
        let mut mirror = Mirror { aircraft, branches, images: Vec::new(), slack: 1e-9 * size };
        let mut beams: Vec<Option<&Beam>> = vec![None; aircraft.nodes.len()];
        let mut bays: Vec<Vec<&MassBay>> = vec![Vec::new(); aircraft.nodes.len()];
        for beam in &aircraft.beams {
            beams[beam.nodes[1]] = Some(beam);
        }
        for bay in &aircraft.bays {
            bays[aircraft.beams[bay.attachment.beam].nodes[1]].push(bay);
        }
        let alike = |one: usize, other: usize| match (beams[one], beams[other]) {
            (Some(one), Some(other)) => mirror.beams(one, other),
            _ => false,
        };
        let joined = aircraft.rotations_joined();
        let with_all = |one: usize, other: usize| {
            let carried = |one: &MassBay, other: &MassBay| {
                let apart = (one.attachment.fraction - other.attachment.fraction).abs();
                apart <= CLOSE && mirror.lumps(one, other)
            };
            joined[one] == joined[other] && alike(one, other) && one_to_one(&bays[one], &bays[other], carried)
        };
        // Branches in one place are told apart by what they carry; what cannot be found so is by its beams alone.
        let images = Some(mirror.branches.images(&with_all)).filter(|images| !images.contains(&None));
        mirror.images = images.unwrap_or_else(|| mirror.branches.images(&alike));
        mirror
    }

    fn places(&self, one: Vector3<f64>, other: Vector3<f64>) -> bool {
        (Side::Mirrored.vector(one) - other).norm() <= self.slack
    }

    fn sections(&self, one: Attachment, other: Attachment) -> bool {
        self.branches.section(one).mirrors(self.branches.section(other), &self.images)
    }

    fn beams(&self, one: &Beam, other: &Beam) -> bool {
        let node = |beam: &Beam, end: usize| self.aircraft.nodes[beam.nodes[end]];
        let image_of_y = Side::Mirrored.vector(one.y_axis);
        let is_turned = image_of_y.dot(&other.y_axis) < 0.0;
        let image = one.coupling.mirrored();
        let image = if is_turned { image.turned_about() } else { image };
        (0..2).all(|end| self.places(node(one, end), node(other, end)))
            && image_of_y.cross(&other.y_axis).norm() <= 1e-9
            && same(one.axial_stiffness, other.axial_stiffness)
            && same(one.torsional_stiffness, other.torsional_stiffness)
            && same(one.bending_stiffness_y, other.bending_stiffness_y)
            && same(one.bending_stiffness_z, other.bending_stiffness_z)
            && self.couplings(other, &image)
            && same_hinges(one.hinge.as_ref(), other.hinge.as_ref())
    }

    /// Whether a beam has a coupling, each stiffness of it relative to those that it couples.
    fn couplings(&self, beam: &Beam, coupling: &Coupling) -> bool {
        let Coupling { bending, bend_twist: [y, z], stretch_by_twist, tension_axis, shear_centre } =
            beam.coupling;
        let [torsional, bending_y, bending_z] =
            [beam.torsional_stiffness, beam.bending_stiffness_y, beam.bending_stiffness_z];
        let near = |one: f64, other: f64, size: f64| (one - other).abs() <= 1e-9 * size;
        let places = |one: [f64; 2], other: [f64; 2]| {
            (0..2).all(|axis| near(one[axis], other[axis], 1e9 * self.slack))
        };
        near(bending, coupling.bending, (bending_y * bending_z).sqrt())
            && near(y, coupling.bend_twist[0], (torsional * bending_y).sqrt())
            && near(z, coupling.bend_twist[1], (torsional * bending_z).sqrt())
            && near(stretch_by_twist, coupling.stretch_by_twist, 1e9 * self.slack)
            && places(tension_axis, coupling.tension_axis)
            && places(shear_centre, coupling.shear_centre)
    }

    fn bays(&self, one: &MassBay, other: &MassBay) -> bool {
        self.sections(one.attachment, other.attachment) && self.lumps(one, other)
    }

    /// Whether two lumps are images of each other, wherever they are carried.
    fn lumps(&self, one: &MassBay, other: &MassBay) -> bool {
        let inertia = Side::Mirrored.inertia(one.inertia) - other.inertia;
        self.places(one.offset, other.offset)
            && same(one.mass, other.mass)
            && inertia.norm() <= 1e-9 * one.inertia.norm()
    }

    fn engines(&self, one: &Engine, other: &Engine) -> bool {
        self.sections(one.attachment, other.attachment)
            && self.places(one.offset, other.offset)
            && (Side::Mirrored.vector(one.direction) - other.direction).norm() <= 1e-9
    }
}

/// Whether each spring of one hinge has its image among those of the other.
fn same_hinges(one: Option<&Hinge>, other: Option<&Hinge>) -> bool {
    let mirrors = |one: &Spring, other: &Spring| {
        Side::Mirrored.vector(one.axis).cross(&other.axis).norm() <= 1e-9
            && same(one.stiffness, other.stiffness)
    };
    match (one, other) {
        (None, None) => true,
        (Some(one), Some(other)) => one_to_one(
            &one.springs.iter().collect::<Vec<_>>(),
            &other.springs.iter().collect::<Vec<_>>(),
            mirrors,
        ),
        _ => false,
    }
}

fn same(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-9 * one.abs()
}

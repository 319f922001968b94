//! The tree of sections at which geometrically exact kinematics evaluates the structure, and the rigid bodies on them.
//!
//! [theory: geometrically-exact.sections, geometrically-exact.attached, coupled-sections.hinge]
//!
//! Sections stand where something is attached, where the structure branches or bends, and beyond hinges. Of each the linear pose is known; its
//! difference from that of the section before it, but for what a helix makes, is what exact kinematics needs.

use nalgebra::{DMatrix, Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use crate::aircraft::{Attachment, MassBay};

use super::ModeShapes;
use super::assembly::Structure;
use super::mirror::Reflection;

/// Fractions of an element's length that differ by less are equal.
const CLOSE: f64 = 1e-9;

/// Elements whose directions have a product that is less short of 1 go on in the same direction.
const STRAIGHT: f64 = 1e-9;

/// A section of the structure with what is fixed to it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BeamSection {
    /// The section before it on the way to O; O's own section is the first, and its own parent.
    pub parent: usize,
    /// Undeformed, body axes, m.
    pub position: Vector3<f64>,
    /// Relative to the parent: Dλ, the displacement that no helix makes, and Dφ, the rotation.
    pub steps: ModeShapes,
    /// All mass fixed to it.
    pub body: RigidBody,
}

/// A rigid body on a section.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RigidBody {
    /// kg.
    pub mass: f64,
    /// From the section to the centre of mass, body axes, m.
    pub offset: Vector3<f64>,
    /// About the centre of mass, body axes, kg·m².
    pub inertia: Matrix3<f64>,
}

impl RigidBody {
    /// No mass.
    pub const NONE: RigidBody = RigidBody {
        mass: 0.0,
        offset: Vector3::new(0.0, 0.0, 0.0),
        inertia: Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    };

    /// The mass of a bay.
    pub(super) fn of(bay: &MassBay) -> Self {
        RigidBody {
            mass: bay.mass,
            offset: bay.offset,
            inertia: (bay.inertia + bay.inertia.transpose()) * 0.5,
        }
    }

    /// Both, fixed to each other.
    fn with(&self, other: &RigidBody) -> Self {
        let mass = self.mass + other.mass;
        let apart = other.offset - self.offset;
        let arm = apart.cross_matrix();
        let share = if mass > 0.0 { other.mass / mass } else { 0.0 };
        RigidBody {
            mass,
            offset: self.offset + apart * share,
            inertia: self.inertia + other.inertia - arm * arm * (self.mass * share),
        }
    }

    /// Whether every number is finite.
    pub(super) fn is_finite(&self) -> bool {
        self.offset.iter().chain(self.inertia.iter()).chain([&self.mass]).all(|x| x.is_finite())
    }
}

/// The sections of a structure with the given mode shapes, each after its parent.
#[derive(Debug)]
pub struct SectionTree {
    /// O's first.
    pub sections: Vec<BeamSection>,
    /// Of each element: its ends, and the sections between them with their fractions.
    ends: Vec<[usize; 2]>,
    between: Vec<Vec<(f64, usize)>>,
}

impl SectionTree {
    /// Of a structure; with a mirror, sections are each other's images even where something is attached on one side only.
    pub(super) fn new(structure: &Structure, shapes: &DMatrix<f64>, mirror: Option<&Reflection>) -> Self {
        let layout = Layout::new(structure, mirror);
        let mut growing = Growing::new(structure, shapes);
        let mut of_node = vec![0; structure.aircraft.nodes.len()];
        let (mut ends, mut between) = (Vec::new(), Vec::new());
        // The element that leads to a node comes before those that begin there.
        for (index, beam) in structure.aircraft.beams.iter().enumerate() {
            let [first, last] = beam.nodes;
            let mut parent = of_node[first];
            if beam.hinge.is_some() {
                parent = growing.push(parent, Attachment { beam: index, fraction: 0.0 });
            }
            let root = parent;
            let mut own = Vec::new();
            for &fraction in &layout.within[index] {
                parent = growing.push(parent, Attachment { beam: index, fraction });
                own.push((fraction, parent));
            }
            of_node[last] = if layout.is_superfluous(last) {
                parent
            } else {
                growing.push(parent, Attachment { beam: index, fraction: 1.0 })
            };
            ends.push([root, of_node[last]]);
            between.push(own);
        }
        let mut tree = SectionTree { sections: growing.sections, ends, between };
        for bay in &structure.aircraft.bays {
            let section = tree.at(bay.attachment);
            let body = &mut tree.sections[section].body;
            *body = body.with(&RigidBody::of(bay));
        }
        tree
    }

    /// The section that carries what is attached at a place.
    pub fn at(&self, place: Attachment) -> usize {
        let [first, last] = self.ends[place.beam];
        match place.fraction {
            fraction if fraction <= CLOSE => first,
            fraction if fraction >= 1.0 - CLOSE => last,
            fraction => {
                let own = &self.between[place.beam];
                let nearest = own.iter().min_by(|(one, _), (other, _)| {
                    (one - fraction).abs().total_cmp(&(other - fraction).abs())
                });
                nearest.map_or(first, |&(_, section)| section)
            }
        }
    }
}

/// Where sections have to be.
struct Layout {
    /// Of each element: the fractions inside, ascending.
    within: Vec<Vec<f64>>,
    /// Whether the section of each node can be done without.
    superfluous: Vec<bool>,
}

impl Layout {
    fn new(structure: &Structure, mirror: Option<&Reflection>) -> Self {
        let aircraft = structure.aircraft;
        let mut within = vec![Vec::new(); aircraft.beams.len()];
        let mut carries = vec![false; aircraft.nodes.len()];
        for place in attachments(structure, mirror) {
            let [first, last] = aircraft.beams[place.beam].nodes;
            match place.fraction {
                fraction if fraction <= CLOSE => carries[first] = true,
                fraction if fraction >= 1.0 - CLOSE => carries[last] = true,
                fraction => within[place.beam].push(fraction),
            }
        }
        for beam in aircraft.beams.iter().filter(|beam| beam.hinge.is_some()) {
            carries[beam.nodes[0]] = true;
        }
        for fractions in &mut within {
            fractions.sort_by(f64::total_cmp);
            fractions.dedup_by(|next, before| *next - *before <= CLOSE);
        }
        let leading = |node: usize| aircraft.beams.iter().position(|beam| beam.nodes[1] == node);
        let from = |node: usize| {
            let mut beginning =
                (0..aircraft.beams.len()).filter(|&beam| aircraft.beams[beam].nodes[0] == node);
            beginning.next().filter(|_| beginning.next().is_none())
        };
        let loaded = |beam: usize| !within[beam].is_empty() || carries[aircraft.beams[beam].nodes[1]];
        let direction = |beam: usize| structure.geometry[beam].axes.row(0);
        let superfluous = |node: usize| {
            let [Some(before), Some(after)] = [leading(node), from(node)] else { return false };
            let straight = direction(before).dot(&direction(after)) > 1.0 - STRAIGHT;
            !carries[node] && straight && loaded(before) && loaded(after)
        };
        Layout { superfluous: (0..aircraft.nodes.len()).map(superfluous).collect(), within }
    }

    fn is_superfluous(&self, node: usize) -> bool {
        self.superfluous[node]
    }
}

/// The places of all that is attached, and of their mirror images.
fn attachments(structure: &Structure, mirror: Option<&Reflection>) -> Vec<Attachment> {
    let aircraft = structure.aircraft;
    let bays = aircraft.bays.iter().map(|bay| bay.attachment);
    let strips = aircraft.strips.iter().map(|strip| strip.attachment);
    let engines = aircraft.engines.iter().map(|engine| engine.attachment);
    let stations = aircraft.stations.iter().map(|station| station.attachment);
    let mut all: Vec<Attachment> = bays.chain(strips).chain(engines).chain(stations).collect();
    if let Some(mirror) = mirror {
        let image = |beam: usize| {
            let end = mirror.image(aircraft.beams[beam].nodes[1]);
            aircraft.beams.iter().position(|other| other.nodes[1] == end)
        };
        let images: Vec<Option<usize>> = (0..aircraft.beams.len()).map(image).collect();
        let mirrored = |place: &Attachment| Some(Attachment { beam: images[place.beam]?, ..*place });
        let mirrored: Vec<_> = all.iter().filter_map(mirrored).collect();
        all.extend(mirrored);
    }
    all
}

/// Sections while they are being found, with the linear pose of each.
struct Growing<'s> {
    structure: &'s Structure<'s>,
    shapes: &'s DMatrix<f64>,
    sections: Vec<BeamSection>,
    poses: Vec<ModeShapes>,
}

impl<'s> Growing<'s> {
    fn new(structure: &'s Structure, shapes: &'s DMatrix<f64>) -> Self {
        let rest = || ModeShapes {
            translation: vec![0.0; 3 * shapes.ncols()],
            rotation: vec![0.0; 3 * shapes.ncols()],
        };
        let position = structure.aircraft.nodes[0];
        let first = BeamSection { parent: 0, position, steps: rest(), body: RigidBody::NONE };
        Growing { structure, shapes, sections: vec![first], poses: vec![rest()] }
    }

    /// Adds a section, and says where it stands.
    fn push(&mut self, parent: usize, place: Attachment) -> usize {
        let position = self.structure.geometry[place.beam].position(place.fraction);
        let pose = self.structure.shapes_at(place, self.shapes);
        let arm = position - self.sections[parent].position;
        let steps = steps(&self.poses[parent], &pose, &arm);
        self.sections.push(BeamSection { parent, position, steps, body: RigidBody::NONE });
        self.poses.push(pose);
        self.sections.len() - 1
    }
}

/// Dλ and Dφ of two linear poses an arm apart [theory: geometrically-exact.sections].
pub(super) fn steps(parent: &ModeShapes, own: &ModeShapes, arm: &Vector3<f64>) -> ModeShapes {
    let modes = own.modes();
    let mut steps = own.clone();
    for mode in 0..modes {
        let ([u, phi], [u_parent, phi_parent]) = (own.of_mode(mode), parent.of_mode(mode));
        let turn = phi - phi_parent;
        let slide = u - u_parent - (phi_parent + turn * 0.5).cross(arm);
        for axis in 0..3 {
            steps.translation[axis * modes + mode] = slide[axis];
            steps.rotation[axis * modes + mode] = turn[axis];
        }
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::linear_poses;
    use crate::structure::test_jet::jet;

    #[test]
    fn sections_of_the_jet_stand_where_something_is_attached_and_where_it_branches() {
        let side =
            |sign: f64| jet().sections.iter().filter(|section| section.position.y * sign > 1e-9).count();
        assert_eq!((jet().sections.len(), side(1.0), side(-1.0)), (135, 34, 34));
    }

    #[test]
    fn steps_lead_to_the_linear_pose_of_all_that_is_attached() {
        let model = jet();
        let poses = linear_poses(&model.sections);
        for mode in 0..model.modes.len() {
            let strips = model.strips.iter().map(|strip| (strip.section, strip.position, &strip.shapes));
            let stations = model.stations.iter().map(|at| (at.carrier.section, at.position, &at.shapes));
            for (section, position, shapes) in strips.chain(stations) {
                assert!((model.sections[section].position - position).norm() < 1e-13);
                let [[u, phi], [displacement, rotation]] =
                    [&poses[section], shapes].map(|of| of.of_mode(mode));
                assert!((u - displacement).norm() < 1e-14, "{u} {displacement}");
                assert!((phi - rotation).norm() < 1e-15, "{phi} {rotation}");
            }
            for engine in &model.engines {
                let [u, phi] = poses[engine.carrier.section].of_mode(mode);
                let arm = engine.position - model.sections[engine.carrier.section].position;
                let [displacement, _] = engine.shapes.of_mode(mode);
                assert!((u + phi.cross(&arm) - displacement).norm() < 1e-14);
            }
        }
    }

    #[test]
    fn steps_of_bending_and_torsion_have_hardly_any_part_along_the_element() {
        let (mut along, mut all): (f64, f64) = (0.0, 0.0);
        for section in &jet().sections[1..] {
            let arm = section.position - jet().sections[section.parent].position;
            for mode in 0..jet().modes.len() {
                let [slide, _] = section.steps.of_mode(mode);
                along = along.max(slide.dot(&arm).abs() / arm.norm());
                all = all.max(slide.norm());
            }
        }
        assert!(along < 1e-2 * all, "{along} {all}");
    }

    #[test]
    fn bodies_have_the_mass_and_the_moments_of_the_aircraft() {
        let integrals = &jet().integrals;
        let (mut mass, mut first_moment, mut inertia) = (0.0, Vector3::zeros(), Matrix3::zeros());
        for section in &jet().sections {
            let centre = section.position + section.body.offset;
            let arm = centre.cross_matrix();
            mass += section.body.mass;
            first_moment += centre * section.body.mass;
            inertia += section.body.inertia - arm * arm * section.body.mass;
        }
        assert!((mass / integrals.mass - 1.0).abs() < 1e-14);
        assert!((first_moment - integrals.first_moment).norm() < 1e-13 * integrals.first_moment.norm());
        assert!((inertia - integrals.inertia).norm() < 1e-13 * integrals.inertia.norm());
    }
}

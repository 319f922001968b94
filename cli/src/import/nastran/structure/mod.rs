//! From elements, rigid links and masses to the components of an aircraft file: a tree of beams with masses on its nodes, and joints
//! where beams form loops.

mod bodies;
mod chains;
mod growth;
mod hinges;
mod loops;
mod masses;
mod pins;
mod rigid;
mod sticks;
mod tree;

use std::collections::{BTreeSet, HashSet};

use nalgebra::Vector3;

use super::cards::Cards;
use super::frames::World;
use super::lumps::Lump;
use super::members::Member;
use super::mistakes::{Mistakes, Origin, Remarks};
use super::stiffness::Stiffness;
use super::units::Units;
use crate::numbers::short;
use bodies::Bodies;
use growth::Growth;
use hinges::Hinges;
pub use hinges::{ComponentHinge, Springs};
pub use loops::Joint;
pub use masses::{HALVES, turned_inertia};
use tree::Tree;

/// Places that are nearer are one, m.
const SAME_PLACE: f64 = 1e-6;

/// Elements of less mass, kg, are written without: half of it stands at each of two places, of which the format takes 1e-9 or more.
pub const LIGHTEST: f64 = 4e-9;

/// Larger decks are no sticks: their elements, and their masses.
const MOST_ELEMENTS: usize = 5000;
const MOST_LUMPS: usize = 20_000;

/// What has more loops is a lattice.
const MOST_LOOPS: usize = 200;

/// A node of the aircraft.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum NodeRef {
    Origin,
    Node { component: usize, node: usize },
}

/// A chain of elements.
#[derive(Clone, Debug)]
pub struct Component {
    pub parent: NodeRef,
    /// Its nodes, m from O; the first is the parent's.
    pub points: Vec<Vector3<f64>>,
    pub elements: Vec<ComponentElement>,
    pub y_axis: Vector3<f64>,
    /// Springs at its beginning.
    pub hinge: Option<ComponentHinge>,
    /// Whether it leads from one beam to another.
    pub is_strut: bool,
    /// None of what the deck has.
    pub made_for: Option<MadeFor>,
}

/// The panel that a rigid beam is for, among all, with its card.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeFor {
    pub panel: usize,
    pub origin: Origin,
}

/// Between two nodes.
#[derive(Clone, Copy, Debug)]
pub struct ComponentElement {
    /// A place among the members; none of rigid links.
    pub member: Option<usize>,
    pub stiffness: Stiffness,
}

impl Component {
    /// Distance of each node from the first along the axis, m.
    pub fn distances(&self) -> Vec<f64> {
        let mut at = 0.0;
        let lengths = self.points.windows(2).map(|ends| {
            at += (ends[1] - ends[0]).norm();
            at
        });
        std::iter::once(0.0).chain(lengths).collect()
    }
}

/// A body on a component.
#[derive(Clone, Debug)]
pub struct PlacedLump {
    pub component: usize,
    pub node: usize,
    /// Its centre from the node.
    pub offset: Vector3<f64>,
    pub lump: Lump,
}

/// Why the aircraft is held where it is.
#[derive(Clone, Debug, PartialEq)]
pub enum Held {
    Clamped(Origin),
    Hinged { by: Origin, needs_links: bool },
    Asked,
    Supported,
    NearestToMass,
}

/// The tree, with all that it carries.
#[derive(Debug)]
pub struct Structure {
    pub members: Vec<Member>,
    pub components: Vec<Component>,
    pub lumps: Vec<PlacedLump>,
    pub joints: Vec<Joint>,
    pub held: Held,
    /// The grid at O.
    pub root_grid: i64,
    /// O, m from the zero of the deck.
    pub origin: Vector3<f64>,
    bodies: Bodies,
    ports: Vec<Vec<(Vector3<f64>, NodeRef)>>,
    /// Of each body the greatest stiffness by length of the elements on it.
    stiffest: Vec<Stiffness>,
}

/// What a structure is made of.
pub struct Parts<'a> {
    pub cards: &'a Cards,
    pub world: &'a World,
    pub units: &'a Units,
    pub members: Vec<Member>,
    pub lumps: Vec<Lump>,
    /// The sets of constraints that hold; all where none.
    pub sets: Option<&'a [i64]>,
    /// The grid that is to be O.
    pub root: Option<i64>,
}

impl Structure {
    /// Finds the tree and hangs masses on it; none where there is no element, or no grid as asked.
    pub fn new(parts: Parts, (mistakes, remarks): (&mut Mistakes, &mut Remarks)) -> Option<Structure> {
        let Parts { cards, world, units, members, lumps, sets, root } = parts;
        if members.is_empty() {
            if mistakes.is_empty() {
                mistakes.of_whole("found no CBAR, CBEAM or CROD; one of them at least is needed".to_owned());
            }
            return None;
        }
        if members.len() > MOST_ELEMENTS || lumps.len() > MOST_LUMPS {
            mistakes.of_whole(format!(
                "found {} elements and {} masses; up to {MOST_ELEMENTS} and {MOST_LUMPS} are allowed of a stick model",
                members.len(),
                lumps.len()
            ));
            return None;
        }
        let of_members = members.iter().flat_map(|member| member.grids);
        let used: BTreeSet<i64> = of_members.chain(lumps.iter().map(|lump| lump.grid)).collect();
        let bodies = Bodies::new((cards, world, units), &used, sets, (mistakes, remarks));
        let (root_grid, held) = root_of((cards, &bodies), (&members, &lumps), root, mistakes)?;
        let (root, origin) = (bodies.of(root_grid)?, world.grid(root_grid)?);
        let tree = Tree::new(&members, &bodies, (root, origin));
        if tree.outward[root].is_empty() {
            mistakes.of_whole(format!("GRID {root_grid}, where the aircraft is held: found no element on it; a grid with elements is needed"));
            return None;
        }
        if tree.closings.len() > MOST_LOOPS {
            let found = format!("found beams that form {} loops", tree.closings.len());
            mistakes.of_whole(format!("{found}; up to {MOST_LOOPS} are allowed of a stick model"));
            return None;
        }
        tree::tell_idle(&tree, &members, remarks);
        tree::leave_out_lost(&tree, &members, remarks);
        pins::tell(&tree, &members, remarks);
        other_clamps(&bodies, root, remarks);
        let stiffest = rigid::stiffest(&members, &tree);
        let springs = bodies.hinge.as_ref().filter(|hinge| hinge.body == root);
        let hinges = Hinges::new((&members, &tree, &stiffest), (&origin, springs));
        let mut growth = Growth::new((&members, &tree), (origin, &hinges), stiffest);
        let joints = loops::close(&mut growth, (&tree, &members), remarks);
        for &(element, gap) in &growth.moved {
            let said = format!("its end is moved by {} mm onto the node beside it", short(gap * 1e3));
            remarks.note(format!("{}: {said}", members[element].origin));
        }
        let Growth { mut components, ports, stiffest, .. } = growth;
        name_struts(&mut components, &tree);
        let held = match held {
            Held::Hinged { by, .. } => Held::Hinged { by, needs_links: hinges.before_root.is_some() },
            held => held,
        };
        let zero = components[0].points[0];
        let mut structure = Structure {
            members,
            components,
            lumps: Vec::new(),
            joints,
            held,
            root_grid,
            origin: zero,
            bodies,
            ports,
            stiffest,
        };
        structure.hang_masses(cards, &tree, lumps, remarks);
        structure.move_to_origin();
        Some(structure)
    }

    /// The node of a body at a place, else the one by which the tree leads to the body.
    fn port(&self, body: usize, place: &Vector3<f64>) -> Option<(Vector3<f64>, NodeRef)> {
        let ports = self.ports.get(body)?;
        ports.iter().find(|port| (port.0 - place).norm() <= SAME_PLACE).or(ports.first()).copied()
    }

    /// The nodes that move with some grids.
    pub fn nodes_of(&self, grids: &[i64]) -> HashSet<NodeRef> {
        let bodies: BTreeSet<usize> = grids.iter().filter_map(|&grid| self.bodies.of(grid)).collect();
        let ports = bodies.into_iter().filter_map(|body| self.ports.get(body));
        ports.flatten().map(|(_, node)| *node).collect()
    }

    /// The node that moves with a grid, at its place (m from O) if there is one, and where that is.
    pub fn node_at(&self, grid: i64, place: &Vector3<f64>) -> Option<(Vector3<f64>, NodeRef)> {
        self.port(self.bodies.of(grid)?, place)
    }

    /// A component, and those that it hangs on.
    pub fn with_parents(&self, component: usize) -> Vec<usize> {
        let mut chain = vec![component];
        let mut at = component;
        // Components hang on earlier ones alone.
        while let NodeRef::Node { component, .. } = self.components[at].parent {
            chain.push(component);
            at = component;
        }
        chain
    }

    /// The centre of mass, m from O; O where nothing weighs.
    pub fn centre(&self) -> Vector3<f64> {
        let of_elements = self.components.iter().flat_map(|component| {
            let middles = component.points.windows(2).map(|ends| 0.5 * (ends[0] + ends[1]));
            let masses = component.elements.iter().map(|element| match element.member {
                Some(member) => (self.members[member].mass(), self.members[member].mass_centre),
                None => (0.0, Vector3::zeros()),
            });
            masses.zip(middles).map(|((mass, offset), middle)| (mass, middle + offset))
        });
        let place = |lump: &PlacedLump| self.components[lump.component].points[lump.node] + lump.offset;
        let of_lumps = self.lumps.iter().map(|lump| (lump.lump.mass, place(lump)));
        let (mass, moment) = of_elements
            .chain(of_lumps)
            .fold((0.0, Vector3::zeros()), |(mass, moment), (part, at)| (mass + part, moment + at * part));
        if mass > 0.0 { moment / mass } else { Vector3::zeros() }
    }

    /// Whether something on it has mass.
    pub fn has_mass(&self) -> bool {
        let of_elements = self.components.iter().flat_map(|component| &component.elements);
        let mut masses =
            of_elements.filter_map(|element| element.member).map(|member| self.members[member].mass());
        masses.any(|mass| mass >= LIGHTEST) || !self.lumps.is_empty()
    }

    fn move_to_origin(&mut self) {
        let origin = self.origin;
        let points = self.components.iter_mut().flat_map(|component| &mut component.points);
        points.for_each(|point| *point -= origin);
        self.ports.iter_mut().flatten().for_each(|(point, _)| *point -= origin);
    }
}

/// What closes a loop where it meets another beam is a strut, if not by half.
fn name_struts(components: &mut [Component], tree: &Tree) {
    let of_struts = tree.closings.iter().filter(|closing| closing.opposite.is_none());
    let struts: BTreeSet<usize> = of_struts.flat_map(|closing| closing.chain.iter().copied()).collect();
    for component in components {
        let mut of_deck = component.elements.iter().filter_map(|element| element.member).peekable();
        component.is_strut = of_deck.peek().is_some() && of_deck.all(|member| struts.contains(&member));
    }
}

/// Clamps beside the one that holds.
fn other_clamps(bodies: &Bodies, root: usize, remarks: &mut Remarks) {
    for (body, grid, origin) in &bodies.clamped {
        if *body != root {
            remarks.card(
                origin,
                format!("GRID {grid} is held too: one place is clamped here, this one is free"),
            );
        }
    }
}

fn root_of(
    (cards, bodies): (&Cards, &Bodies),
    (members, lumps): (&[Member], &[Lump]),
    asked: Option<i64>,
    mistakes: &mut Mistakes,
) -> Option<(i64, Held)> {
    if let Some(grid) = asked {
        if !cards.grids.contains_key(&grid) {
            mistakes.of_whole(format!("--origin: found {grid}, a GRID of the deck is needed"));
            return None;
        }
        let clamp = bodies.clamped.iter().find(|(body, _, _)| bodies.of(grid) == Some(*body));
        return Some((grid, clamp.map_or(Held::Asked, |(_, _, origin)| Held::Clamped(origin.clone()))));
    }
    let on_body: BTreeSet<usize> =
        members.iter().flat_map(|member| member.grids).filter_map(|grid| bodies.of(grid)).collect();
    if let Some((_, grid, origin)) = bodies.clamped.iter().find(|(body, _, _)| on_body.contains(body)) {
        return Some((*grid, Held::Clamped(origin.clone())));
    }
    if let Some(hinge) = bodies.hinge.as_ref().filter(|hinge| on_body.contains(&hinge.body)) {
        return Some((hinge.grid, Held::Hinged { by: hinge.origin.clone(), needs_links: false }));
    }
    if let Some(grid) =
        cards.reference_grid.filter(|grid| bodies.of(*grid).is_some_and(|body| on_body.contains(&body)))
    {
        return Some((grid, Held::Supported));
    }
    let mut mass = 0.0;
    let mut moment = Vector3::zeros();
    for (part, at) in lumps.iter().map(|lump| (lump.mass, lump.centre)).chain(
        members
            .iter()
            .map(|member| (member.mass(), 0.5 * (member.ends[0] + member.ends[1]) + member.mass_centre)),
    ) {
        mass += part;
        moment += at * part;
    }
    let centre = if mass > 0.0 { moment / mass } else { Vector3::zeros() };
    Some((tree::root_of_free(members, &centre)?, Held::NearestToMass))
}

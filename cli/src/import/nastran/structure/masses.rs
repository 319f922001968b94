//! Masses on the nodes of components.

use std::collections::BTreeMap;

use super::super::cards::{Cards, Spread};
use super::super::lumps::Lump;
use super::super::members::Member;
use super::super::mistakes::Remarks;
use super::tree::Tree;
use super::{Joint, NodeRef, PlacedLump, SAME_PLACE, Structure};

/// Grids that others carry in shares, which others carry: so many levels, for there may be circles.
const DEEPEST: usize = 4;

/// The least mass of the format, kg.
const LIGHTEST_LUMP: f64 = 1e-9;

/// Shares of masses, all together.
const MOST_SHARES: usize = 100_000;

impl Structure {
    /// Masses of CONM1 and CONM2, of elements that strain nothing, and of rods that close loops.
    pub fn hang_masses(&mut self, cards: &Cards, tree: &Tree, lumps: Vec<Lump>, remarks: &mut Remarks) {
        let of_idle = tree.idle.iter().flat_map(|&element| halves(&self.members[element], HALVES));
        let rods =
            tree.closings.iter().flat_map(|closing| &closing.chain).filter(|&&element| {
                self.members[element].pins.iter().flatten().any(|pin| pin.field.is_none())
            });
        let rods: Vec<usize> = rods.copied().collect();
        // At their ends, as Nastran has them: between its pins a rod does not swing.
        let of_rods = rods.iter().flat_map(|&element| halves(&self.members[element], [0.0, 1.0]));
        let of_elements: Vec<Lump> = of_idle.chain(of_rods).collect();
        for element in rods {
            self.members[element].mass_by_length = 0.0;
        }
        let mut spreads: BTreeMap<usize, &Spread> = BTreeMap::new();
        for spread in cards.spreads.iter().filter(|spread| spread.carriers.len() > 1) {
            if let Some(body) = self.bodies.of(spread.grid) {
                spreads.entry(body).or_insert(spread);
            }
        }
        let is_reached = |grid: i64| self.bodies.of(grid).is_some_and(|body| tree.is_reached[body]);
        for spread in
            cards.spreads.iter().filter(|spread| spread.carriers.len() > 1 && is_reached(spread.grid))
        {
            let said = format!(
                "GRID {} is on beams of its own: that it moves with the mean of {} grids is not held",
                spread.grid,
                spread.carriers.len()
            );
            remarks.card(&spread.origin, said);
        }
        let mut left = MOST_SHARES;
        for lump in lumps.into_iter().chain(of_elements) {
            self.spread((&spreads, tree), &lump, (DEEPEST, &mut left), remarks);
        }
    }

    /// Hangs a mass on its body, or shares on those that carry this.
    fn spread(
        &mut self,
        (spreads, tree): (&BTreeMap<usize, &Spread>, &Tree),
        lump: &Lump,
        (depth, left): (usize, &mut usize),
        remarks: &mut Remarks,
    ) {
        let body = self.bodies.of(lump.grid);
        let is_carried = body.is_some_and(|body| tree.is_reached[body]);
        let is_possible = |spread: &&Spread| !is_carried && depth > 0 && spread.carriers.len() <= *left;
        let of_body = body.and_then(|body| spreads.get(&body).copied());
        let Some(spread) = of_body.filter(is_possible) else {
            self.hang(lump, remarks);
            return;
        };
        *left -= spread.carriers.len();
        let whole: f64 = spread.carriers.iter().map(|(_, weight)| weight).sum();
        let said = format!(
            "{} on GRID {}: its mass is divided by the weights of {} among {} grids, each part rigid on its own; mass, centre and inertia of the whole are kept",
            lump.origin,
            lump.grid,
            spread.origin,
            spread.carriers.len()
        );
        remarks.card(&spread.origin, said);
        for &(grid, weight) in &spread.carriers {
            let share = weight / whole;
            let (mass, inertia) = (share * lump.mass, lump.inertia * share);
            let part = Lump { grid, mass, inertia, ..lump.clone() };
            self.spread((spreads, tree), &part, (depth - 1, left), remarks);
        }
    }

    fn hang(&mut self, lump: &Lump, remarks: &mut Remarks) {
        if lump.mass < LIGHTEST_LUMP {
            let said = format!(
                "{:.3e} kg of it, and what turns with them, are too little for a mass here: left out",
                lump.mass
            );
            remarks.card(&lump.origin, said);
            return;
        }
        let Some((at, node)) = self.bodies.of(lump.grid).and_then(|body| self.port(body, &lump.at)) else {
            let said = format!(
                "no chain of elements and rigid links joins GRID {} to the root: {:.6} kg are left out",
                lump.grid, lump.mass
            );
            remarks.card(&lump.origin, said);
            return;
        };
        let offset = lump.centre - at;
        let carriers = self.carriers(node);
        let share = 1.0 / carriers.len() as f64;
        for (component, node) in carriers {
            let lump = Lump { mass: share * lump.mass, inertia: lump.inertia * share, ..lump.clone() };
            self.lumps.push(PlacedLump { component, node, offset, lump });
        }
    }

    /// The component and its node that carry what is on a node. Where two components that are mirror images begin at O, or end in a joint,
    /// there are two, each for its half, so that both sides are alike.
    pub fn carriers(&self, node: NodeRef) -> Vec<(usize, usize)> {
        let NodeRef::Node { component, node } = node else {
            let at_origin = |place: &usize| self.components[*place].parent == NodeRef::Origin;
            let beginning: Vec<usize> = (0..self.components.len()).filter(at_origin).collect();
            let is_in_plane = |place: &&usize| {
                let points = &self.components[**place].points;
                points.iter().all(|point| (point.y - points[0].y).abs() <= SAME_PLACE)
            };
            if let Some(&place) = beginning.iter().find(is_in_plane) {
                return vec![(place, 0)];
            }
            let first = |place: usize| self.components[place].points[1] - self.components[place].points[0];
            let mirrored = |one: usize, other: usize| {
                let [one, other] = [first(one), first(other)];
                (one + other).y.abs() + (one.xz() - other.xz()).norm() <= SAME_PLACE
            };
            let pair = beginning.iter().find(|&&other| mirrored(beginning[0], other));
            return std::iter::once(beginning[0]).chain(pair.copied()).map(|place| (place, 0)).collect();
        };
        let is_here = |joint: &&Joint| joint.ends[1] == (component, node) && self.is_between_tips(joint);
        let other = self.joints.iter().find(is_here).map(|joint| joint.ends[0]);
        other.into_iter().chain([(component, node)]).collect()
    }

    /// Whether a joint is between the last nodes of two components.
    fn is_between_tips(&self, joint: &Joint) -> bool {
        joint.ends.iter().all(|&(component, node)| node + 1 == self.components[component].points.len())
    }
}

/// The mass of an element at two places of it, each on the grid beside it.
fn halves(member: &Member, places: [f64; 2]) -> Vec<Lump> {
    if member.mass() <= 0.0 {
        return Vec::new();
    }
    let half = |end: usize| {
        let centre = member.ends[0] + member.span() * places[end] + member.mass_centre;
        let inertia = turned_inertia(member) * 0.5;
        Lump {
            origin: member.origin.clone(),
            grid: member.grids[end],
            at: member.ends[end],
            mass: 0.5 * member.mass(),
            centre,
            inertia,
        }
    };
    vec![half(0), half(1)]
}

/// Two places of a uniform rod, as shares of its length: half of its mass at each has its centre and its inertia.
pub const HALVES: [f64; 2] = [0.211_324_865_405_187_13, 0.788_675_134_594_812_9];

/// Of a member about the centre of its mass, as a body at its middle has it beside that of its length.
pub fn turned_inertia(member: &Member) -> nalgebra::Matrix3<f64> {
    let axis = member.span().normalize();
    // A disc: half of its polar moment about each diameter.
    let polar = member.inertia_by_length * member.length();
    let disc = 0.5 * polar * (nalgebra::Matrix3::identity() + axis * axis.transpose());
    disc + member.apart_by_length * member.length()
}

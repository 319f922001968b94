//! From elements between bodies to a tree of them: which elements lead where, from the root out, and where loops are closed.

use std::collections::BTreeSet;

use nalgebra::Vector3;

use super::super::members::Member;
use super::super::mistakes::Remarks;
use super::bodies::Bodies;
use super::chains::{Chain, Graph};

/// Elements by the bodies that they join; those of the tree lead away from the root.
#[derive(Debug)]
pub struct Tree {
    /// Of each element, its bodies; where it closes a loop, its end is a body of its own.
    pub ends: Vec<[usize; 2]>,
    /// Elements that leave each body, outwards.
    pub outward: Vec<Vec<usize>>,
    /// Where loops are closed.
    pub closings: Vec<Closing>,
    /// Elements with both ends on one body.
    pub idle: Vec<usize>,
    /// Elements that no chain joins to the root.
    pub lost: Vec<usize>,
    /// Whether a body hangs on the root.
    pub is_reached: Vec<bool>,
    pub root: usize,
}

/// Where a chain of elements closes a loop.
#[derive(Clone, Debug)]
pub struct Closing {
    /// All elements of the chain.
    pub chain: Vec<usize>,
    /// The one whose end is joined, and which end that is.
    pub tip: (usize, usize),
    /// The body of this end alone, and the one that it is joined to.
    pub own: usize,
    pub joined_to: usize,
    /// The element whose end is on the other side of the cut, where the chain is cut between two.
    pub opposite: Option<(usize, usize)>,
    /// The ends by which the chain hangs on the tree.
    pub roots: Vec<(usize, usize)>,
}

impl Tree {
    /// The tree with the stiffest chains of elements: a loop is cut at its softest one, at rods and pinned ones before others.
    pub fn new(members: &[Member], bodies: &Bodies, (root, origin): (usize, Vector3<f64>)) -> Tree {
        let ends: Vec<[usize; 2]> =
            members.iter().map(|member| member.grids.map(|grid| bodies.of(grid).unwrap_or(root))).collect();
        let places = members.iter().flat_map(|member| member.ends);
        let size = places.map(|place| (place - origin).norm()).fold(0.0, f64::max);
        let graph = Graph { members, ends: &ends, root, plane: origin.y, size };
        let chains = graph.chains(bodies.count());
        let mut ranked: Vec<_> = chains.into_iter().map(|chain| (graph.readiness(&chain), chain)).collect();
        ranked.sort_by(|(one, _), (other, _)| one.partial_cmp(other).unwrap_or(std::cmp::Ordering::Equal));
        let mut heads: Vec<usize> = (0..bodies.count()).collect();
        let mut joined = vec![false; members.len()];
        let mut closing = Vec::new();
        for (_, chain) in ranked {
            let [one, other] = [chain.bodies[0], chain.last_body()].map(|body| head(&mut heads, body));
            if one == other {
                closing.push(chain);
            } else {
                heads[one] = other;
                chain.elements.iter().for_each(|&element| joined[element] = true);
            }
        }
        let mut tree = Tree {
            outward: vec![Vec::new(); bodies.count()],
            closings: Vec::new(),
            idle: Vec::new(),
            lost: Vec::new(),
            is_reached: vec![false; bodies.count()],
            ends: ends.clone(),
            root,
        };
        let from_root = tree.walk(&joined, members);
        for chain in closing.iter().filter(|chain| from_root[chain.bodies[0]].is_finite()) {
            tree.close(&graph, chain, graph.cut(chain, &from_root));
            chain.elements.iter().for_each(|&element| joined[element] = true);
        }
        for (element, is_joined) in joined.iter().enumerate() {
            match (tree.is_reached[ends[element][0]], is_joined) {
                (false, _) => tree.lost.push(element),
                (true, false) => tree.idle.push(element),
                (true, true) => {}
            }
        }
        tree
    }

    /// Finds what hangs on the root, which way it leads, and how far each body is from it along elements, m.
    fn walk(&mut self, joined: &[bool], members: &[Member]) -> Vec<f64> {
        let mut at: Vec<Vec<usize>> = vec![Vec::new(); self.outward.len()];
        for (element, ends) in self.ends.iter().enumerate() {
            ends.iter().for_each(|&body| at[body].push(element));
        }
        let mut from_root = vec![f64::INFINITY; self.outward.len()];
        let mut waiting = vec![self.root];
        from_root[self.root] = 0.0;
        self.is_reached[self.root] = true;
        while let Some(body) = waiting.pop() {
            for &element in at[body].iter().filter(|element| joined[**element]) {
                let other = self.other_end(element, body);
                if !self.is_reached[other] {
                    self.is_reached[other] = true;
                    from_root[other] = from_root[body] + members[element].length();
                    self.outward[body].push(element);
                    waiting.push(other);
                }
            }
        }
        from_root
    }

    /// Hangs a chain on its ends, cut at one of its places: what is before hangs on its first body, what is behind on the last; one of the
    /// two ends at the cut is on a body of its own.
    fn close(&mut self, graph: &Graph, chain: &Chain, place: usize) {
        let own = self.outward.len();
        self.outward.push(Vec::new());
        self.is_reached.push(true);
        chain.bodies.iter().for_each(|&body| self.is_reached[body] = true);
        for (at, &element) in chain.elements.iter().enumerate() {
            let from = if at < place { chain.bodies[at] } else { chain.bodies[at + 1] };
            self.outward[from].push(element);
        }
        let last = chain.elements.len();
        let [before, behind] = [place.checked_sub(1), Some(place).filter(|place| *place < last)]
            .map(|at| at.map(|at| (chain.elements[at], graph.first_end(chain, at))));
        let before = before.map(|(element, first)| (element, 1 - first));
        // PROOF: a chain has an element, so that one of the two is there.
        let Some(tip) = behind.or(before) else { return };
        self.ends[tip.0][tip.1] = own;
        let [first, other] = [false, true].map(|is_last| graph.outer(chain, is_last));
        let roots = [before.map(|_| first), behind.map(|_| other)];
        self.closings.push(Closing {
            chain: chain.elements.clone(),
            tip,
            own,
            joined_to: chain.bodies[place],
            opposite: before.filter(|_| behind.is_some()),
            roots: roots.into_iter().flatten().collect(),
        });
    }

    /// Which of its ends an element has on a body.
    pub fn end_at(&self, element: usize, body: usize) -> usize {
        usize::from(self.ends[element][0] != body)
    }

    /// The body at the other end of an element.
    pub fn other_end(&self, element: usize, body: usize) -> usize {
        let [one, other] = self.ends[element];
        if one == body { other } else { one }
    }
}

fn head(heads: &mut [usize], body: usize) -> usize {
    let mut head = body;
    while heads[head] != head {
        heads[head] = heads[heads[head]];
        head = heads[head];
    }
    head
}

/// Says of what strains nothing that its mass is held.
pub fn tell_idle(tree: &Tree, members: &[Member], remarks: &mut Remarks) {
    for &element in &tree.idle {
        let member = &members[element];
        let [from, to] = member.grids;
        let said = format!(
            "both its ends, GRID {from} and {to}, are on one rigid body: it strains nothing, its mass of {:.6} kg is held",
            member.mass()
        );
        remarks.card(&member.origin, said);
    }
}

/// What hangs on nothing is left out, and said so.
pub fn leave_out_lost(tree: &Tree, members: &[Member], remarks: &mut Remarks) {
    for &element in &tree.lost {
        let member = &members[element];
        let said = format!(
            "no chain of elements and rigid links joins it to the root: it is left out, with {:.6} kg",
            member.mass()
        );
        remarks.card(&member.origin, said);
    }
}

/// The body that the aircraft is held at, and the grid there: where it is clamped, else as asked, else nearest to the centre of mass, in the
/// plane of symmetry if something is there.
pub fn root_of_free(members: &[Member], centre: &Vector3<f64>) -> Option<i64> {
    let size = members.iter().flat_map(|member| member.ends).map(|end| end.norm()).fold(0.0, f64::max);
    let mut seen = BTreeSet::new();
    let ends = members.iter().flat_map(|member| std::iter::zip(member.grids, member.ends));
    let ends: Vec<(i64, Vector3<f64>)> = ends.filter(|(grid, _)| seen.insert(*grid)).collect();
    let in_plane = |(_, end): &&(i64, Vector3<f64>)| end.y.abs() <= 1e-6 * size;
    let nearest = |one: &&(i64, Vector3<f64>), other: &&(i64, Vector3<f64>)| {
        (one.1 - centre).norm().total_cmp(&(other.1 - centre).norm())
    };
    let of_plane = ends.iter().filter(in_plane).min_by(nearest);
    of_plane.or_else(|| ends.iter().min_by(nearest)).map(|(grid, _)| *grid)
}

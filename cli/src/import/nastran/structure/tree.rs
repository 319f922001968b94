//! From elements between bodies to a tree of them: which elements lead where, from the root out.

use std::collections::BTreeSet;

use nalgebra::Vector3;

use super::super::members::Member;
use super::super::mistakes::Remarks;
use super::bodies::Bodies;

/// Elements by the bodies that they join; those of the tree lead away from the root.
#[derive(Debug)]
pub struct Tree {
    /// Of each element, its bodies.
    pub ends: Vec<[usize; 2]>,
    /// Elements that leave each body, outwards.
    pub outward: Vec<Vec<usize>>,
    /// Elements that are in no tree: they would close a loop.
    pub cut: Vec<usize>,
    /// Elements that no chain joins to the root.
    pub lost: Vec<usize>,
    /// Whether a body hangs on the root.
    pub is_reached: Vec<bool>,
    pub root: usize,
}

impl Tree {
    /// The tree with the stiffest elements: of a loop the softest is cut, and rods before others.
    pub fn new(members: &[Member], bodies: &Bodies, root: usize) -> Tree {
        let ends: Vec<[usize; 2]> =
            members.iter().map(|member| member.grids.map(|grid| bodies.of(grid).unwrap_or(root))).collect();
        let mut order: Vec<usize> = (0..members.len()).collect();
        let stiffness = |member: &Member| member.stiffness.ei_y.min(member.stiffness.ei_z);
        order.sort_by(|&one, &other| {
            let [one, other] = [&members[one], &members[other]];
            one.is_rod.cmp(&other.is_rod).then(stiffness(other).total_cmp(&stiffness(one)))
        });
        let mut heads: Vec<usize> = (0..bodies.count()).collect();
        let mut joined = vec![false; members.len()];
        for element in order {
            let [one, other] = ends[element].map(|body| head(&mut heads, body));
            joined[element] = one != other;
            heads[one] = other;
        }
        let mut tree = Tree {
            outward: vec![Vec::new(); bodies.count()],
            cut: Vec::new(),
            lost: Vec::new(),
            is_reached: vec![false; bodies.count()],
            ends,
            root,
        };
        tree.walk(&joined);
        tree
    }

    /// Finds what hangs on the root, and which way it leads.
    fn walk(&mut self, joined: &[bool]) {
        let mut at: Vec<Vec<usize>> = vec![Vec::new(); self.outward.len()];
        for (element, ends) in self.ends.iter().enumerate() {
            ends.iter().for_each(|&body| at[body].push(element));
        }
        let mut waiting = vec![self.root];
        self.is_reached[self.root] = true;
        while let Some(body) = waiting.pop() {
            for &element in at[body].iter().filter(|element| joined[**element]) {
                let other = self.other_end(element, body);
                if !self.is_reached[other] {
                    self.is_reached[other] = true;
                    self.outward[body].push(element);
                    waiting.push(other);
                }
            }
        }
        for (element, is_joined) in joined.iter().enumerate() {
            match (self.is_reached[self.ends[element][0]], is_joined) {
                (false, _) => self.lost.push(element),
                (true, false) => self.cut.push(element),
                (true, true) => {}
            }
        }
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

/// Closes loops: the format has trees alone, so that an element which would close one is left out, and said so. A format that joins
/// nodes would have the element here, and a joint at its far end.
pub fn close_loops(tree: &Tree, members: &[Member], remarks: &mut Remarks) {
    for &element in &tree.cut {
        let member = &members[element];
        let [from, to] = member.grids;
        let [one, other] = tree.ends[element];
        let said = if one == other {
            format!(
                "both its ends, GRID {from} and {to}, are on one rigid body: it strains nothing, its mass of {:.6} kg is held",
                member.mass()
            )
        } else {
            format!(
                "it closes a loop from GRID {from} to {to}, and beams form a tree here: it is cut out, the loop is open there; its mass of {:.6} kg is \
                 held, half at each end",
                member.mass()
            )
        };
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

//! In which order sections are evaluated, and which coordinates move them.
//!
//! [theory: geometrically-exact.sections]
//!
//! Sections that follow one another make a *strand*: what adds up along it stays in registers. As the structure is clamped at
//! O, a mode moves only what grows from some of the elements there; of a group of eight sections there are rows only for modes
//! that move any of them.

use std::ops::Range;

use crate::math::{LANES, largest};
use crate::structure::{BeamSection, ModeShapes};

/// Steps by a mode below this, in parts of the mode's largest, are rounding.
const ROUNDING: f64 = 1e-12;

/// Sections in the order of evaluation, that of O first.
#[derive(Clone, Debug)]
pub struct Strands {
    /// The section at each place, if there is one.
    pub sections: Vec<Option<usize>>,
    /// The place of each section.
    pub places: Vec<usize>,
    /// What each group of eight has of strands, each part after that from which it grows.
    pub parts: Vec<Vec<Part>>,
    /// How many groups of eight, the first, are of sections in the mirror plane alone.
    pub in_plane: usize,
    /// The modes that move the section at each place, ascending.
    modes_at: Vec<Vec<usize>>,
}

/// Sections one after the other in a group of eight.
#[derive(Clone, Debug)]
pub struct Part {
    /// The group and the lane of the section before the first.
    pub parent: [usize; 2],
    pub lanes: Range<usize>,
    /// For each mode that moves them the row that the group has for it, and that which the parent's has; O, which no mode
    /// moves, has none.
    pub rows: Vec<(usize, Option<usize>)>,
}

impl Strands {
    /// Of sections, each after its parent, with the shapes of so many modes.
    pub fn new(sections: &[&BeamSection], parents: &[usize], modes: usize) -> Self {
        let Grown { strands, roots } = Grown::new(sections, parents);
        let moved = modes_that_move(sections, &roots, modes);
        let mut order = Strands {
            sections: vec![Some(0)],
            places: vec![0; sections.len()],
            parts: Vec::new(),
            in_plane: 0,
            modes_at: Vec::new(),
        };
        let (in_plane, in_space): (Vec<_>, Vec<_>) = strands.iter().partition(|strand| strand.in_plane);
        for &strand in &in_plane {
            order.put(&strand.own);
        }
        if !in_plane.is_empty() {
            order.sections.resize(order.sections.len().next_multiple_of(LANES), None);
            order.in_plane = order.eights();
        }
        for &strand in &in_space {
            order.put(&strand.own);
        }
        let modes_at = |section: &Option<usize>| section.map_or(Vec::new(), |own| moved[roots[own]].clone());
        order.modes_at = order.sections.iter().map(modes_at).collect();
        order.parts = vec![Vec::new(); order.eights()];
        for strand in in_plane.into_iter().chain(in_space) {
            order.part(&strand.own, parents[strand.own[0]]);
        }
        order
    }

    /// Puts sections at the next places.
    fn put(&mut self, own: &[usize]) {
        for &section in own {
            self.places[section] = self.sections.len();
            self.sections.push(Some(section));
        }
    }

    /// Parts a strand of sections at their places among the groups.
    fn part(&mut self, own: &[usize], parent: usize) {
        let (first, mut parent) = (self.places[own[0]], self.places[parent]);
        let end = first + own.len();
        for eight in first / LANES..end.div_ceil(LANES) {
            let begin = eight * LANES;
            let lanes = first.max(begin) - begin..end.min(begin + LANES) - begin;
            let before = self.modes_of_eight(parent / LANES);
            let row_before = |mode| before.iter().position(|&other| other == mode).filter(|_| parent != 0);
            let rows =
                self.modes_at(begin + lanes.start).into_iter().map(|(mode, row)| (row, row_before(mode)));
            let part = Part { parent: [parent / LANES, parent % LANES], rows: rows.collect(), lanes };
            parent = begin + part.lanes.end - 1;
            self.parts[eight].push(part);
        }
    }

    /// The modes that move any section of a group of eight, ascending: the group has a row for each.
    pub fn modes_of_eight(&self, eight: usize) -> Vec<usize> {
        let of_eight = self.modes_at.iter().skip(eight * LANES).take(LANES);
        let mut modes: Vec<usize> = of_eight.flatten().copied().collect();
        modes.sort_unstable();
        modes.dedup();
        modes
    }

    /// The modes that move the section at a place, each with the row that its group of eight has for it.
    pub fn modes_at(&self, place: usize) -> Vec<(usize, usize)> {
        let all = self.modes_of_eight(place / LANES).into_iter().enumerate();
        all.filter(|(_, mode)| self.modes_at[place].contains(mode)).map(|(row, mode)| (mode, row)).collect()
    }

    /// Number of groups of eight.
    pub fn eights(&self) -> usize {
        self.sections.len().div_ceil(LANES)
    }
}

/// Strands as they are found.
struct Grown {
    strands: Vec<GrownStrand>,
    /// Of each section the one next to O on the way there.
    roots: Vec<usize>,
}

struct GrownStrand {
    own: Vec<usize>,
    in_plane: bool,
}

impl Grown {
    fn new(sections: &[&BeamSection], parents: &[usize]) -> Self {
        let count = sections.len();
        let (mut roots, mut in_plane) = (vec![0; count], vec![lies_in_plane(sections[0]); count]);
        let (mut children, mut beyond) = (vec![Vec::new(); count], vec![1; count]);
        for section in 1..count {
            let parent = parents[section];
            roots[section] = if parent == 0 { section } else { roots[parent] };
            in_plane[section] = in_plane[parent] && lies_in_plane(sections[section]);
            children[parent].push(section);
        }
        for section in (1..count).rev() {
            beyond[parents[section]] += beyond[section];
        }
        let mut heads: Vec<usize> = children[0].iter().rev().copied().collect();
        let mut strands = Vec::new();
        while let Some(mut last) = heads.pop() {
            let mut strand = GrownStrand { own: vec![last], in_plane: in_plane[last] };
            loop {
                let goes_on = |&&child: &&usize| in_plane[child] == strand.in_plane;
                let next = children[last].iter().filter(goes_on).max_by_key(|&&child| beyond[child]).copied();
                heads.extend(children[last].iter().rev().filter(|&&child| Some(child) != next));
                let Some(next) = next else { break };
                strand.own.push(next);
                last = next;
            }
            strands.push(strand);
        }
        Grown { strands, roots }
    }
}

/// Whether a section is in the mirror plane, and the step that leads there.
fn lies_in_plane(section: &BeamSection) -> bool {
    let mut across = ModeShapes::ACROSS.into_iter().flat_map(|row| section.steps.row(row));
    section.position.y == 0.0 && across.all(|&step| step == 0.0)
}

/// The modes that move what grows from each section next to O.
fn modes_that_move(sections: &[&BeamSection], roots: &[usize], modes: usize) -> Vec<Vec<usize>> {
    let mut moved = vec![Vec::new(); sections.len()];
    for mode in 0..modes {
        let step = |section: &&BeamSection| largest((0..6).map(|row| section.steps.row(row)[mode]));
        let steps: Vec<f64> = sections.iter().map(step).collect();
        let least = ROUNDING * largest(steps.iter().copied());
        for (&root, &step) in roots.iter().zip(&steps) {
            if step > least && moved[root].last() != Some(&mode) {
                moved[root].push(mode);
            }
        }
    }
    moved
}

//! Chains: elements one after the other between two bodies where more than two meet, or one, or where two meet as different beams do.

use nalgebra::Vector3;

use super::super::members::Member;
use super::SAME_PLACE;

/// Places are in the plane of symmetry within this share of the aircraft.
const IN_PLANE: f64 = 1e-6;

/// Cosine of the sharpest turn within a chain, 60°.
const ONWARD: f64 = 0.5;

/// Elements with the bodies before, between and behind them.
#[derive(Clone, Debug)]
pub struct Chain {
    pub elements: Vec<usize>,
    pub bodies: Vec<usize>,
}

/// Elements in space, with the bodies at their ends.
#[derive(Clone, Copy)]
pub struct Graph<'a> {
    pub members: &'a [Member],
    pub ends: &'a [[usize; 2]],
    pub root: usize,
    /// Distance of the plane of symmetry from the zero of the deck, m, and the size of the aircraft.
    pub plane: f64,
    pub size: f64,
}

/// Which chains loops are cut at rather than at others: the greatest first.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Readiness {
    /// Rods and pinned ones have least to lose.
    is_pinned: bool,
    /// Those in the plane of symmetry last, and from side to side first: both sides stay alike.
    across: u8,
    softness: f64,
}

impl Graph<'_> {
    /// All chains of elements that strain; a ring that hangs on nothing is in none.
    pub fn chains(&self, count: usize) -> Vec<Chain> {
        let mut at: Vec<Vec<usize>> = vec![Vec::new(); count];
        for (element, [one, other]) in self.ends.iter().enumerate().filter(|(_, [one, other])| one != other) {
            at[*one].push(element);
            at[*other].push(element);
        }
        let is_end = |body: usize| match at[body][..] {
            [one, other] => body == self.root || self.is_break(body, [one, other]),
            _ => true,
        };
        let mut is_taken = vec![false; self.ends.len()];
        let mut chains = Vec::new();
        for body in (0..count).filter(|body| is_end(*body)) {
            for &first in &at[body] {
                if is_taken[first] {
                    continue;
                }
                let mut chain = Chain { elements: Vec::new(), bodies: vec![body] };
                let mut next = Some(first);
                while let Some(element) = next {
                    is_taken[element] = true;
                    let here = self.other_end(element, chain.last_body());
                    chain.elements.push(element);
                    chain.bodies.push(here);
                    next = at[here].iter().copied().find(|other| *other != element && !is_end(here));
                }
                chains.push(chain);
            }
        }
        chains
    }

    /// Whether two elements that meet at a body are of different beams: at a corner, at a pin, where a rod meets a bar.
    fn is_break(&self, body: usize, elements: [usize; 2]) -> bool {
        let ends = elements.map(|element| usize::from(self.ends[element][0] != body));
        let away = |side: usize| {
            let member = &self.members[elements[side]];
            (member.ends[1 - ends[side]] - member.ends[ends[side]]).normalize()
        };
        let pins = [0, 1].map(|side| self.members[elements[side]].pins[ends[side]].as_ref());
        let is_rod = pins.map(|pin| pin.is_some_and(|pin| pin.field.is_none()));
        let is_pinned = pins.iter().flatten().any(|pin| pin.field.is_some());
        is_pinned || is_rod[0] != is_rod[1] || -away(0).dot(&away(1)) < ONWARD
    }

    fn other_end(&self, element: usize, body: usize) -> usize {
        let [one, other] = self.ends[element];
        if one == body { other } else { one }
    }

    /// Which end of the element at a place in a chain is the nearer to the chain's first body.
    pub fn first_end(&self, chain: &Chain, place: usize) -> usize {
        usize::from(self.ends[chain.elements[place]][0] != chain.bodies[place])
    }

    /// The element at the beginning or the end of a chain, and which of its ends is there.
    pub fn outer(&self, chain: &Chain, is_last: bool) -> (usize, usize) {
        let place = if is_last { chain.elements.len() - 1 } else { 0 };
        let end = self.first_end(chain, place);
        (chain.elements[place], if is_last { 1 - end } else { end })
    }

    fn is_pinned(&self, chain: &Chain, is_last: bool) -> bool {
        let (element, end) = self.outer(chain, is_last);
        self.members[element].pins[end].is_some()
    }

    fn place_of(&self, (element, end): (usize, usize)) -> Vector3<f64> {
        self.members[element].ends[end]
    }

    fn is_in_plane(&self, place: &Vector3<f64>) -> bool {
        (place.y - self.plane).abs() <= IN_PLANE * self.size
    }

    /// How readily a loop is cut at a chain.
    pub fn readiness(&self, chain: &Chain) -> Readiness {
        let is_pinned = [false, true].into_iter().any(|is_last| self.is_pinned(chain, is_last));
        let mut places = chain.elements.iter().flat_map(|&element| self.members[element].ends);
        let across = match () {
            () if places.all(|place| self.is_in_plane(&place)) => 0,
            () if self.middle(chain).is_some() => 2,
            () => 1,
        };
        let softest = chain.elements.iter().map(|&element| self.members[element].stiffness.softest());
        Readiness { is_pinned, across, softness: -softest.fold(f64::INFINITY, f64::min) }
    }

    /// Where a chain that goes from one side to the other alike crosses the plane of symmetry: the place of a body in it.
    fn middle(&self, chain: &Chain) -> Option<usize> {
        let [first, last] = [false, true].map(|is_last| self.place_of(self.outer(chain, is_last)));
        let image = Vector3::new(first.x, 2.0 * self.plane - first.y, first.z);
        if self.is_in_plane(&first) || (image - last).norm() > IN_PLANE * self.size {
            return None;
        }
        (1..chain.elements.len()).find(|&place| {
            let before = self.members[chain.elements[place - 1]].ends[1 - self.first_end(chain, place - 1)];
            let behind = self.members[chain.elements[place]].ends[self.first_end(chain, place)];
            self.is_in_plane(&behind) && (before - behind).norm() <= SAME_PLACE
        })
    }

    /// The place in a chain at which a loop is cut: the elements before it hang on the first body, those behind on the last. In the plane
    /// of symmetry, if the chain crosses it; else at a pinned end, or at the one that is farther from the root.
    pub fn cut(&self, chain: &Chain, from_root: &[f64]) -> usize {
        let last = chain.elements.len();
        self.middle(chain).unwrap_or_else(|| {
            let [first, other] = [from_root[chain.bodies[0]], from_root[chain.last_body()]];
            match [false, true].map(|is_last| self.is_pinned(chain, is_last)) {
                [true, false] => 0,
                [false, true] => last,
                _ if first > other + IN_PLANE * self.size => 0,
                _ => last,
            }
        })
    }
}

impl Chain {
    pub fn last_body(&self) -> usize {
        self.bodies[self.bodies.len() - 1]
    }
}

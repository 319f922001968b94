//! Mirror images in y = 0 in a tree of beams, found branch by branch from O.
//!
//! Nodes may share a place without being joined: a strut that touches a wing, tail booms that meet a tailplane, the
//! two halves of a tailplane that meet. What is whose image is therefore a matter of the branches that lead there,
//! not of places.

use super::model::{Aircraft, Attachment};

/// Fractions of a beam's length that differ by less are equal.
pub(super) const CLOSE: f64 = 1e-9;

/// The tree of an aircraft's beams. Every node but O is the end of one beam, which is called by that node.
pub(crate) struct Branches {
    /// The node before each, O before itself.
    parents: Vec<usize>,
    /// The nodes after each.
    children: Vec<Vec<usize>>,
    /// The end node of each beam.
    ends: Vec<usize>,
}

/// Where something sits in the tree: at a node, whichever of its beams carries it, or within a beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Section {
    Node(usize),
    /// The beam's end node, and the fraction of its length.
    Within(usize, f64),
}

impl Branches {
    pub(crate) fn of(aircraft: &Aircraft) -> Self {
        let mut branches = Branches {
            parents: vec![0; aircraft.nodes.len()],
            children: vec![Vec::new(); aircraft.nodes.len()],
            ends: aircraft.beams.iter().map(|beam| beam.nodes[1]).collect(),
        };
        for [from, to] in aircraft.beams.iter().map(|beam| beam.nodes) {
            branches.parents[to] = from;
            branches.children[from].push(to);
        }
        branches
    }

    /// The node before another one on the way from O.
    pub(crate) fn parent(&self, node: usize) -> usize {
        self.parents[node]
    }

    /// The end nodes of the beams on the way from a node to another one.
    pub(crate) fn between(&self, [one, other]: [usize; 2]) -> Vec<usize> {
        let to_origin = |node: usize| {
            std::iter::successors(Some(node), |&node| Some(self.parents[node]).filter(|_| node != 0))
        };
        let beyond_origin = |node: usize| to_origin(node).take_while(|&node| node != 0).collect::<Vec<_>>();
        let (ones, others) = (beyond_origin(one), beyond_origin(other));
        let apart = |own: &[usize], their: &[usize]| {
            own.iter().copied().filter(|node| !their.contains(node)).collect::<Vec<_>>()
        };
        [apart(&ones, &others), apart(&others, &ones)].concat()
    }

    /// The image of each node, if it has one, each taken once; `alike` says whether a node with the beam that ends
    /// there is, by itself, the image of another one with its beam. Whole branches go before single beams.
    pub(crate) fn images(&self, alike: &dyn Fn(usize, usize) -> bool) -> Vec<Option<usize>> {
        let mut images = vec![None; self.parents.len()];
        images[0] = Some(0);
        let mut pairs = vec![(0, 0)];
        while let Some((node, image)) = pairs.pop() {
            let fits: [&dyn Fn(usize, usize) -> bool; 2] =
                [&|one, other| self.mirror(one, other, alike), &|one, other| alike(one, other)];
            for fits in fits {
                for &child in &self.children[node] {
                    if images[child].is_some() {
                        continue;
                    }
                    // In the plane a branch may be its own image.
                    let itself = (node == image).then_some(child);
                    let mut candidates = itself.into_iter().chain(self.children[image].iter().copied());
                    let found = candidates.find(|&other| images[other].is_none() && fits(child, other));
                    if let Some(other) = found {
                        (images[child], images[other]) = (Some(other), Some(child));
                        pairs.push((child, other));
                    }
                }
            }
        }
        images
    }

    /// Whether the whole branches that begin with two beams are images of each other.
    fn mirror(&self, one: usize, other: usize, alike: &dyn Fn(usize, usize) -> bool) -> bool {
        let (mut one, mut other) = (one, other);
        loop {
            if !alike(one, other) {
                return false;
            }
            match (self.children[one].as_slice(), self.children[other].as_slice()) {
                ([next], [other_next]) => (one, other) = (*next, *other_next),
                (ones, others) => {
                    return one_to_one(ones, others, |one, other| self.mirror(one, other, alike));
                }
            }
        }
    }

    pub(super) fn section(&self, attachment: Attachment) -> Section {
        let end = self.ends[attachment.beam];
        match attachment.fraction {
            fraction if fraction <= CLOSE => Section::Node(self.parents[end]),
            fraction if fraction >= 1.0 - CLOSE => Section::Node(end),
            fraction => Section::Within(end, fraction),
        }
    }
}

/// Whether each of some things fits one of some others, each taken once.
pub(super) fn one_to_one<T: Copy>(ones: &[T], others: &[T], fits: impl Fn(T, T) -> bool) -> bool {
    let mut free = others.to_vec();
    let mut take = |one: T| {
        let found = free.iter().position(|&other| fits(one, other));
        found.map(|place| free.swap_remove(place)).is_some()
    };
    ones.len() == others.len() && ones.iter().all(|&one| take(one))
}

impl Section {
    /// Whether another section is the image of this one.
    pub(super) fn mirrors(self, other: Section, images: &[Option<usize>]) -> bool {
        match (self, other) {
            (Section::Node(one), Section::Node(other)) => images[one] == Some(other),
            (Section::Within(one, fraction), Section::Within(other, other_fraction)) => {
                images[one] == Some(other) && (fraction - other_fraction).abs() <= CLOSE
            }
            _ => false,
        }
    }
}

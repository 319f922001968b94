//! Modes that only together are what a symmetric aircraft has: a basis with one of them and not the other bends one wing.
//!
//! [theory: structure.pairs]
//!
//! Clamped at O, left and right wing swing by themselves. With a mirror plane their modes are combined to symmetric and
//! antisymmetric ones; the least trace of asymmetry leaves one mode of either wing, alike but mirrored, at almost the same
//! frequency. Modes of exactly the same frequency are a pair too, for any mixture of them is a mode.

use nalgebra::{DMatrix, DVector, Vector3};

use crate::aircraft::Aircraft;

use super::Mode;
use super::mirror::SIGN;

/// Frequencies within this (relative) are the same.
const DEGENERATE: f64 = 1e-6;

/// Mirror images have frequencies within this (relative).
const ALIKE: f64 = 0.1;

/// How much of a mode's energy must be that of another one's mirror image. Two modes of a pair in any mixture share 1.
const MIRRORED: f64 = 0.25;

/// Nodes count as mirror images within this part of the aircraft's size.
const NEAR: f64 = 1e-2;

/// Nodes nearer to each other, in parts of the aircraft's size, share a place.
const SAME_PLACE: f64 = 1e-9;

/// An aircraft held against a mirror in y = 0 that it need not have.
pub(super) struct Pairs<'a> {
    /// Node → the node at its mirrored place, if there is one.
    image: Vec<Option<usize>>,
    mass: &'a DMatrix<f64>,
}

/// Node → the one of its component's mirror image, itself where there is none.
fn images_by_component(aircraft: &Aircraft) -> Vec<usize> {
    let mut images: Vec<usize> = (0..aircraft.nodes.len()).collect();
    for component in &aircraft.components {
        let Some(image) = component.image else { continue };
        // Its first node is of the component on which it hangs.
        for (&node, &image) in component.nodes.iter().zip(&aircraft.components[image].nodes).skip(1) {
            images[node] = image;
        }
    }
    images
}

impl<'a> Pairs<'a> {
    /// Of an aircraft with this mass matrix of its nodal unknowns.
    pub fn new(aircraft: &Aircraft, mass: &'a DMatrix<f64>) -> Self {
        let nodes = &aircraft.nodes;
        let size = nodes.iter().map(Vector3::norm).fold(0.0, f64::max);
        let by_component = images_by_component(aircraft);
        let image = |node: usize| {
            let mirrored = Vector3::new(nodes[node].x, -nodes[node].y, nodes[node].z);
            let distance = |other: usize| (nodes[other] - mirrored).norm();
            let nearest = (0..nodes.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b)))?;
            let own = by_component[node];
            let chosen = if distance(own) <= distance(nearest) + SAME_PLACE * size { own } else { nearest };
            (distance(chosen) <= NEAR * size).then_some(chosen)
        };
        Pairs { image: (0..nodes.len()).map(image).collect(), mass }
    }

    /// Marks all modes, lowest frequencies first, that make a pair with one before, as far as bases of up to `count` and the
    /// modes that these need can tell.
    pub fn mark(&self, modes: &mut [(Mode, DVector<f64>)], count: usize) {
        let frequency = |modes: &[(Mode, DVector<f64>)], mode: usize| modes[mode].0.angular_frequency;
        let mut end = count;
        for lower in 0..modes.len() {
            if lower >= end {
                break;
            }
            let near = |upper: &usize| frequency(modes, *upper) <= frequency(modes, lower) * (1.0 + ALIKE);
            let candidates: Vec<usize> = (lower + 1..modes.len()).take_while(near).collect();
            if candidates.is_empty() {
                continue;
            }
            let mirrored = self.mass * self.reflect(&modes[lower].1);
            let makes_a_pair = |upper: usize| {
                let same = frequency(modes, upper) <= frequency(modes, lower) * (1.0 + DEGENERATE);
                let share = modes[upper].1.dot(&mirrored);
                same || share * share > MIRRORED
            };
            if let Some(upper) = candidates.into_iter().rev().find(|&upper| makes_a_pair(upper)) {
                for (mode, _) in &mut modes[lower + 1..=upper] {
                    mode.completes_a_pair = true;
                }
                end = end.max(upper + 1);
            }
        }
    }

    /// The mirror image of a shape.
    fn reflect(&self, shape: &DVector<f64>) -> DVector<f64> {
        let mut reflected = DVector::zeros(shape.len());
        let moving = self.image.iter().enumerate().skip(1);
        for (node, image) in
            moving.filter_map(|(node, image)| Some((node, image.filter(|&image| image > 0)?)))
        {
            for (axis, sign) in SIGN.iter().enumerate() {
                reflected[6 * (node - 1) + axis] = sign * shape[6 * (image - 1) + axis];
            }
        }
        reflected
    }
}

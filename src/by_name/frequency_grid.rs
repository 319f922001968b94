//! Frequencies at which responses are summed up: equally far apart on a logarithmic scale, and closer at roots that are lightly damped
//! [theory: gusts.quadrature].
//!
//! They are equally far apart in
//!
//! ```text
//! N(ω) = n log₁₀ ω + Σ m/π · atan((ω − ω_p)/σ_p)
//! ```
//!
//! over the roots −σ_p ± iω_p: as a function of N the peak |1/(iω − p)|² dω is flat.

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use nalgebra::Complex;

/// n: steps for each decade.
const PER_DECADE: f64 = 24.0;

/// m: steps for each root.
const PER_ROOT: f64 = 8.0;

/// Roots with a larger damping ratio need no frequencies of their own.
const LIGHTLY_DAMPED: f64 = 0.5;

/// Roots are as far from the axis as this part of their frequency, at least.
const LEAST_DAMPED: f64 = 1e-7;

/// N over a range of frequencies.
pub(super) struct FrequencyGrid {
    range: RangeInclusive<f64>,
    /// ω_p and σ_p, rad/s.
    roots: Vec<[f64; 2]>,
}

/// A frequency of a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Node {
    /// ω, rad/s.
    pub frequency: f64,
    /// dω/dN, rad/s.
    pub stretch: f64,
}

impl FrequencyGrid {
    /// Over a range, rad/s, for an aircraft with these roots.
    pub fn new(range: RangeInclusive<f64>, roots: &[Complex<f64>]) -> Self {
        let is_near =
            |root: &&Complex<f64>| range.contains(&root.im) && root.re.abs() < LIGHTLY_DAMPED * root.norm();
        let near = roots.iter().filter(is_near);
        let roots = near.map(|root| [root.im, root.re.abs().max(LEAST_DAMPED * root.im)]).collect();
        FrequencyGrid { range, roots }
    }

    /// How many steps it has at first: a multiple of 4.
    pub fn steps(&self) -> usize {
        4 * (0.25 * self.length()).ceil().max(1.0) as usize
    }

    /// Frequencies in so many equal steps of N, from end to end.
    pub fn nodes(&self, steps: usize) -> Vec<Node> {
        let step = self.length() / steps as f64;
        let mut frequency = *self.range.start();
        let mut nodes = Vec::with_capacity(steps + 1);
        for number in 0..=steps {
            frequency = match number {
                0 => frequency,
                last if last == steps => *self.range.end(),
                _ => self.find(number as f64 * step, frequency),
            };
            // Of a step, so that a sum needs no more.
            nodes.push(Node { frequency, stretch: step / self.density(frequency) });
        }
        nodes
    }

    /// N from end to end.
    fn length(&self) -> f64 {
        self.count(*self.range.end())
    }

    /// N from the least frequency on.
    fn count(&self, frequency: f64) -> f64 {
        let least = *self.range.start();
        let of_root =
            |[at, width]: &[f64; 2]| libm::atan((frequency - at) / width) - libm::atan((least - at) / width);
        let of_roots: f64 = self.roots.iter().map(of_root).sum();
        PER_DECADE * libm::log10(frequency / least) + PER_ROOT / PI * of_roots
    }

    /// dN/dω, s.
    fn density(&self, frequency: f64) -> f64 {
        let of_root = |[at, width]: &[f64; 2]| {
            let distance = (frequency - at) / width;
            1.0 / (width * (1.0 + distance * distance))
        };
        let of_roots: f64 = self.roots.iter().map(of_root).sum();
        PER_DECADE / (frequency * std::f64::consts::LN_10) + PER_ROOT / PI * of_roots
    }

    /// Where N has a value, above a frequency.
    fn find(&self, value: f64, above: f64) -> f64 {
        let (mut low, mut high) = (above, *self.range.end());
        while high - low > 1e-14 * high {
            let middle = 0.5 * (low + high);
            // Between neighbouring numbers there is none.
            if middle <= low || middle >= high {
                break;
            }
            if self.count(middle) < value { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A peak two thousand times narrower than its frequency, beside a broad one.
    #[test]
    fn the_area_of_narrow_peaks_is_found_with_few_frequencies() {
        let roots = [Complex::new(-0.05, 103.5), Complex::new(-1.0, 3.0), Complex::new(-200.0, 1.0)];
        let grid = FrequencyGrid::new(0.05..=300.0, &roots);
        assert_eq!(grid.roots.len(), 2);
        let peak = |[at, width]: [f64; 2]| {
            let antiderivative = |frequency: f64| libm::atan((frequency - at) / width) / width;
            let exact = antiderivative(300.0) - antiderivative(0.05);
            // Halved twice.
            let steps = 4 * grid.steps();
            let nodes = grid.nodes(steps);
            assert!(nodes.is_sorted_by(|one, other| one.frequency < other.frequency));
            let found: f64 = nodes
                .iter()
                .enumerate()
                .map(|(number, node)| {
                    let weight = if number == 0 || number == steps { 0.5 } else { 1.0 };
                    weight * node.stretch / (width * width + (node.frequency - at) * (node.frequency - at))
                })
                .sum();
            found / exact - 1.0
        };
        let [narrow, broad] = [[103.5, 0.05], [3.0, 1.0]].map(peak);
        assert!(narrow.abs() < 1e-4 && broad.abs() < 1e-6, "{narrow:e} {broad:e}");
        assert!(grid.steps() < 110, "{}", grid.steps());
    }
}

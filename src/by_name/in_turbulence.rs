//! Loads in continuous turbulence: the rms of outputs by that of the turbulence [theory: gusts.continuous, gusts.quadrature].

use std::f64::consts::TAU;
use std::ops::RangeInclusive;

use nalgebra::{Complex, DMatrix};

use crate::air::TurbulenceSettings;
use crate::plant::{EigenvaluesNotFound, product};

use super::frequency_grid::{FrequencyGrid, Node};
use super::harmonic_gusts::HarmonicGusts;

/// Frequencies of turbulence that count, rad/s.
const FREQUENCIES: RangeInclusive<f64> = 0.05..=300.0;

/// Steps of the frequencies are halved until no Ā is moved by more than this part of it, and was not moved much more by the halving
/// before, for a single one may leave it by chance; or until there are so many.
const TOLERANCE: f64 = 2e-4;
const TOLERANCE_BEFORE: f64 = 1e-3;
const MOST_STEPS: usize = 1 << 15;

/// Ā below this part of the largest of its unit is left out of account, and less is rounding.
const SMALL: f64 = 1e-6;
const ROUNDING: f64 = 1e-9;

/// Roots that grow faster than this are unstable, 1/s, those below the frequencies that count left out.
const GROWS: f64 = 1e-6;

/// How many harmonic gusts are evaluated together.
const TOGETHER: usize = 64;

/// Outputs in continuous turbulence with an rms of 1 m/s.
#[derive(Clone, Debug, PartialEq)]
pub struct InTurbulence {
    /// ω of the densities, rad/s, ascending.
    pub frequencies: Vec<f64>,
    /// One for each output that was asked for.
    pub outputs: Vec<OutputInTurbulence>,
    /// By which part of it any Ā was moved at most when the steps of the frequencies were last halved: at most 2e-4, but where a root
    /// is so lightly damped that 32 768 steps did not do.
    pub moved: f64,
    /// Roots of the aircraft that grow, 1/s, one of each pair: with them no motion is ever stationary.
    pub unstable: Vec<Complex<f64>>,
}

/// An output in continuous turbulence with an rms of 1 m/s.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputInTurbulence {
    /// Ā: its rms about the trim, per m/s.
    pub rms: f64,
    /// N0: how often it comes through its mean upwards, Hz.
    pub crossings: f64,
    /// |H|²Φ at each frequency, per (m/s)² and per rad/s.
    pub densities: Vec<f64>,
}

/// |H|²Φ of every output at a frequency.
type Densities = Vec<f64>;

impl HarmonicGusts {
    /// Some outputs, by their places among those of the linear model, in turbulence of some spectrum and scale across the track in
    /// a direction (0 upwards, positive to the right, rad), between 0.05 and 300 rad/s. Intensity and the rest of the settings do
    /// not count; without a spectrum nothing moves. Allocates.
    ///
    /// # Errors
    /// When the eigenvalues of the linear model do not converge.
    pub fn in_turbulence(
        &self,
        direction: f64,
        turbulence: &TurbulenceSettings,
        outputs: &[usize],
    ) -> Result<InTurbulence, EigenvaluesNotFound> {
        let roots = self.linear_model().eigenvalues()?;
        let grid = FrequencyGrid::new(FREQUENCIES, &roots);
        let asked = Asked {
            gusts: self,
            direction,
            turbulence,
            c: self.linear_model().c.select_rows(outputs),
            outputs,
        };
        let mut nodes = grid.nodes(grid.steps());
        let mut densities = asked.densities(&nodes);
        let moved = loop {
            let [coarse, middle, fine] = [4, 2, 1].map(|every| Moments::of(&nodes, &densities, every));
            let before = self.largest_change(outputs, &coarse, &middle);
            let moved = self.largest_change(outputs, &middle, &fine);
            if moved <= TOLERANCE && before <= TOLERANCE_BEFORE || nodes.len() > MOST_STEPS {
                break moved;
            }
            (nodes, densities) = asked.halved(&grid, densities);
        };
        let moments = Moments::of(&nodes, &densities, 1);
        let largest = self.largest_of_units(outputs, &moments);
        let found = moments.iter().zip(largest).enumerate().map(|(place, (moments, largest))| {
            let is_there = moments.rms() > ROUNDING * largest;
            OutputInTurbulence {
                rms: if is_there { moments.rms() } else { 0.0 },
                crossings: if is_there { moments.crossings() } else { 0.0 },
                densities: densities.iter().map(|densities| densities[place]).collect(),
            }
        });
        let is_unstable =
            |root: &&Complex<f64>| root.re > GROWS && root.im >= 0.0 && root.norm() >= *FREQUENCIES.start();
        Ok(InTurbulence {
            frequencies: nodes.iter().map(|node| node.frequency).collect(),
            outputs: found.collect(),
            moved,
            unstable: roots.iter().filter(is_unstable).copied().collect(),
        })
    }

    /// By which part of it any rms differs between a coarse and a fine sum.
    fn largest_change(&self, outputs: &[usize], coarse: &[Moments], fine: &[Moments]) -> f64 {
        let changes = coarse.iter().zip(fine).zip(self.largest_of_units(outputs, fine));
        let change = |((coarse, fine), largest): ((&Moments, &Moments), f64)| {
            let is_of_account = fine.rms() > SMALL * largest;
            if is_of_account { (coarse.rms() / fine.rms() - 1.0).abs() } else { 0.0 }
        };
        changes.map(change).fold(0.0, f64::max)
    }

    /// Of each output the largest rms of any that has its unit.
    fn largest_of_units(&self, outputs: &[usize], moments: &[Moments]) -> Vec<f64> {
        let unit = |place: usize| self.linear_model().outputs[outputs[place]].unit;
        let of_unit = |here: usize| {
            let alike = moments.iter().enumerate().filter(|(place, _)| unit(*place) == unit(here));
            alike.map(|(_, moments)| moments.rms()).fold(0.0, f64::max)
        };
        (0..moments.len()).map(of_unit).collect()
    }
}

/// What is asked of an aircraft in harmonic gusts.
struct Asked<'g> {
    gusts: &'g HarmonicGusts,
    direction: f64,
    turbulence: &'g TurbulenceSettings,
    /// The rows of C.
    c: DMatrix<f64>,
    outputs: &'g [usize],
}

impl Asked<'_> {
    /// At each node.
    fn densities(&self, nodes: &[Node]) -> Vec<Densities> {
        let mut densities = Vec::with_capacity(nodes.len());
        for nodes in nodes.chunks(TOGETHER) {
            let frequencies: Vec<f64> = nodes.iter().map(|node| node.frequency).collect();
            let columns = self.gusts.columns(self.direction, &frequencies);
            densities.extend(frequencies.iter().zip(columns).map(|(&frequency, column)| {
                let speed = self.gusts.speed();
                let spectrum = self.turbulence.density(frequency / speed, false) / speed;
                // On a root itself nothing stands to be summed up; its neighbours say that it is there.
                let states = self.gusts.states(frequency, &column).unwrap_or(column.b * Complex::from(0.0));
                let amplitudes = product(&self.c, &states);
                let all = amplitudes.iter().zip(self.outputs);
                all.map(|(amplitude, &output)| (amplitude + column.d[output]).norm_sqr() * spectrum).collect()
            }));
        }
        densities
    }

    /// With a node in each step between those of a grid at which densities are known.
    fn halved(&self, grid: &FrequencyGrid, known: Vec<Densities>) -> (Vec<Node>, Vec<Densities>) {
        let nodes = grid.nodes(2 * (known.len() - 1));
        let between: Vec<Node> = nodes.iter().copied().skip(1).step_by(2).collect();
        let mut between = self.densities(&between).into_iter();
        let densities = known.into_iter().flat_map(|known| [Some(known), between.next()]).flatten().collect();
        (nodes, densities)
    }
}

/// ∫ |H|²Φ dω and ∫ ω² |H|²Φ dω.
#[derive(Clone, Copy, Debug, Default)]
struct Moments {
    square: f64,
    of_rates: f64,
}

impl Moments {
    /// Of each output, by the trapezoidal rule over every node, or every second or fourth one of a multiple of four steps.
    fn of(nodes: &[Node], densities: &[Densities], every: usize) -> Vec<Self> {
        let mut moments = vec![Moments::default(); densities.first().map_or(0, Vec::len)];
        let last = nodes.len() - 1;
        for (number, (node, densities)) in nodes.iter().zip(densities).enumerate().step_by(every) {
            let weight = if number == 0 || number == last { 0.5 } else { 1.0 };
            let width = weight * every as f64 * node.stretch;
            for (moments, density) in moments.iter_mut().zip(densities) {
                moments.square += width * density;
                moments.of_rates += width * density * node.frequency * node.frequency;
            }
        }
        moments
    }

    fn rms(&self) -> f64 {
        libm::sqrt(self.square)
    }

    /// Hz.
    fn crossings(&self) -> f64 {
        libm::sqrt(self.of_rates / self.square) / TAU
    }
}

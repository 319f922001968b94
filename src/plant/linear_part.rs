//! The linear part of ẋ that a flight integrates exactly: ẋ = L x + N [theory: integration.linear-part].
//!
//! L is diagonal in coordinates of its own: those of the state, but for amplitudes of the free modes in the place of the
//! structure's. It is made of the free modes about a trim and of the decay of the wake at a reference airspeed. Any L is
//! right, a good one leaves little to N.

use std::ops::Range;

use crate::equations::StateLayout;
use crate::math::{AlignedNumbers, zeros};

use super::amplitudes::Amplitudes;
use super::free_modes::FreeModes;
use super::system::Plant;
use super::trim::Trim;

/// A diagonal matrix in the layout of the state: for the real states a number, for the complex ones the real part
/// in the place of their real and the imaginary part in that of their imaginary part.
pub type Diagonal = AlignedNumbers;

/// Which states stand alone, and which are the two parts of complex ones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spectrum {
    /// Places of the real states.
    pub real: [Range<usize>; 2],
    /// Places of the complex states' real parts, and of their imaginary parts.
    pub complex: [(Range<usize>, Range<usize>); 2],
}

/// L, and the coordinates in which it is diagonal.
///
/// ```
/// # use flexible_aircraft::{Aircraft, ReducedModel, plant::{Plant, PlantSettings}};
/// # let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
/// # let settings = PlantSettings::of(&jet);
/// let plant = Plant::under(&jet, &settings)?;
/// let trim = plant.trim(&settings.trim_condition())?;
/// let mut linear = plant.linear_part(&trim);
/// linear.take_airspeed(&plant, jet.airspeed); // m/s
/// // The wake and the structure decay, the rigid motion is left to the rest.
/// assert!(linear.diagonal()[plant.layout().inflow_layout().real()].iter().all(|rate| *rate < 0.0)); // 1/s
/// assert!(linear.diagonal()[plant.layout().rigid()].iter().all(|rate| *rate == 0.0));
/// // Between the state's coordinates and those of L there is a way back.
/// let mut state = trim.state.clone();
/// linear.enter(&mut state);
/// linear.leave(&mut state);
/// assert!(state.iter().zip(&trim.state).all(|(back, there)| (back - there).abs() < 1e-9));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct LinearPart {
    spectrum: Spectrum,
    amplitudes: Amplitudes,
    /// 1/s.
    diagonal: Diagonal,
    /// At which the wake's was taken, m/s.
    airspeed: f64,
}

impl Spectrum {
    /// Of states of a layout whose coordinates are amplitudes of modes.
    pub fn new(layout: &StateLayout) -> Self {
        Spectrum {
            real: [layout.rigid(), layout.inflow_layout().real()],
            complex: [
                (layout.coordinate_rates(), layout.coordinates()),
                (layout.inflow_layout().re(), layout.inflow_layout().im()),
            ],
        }
    }
}

impl Plant {
    /// The linear part of ẋ about a trim of this plant, that of the wake still to be [taken](LinearPart::take_airspeed).
    /// Allocates.
    pub fn linear_part(&self, trim: &Trim) -> LinearPart {
        let modes = FreeModes::new(&self.equations, &trim.state, &trim.controls);
        LinearPart::new(self.layout(), modes)
    }
}

impl LinearPart {
    /// For states of a layout with these free modes, in still air.
    pub(crate) fn new(layout: &StateLayout, modes: Option<FreeModes>) -> Self {
        let amplitudes = Amplitudes::new(layout, modes);
        let mut diagonal = zeros(layout.len());
        amplitudes.write_linear_part(&mut diagonal);
        LinearPart { spectrum: Spectrum::new(layout), amplitudes, diagonal, airspeed: 0.0 }
    }

    /// Takes the decay of a plant's wake at an airspeed (m/s); returns whether that is another one than before.
    pub fn take_airspeed(&mut self, plant: &Plant, airspeed: f64) -> bool {
        let is_new = airspeed != self.airspeed;
        if is_new {
            self.airspeed = airspeed;
            plant.equations.inflow_linear_part(airspeed, &mut self.diagonal);
        }
        is_new
    }

    /// At which the wake's decay was taken last, m/s; 0 in the beginning, when it has none.
    pub fn airspeed(&self) -> f64 {
        self.airspeed
    }

    /// L, 1/s, in the layout of the state.
    pub fn diagonal(&self) -> &[f64] {
        &self.diagonal
    }

    /// Which of its states are complex.
    pub fn spectrum(&self) -> &Spectrum {
        &self.spectrum
    }

    /// Which states have other coordinates here.
    #[inline(always)]
    pub fn changed(&self) -> Range<usize> {
        self.amplitudes.range()
    }

    /// Replaces the state's coordinates by those of L, in a state or in a rate of change of one.
    #[inline(always)]
    pub fn enter(&mut self, state: &mut [f64]) {
        self.amplitudes.enter(state);
    }

    /// Replaces the coordinates of L by those of the state.
    #[inline(always)]
    pub fn leave(&mut self, state: &mut [f64]) {
        self.amplitudes.leave(state);
    }

    /// Has another diagonal written over that of the wake.
    #[cfg(test)]
    pub(crate) fn with_diagonal(mut self, write: impl FnOnce(&mut [f64])) -> Self {
        write(&mut self.diagonal);
        self
    }
}

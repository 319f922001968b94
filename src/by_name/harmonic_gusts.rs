//! What an aircraft answers to harmonic gusts that are frozen in the air, each strip at its own time
//! [theory: linearisation.harmonic-gusts].

use std::sync::Arc;

use nalgebra::{Complex, DVector};

use crate::air::{GustWave, ImposedGust};
use crate::flight::{Settings, SimulationError};
use crate::plant::{ConditionSettings, ManoeuvreChoice, SettingError, product};
use crate::structure::ReducedModel;

use super::at_trim::AtTrim;
use super::linear_model::{LinearContents, LinearModel};
use super::resolvent::Resolvent;

/// An aircraft that is linearised about the trim with which a flight begins, in harmonic gusts.
///
/// A gust of unit amplitude is the velocity e^{iω(t + s/V)} of the air at a distance s ahead of O along the track: its phase is
/// that at O, and what is ahead meets it earlier. No delay is rounded: every strip meets it at three points of its chord.
///
/// ```
/// use flexible_aircraft::{Aircraft, HarmonicGusts, flight::Settings};
///
/// let jet = Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
/// let mut settings = Settings::of(&jet);
/// settings.plant.mode_count = 2;
/// let gusts = HarmonicGusts::new(jet, &settings)?;
/// let amplitudes = gusts.response(0.0, 3.0).ok_or("no root at 3i")?; // upwards, 3 rad/s
/// let load_factor = gusts.linear_model().outputs.iter().position(|output| output.name == "load_factor.z");
/// let amplitude = amplitudes[load_factor.ok_or("no such output")?].norm(); // per m/s
/// assert!((0.01..0.1).contains(&amplitude), "{amplitude}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct HarmonicGusts {
    at_trim: AtTrim,
    linear: LinearModel,
    resolvent: Resolvent,
}

/// What a harmonic gust of unit amplitude does: ẋ = A x + B_g e^{iωt}, y = C x + D_g e^{iωt}.
#[derive(Clone, Debug, PartialEq)]
pub struct HarmonicColumn {
    /// B_g, an entry for each state of the linear model.
    pub b: DVector<Complex<f64>>,
    /// D_g, an entry for each output.
    pub d: DVector<Complex<f64>>,
}

impl HarmonicGusts {
    /// Linearises an aircraft about the trim of some settings, whose gust and turbulence are left out. Allocates.
    ///
    /// # Errors
    /// When a setting is out of range or no flight could begin with them; in turns and pull-ups, whose path leaves the gust's track.
    pub fn new(model: impl Into<Arc<ReducedModel>>, settings: &Settings) -> Result<Self, SimulationError> {
        check_straight(&settings.plant.condition)?;
        let at_trim = AtTrim::new(model.into(), settings, LinearContents::default())?;
        let linear = at_trim.linear_model();
        let resolvent = Resolvent::new(&linear.a, at_trim.wake());
        Ok(HarmonicGusts { at_trim, linear, resolvent })
    }

    /// The linear model without gusts.
    pub fn linear_model(&self) -> &LinearModel {
        &self.linear
    }

    /// V: how fast the aircraft goes along the track, m/s.
    pub fn speed(&self) -> f64 {
        self.at_trim.way.track.speed()
    }

    /// Of gusts in a direction (0 upwards, positive to the right, rad), for each ω, rad/s.
    pub fn columns(&self, direction: f64, frequencies: &[f64]) -> Vec<HarmonicColumn> {
        let (sin, cos) = libm::sincos(direction);
        let strength = [0.0, sin, -cos];
        let waves = frequencies.iter().flat_map(|frequency| {
            let wave_number = frequency / self.speed();
            [GustWave::Cosine(wave_number), GustWave::Sine(wave_number)]
        });
        let gusts: Vec<ImposedGust> = waves.map(|wave| ImposedGust { wave, strength }).collect();
        let found = self.at_trim.linear_gusts(&gusts);
        let column = |number: usize| {
            let parts = |matrix: &nalgebra::DMatrix<f64>| {
                matrix.column(2 * number).zip_map(&matrix.column(2 * number + 1), Complex::new)
            };
            // Actuators and engines that lag come behind the states of the plant, and no gust acts on them.
            let b = parts(&found.b).resize_vertically(self.linear.states.len(), Complex::from(0.0));
            HarmonicColumn { b, d: parts(&found.d) }
        };
        (0..frequencies.len()).map(column).collect()
    }

    /// Amplitudes of all outputs in a gust of unit amplitude in a direction (0 upwards, positive to the right, rad) at ω, rad/s:
    /// C (iω − A)⁻¹ B_g + D_g; `None` where iω is an eigenvalue of A.
    pub fn response(&self, direction: f64, frequency: f64) -> Option<DVector<Complex<f64>>> {
        let column = self.columns(direction, &[frequency]).pop()?;
        let states = self.states(frequency, &column)?;
        Some(product(&self.linear.c, &states) + column.d)
    }

    /// Amplitudes of the states under a column.
    pub(super) fn states(&self, frequency: f64, column: &HarmonicColumn) -> Option<DVector<Complex<f64>>> {
        self.resolvent.solve(frequency, &column.b)
    }
}

/// That the path is the track along which gusts are frozen.
fn check_straight(condition: &ConditionSettings) -> Result<(), SettingError> {
    let found = match condition.manoeuvre {
        ManoeuvreChoice::Straight => return Ok(()),
        ManoeuvreChoice::Turn => "turn",
        ManoeuvreChoice::PullUp => "pull_up",
    };
    let allowed = "straight in harmonic gusts and turbulence: the path of others leaves the track along which these are frozen";
    let [setting, found] = ["condition.manoeuvre", found].map(str::to_owned);
    Err(SettingError { setting, found, allowed: allowed.to_owned() })
}

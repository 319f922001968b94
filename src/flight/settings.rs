//! What a user chooses before the flight.

use std::fmt::Display;

use nalgebra::Vector3;

use crate::aircraft::{ALTITUDES, Support};
use crate::equations::{Configuration, Fidelity};
use crate::plant::{Plant, TrimCondition};
use crate::sealed::{self, Writer};
use crate::strips::PetersInflow;
use crate::structure::{ModeFamily, ReducedModel};
use crate::symmetry::Plants;

use super::error::SimulationError;

/// Which families of modes take part, lowest frequencies first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ModeSelection {
    /// Symmetric and antisymmetric modes together.
    All,
    /// Symmetric modes only.
    Symmetric,
}

/// What the surface and thrust inputs mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum InputReference {
    /// They add to the trim values.
    Trim,
    /// They are the values themselves.
    Absolute,
}

/// Modes that take part unless someone asks for another number, if the aircraft has so many.
const USUAL_MODES: usize = 12;

/// The parameters of a flight.
///
/// ```
/// use flexible_aircraft::equations::Fidelity;
/// use flexible_aircraft::flight::Settings;
/// # use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
/// let fast = Settings { airspeed: 180.0, ..Settings::of(&jet) }; // m/s
/// assert_eq!(fast.choose_modes(&jet)?, [0, 1, 2, 3]);
/// let rigid = Settings { fidelity: Fidelity::Rigid, ..fast.clone() };
/// assert_eq!(rigid.plant(&jet)?.layout().modes(), 0);
/// let refused = Settings { airspeed: -1.0, ..fast }.plant(&jet).unwrap_err();
/// assert_eq!(refused.to_string(), "airspeed: found -1, allowed is 1 to 400 (m/s)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Fidelity level.
    pub fidelity: Fidelity,
    /// Trimmed airspeed, m/s, within [`Support::airspeeds`].
    pub airspeed: f64,
    /// Trimmed altitude, m, within [`ALTITUDES`]; of no account in a tunnel with air of its own.
    pub altitude: f64,
    /// Initial yaw angle, rad.
    pub heading: f64,
    /// Factor on all elastic properties, > 0.
    pub stiffness_scale: f64,
    /// Modal damping ratio ζ of every mode, ≥ 0.
    pub structural_damping: f64,
    /// Families of modes.
    pub mode_selection: ModeSelection,
    /// Number of modes, 0…those packaged of the selection; the other one of a pair comes with the last. `Rigid`
    /// ignores it.
    pub mode_count: usize,
    /// Peters inflow states per strip, 0…8; 0 is steady aerodynamics.
    pub inflow_states: usize,
    /// Relative tolerance of the integrator, > 0.
    pub tolerance: f64,
    /// Meaning of the inputs.
    pub input_reference: InputReference,
}

impl Settings {
    /// Those of the FMU of an aircraft before any parameter is set: the aircraft's own flight condition.
    pub fn of(model: &ReducedModel) -> Self {
        Settings {
            fidelity: Fidelity::Exact,
            airspeed: model.airspeed,
            altitude: model.altitude,
            heading: 0.0,
            stiffness_scale: 1.0,
            structural_damping: 0.0,
            mode_selection: ModeSelection::All,
            mode_count: USUAL_MODES.min(model.modes.len()),
            inflow_states: model.inflow_states,
            tolerance: 1e-5,
            input_reference: InputReference::Trim,
        }
    }

    /// Checks every setting against its range and against the model, and chooses the modes: ascending
    /// indices of the packaged modes that take part.
    ///
    /// # Errors
    /// Names the first setting that is out of range.
    pub fn choose_modes(&self, model: &ReducedModel) -> Result<Vec<usize>, SimulationError> {
        self.check_ranges(model.support)?;
        if self.fidelity == Fidelity::Rigid {
            return Ok(Vec::new());
        }
        let candidates: Vec<usize> = (0..model.modes.len())
            .filter(|&mode| {
                self.mode_selection == ModeSelection::All || model.modes[mode].family == ModeFamily::Symmetric
            })
            .collect();
        if self.mode_selection == ModeSelection::Symmetric
            && model.modes.iter().any(|mode| mode.family == ModeFamily::Unsymmetric)
        {
            return refuse("mode_family", "symmetric", "all: the structure has no mirror plane y = 0");
        }
        if self.mode_count > candidates.len() {
            let allowed = format!("0 to {} modes of the chosen family, as packaged", candidates.len());
            return refuse("mode_count", self.mode_count, &allowed);
        }
        let others = &candidates[self.mode_count..];
        let pairs = others.iter().take_while(|&&mode| model.modes[mode].completes_a_pair).count();
        Ok(candidates.into_iter().take(self.mode_count + pairs).collect())
    }

    /// The plant of a whole model under these settings.
    ///
    /// # Errors
    /// When a setting is out of range.
    pub fn plant(&self, model: &ReducedModel) -> Result<Plant, SimulationError> {
        Ok(Plant::of_modes(model, &self.configuration(model), &self.choose_modes(model)?))
    }

    /// The plants of all forms of a model under these settings.
    ///
    /// # Errors
    /// When a setting is out of range.
    pub fn plants(&self, model: &ReducedModel) -> Result<Plants, SimulationError> {
        Ok(Plants::new(model, &self.configuration(model), &self.choose_modes(model)?))
    }

    /// The same, with the heading along the course.
    pub(super) fn along_course(&self) -> Self {
        Settings { heading: 0.0, ..self.clone() }
    }

    /// The flight to be trimmed.
    pub fn trim_condition(&self) -> TrimCondition {
        TrimCondition { airspeed: self.airspeed, altitude: self.altitude, heading: self.heading }
    }

    /// What the settings mean for the equations of a model.
    pub(super) fn configuration(&self, model: &ReducedModel) -> Configuration {
        let tunnel_flow = match model.support {
            Support::Free => Vector3::zeros(),
            Support::Clamped => {
                let (sin, cos) = libm::sincos(self.heading);
                Vector3::new(cos, sin, 0.0) * -self.airspeed
            }
        };
        Configuration {
            fidelity: self.fidelity,
            stiffness_scale: self.stiffness_scale,
            structural_damping: self.structural_damping,
            inflow_states: self.inflow_states,
            tunnel_flow,
        }
    }

    /// Tells settings apart: a hash of their values.
    pub(super) fn hash(&self) -> u128 {
        let Settings {
            fidelity,
            airspeed,
            altitude,
            heading,
            stiffness_scale,
            structural_damping,
            mode_selection,
            mode_count,
            inflow_states,
            tolerance,
            input_reference,
        } = *self;
        let mut bytes = Vec::new();
        let mut writer = Writer::new(&mut bytes);
        for choice in [fidelity as u8, mode_selection as u8, input_reference as u8] {
            writer.byte(choice);
        }
        for count in [mode_count, inflow_states] {
            writer.count(u32::try_from(count).unwrap_or(u32::MAX));
        }
        writer.reals([airspeed, altitude, heading, stiffness_scale, structural_damping, tolerance]);
        sealed::hash(&bytes)
    }

    pub(super) fn check_ranges(&self, support: Support) -> Result<(), SimulationError> {
        let within = |setting, value: f64, inside: bool, allowed: &str| {
            if value.is_finite() && inside { Ok(()) } else { refuse(setting, value, allowed) }
        };
        let Settings { airspeed, altitude, heading, stiffness_scale, structural_damping, tolerance, .. } =
            *self;
        let airspeeds = support.airspeeds();
        let allowed = format!("{} to {} (m/s)", airspeeds.start(), airspeeds.end());
        within("airspeed", airspeed, airspeeds.contains(&airspeed), &allowed)?;
        within("altitude", altitude, ALTITUDES.contains(&altitude), "-1000 to 20000 (m)")?;
        within("heading", heading, true, "a finite number (rad)")?;
        within("stiffness_scale", stiffness_scale, stiffness_scale > 0.0, "a finite number > 0")?;
        within("structural_damping", structural_damping, structural_damping >= 0.0, "a finite number >= 0")?;
        within(
            "tolerance",
            tolerance,
            tolerance > 0.0 && tolerance < 1.0,
            "a number between 0 and 1, exclusive",
        )?;
        if self.inflow_states > PetersInflow::MAX_STATES {
            let allowed = format!("0 to {}", PetersInflow::MAX_STATES);
            return refuse("inflow_states", self.inflow_states, &allowed);
        }
        Ok(())
    }
}

fn refuse<T>(setting: &'static str, found: impl Display, allowed: &str) -> Result<T, SimulationError> {
    Err(SimulationError::Setting { setting, found: found.to_string(), allowed: allowed.to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::variables::tests::jet;

    #[test]
    fn the_identity_of_a_snapshot_depends_on_every_setting_and_on_no_name() {
        let settings = Settings::of(jet());
        let change = |change: fn(&mut Settings)| {
            let mut changed = settings.clone();
            change(&mut changed);
            changed.hash()
        };
        let mut hashes = vec![
            settings.hash(),
            change(|s| s.fidelity = Fidelity::Rigid),
            change(|s| s.airspeed += 1.0),
            change(|s| s.altitude += 1.0),
            change(|s| s.heading += 1.0),
            change(|s| s.stiffness_scale += 1.0),
            change(|s| s.structural_damping += 1.0),
            change(|s| s.mode_selection = ModeSelection::Symmetric),
            change(|s| s.mode_count += 1),
            change(|s| s.inflow_states += 1),
            change(|s| s.tolerance *= 2.0),
            change(|s| s.input_reference = InputReference::Absolute),
        ];
        let count = hashes.len();
        hashes.sort_unstable();
        hashes.dedup();
        assert_eq!(hashes.len(), count);
        // Written out by hand: one byte for each choice, counts, then the real numbers.
        let mut bytes = vec![0, 0, 0, 12, 0, 0, 0, 5, 0, 0, 0];
        for number in [127.0_f64, 7620.0, 0.0, 1.0, 0.0, 1e-5] {
            bytes.extend(number.to_le_bytes());
        }
        assert_eq!(settings.hash(), sealed::hash(&bytes));
    }
}

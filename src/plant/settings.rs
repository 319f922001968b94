//! What a user chooses of a plant: fidelity, modes, inflow, stiffness, damping, and the flight condition.

use std::fmt::Display;

use nalgebra::Vector3;

use crate::aircraft::{ALTITUDES, Support, TEMPERATURE_OFFSETS};
use crate::equations::{Configuration, Fidelity};
use crate::strips::PetersInflow;
use crate::structure::{ModeFamily, ModesInUse, ReducedModel};

use super::manoeuvre::ConditionSettings;
use super::setting_error::SettingError;
use super::system::Plant;
use super::trim::TrimCondition;

/// Which families of modes take part, lowest frequencies first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ModeSelection {
    /// Symmetric and antisymmetric modes together.
    All,
    /// Symmetric modes only.
    Symmetric,
}

/// Modes that take part unless someone asks for another number, if the aircraft has so many.
const USUAL_MODES: usize = 12;

/// The parameters of a plant and of its trim.
///
/// ```
/// use flexible_aircraft::equations::Fidelity;
/// use flexible_aircraft::plant::{Plant, PlantSettings};
/// # use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
/// let fast = PlantSettings { airspeed: 180.0, ..PlantSettings::of(&jet) }; // m/s
/// assert_eq!(fast.choose_modes(&jet)?.len(), 4);
/// let rigid = PlantSettings { fidelity: Fidelity::Rigid, ..fast };
/// assert_eq!(Plant::under(&jet, &rigid)?.layout().modes(), 0);
/// let refused = Plant::under(&jet, &PlantSettings { airspeed: -1.0, ..fast }).unwrap_err();
/// assert_eq!(refused.to_string(), "airspeed: found -1, allowed is 1 to 400 (m/s)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlantSettings {
    /// Fidelity level; that of the aircraft at first.
    pub fidelity: Fidelity,
    /// Trimmed airspeed, m/s, within [`Support::airspeeds`].
    pub airspeed: f64,
    /// Trimmed altitude, m, within [`ALTITUDES`]; of no account in a tunnel with air of its own but for gusts of CS-25.
    pub altitude: f64,
    /// By how much the air is warmer than the standard atmosphere, K, within [`TEMPERATURE_OFFSETS`]; of no account in a tunnel
    /// with air of its own.
    pub temperature_offset: f64,
    /// Initial yaw angle, rad.
    pub heading: f64,
    /// Factor on all elastic properties, > 0.
    pub stiffness_scale: f64,
    /// Modal damping ratio ζ of every mode, ≥ 0.
    pub structural_damping: f64,
    /// Families of modes.
    pub mode_selection: ModeSelection,
    /// Number of natural modes, 0…those packaged of the selection; the other one of a pair comes with the last. `Rigid`
    /// ignores it.
    pub mode_count: usize,
    /// Whether the load modes that belong to those modes stand beside them; only where the model has load modes.
    pub load_modes: bool,
    /// Peters inflow states per strip, 0…[`MOST_INFLOW_STATES`](Self::MOST_INFLOW_STATES); 0 is steady aerodynamics.
    pub inflow_states: usize,
    /// How the flight begins: straight and level at first.
    pub condition: ConditionSettings,
}

impl PlantSettings {
    /// Peters inflow states per strip that there can be.
    pub const MOST_INFLOW_STATES: usize = PetersInflow::MAX_STATES;

    /// Those of an aircraft before any parameter is set: its own flight condition.
    pub fn of(model: &ReducedModel) -> Self {
        PlantSettings {
            fidelity: model.fidelity,
            airspeed: model.airspeed,
            altitude: model.altitude,
            temperature_offset: model.temperature_offset,
            heading: 0.0,
            stiffness_scale: 1.0,
            structural_damping: 0.0,
            mode_selection: ModeSelection::All,
            mode_count: USUAL_MODES.min(model.natural_modes()),
            load_modes: model.has_load_modes(),
            inflow_states: model.inflow_states,
            condition: ConditionSettings::default(),
        }
    }

    /// Checks every setting against its range and against the model, and chooses the modes that take part.
    ///
    /// # Errors
    /// Names the first setting that is out of range.
    pub fn choose_modes(&self, model: &ReducedModel) -> Result<ModesInUse, SettingError> {
        self.check(model.support)?;
        self.condition.check(model.support, model.engines.len())?;
        self.check_thrust(model)?;
        self.fidelity.flies(&model.joints)?;
        if self.fidelity == Fidelity::Rigid {
            return Ok(ModesInUse::chosen(&[]));
        }
        let watched = |family| self.mode_selection == ModeSelection::All || family == ModeFamily::Symmetric;
        let is_candidate = |&mode: &usize| !model.modes[mode].of_loads && watched(model.modes[mode].family);
        let candidates: Vec<usize> = (0..model.modes.len()).filter(is_candidate).collect();
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
        let natural = &candidates[..self.mode_count + pairs];
        match (self.load_modes, model.has_load_modes()) {
            (false, _) => Ok(ModesInUse::chosen(natural)),
            (true, true) => ModesInUse::beside_loads((&model.modes, &model.static_loads), natural, watched)
                .or_else(|error| refuse("load_modes", "true", &format!("false: {error}"))),
            (true, false) => refuse("load_modes", "true", "false: the model has none"),
        }
    }

    /// That an engine with a share of the thrust runs.
    fn check_thrust(&self, model: &ReducedModel) -> Result<(), SettingError> {
        let Some(failed) = self.condition.manoeuvre().failed_engine else { return Ok(()) };
        let pushes_beside = |failed: usize| {
            let mut engines = model.engines.iter().enumerate();
            engines.any(|(engine, of)| engine != failed && of.trim_share > 0.0)
        };
        if model.support == Support::Clamped || pushes_beside(failed) {
            return Ok(());
        }
        let named = |engine: usize| format!("{} ({})", engine + 1, model.engines[engine].name);
        let others: Vec<String> =
            (0..model.engines.len()).filter(|&engine| pushes_beside(engine)).map(named).collect();
        let allowed = format!("{}: beside it another has a `trim_share` above 0", others.join(", "));
        refuse("condition.failed_engine", named(failed), &allowed)
    }

    /// The flight to be trimmed.
    pub fn trim_condition(&self) -> TrimCondition {
        let PlantSettings { airspeed, altitude, heading, condition, .. } = *self;
        TrimCondition { airspeed, altitude, heading, manoeuvre: condition.manoeuvre() }
    }

    /// Altitude, and temperature where it is not that of the standard atmosphere: `7620 m, ISA +20 K`.
    pub fn air_in_words(&self) -> String {
        let PlantSettings { altitude, temperature_offset, .. } = self;
        match temperature_offset {
            0.0 => format!("{altitude} m"),
            offset => format!("{altitude} m, ISA {offset:+} K"),
        }
    }

    /// The same, with the heading along the course.
    pub(crate) fn along_course(&self) -> Self {
        PlantSettings { heading: 0.0, ..*self }
    }

    /// What the settings mean for the equations of an aircraft on its support.
    pub fn configuration(&self, support: Support) -> Configuration {
        let tunnel_flow = match support {
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
            temperature_offset: self.temperature_offset,
            tunnel_flow,
        }
    }

    /// Checks every setting against its range.
    ///
    /// # Errors
    /// Names the first that is outside.
    pub fn check(&self, support: Support) -> Result<(), SettingError> {
        let within = |setting, value: f64, inside: bool, allowed: &str| {
            if value.is_finite() && inside { Ok(()) } else { refuse(setting, value, allowed) }
        };
        let PlantSettings { airspeed, altitude, heading, stiffness_scale, structural_damping, .. } = *self;
        let airspeeds = support.airspeeds();
        let allowed = format!("{} to {} (m/s)", airspeeds.start(), airspeeds.end());
        within("airspeed", airspeed, airspeeds.contains(&airspeed), &allowed)?;
        within("altitude", altitude, ALTITUDES.contains(&altitude), "-1000 to 30000 (m)")?;
        let offset = self.temperature_offset;
        within("temperature_offset", offset, TEMPERATURE_OFFSETS.contains(&offset), "-60 to 60 (K)")?;
        within("heading", heading, true, "a finite number (rad)")?;
        within("stiffness_scale", stiffness_scale, stiffness_scale > 0.0, "a finite number > 0")?;
        within("structural_damping", structural_damping, structural_damping >= 0.0, "a finite number >= 0")?;
        if self.inflow_states > Self::MOST_INFLOW_STATES {
            let allowed = format!("0 to {}", Self::MOST_INFLOW_STATES);
            return refuse("inflow_states", self.inflow_states, &allowed);
        }
        Ok(())
    }
}

fn refuse<T>(setting: &str, found: impl Display, allowed: &str) -> Result<T, SettingError> {
    Err(SettingError { setting: setting.to_owned(), found: found.to_string(), allowed: allowed.to_owned() })
}

impl Plant {
    /// Of a whole aircraft before any parameter is set, but with all its modes.
    pub(crate) fn of_all_modes(model: &ReducedModel) -> Self {
        Plant::of_chosen(model, &PlantSettings::of(model).configuration(model.support))
    }

    /// That of a whole aircraft under some settings.
    ///
    /// # Errors
    /// When a setting is out of range.
    pub fn under(model: &ReducedModel, settings: &PlantSettings) -> Result<Self, SettingError> {
        let modes = settings.choose_modes(model)?;
        Ok(Plant::of_modes(model, &settings.configuration(model.support), &modes)?)
    }
}

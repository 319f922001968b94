//! The roots of an aircraft over some airspeeds, and the words for it: what `flexair flutter` and `flexair converge` share.

use flexible_aircraft::air::Atmosphere;
use flexible_aircraft::aircraft::Support;
use flexible_aircraft::plant::{PlantSettings, SettingError};
use flexible_aircraft::stability::Sweep;
use flexible_aircraft::structure::ReducedModel;

use crate::condition::Airspeeds;
use crate::numbers::Plain;
use crate::progress::Progress;

pub mod motion;

/// What was analysed, and what came out.
pub struct Analysis {
    /// With the modes that take part.
    pub model: ReducedModel,
    pub settings: PlantSettings,
    /// That were asked for.
    pub airspeeds: Airspeeds,
    pub sweep: Sweep,
}

impl Analysis {
    /// Of a model under some settings at some airspeeds.
    ///
    /// # Errors
    /// When a setting is out of range.
    pub fn new(
        model: &ReducedModel,
        settings: PlantSettings,
        airspeeds: Airspeeds,
        progress: &Progress,
    ) -> Result<Self, SettingError> {
        let sweep = Sweep::watched(model, &settings, &airspeeds.all(), &|| progress.advance())?;
        let model = model.in_use(&settings.choose_modes(model)?);
        Ok(Analysis { model, settings, airspeeds, sweep })
    }

    /// How the aircraft is held, in words.
    pub fn support(&self) -> &'static str {
        match self.model.support {
            Support::Free => "free, trimmed",
            Support::Clamped => "clamped in a wind tunnel",
        }
    }

    /// Level, stiffness, modes, as the caller calls them, inflow and air, in a line of a report.
    pub fn condition(&self, modes: &str) -> String {
        let PlantSettings { fidelity, stiffness_scale, inflow_states, .. } = self.settings;
        let (level, stiffness) = (fidelity.name().replace('_', " "), Plain(stiffness_scale));
        let altitude = match self.model.tunnel_air {
            Some(_) => String::new(),
            None => format!("{}, ", self.settings.air_in_words()),
        };
        let density = self.density();
        format!(
            "{level} model, stiffness × {stiffness}, {modes}, {inflow_states} inflow states, {altitude}{density:.4} kg/m³\n"
        )
    }

    /// kg/m³.
    pub fn density(&self) -> f64 {
        let PlantSettings { altitude, temperature_offset, .. } = self.settings;
        Atmosphere::new(self.model.tunnel_air.as_ref(), temperature_offset).at(altitude).density
    }
}

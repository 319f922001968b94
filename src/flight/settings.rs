//! What a user chooses before the flight.

use crate::air::{GustSettings, TurbulenceSettings};
use crate::aircraft::Support;
use crate::plant::{PlantSettings, SettingError};
use crate::sealed::{self, Writer};
use crate::structure::ReducedModel;

/// What the inputs of controls and thrusts mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum InputReference {
    /// They add to the trim values.
    Trim,
    /// They are the values themselves.
    Absolute,
}

/// The parameters of a flight: those of the plant that flies, and how it is flown.
///
/// ```
/// use flexible_aircraft::flight::Settings;
/// use flexible_aircraft::plant::PlantSettings;
/// # use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
/// let fast = PlantSettings { airspeed: 180.0, ..PlantSettings::of(&jet) }; // m/s
/// let settings = Settings { tolerance: 1e-7, ..fast.into() };
/// assert_eq!(settings.plant.airspeed, 180.0);
/// assert_eq!(Settings::of(&jet), PlantSettings::of(&jet).into());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Of the plant and its trim.
    pub plant: PlantSettings,
    /// Relative tolerance of the integrator, > 0.
    pub tolerance: f64,
    /// Meaning of the inputs.
    pub input_reference: InputReference,
    /// A single gust that the aircraft flies into.
    pub gust: GustSettings,
    /// Continuous turbulence that it flies into.
    pub turbulence: TurbulenceSettings,
}

impl From<PlantSettings> for Settings {
    /// Those of the FMU before any other parameter is set.
    fn from(plant: PlantSettings) -> Self {
        Settings {
            plant,
            tolerance: 1e-5,
            input_reference: InputReference::Trim,
            gust: GustSettings::default(),
            turbulence: TurbulenceSettings::default(),
        }
    }
}

impl Settings {
    /// Those of the FMU of an aircraft before any parameter is set: the aircraft's own flight condition.
    pub fn of(model: &ReducedModel) -> Self {
        PlantSettings::of(model).into()
    }

    /// Tells settings apart: a hash of their values.
    pub(super) fn hash(&self) -> u128 {
        let Settings { plant, tolerance, input_reference, gust, turbulence } = *self;
        let PlantSettings {
            fidelity,
            airspeed,
            altitude,
            heading,
            stiffness_scale,
            structural_damping,
            mode_selection,
            mode_count,
            load_modes,
            inflow_states,
        } = plant;
        let mut bytes = Vec::new();
        let mut writer = Writer::new(&mut bytes);
        for choice in [fidelity as u8, mode_selection as u8, u8::from(load_modes), input_reference as u8] {
            writer.byte(choice);
        }
        for count in [mode_count, inflow_states] {
            writer.count(u32::try_from(count).unwrap_or(u32::MAX));
        }
        writer.reals([airspeed, altitude, heading, stiffness_scale, structural_damping, tolerance]);
        write_gust(&mut writer, &gust);
        write_turbulence(&mut writer, &turbulence);
        sealed::hash(&bytes)
    }

    /// Checks every setting against its range.
    pub(super) fn check(&self, support: Support) -> Result<(), SettingError> {
        self.plant.check(support)?;
        self.gust.check()?;
        self.turbulence.check()?;
        let tolerance = self.tolerance;
        if tolerance > 0.0 && tolerance < 1.0 {
            return Ok(());
        }
        let allowed = "a number between 0 and 1, exclusive".to_owned();
        Err(SettingError { setting: "tolerance", found: tolerance.to_string(), allowed })
    }
}

/// What tells gusts apart.
fn write_gust(writer: &mut Writer, gust: &GustSettings) {
    let GustSettings {
        shape,
        gradient,
        peak,
        direction,
        inclination,
        start,
        criterion,
        alleviation,
        maximum_operating_altitude,
    } = *gust;
    writer.byte(shape as u8);
    writer.byte(criterion as u8);
    writer.reals([gradient, peak, direction, inclination, start, alleviation, maximum_operating_altitude]);
}

/// What tells turbulence apart.
fn write_turbulence(writer: &mut Writer, turbulence: &TurbulenceSettings) {
    let TurbulenceSettings { spectrum, intensity, scale, seed, components, start } = *turbulence;
    writer.byte(spectrum as u8);
    writer.byte(components as u8);
    writer.reals([intensity, scale, f64::from(seed), start]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::air::{GustCriterion, GustShape, Spectrum, TurbulenceComponents};
    use crate::equations::Fidelity;
    use crate::plant::ModeSelection;
    use crate::structure::test_jet::jet;

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
            change(|s| s.plant.fidelity = Fidelity::Rigid),
            change(|s| s.plant.airspeed += 1.0),
            change(|s| s.plant.altitude += 1.0),
            change(|s| s.plant.heading += 1.0),
            change(|s| s.plant.stiffness_scale += 1.0),
            change(|s| s.plant.structural_damping += 1.0),
            change(|s| s.plant.mode_selection = ModeSelection::Symmetric),
            change(|s| s.plant.mode_count += 1),
            change(|s| s.plant.load_modes = true),
            change(|s| s.plant.inflow_states += 1),
            change(|s| s.tolerance *= 2.0),
            change(|s| s.input_reference = InputReference::Absolute),
            change(|s| s.gust.shape = GustShape::OneMinusCosine),
            change(|s| s.gust.gradient += 1.0),
            change(|s| s.gust.peak += 1.0),
            change(|s| s.gust.direction += 1.0),
            change(|s| s.gust.inclination += 1.0),
            change(|s| s.gust.start += 1.0),
            change(|s| s.gust.criterion = GustCriterion::Cs25Vd),
            change(|s| s.gust.alleviation = 0.5),
            change(|s| s.gust.maximum_operating_altitude += 1.0),
            change(|s| s.turbulence.spectrum = Spectrum::Dryden),
            change(|s| s.turbulence.intensity += 1.0),
            change(|s| s.turbulence.scale += 1.0),
            change(|s| s.turbulence.seed += 1),
            change(|s| s.turbulence.components = TurbulenceComponents::Lateral),
            change(|s| s.turbulence.start += 1.0),
        ];
        let count = hashes.len();
        hashes.sort_unstable();
        hashes.dedup();
        assert_eq!(hashes.len(), count);
        // Written out by hand: one byte for each choice, counts, then the real numbers.
        let mut bytes = vec![0, 0, 0, 0, 12, 0, 0, 0, 5, 0, 0, 0];
        for number in [127.0_f64, 7620.0, 0.0, 1.0, 0.0, 1e-5] {
            bytes.extend(number.to_le_bytes());
        }
        // The gust's shape and criterion and its numbers, then the same of the turbulence.
        bytes.extend([0, 0]);
        for number in [30.0_f64, 10.0, 0.0, 0.0, 1.0, 1.0, 12_500.0] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend([0, 0]);
        for number in [1.0_f64, 0.0, 1.0, 0.0] {
            bytes.extend(number.to_le_bytes());
        }
        assert_eq!(settings.hash(), sealed::hash(&bytes));
    }
}

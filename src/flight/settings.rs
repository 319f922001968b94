//! What a user chooses before the flight.

use crate::air::{GustSettings, TurbulenceSettings};
use crate::devices::{Actuator, ActuatorSetting, EngineLag, EngineSetting};
use crate::plant::{ConditionSettings, PlantSettings, SettingError};
use crate::sealed::{self, Writer};
use crate::structure::ReducedModel;

use super::per_part::PerPart;
use super::sensor_settings::SensorSettings;

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
    /// Of the controls; usually there are none.
    pub actuators: PerPart<Actuator>,
    /// Usually engines do not lag.
    pub engines: PerPart<EngineLag>,
    /// Usually they give what they measure.
    pub sensors: SensorSettings,
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
            actuators: PerPart::default(),
            engines: PerPart::default(),
            sensors: SensorSettings::default(),
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
        let Settings { plant, tolerance, input_reference, gust, turbulence, actuators, engines, sensors } =
            self;
        let (actuators, engines) = (actuators.said(), engines.said());
        let PlantSettings {
            fidelity,
            airspeed,
            altitude,
            temperature_offset,
            heading,
            stiffness_scale,
            structural_damping,
            mode_selection,
            mode_count,
            load_modes,
            inflow_states,
            condition,
        } = *plant;
        let SensorSettings { enabled, period, time_constant, delay, noise, seed } = *sensors;
        let mut bytes = Vec::new();
        let mut writer = Writer::new(&mut bytes);
        let choices =
            [fidelity as u8, mode_selection as u8, load_modes.into(), *input_reference as u8, enabled.into()];
        choices.into_iter().for_each(|choice| writer.byte(choice));
        for count in [mode_count, inflow_states, actuators.len(), engines.len(), delay] {
            writer.count(u32::try_from(count).unwrap_or(u32::MAX));
        }
        writer.count(seed);
        writer.reals([airspeed, altitude, temperature_offset, heading]);
        writer.reals([stiffness_scale, structural_damping, *tolerance]);
        for &Actuator { frequency, damping, rate_limit, minimum, maximum } in actuators {
            writer.reals([frequency, damping, rate_limit, minimum, maximum]);
        }
        for &EngineLag { time_constant, minimum, maximum } in engines {
            writer.reals([time_constant, minimum, maximum]);
        }
        writer.reals([period, time_constant].into_iter().chain(noise));
        write_gust(&mut writer, gust);
        write_turbulence(&mut writer, turbulence);
        write_condition(&mut writer, &condition);
        sealed::hash(&bytes)
    }

    /// Checks every setting against its range.
    pub(super) fn check(&self, model: &ReducedModel) -> Result<(), SettingError> {
        self.plant.check(model.support)?;
        self.gust.check()?;
        self.turbulence.check()?;
        let tolerance = self.tolerance;
        if !(tolerance > 0.0 && tolerance < 1.0) {
            let (found, allowed) = (tolerance.to_string(), "a number between 0 and 1, exclusive".to_owned());
            return Err(SettingError { setting: "tolerance".to_owned(), found, allowed });
        }
        for (control, mut actuator) in model.controls.iter().zip(self.actuators.said().iter().copied()) {
            let part = format!("actuator.{}", control.name);
            for setting in ActuatorSetting::ALL {
                let found = *setting.of(&mut actuator);
                check_within(&part, setting.name(), found, setting.range(), setting.least_beside_none())?;
            }
            check_limits(&part, [actuator.minimum, actuator.maximum], "rad")?;
        }
        for (engine, mut lag) in model.engines.iter().zip(self.engines.said().iter().copied()) {
            let part = format!("engine.{}", engine.name);
            for setting in EngineSetting::ALL {
                check_within(&part, setting.name(), *setting.of(&mut lag), setting.range(), None)?;
            }
            check_limits(&part, [lag.minimum, lag.maximum], "N")?;
        }
        self.sensors.check()
    }
}

/// What tells flight conditions apart.
fn write_condition(writer: &mut Writer, condition: &ConditionSettings) {
    let ConditionSettings {
        manoeuvre,
        climb_angle,
        bank_angle,
        load_factor,
        sideslip,
        lateral,
        failed_engine,
    } = *condition;
    writer.byte(manoeuvre as u8);
    writer.byte(lateral as u8);
    writer.count(u32::try_from(failed_engine).unwrap_or(u32::MAX));
    writer.reals([climb_angle, bank_angle, load_factor, sideslip]);
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

/// That a number of an actuator or an engine is within its range, or 0 where that stands for none.
fn check_within(
    part: &str,
    name: &str,
    found: f64,
    ([least, most], unit): ([f64; 2], &str),
    least_beside_none: Option<f64>,
) -> Result<(), SettingError> {
    let is_none_or_enough = least_beside_none.is_none_or(|least| found == 0.0 || found >= least);
    if (least..=most).contains(&found) && is_none_or_enough {
        return Ok(());
    }
    let none = least_beside_none.map_or(String::new(), |least| format!("or {least} "));
    let allowed = format!("{least} {none}to {most} ({unit})");
    Err(SettingError { setting: format!("{part}.{name}"), found: found.to_string(), allowed })
}

/// That limits leave something between them.
fn check_limits(part: &str, [minimum, maximum]: [f64; 2], unit: &str) -> Result<(), SettingError> {
    if minimum <= maximum {
        return Ok(());
    }
    let allowed = format!("`{part}.minimum`, which is {minimum} ({unit}), and above");
    Err(SettingError { setting: format!("{part}.maximum"), found: maximum.to_string(), allowed })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::air::{GustCriterion, GustShape, Spectrum, TurbulenceComponents};
    use crate::equations::Fidelity;
    use crate::plant::{Lateral, ManoeuvreChoice, ModeSelection};
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
            change(|s| s.plant.temperature_offset += 1.0),
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
            change(|s| s.plant.condition.manoeuvre = ManoeuvreChoice::Turn),
            change(|s| s.plant.condition.climb_angle = 0.1),
            change(|s| s.plant.condition.bank_angle = 0.1),
            change(|s| s.plant.condition.load_factor = 0.1),
            change(|s| s.plant.condition.sideslip = 0.1),
            change(|s| s.plant.condition.lateral = Lateral::Bank),
            change(|s| s.plant.condition.failed_engine = 1),
            change(|s| s.actuators.set(1, Actuator { frequency: 1.0, ..Actuator::default() })),
            change(|s| s.actuators.set(1, Actuator { damping: 1.0, ..Actuator::default() })),
            change(|s| s.actuators.set(1, Actuator { rate_limit: 1.0, ..Actuator::default() })),
            change(|s| s.actuators.set(1, Actuator { minimum: -1.0, ..Actuator::default() })),
            change(|s| s.actuators.set(1, Actuator { maximum: 1.0, ..Actuator::default() })),
            change(|s| s.actuators.set(0, Actuator { maximum: 1.0, ..Actuator::default() })),
            change(|s| s.engines.set(1, EngineLag { time_constant: 1.0, ..EngineLag::default() })),
            change(|s| s.engines.set(1, EngineLag { minimum: -1.0, ..EngineLag::default() })),
            change(|s| s.engines.set(1, EngineLag { maximum: 1.0, ..EngineLag::default() })),
            change(|s| s.sensors.enabled = true),
            change(|s| s.sensors.period = 0.02),
            change(|s| s.sensors.time_constant = 0.02),
            change(|s| s.sensors.delay = 1),
            change(|s| s.sensors.noise[3] = 1.0),
            change(|s| s.sensors.seed = 2),
        ];
        let count = hashes.len();
        hashes.sort_unstable();
        hashes.dedup();
        assert_eq!(hashes.len(), count);
        // Written out by hand: one byte for each choice, counts, then the real numbers.
        let mut bytes = vec![0, 0, 0, 0, 0];
        for count in [12_u32, 5, 0, 0, 0, 1] {
            bytes.extend(count.to_le_bytes());
        }
        let condition = [127.0_f64, 7620.0, 0.0, 0.0, 1.0, 0.0, 1e-5];
        for number in condition.into_iter().chain([0.01, 0.0]).chain([0.0; 7]) {
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
        // The manoeuvre and what is given of it, the engine that has failed, and the numbers of the condition.
        bytes.extend([0, 0]);
        bytes.extend(0_u32.to_le_bytes());
        bytes.extend([0.0_f64; 4].iter().flat_map(|number| number.to_le_bytes()));
        assert_eq!(settings.hash(), sealed::hash(&bytes));
    }

    #[test]
    fn devices_out_of_range_are_refused_by_name_with_what_is_allowed() {
        let refusal = |change: fn(&mut Settings)| {
            let mut changed = Settings::of(jet());
            change(&mut changed);
            changed.check(jet()).unwrap_err().to_string()
        };
        assert_eq!(
            refusal(|s| s.actuators.set(0, Actuator { frequency: -1.0, ..Actuator::default() })),
            "actuator.elevator.frequency: found -1, allowed is 0 or 0.001 to 1000 (rad/s)"
        );
        let slow = refusal(|s| s.actuators.set(1, Actuator { frequency: 1e-5, ..Actuator::default() }));
        assert_eq!(slow, "actuator.aileron.frequency: found 0.00001, allowed is 0 or 0.001 to 1000 (rad/s)");
        assert_eq!(
            refusal(|s| s.actuators.set(0, Actuator { minimum: 0.2, maximum: 0.1, ..Actuator::default() })),
            "actuator.elevator.maximum: found 0.1, allowed is `actuator.elevator.minimum`, which is 0.2 (rad), and above"
        );
        assert_eq!(
            refusal(|s| s.engines.set(1, EngineLag { time_constant: f64::NAN, ..EngineLag::default() })),
            "engine.right.time_constant: found NaN, allowed is 0 to 10000 (s)"
        );
        assert_eq!(
            refusal(|s| s.sensors.period = 0.015),
            "sensor.period: found 0.015, allowed is a multiple of 0.01 from 0.01 to 10 (s)"
        );
        assert!(refusal(|s| s.sensors.noise[0] = -1.0).starts_with("sensor.noise.attitude: found -1, "));
        let mut usual = Settings::of(jet());
        usual.actuators.set(3, Actuator::default());
        assert_eq!((usual.check(jet()), &usual), (Ok(()), &Settings::of(jet())));
    }
}

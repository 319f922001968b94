//! What a motion without a method of integration can be asked for: nothing that happens at some times only
//! [theory: continuous-model.states].

use crate::devices::{ActuatorSetting, EngineSetting, LIMITLESS};
use crate::plant::{ModeSelection, SettingError};
use crate::structure::{Mode, ModeFamily, ReducedModel};

use super::settings::Settings;

/// Those of an aircraft before any parameter is set. With load modes all natural modes take part, for those of fewer would
/// be combined of others.
pub fn usual(model: &ReducedModel) -> Settings {
    let mut settings = Settings::of(model);
    if model.has_load_modes() {
        settings.plant.mode_count = model.natural_modes();
    }
    settings
}

/// That nothing is asked for that is not continuous.
///
/// # Errors
/// Names the first setting that is.
pub fn check(settings: &Settings, model: &ReducedModel) -> Result<(), SettingError> {
    let Settings { plant, actuators, engines, sensors, .. } = settings;
    let packaged = model.inflow_states;
    if ![0, packaged].contains(&plant.inflow_states) {
        let allowed = format!(
            "0 or {packaged}: a model exchange FMU has as many states as its aircraft file says (`inflow_states`)"
        );
        return refuse("inflow_states".to_owned(), plant.inflow_states.to_string(), &allowed);
    }
    let natural = model.natural_modes();
    if model.has_load_modes() && plant.mode_count != natural {
        let allowed =
            format!("{natural}: with load modes all natural modes of a model exchange FMU take part");
        return refuse("mode_count".to_owned(), plant.mode_count.to_string(), &allowed);
    }
    if sensors.enabled {
        let allowed = "false: a sampled sensor belongs to co-simulation";
        return refuse("sensor.enabled".to_owned(), "true".to_owned(), allowed);
    }
    for (control, mut actuator) in model.controls.iter().zip(actuators.said().iter().copied()) {
        for setting in [ActuatorSetting::RateLimit, ActuatorSetting::Minimum, ActuatorSetting::Maximum] {
            let name = || format!("actuator.{}.{}", control.name, setting.name());
            check_limitless(name, *setting.of(&mut actuator), setting.range())?;
        }
    }
    for (engine, mut lag) in model.engines.iter().zip(engines.said().iter().copied()) {
        for setting in [EngineSetting::Minimum, EngineSetting::Maximum] {
            let name = || format!("engine.{}.{}", engine.name, setting.name());
            check_limitless(name, *setting.of(&mut lag), setting.range())?;
        }
    }
    Ok(())
}

/// With load modes the number of natural modes is that of the family in use, whatever it is packaged as.
pub(super) fn in_use(settings: &Settings, model: &ReducedModel) -> Settings {
    let mut settings = settings.clone();
    if model.has_load_modes() && settings.plant.mode_selection == ModeSelection::Symmetric {
        let is_symmetric = |mode: &&Mode| !mode.of_loads && mode.family == ModeFamily::Symmetric;
        settings.plant.mode_count = model.modes.iter().filter(is_symmetric).count();
    }
    settings
}

/// That a limit, which is at one end of its range where there is none, is none.
fn check_limitless(
    name: impl Fn() -> String,
    found: f64,
    ([least, most], unit): ([f64; 2], &str),
) -> Result<(), SettingError> {
    if found.abs() >= LIMITLESS {
        return Ok(());
    }
    let name = name();
    let none = if name.ends_with("minimum") { least } else { most };
    let allowed = format!("{none:e} {unit}, none: a limit belongs to co-simulation");
    refuse(name, found.to_string(), &allowed)
}

fn refuse<T>(setting: String, found: String, allowed: &str) -> Result<T, SettingError> {
    Err(SettingError { setting, found, allowed: allowed.to_owned() })
}

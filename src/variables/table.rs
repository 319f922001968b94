//! The rows of the table.

use crate::aircraft::{Control, Support, TrimRole};
use crate::flight::Settings;
use crate::structure::{Mode, ModeFamily, ReducedModel};

use super::air_quantity::AirQuantity;
use super::axis::Axis;
use super::devices::{actuators, sensor_channels};
use super::gusts;
use super::output_slot::{DeflectionComponent, OutputSlot};
use super::parameters::parameters;
use super::row::{input, output};
use super::slot::InputSlot;
use super::unit::Unit;
use super::variable::{Variability, Variable};

/// All rows for an aircraft whose parameters start somewhere, inputs first.
pub(super) fn rows(model: &ReducedModel, starts: &Settings) -> Vec<Variable> {
    let mut rows = inputs(model);
    rows.extend(parameters(model, starts));
    rows.extend(motion());
    rows.extend(flow());
    rows.extend(gusts::outputs());
    rows.extend(deflections(model));
    rows.extend(sensors(model));
    rows.extend(modal_coordinates(model));
    rows.extend(controls_and_trim(model));
    rows.extend(actuators(model));
    rows.extend(sensor_channels(model, &rows));
    rows
}

fn inputs(model: &ReducedModel) -> Vec<Variable> {
    let mut rows = Vec::new();
    for (i, control) in model.controls.iter().enumerate() {
        let Control { name, description, positive, .. } = control;
        let text = format!("{description}, positive {positive}; {}", control.facts().join("; "));
        rows.push(input(name, Unit::Radian, InputSlot::Control(i), &text));
    }
    for (i, engine) in model.engines.iter().enumerate() {
        let text = format!("Thrust of engine {}, positive forward", engine.name);
        let name = format!("thrust_{}", engine.name);
        rows.push(input(&name, Unit::Newton, InputSlot::Thrust(i), &text).nominal(10_000.0));
    }
    for (axis, direction) in Axis::ALL.into_iter().zip(NORTH_EAST_DOWN) {
        let text = format!("Velocity of the air mass towards {direction}");
        rows.push(input(&format!("wind_{direction}"), Unit::MetrePerSecond, InputSlot::Wind(axis), &text));
    }
    for (axis, direction) in Axis::ALL.into_iter().zip(NORTH_EAST_DOWN) {
        let text = format!(
            "Rate of wind_{direction}, kept until set again and counted from the last setting of either; gusts need it"
        );
        let name = format!("wind_rate_{direction}");
        rows.push(input(&name, Unit::MetrePerSecondSquared, InputSlot::WindRate(axis), &text));
    }
    rows
}

fn motion() -> Vec<Variable> {
    type Triple = (&'static str, [&'static str; 3], Unit, fn(Axis) -> OutputSlot, &'static str);
    const XYZ: [&str; 3] = ["x", "y", "z"];
    let triples: [Triple; 6] = [
        ("position", NORTH_EAST_DOWN, Unit::Metre, OutputSlot::Position, "Position of O"),
        ("attitude", ["roll", "pitch", "yaw"], Unit::Radian, OutputSlot::Attitude, "3-2-1 Euler angle"),
        ("velocity", XYZ, Unit::MetrePerSecond, OutputSlot::Velocity, "Inertial velocity of O, body axis"),
        ("rate", XYZ, Unit::RadianPerSecond, OutputSlot::Rate, "Angular velocity, body axis"),
        (
            "acceleration",
            XYZ,
            Unit::MetrePerSecondSquared,
            OutputSlot::Acceleration,
            "Rate of change of the velocity component along body axis",
        ),
        (
            "load_factor",
            XYZ,
            Unit::One,
            OutputSlot::LoadFactor,
            "(Inertial acceleration - gravity)/g at O, z counted upwards: component",
        ),
    ];
    let mut rows = Vec::new();
    for (group, components, unit, slot, text) in triples {
        for (axis, component) in Axis::ALL.into_iter().zip(components) {
            rows.push(output(
                format!("{group}.{component}"),
                unit,
                slot(axis),
                format!("{text} {component}"),
            ));
        }
    }
    rows
}

fn flow() -> Vec<Variable> {
    let quantities = [
        ("speed", Unit::MetrePerSecond, AirQuantity::Speed, "True airspeed at O"),
        ("alpha", Unit::Radian, AirQuantity::AngleOfAttack, "Angle of attack of the body x axis at O"),
        (
            "beta",
            Unit::Radian,
            AirQuantity::Sideslip,
            "Sideslip angle at O, positive with the wind from the right",
        ),
        ("mach", Unit::One, AirQuantity::Mach, "Mach number at O"),
        ("density", Unit::KilogramPerCubicMetre, AirQuantity::Density, "Air density at O"),
        ("dynamic_pressure", Unit::Pascal, AirQuantity::DynamicPressure, "Dynamic pressure at O"),
        ("equivalent", Unit::MetrePerSecond, AirQuantity::Equivalent, "Equivalent airspeed at O"),
        ("calibrated", Unit::MetrePerSecond, AirQuantity::Calibrated, "Calibrated airspeed at O"),
        ("pressure", Unit::Pascal, AirQuantity::Pressure, "Static pressure at O"),
        ("temperature", Unit::Kelvin, AirQuantity::Temperature, "Static temperature at O"),
    ];
    let rows = quantities.into_iter().map(|(name, unit, quantity, text)| {
        let row = output(format!("air.{name}"), unit, OutputSlot::Air(quantity), text.to_owned());
        if unit == Unit::Radian { row } else { row.at_least(0.0) }
    });
    rows.collect()
}

fn deflections(model: &ReducedModel) -> Vec<Variable> {
    use DeflectionComponent::{Along, Twist, Up};
    let components = [
        ("x", Unit::Metre, Along(Axis::X), "Elastic displacement along body x"),
        ("y", Unit::Metre, Along(Axis::Y), "Elastic displacement along body y"),
        ("z", Unit::Metre, Along(Axis::Z), "Elastic displacement along body z"),
        ("up", Unit::Metre, Up, "Elastic displacement upwards (-z)"),
        ("twist", Unit::Radian, Twist, "Elastic twist, nose-up positive,"),
    ];
    let mut rows = Vec::new();
    for (station, point) in model.stations.iter().enumerate() {
        for (suffix, unit, component, text) in components {
            let slot = OutputSlot::Deflection { station, component };
            rows.push(output(
                format!("deflection.{}.{suffix}", point.name),
                unit,
                slot,
                format!("{text} at {}", point.name),
            ));
        }
    }
    rows
}

fn sensors(model: &ReducedModel) -> Vec<Variable> {
    let mut rows = Vec::new();
    for (station, point) in model.stations.iter().enumerate() {
        let name = &point.name;
        for (axis, component) in Axis::ALL.into_iter().zip(["x", "y", "z"]) {
            rows.push(output(
                format!("station.{name}.specific_force.{component}"),
                Unit::MetrePerSecondSquared,
                OutputSlot::SpecificForce { station, axis },
                format!(
                    "Reading of an accelerometer on the deformed section at {name}, its {component} axis"
                ),
            ));
        }
        for (axis, component) in Axis::ALL.into_iter().zip(["x", "y", "z"]) {
            rows.push(output(
                format!("station.{name}.rate.{component}"),
                Unit::RadianPerSecond,
                OutputSlot::StationRate { station, axis },
                format!("Reading of a rate gyro on the deformed section at {name}, its {component} axis"),
            ));
        }
    }
    rows
}

fn modal_coordinates(model: &ReducedModel) -> Vec<Variable> {
    let mut rows = Vec::new();
    // Load modes of fewer natural modes than packaged are combined of all that is packaged.
    let unused = if model.has_load_modes() {
        "0 when neither it nor a load mode of its family is in use"
    } else {
        "0 when not in use"
    };
    let kind = |mode: &Mode| match (mode.of_loads, mode.family) {
        (false, _) => "",
        (true, ModeFamily::Symmetric) => ", a symmetric load mode",
        (true, ModeFamily::Antisymmetric) => ", an antisymmetric load mode",
        (true, ModeFamily::Unsymmetric) => ", a load mode",
    };
    for (mode, kind) in model.modes.iter().map(kind).enumerate() {
        let number = mode + 1;
        let text = format!("Generalised coordinate of mode {number} (kg^(1/2) m){kind}, {unused}");
        let slot = OutputSlot::ModalCoordinate(mode);
        rows.push(output(format!("modal.q[{number}]"), None, slot, text));
    }
    for (mode, kind) in model.modes.iter().map(kind).enumerate() {
        let number = mode + 1;
        let text = format!("Rate of the generalised coordinate of mode {number} (kg^(1/2) m/s){kind}");
        let slot = OutputSlot::ModalRate(mode);
        rows.push(output(format!("modal.q_dot[{number}]"), None, slot, text));
    }
    rows
}

fn controls_and_trim(model: &ReducedModel) -> Vec<Variable> {
    let mut rows = Vec::new();
    for (i, Control { name, description, .. }) in model.controls.iter().enumerate() {
        let description = within_a_sentence(description);
        let text = format!(
            "Acting {description}, trim included; a flap turns by the sum of gain times angle over the controls that move it"
        );
        rows.push(output(format!("surface.{name}"), Unit::Radian, OutputSlot::Control(i), text));
    }
    for (i, engine) in model.engines.iter().enumerate() {
        let text = format!("Acting thrust of engine {}, trim included", engine.name);
        let name = format!("engine.{}.thrust", engine.name);
        rows.push(output(name, Unit::Newton, OutputSlot::Thrust(i), text).nominal(10_000.0));
    }
    let glides = model.support == Support::Free && model.engines.is_empty();
    let with_role = |role| {
        let control = model.control_for(role).map(|control| &model.controls[control]);
        let slot = OutputSlot::TrimControl(role);
        control.map(|Control { name, description, .. }| {
            (name.as_str(), Unit::Radian, slot, description.as_str())
        })
    };
    let trim = [
        Some(("pitch", Unit::Radian, OutputSlot::TrimPitch, "Pitch angle")),
        with_role(TrimRole::Pitch),
        Some(if glides {
            ("climb_angle", Unit::Radian, OutputSlot::TrimClimbAngle, "Angle of the path above the horizon")
        } else {
            (
                "thrust",
                Unit::Newton,
                OutputSlot::TrimThrust,
                "Thrust per engine that runs, or per unit of `trim_share` of these",
            )
        }),
        Some(("roll", Unit::Radian, OutputSlot::TrimRoll, "Bank angle")),
        Some(("beta", Unit::Radian, OutputSlot::TrimSideslip, "Sideslip angle")),
        with_role(TrimRole::Roll),
        with_role(TrimRole::Yaw),
    ];
    let flown = [
        ("alpha", Unit::Radian, OutputSlot::TrimAngleOfAttack, "Angle of attack"),
        (
            "turn_rate",
            Unit::RadianPerSecond,
            OutputSlot::TrimTurnRate,
            "Rate of turn, positive to the right,",
        ),
        (
            "pitch_rate",
            Unit::RadianPerSecond,
            OutputSlot::TrimPitchRate,
            "Pitch rate, beside that of a turn,",
        ),
        ("load_factor", Unit::One, OutputSlot::TrimLoadFactor, "Load factor across the flow"),
    ];
    let flown = flown.into_iter().filter(|_| model.support == Support::Free);
    for (name, unit, slot, text) in trim.into_iter().flatten().chain(flown) {
        let text = format!("{text} of the trim found at initialisation");
        let row = output(format!("trim.{name}"), unit, slot, text);
        rows.push(Variable { variability: Variability::Discrete, ..row });
    }
    rows
}

/// A description without its capital, unless it begins with more than one or none at all: "V-tail" stays.
fn within_a_sentence(description: &str) -> String {
    let mut letters = description.chars();
    match (letters.next(), letters.next()) {
        (Some(first), Some(second)) if second.is_lowercase() => {
            first.to_lowercase().chain(std::iter::once(second)).chain(letters).collect()
        }
        _ => description.to_owned(),
    }
}

pub(super) const NORTH_EAST_DOWN: [&str; 3] = ["north", "east", "down"];

//! The rows of the table.

use crate::aircraft::{ALTITUDES, Control, Support, TrimRole};
use crate::flight::Settings;
use crate::plant::PlantSettings;
use crate::structure::{Mode, ModeFamily, ReducedModel};

use super::{
    AirQuantity, Axis, DeflectionComponent, EnumerationType, InputSlot, OutputSlot, ParameterSlot, Slot,
    Type, Unit, Value, Variability, Variable,
};

/// All rows for an aircraft, inputs first.
pub(super) fn rows(model: &ReducedModel) -> Vec<Variable> {
    let mut rows = inputs(model);
    rows.extend(parameters(model));
    rows.extend(motion());
    rows.extend(flow());
    rows.extend(deflections(model));
    rows.extend(sensors(model));
    rows.extend(modal_coordinates(model));
    rows.extend(controls_and_trim(model));
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

fn parameters(model: &ReducedModel) -> Vec<Variable> {
    use ParameterSlot as P;
    let start = Settings::of(model);
    let airspeeds = model.support.airspeeds();
    let choice = |name, slot, kind: EnumerationType, text| {
        Variable { kind: Type::Enumeration(kind), ..parameter(name, slot, &start, text) }
            .between(1.0, kind.items().len() as f64)
    };
    let count = |name, slot, max: usize, text| {
        Variable { kind: Type::Integer, ..parameter(name, slot, &start, text) }.between(0.0, max as f64)
    };
    let real = |name, slot, unit, text| Variable { unit: Some(unit), ..parameter(name, slot, &start, text) };
    let rows = vec![
        choice(
            "input_reference",
            P::InputReference,
            EnumerationType::InputReference,
            "Whether the inputs of controls and thrusts add to the trim values or replace them",
        ),
        choice("model", P::Model, EnumerationType::Model, "Fidelity level"),
        real(
            "airspeed",
            P::Airspeed,
            Unit::MetrePerSecond,
            "True airspeed of the trimmed flight at the start",
        )
        .between(*airspeeds.start(), *airspeeds.end()),
        real("altitude", P::Altitude, Unit::Metre, "Altitude of the trimmed flight at the start")
            .between(*ALTITUDES.start(), *ALTITUDES.end())
            .nominal(10_000.0),
        real("heading", P::Heading, Unit::Radian, "Initial yaw angle"),
        real("stiffness_scale", P::StiffnessScale, Unit::One, "Factor on all elastic properties")
            .at_least(1e-6),
        real("structural_damping", P::StructuralDamping, Unit::One, "Modal damping ratio of every mode")
            .at_least(0.0),
        choice("mode_family", P::ModeFamily, EnumerationType::ModeFamily, "Families of modes that take part"),
        count(
            "mode_count",
            P::ModeCount,
            model.natural_modes(),
            "Number of natural modes that take part, lowest first; of mirrored pairs both do",
        ),
        Variable {
            kind: Type::Boolean,
            ..parameter(
                "load_modes",
                P::LoadModes,
                &start,
                "Whether the load modes that belong to those natural modes take part too",
            )
        },
        count(
            "inflow_states",
            P::InflowStates,
            PlantSettings::MOST_INFLOW_STATES,
            "Peters inflow states per strip; 0 is steady aerodynamics",
        ),
        real("tolerance", P::Tolerance, Unit::One, "Relative tolerance of the internal integrator")
            .between(1e-12, 0.1),
    ];
    let is_there = |row: &Variable| match row.slot {
        Slot::Parameter(P::Altitude) => model.tunnel_air.is_none(),
        Slot::Parameter(P::LoadModes) => model.has_load_modes(),
        _ => true,
    };
    rows.into_iter().filter(is_there).collect()
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
            ("thrust", Unit::Newton, OutputSlot::TrimThrust, "Thrust per engine")
        }),
        Some(("roll", Unit::Radian, OutputSlot::TrimRoll, "Bank angle")),
        Some(("beta", Unit::Radian, OutputSlot::TrimSideslip, "Sideslip angle")),
        with_role(TrimRole::Roll),
        with_role(TrimRole::Yaw),
    ];
    for (name, unit, slot, text) in trim.into_iter().flatten() {
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

fn input(name: &str, unit: Unit, slot: InputSlot, description: &str) -> Variable {
    Variable {
        start: Some(Value::Real(0.0)),
        ..real(name.to_owned(), Some(unit), Slot::Input(slot), description.to_owned())
    }
}

/// A parameter; type and unit are for the caller to add.
fn parameter(name: &str, slot: ParameterSlot, start: &Settings, description: &str) -> Variable {
    Variable {
        variability: Variability::Fixed,
        start: Some(slot.get(start)),
        ..real(name.to_owned(), None, Slot::Parameter(slot), description.to_owned())
    }
}

pub(super) fn output(
    name: String,
    unit: impl Into<Option<Unit>>,
    slot: OutputSlot,
    description: String,
) -> Variable {
    real(name, unit.into(), Slot::Output(slot), description)
}

fn real(name: String, unit: Option<Unit>, slot: Slot, description: String) -> Variable {
    Variable {
        name,
        description,
        kind: Type::Real,
        variability: Variability::Continuous,
        unit,
        start: None,
        min: None,
        max: None,
        nominal: None,
        slot,
    }
}

impl Variable {
    fn at_least(self, min: f64) -> Self {
        Variable { min: Some(min), ..self }
    }

    fn between(self, min: f64, max: f64) -> Self {
        Variable { min: Some(min), max: Some(max), ..self }
    }

    fn nominal(self, nominal: f64) -> Self {
        Variable { nominal: Some(nominal), ..self }
    }
}

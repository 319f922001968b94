//! The rows of the flight condition beside airspeed, altitude and heading [theory: trim.manoeuvres].

use crate::aircraft::Support;
use crate::flight::Settings;
use crate::plant::{LARGEST_LOAD_FACTOR, STEEPEST};
use crate::structure::ReducedModel;

use super::condition_slot::ConditionSetting;
use super::enumeration::EnumerationType;
use super::row::parameter;
use super::slot::ParameterSlot;
use super::unit::Unit;
use super::variable::{Type, Variable};

/// Those of an aircraft that flies.
pub(super) fn parameters(model: &ReducedModel, start: &Settings) -> Vec<Variable> {
    use ConditionSetting as C;
    if model.support == Support::Clamped {
        return Vec::new();
    }
    let row = |name: &str, setting, text: &str| {
        parameter(format!("condition.{name}"), ParameterSlot::Condition(setting), start, text)
    };
    let angle = |name, setting, text| {
        Variable { unit: Some(Unit::Radian), ..row(name, setting, text) }.between(-STEEPEST, STEEPEST)
    };
    let choice = |name, setting, kind: EnumerationType, text| {
        let row = Variable { kind: Type::Enumeration(kind), ..row(name, setting, text) };
        row.between(1.0, kind.items().len() as f64)
    };
    let mut rows = vec![choice(
        "manoeuvre",
        C::Manoeuvre,
        EnumerationType::Manoeuvre,
        "Flight that is trimmed at the start",
    )];
    if !model.engines.is_empty() {
        rows.push(angle("climb_angle", C::ClimbAngle, "Climb angle of the path at the start"));
    }
    rows.extend([
        angle(
            "bank_angle",
            C::BankAngle,
            "Bank angle of a turn whose load factor is 0, or of a straight flight with condition.lateral = bank; positive to the right",
        ),
        Variable {
            unit: Some(Unit::One),
            ..row(
                "load_factor",
                C::LoadFactor,
                "Load factor across the flow of a pull-up, or of a turn without bank angle, negative to the left; 0: not given",
            )
        }
        .between(-LARGEST_LOAD_FACTOR, LARGEST_LOAD_FACTOR),
        angle(
            "sideslip",
            C::Sideslip,
            "Sideslip of a straight flight with condition.lateral = sideslip; positive with the wind from the right",
        ),
        choice(
            "lateral",
            C::Lateral,
            EnumerationType::Lateral,
            "What is given of a straight flight: sideslip or bank angle; the other is found",
        ),
    ]);
    if model.engines.len() > 1 {
        let names: Vec<String> = model
            .engines
            .iter()
            .enumerate()
            .map(|(i, engine)| format!("{}: {}", i + 1, engine.name))
            .collect();
        let text = format!(
            "Engine without thrust in the trim of a straight flight, whose input acts all the same; 0: none, {}",
            names.join(", ")
        );
        let failed = Variable { kind: Type::Integer, ..row("failed_engine", C::FailedEngine, &text) };
        rows.push(failed.between(0.0, model.engines.len() as f64));
    }
    rows
}

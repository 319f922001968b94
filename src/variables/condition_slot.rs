//! Where the parameters of the flight condition live.

use crate::plant::{ConditionSettings, Lateral, ManoeuvreChoice};

use super::value::Value;

/// A parameter of the flight condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the quantities are documented in ConditionSettings")]
pub enum ConditionSetting {
    Manoeuvre,
    ClimbAngle,
    BankAngle,
    LoadFactor,
    Sideslip,
    Lateral,
    FailedEngine,
}

/// All items of the enumerations, in the order of their numbers from 1.
const MANOEUVRES: [ManoeuvreChoice; 3] =
    [ManoeuvreChoice::Straight, ManoeuvreChoice::Turn, ManoeuvreChoice::PullUp];
const LATERALS: [Lateral; 2] = [Lateral::Sideslip, Lateral::Bank];

impl ConditionSetting {
    pub(super) fn get(self, condition: &ConditionSettings) -> Value {
        match self {
            ConditionSetting::Manoeuvre => Value::Integer(condition.manoeuvre as i32 + 1),
            ConditionSetting::ClimbAngle => Value::Real(condition.climb_angle),
            ConditionSetting::BankAngle => Value::Real(condition.bank_angle),
            ConditionSetting::LoadFactor => Value::Real(condition.load_factor),
            ConditionSetting::Sideslip => Value::Real(condition.sideslip),
            ConditionSetting::Lateral => Value::Integer(condition.lateral as i32 + 1),
            ConditionSetting::FailedEngine => {
                Value::Integer(i32::try_from(condition.failed_engine).unwrap_or(i32::MAX))
            }
        }
    }

    /// A value of the wrong type or outside an enumeration changes nothing.
    pub(super) fn set(self, condition: &mut ConditionSettings, value: Value) {
        let place = |number: i32| usize::try_from(number).ok()?.checked_sub(1);
        match (self, value) {
            (ConditionSetting::Manoeuvre, Value::Integer(i)) => {
                let item = place(i).and_then(|place| MANOEUVRES.get(place));
                condition.manoeuvre = item.copied().unwrap_or(condition.manoeuvre);
            }
            (ConditionSetting::Lateral, Value::Integer(i)) => {
                let item = place(i).and_then(|place| LATERALS.get(place));
                condition.lateral = item.copied().unwrap_or(condition.lateral);
            }
            (ConditionSetting::FailedEngine, Value::Integer(i)) => {
                condition.failed_engine = usize::try_from(i).unwrap_or(condition.failed_engine);
            }
            (ConditionSetting::ClimbAngle, Value::Real(x)) => condition.climb_angle = x,
            (ConditionSetting::BankAngle, Value::Real(x)) => condition.bank_angle = x,
            (ConditionSetting::LoadFactor, Value::Real(x)) => condition.load_factor = x,
            (ConditionSetting::Sideslip, Value::Real(x)) => condition.sideslip = x,
            _ => {}
        }
    }
}

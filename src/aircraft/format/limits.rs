//! `[limits]`: what the aircraft is flown within.

use super::allowed::{ANGLE_DEG, MACH, THRUST};
use super::control;
use super::table::{Absent, Field, Kind, Table};
use crate::aircraft::limits::{USUAL_ANGLE_OF_ATTACK, USUAL_LEAST_THRUST, USUAL_MACH};

pub(super) static LIMITS: Table = Table {
    path: "limits",
    sentence: "What trims should stay within: beyond, they stand with a warning",
    fields: &[&LEAST_ANGLE_OF_ATTACK, &MOST_ANGLE_OF_ATTACK, &MOST_MACH, &LEAST_THRUST, &MOST_THRUST],
    rules: &[],
    former: &[&FORMER_SURFACE],
};

pub static LEAST_ANGLE_OF_ATTACK: Field = Field {
    name: "minimum_angle_of_attack_deg",
    kind: Kind::Number(&ANGLE_DEG),
    unit: "deg",
    absent: Absent::Number(-USUAL_ANGLE_OF_ATTACK),
    sentence: "the least angle of attack of body x at O",
};
pub static MOST_ANGLE_OF_ATTACK: Field = Field {
    name: "maximum_angle_of_attack_deg",
    kind: Kind::Number(&ANGLE_DEG),
    unit: "deg",
    absent: Absent::Number(USUAL_ANGLE_OF_ATTACK),
    sentence: "the greatest angle of attack of body x at O, above the least",
};
pub static MOST_MACH: Field = Field {
    name: "maximum_mach",
    kind: Kind::Number(&MACH),
    unit: "",
    absent: Absent::Number(USUAL_MACH),
    sentence: "the greatest Mach number",
};
pub static LEAST_THRUST: Field = Field {
    name: "minimum_thrust_N",
    kind: Kind::Number(&THRUST),
    unit: "N",
    absent: Absent::Number(USUAL_LEAST_THRUST),
    sentence: "the least thrust of each engine",
};
pub static MOST_THRUST: Field = Field {
    name: "maximum_thrust_N",
    kind: Kind::Number(&THRUST),
    unit: "N",
    absent: Absent::Nothing,
    sentence: "the greatest thrust of each engine, above the least",
};

/// Where limits of controls stood before controls had tables of their own.
pub static FORMER_SURFACE: Field = Field {
    name: "surface",
    kind: Kind::Table(&FORMER),
    unit: "",
    absent: Absent::Nothing,
    sentence: "tables of limits by the names of controls",
};

static FORMER: Table = Table {
    path: "limits.surface",
    sentence: "Limits of a control",
    fields: &[&control::MINIMUM, &control::MAXIMUM],
    rules: &[],
    former: &[],
};

//! `[[control]]`: what turns the flaps.

use super::allowed::ANGLE_DEG;
use super::table::{Absent, Field, Kind, Table, Word};
use crate::aircraft::control::TrimRole;
use crate::aircraft::limits::USUAL_DEFLECTION;

pub(super) static CONTROL: Table = Table {
    path: "control",
    sentence: "An angle that a pilot or a control law sets: an input of the FMU, in the order of the file",
    fields: &[&NAME, &DESCRIPTION, &POSITIVE, &MIRROR, &TRIM, &MINIMUM, &MAXIMUM],
    rules: &[],
    former: &[],
};

pub static NAME: Field = Field {
    name: "name",
    kind: Kind::Name,
    unit: "",
    absent: Absent::Needed,
    sentence: "the input; the outputs `surface.<name>` (this control's angle as it acts, trim included) and, with a role, \
               `trim.<name>`. Letters, digits, underscores, not a digit first, and no name that another variable has: \
               `model`, `wind_north`, `thrust_<engine>` …",
};
pub static DESCRIPTION: Field = Field {
    name: "description",
    kind: Kind::Phrase,
    unit: "",
    absent: Absent::Found("\"Angle of …\""),
    sentence: "for people; a full stop at its end is left out",
};
pub static POSITIVE: Field = Field {
    name: "positive",
    kind: Kind::Phrase,
    unit: "",
    absent: Absent::Needed,
    sentence: "what a positive angle does, in words, as in \"positive nose-down\"",
};
pub static MIRROR: Field = Field {
    name: "mirror",
    kind: Kind::OneOf(&[SAME, OPPOSITE, NONE]),
    unit: "",
    absent: Absent::Needed,
    sentence: "how gains pass to the mirror image of a component",
};
pub static TRIM: Field = Field {
    name: "trim",
    kind: Kind::OneOf(&[PITCH, ROLL, YAW]),
    unit: "",
    absent: Absent::Nothing,
    sentence: "its role in trims, which one control at most has and whose flaps must be able to (for pitch they act alike on both \
               sides, for roll and yaw against each other, or stand upright as a fin's)",
};
pub static MINIMUM: Field = Field {
    name: "minimum_deg",
    kind: Kind::Number(&ANGLE_DEG),
    unit: "deg",
    absent: Absent::Number(-USUAL_DEFLECTION),
    sentence: "the least angle that trims should have; it changes no flight. Without a role 0 is between the two",
};
pub static MAXIMUM: Field = Field {
    name: "maximum_deg",
    kind: Kind::Number(&ANGLE_DEG),
    unit: "deg",
    absent: Absent::Number(USUAL_DEFLECTION),
    sentence: "the greatest angle that trims should have, above the least; it changes no flight",
};

pub const SAME: Word = Word { word: "same", sentence: "both sides alike, as an elevator" };
pub const OPPOSITE: Word = Word { word: "opposite", sentence: "with the other sign, as ailerons" };
pub const NONE: Word =
    Word { word: "none", sentence: "each side by itself: what the control turns there has a `side`" };

pub const PITCH: Word =
    Word { word: TrimRole::Pitch.word(), sentence: "balances every free flight, and is needed there" };
pub const ROLL: Word =
    Word { word: TrimRole::Roll.word(), sentence: "balances flights that would roll aside" };
pub const YAW: Word = Word { word: TrimRole::Yaw.word(), sentence: "balances flights that would yaw aside" };

//! `[[joint]]`: two nodes that move together.

use super::allowed::FRACTION;
use super::table::{Absent, Field, Kind, Table, Word};

pub(super) static JOINT: Table = Table {
    path: "joint",
    sentence: "Two nodes that move together: a strut and its wing, the halves of a tail between booms. With a mirrored component it is \
               on both sides. No `model = \"geometrically_exact\"` then",
    fields: &[&COMPONENT, &AT, &JOINED_TO, &ROTATIONS],
    rules: &[],
    former: &[],
};
pub static COMPONENT: Field = Field {
    name: "component",
    kind: Kind::Name,
    unit: "",
    absent: Absent::Needed,
    sentence: "the component that has the one node; of mirrored ones, one side is written",
};
pub static AT: Field = Field {
    name: "at",
    kind: Kind::Number(&FRACTION),
    unit: "",
    absent: Absent::Needed,
    sentence: "the fraction of that component's length; there must be a node",
};
pub static JOINED_TO: Field = Field {
    name: "joined_to",
    kind: Kind::Table(&OTHER),
    unit: "",
    absent: Absent::Needed,
    sentence: "the other node, within 1 mm of the one: `{ component = \"…\", at = 1 }`",
};
pub static ROTATIONS: Field = Field {
    name: "rotations",
    kind: Kind::WordOrWords(&[FREE, FIXED], &AXES),
    unit: "",
    absent: Absent::Needed,
    sentence: "which rotations they share beside their displacements; a list names the body axes about which they turn together",
};

static OTHER: Table = Table {
    path: "joint.joined_to",
    sentence: "The other node",
    fields: &[&OTHER_COMPONENT, &OTHER_AT],
    rules: &[],
    former: &[],
};
pub static OTHER_COMPONENT: Field = Field {
    name: "component",
    kind: Kind::Name,
    unit: "",
    absent: Absent::Needed,
    sentence: "the component that has the other node; the same as the first in no case but a ring's",
};
pub static OTHER_AT: Field = Field {
    name: "at",
    kind: Kind::Number(&FRACTION),
    unit: "",
    absent: Absent::Needed,
    sentence: "the fraction of that component's length; there must be a node",
};

pub const FREE: Word = Word { word: "free", sentence: "none: a pin, as of a strut" };
pub const FIXED: Word = Word { word: "fixed", sentence: "all: a rigid joint, as of tail booms" };
/// In the order of the body axes.
pub static AXES: [Word; 3] = [
    Word { word: "x", sentence: "roll" },
    Word { word: "y", sentence: "pitch" },
    Word { word: "z", sentence: "yaw" },
];

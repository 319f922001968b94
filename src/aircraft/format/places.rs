//! Places along components, and what there is at them: `[[engine]]`, `[[station]]`, `[[cut]]`.

use super::allowed::{
    ANGULAR_MOMENTUM as MOMENTA, DISTANCE, FRACTION, LENGTH, THRUST_SHARE, TORQUE_PER_THRUST,
};
use super::table::{Absent, Field, Kind, Rule, Table};

/// Where along a component some things are.
pub static ALONG: [&Field; 2] = [&AT_METRES, &AT];
/// Where along a component one thing is.
pub static PLACE: [&Field; 2] = [&PLACE_METRES, &PLACE_FRACTION];

pub static AT_METRES: Field = Field {
    name: "at_m",
    kind: Kind::NumberOrMore(&DISTANCE),
    unit: "m",
    absent: Absent::Nothing,
    sentence: "distances along the component from its root, up to its length",
};
pub static AT: Field = Field {
    name: "at",
    kind: Kind::NumberOrMore(&FRACTION),
    unit: "",
    absent: Absent::Nothing,
    sentence: "fractions of the component's length",
};
pub static PLACE_METRES: Field = Field {
    name: AT_METRES.name,
    kind: Kind::Number(&DISTANCE),
    unit: "m",
    absent: Absent::Nothing,
    sentence: "distance along the component from its root, up to its length",
};
pub static PLACE_FRACTION: Field = Field {
    name: AT.name,
    kind: Kind::Number(&FRACTION),
    unit: "",
    absent: Absent::Nothing,
    sentence: "fraction of the component's length",
};

/// Where a stretch of a component begins.
pub static FROM: Field = Field {
    name: "from",
    kind: Kind::Number(&FRACTION),
    unit: "",
    absent: Absent::Number(0.0),
    sentence: "where the stretch begins, as a fraction of the component's length",
};
/// Where it ends.
pub static TO: Field = Field {
    name: "to",
    kind: Kind::Number(&FRACTION),
    unit: "",
    absent: Absent::Number(1.0),
    sentence: "where the stretch ends, beyond `from`",
};

/// From the elastic axis.
pub static OFFSET: Field = Field {
    name: "offset_m",
    kind: Kind::Vector(&LENGTH),
    unit: "m",
    absent: Absent::Zeros,
    sentence: "centre of mass from the elastic axis, body axes; of a distributed mass added to that of `offset_chords`",
};

pub(super) static ENGINE: Table = Table {
    path: "engine",
    sentence: "Where thrust acts. Engines weigh nothing by themselves: their masses are point masses",
    fields: &[
        &ENGINE_NAME,
        &COMPONENT,
        &PLACE_METRES,
        &PLACE_FRACTION,
        &THRUST_OFFSET,
        &DIRECTION,
        &TORQUE,
        &ANGULAR_MOMENTUM,
        &TRIM_SHARE,
    ],
    rules: &[Rule::ExactlyOne(&PLACE)],
    former: &[],
};
pub static ENGINE_NAME: Field = name("the input `thrust_<name>`");
pub static THRUST_OFFSET: Field = Field {
    name: "offset_m",
    kind: Kind::Vector(&LENGTH),
    unit: "m",
    absent: Absent::Zeros,
    sentence: "where the thrust acts, from the elastic axis, body axes",
};
pub static DIRECTION: Field = Field {
    name: "direction",
    kind: Kind::Direction,
    unit: "",
    absent: Absent::Needed,
    sentence: "the direction of the thrust, body axes",
};

pub static TORQUE: Field = Field {
    name: "torque_m",
    kind: Kind::Number(&TORQUE_PER_THRUST),
    unit: "m",
    absent: Absent::Number(0.0),
    sentence: "torque on the aircraft in N m per N of thrust, right-handed about `direction`: negative for a propeller that turns \
               clockwise as seen from behind. With `symmetric = true` a mirror image has the opposite, an engine in the plane none",
};
pub static ANGULAR_MOMENTUM: Field = Field {
    name: "angular_momentum_kg_m2_s",
    kind: Kind::Number(&MOMENTA),
    unit: "kg m²/s",
    absent: Absent::Number(0.0),
    sentence: "angular momentum of what turns in it, along `direction`, constant: positive for a propeller that turns clockwise as \
               seen from behind. With `symmetric = true` a mirror image has the opposite, an engine in the plane none",
};
pub static TRIM_SHARE: Field = Field {
    name: "trim_share",
    kind: Kind::Number(&THRUST_SHARE),
    unit: "",
    absent: Absent::Number(1.0),
    sentence: "in what proportion to the others it has the thrust of trims; some engine needs more than 0",
};

pub(super) static STATION: Table = Table {
    path: "station",
    sentence: "A point whose deflections are outputs",
    fields: &[&STATION_NAME, &COMPONENT, &PLACE_METRES, &PLACE_FRACTION],
    rules: &[Rule::ExactlyOne(&PLACE)],
    former: &[],
};
pub static STATION_NAME: Field = name("the outputs `deflection.<name>.*`");

/// Of engines and stations.
pub static COMPONENT: Field = Field {
    name: "component",
    kind: Kind::Name,
    unit: "",
    absent: Absent::Needed,
    sentence: "where it sits; mirror images have their names too",
};

pub(super) static CUT: Table = Table {
    path: "cut",
    sentence: "A section of the airframe whose loads are outputs; it changes no flight",
    fields: &[&CUT_NAME, &CUT_COMPONENT, &CUT_AT],
    rules: &[],
    former: &[],
};
pub static CUT_NAME: Field = name(
    "of the cut: the outputs are `loads.<name>.shear`, `.shear_chordwise`, `.axial` (N), `.torsion`, `.bending`, \
     `.bending_chordwise` (N m)",
);
pub static CUT_COMPONENT: Field = Field {
    name: "component",
    kind: Kind::Name,
    unit: "",
    absent: Absent::Needed,
    sentence: "the component that is cut",
};
pub static CUT_AT: Field = Field {
    name: "at",
    kind: Kind::Number(&FRACTION),
    unit: "",
    absent: Absent::Needed,
    sentence: "where, as a fraction of its length along the axis; the cut stands at the nearest node, of two the inner one: \
               the descriptions of its outputs say where",
};

const fn name(sentence: &'static str) -> Field {
    Field { name: "name", kind: Kind::Name, unit: "", absent: Absent::Needed, sentence }
}

//! `[[component]]`: a beam.

use super::allowed::{BEAM_STIFFNESS, FRACTION, LENGTH, POSITIVE_LENGTH};
use super::law::{EA, EI_Y, EI_Z, FORMS, FORMS_OF_CHORD, GJ};
use super::masses::{DISTRIBUTED_MASS, POINT_MASSES};
use super::section::{
    BEND_TWIST_Y, BEND_TWIST_Z, BENDING_PRODUCT, BOX_FIELD, HINGE_FIELD, SECTION_MASS, SECTION_STIFFNESS,
    SHEAR_Y, SHEAR_Z, TENSION_Y, TENSION_Z,
};
use super::surface::SURFACE;
use super::table::{Absent, Field, Kind, Rule, Table, Word};

/// More elements than this are a slip of the pen, and would only run out of memory.
const MOST_ELEMENTS: usize = 1000;

pub(super) static COMPONENT: Table = Table {
    path: "component",
    sentence: "A beam, and what it carries",
    fields: &[
        &NAME,
        &MIRROR,
        &ATTACHED_TO,
        &AXIS,
        &ELEMENTS,
        &Y_AXIS,
        &AXIAL,
        &TORSIONAL,
        &BENDING_Y,
        &BENDING_Z,
        &BENDING_PRODUCT,
        &BEND_TWIST_Y,
        &BEND_TWIST_Z,
        &TENSION_Y,
        &TENSION_Z,
        &SHEAR_Y,
        &SHEAR_Z,
        &SECTION_STIFFNESS,
        &BOX_FIELD,
        &HINGE_FIELD,
        &CHORD,
        &DISTRIBUTED_MASSES,
        &SECTION_MASS,
        &POINT_MASSES_FIELD,
        &SURFACES,
    ],
    rules: &[
        Rule::ExactlyOne(&SOURCES),
        Rule::Needs(&AXIAL, &TORSIONAL),
        Rule::Needs(&AXIAL, &BENDING_Y),
        Rule::Needs(&AXIAL, &BENDING_Z),
        Rule::Needs(&TORSIONAL, &AXIAL),
        Rule::Needs(&BENDING_Y, &AXIAL),
        Rule::Needs(&BENDING_Z, &AXIAL),
        Rule::AtMostOne(&[&BENDING_PRODUCT, &SECTION_STIFFNESS]),
        Rule::AtMostOne(&[&BEND_TWIST_Y, &SECTION_STIFFNESS]),
        Rule::AtMostOne(&[&BEND_TWIST_Z, &SECTION_STIFFNESS]),
        Rule::AtMostOne(&[&TENSION_Y, &SECTION_STIFFNESS]),
        Rule::AtMostOne(&[&TENSION_Z, &SECTION_STIFFNESS]),
        Rule::AtMostOne(&[&SHEAR_Y, &SECTION_STIFFNESS]),
        Rule::AtMostOne(&[&SHEAR_Z, &SECTION_STIFFNESS]),
    ],
    former: &[],
};

pub static NAME: Field = Field {
    name: "name",
    kind: Kind::Name,
    unit: "",
    absent: Absent::Needed,
    sentence: "letters, digits, underscores, not a digit first",
};
pub static MIRROR: Field = Field {
    name: "mirror",
    kind: Kind::Name,
    unit: "",
    absent: Absent::Nothing,
    sentence: "name of its mirror image in y = 0, which follows it; everything it carries is mirrored too, on the mirrored \
               parent if there is one; gains as each control's `mirror` says",
};
pub static ATTACHED_TO: Field = Field {
    name: "attached_to",
    kind: Kind::WordOrTable(&ORIGIN, &PARENT),
    unit: "",
    absent: Absent::Needed,
    sentence: "`\"origin\"`, or `{ component = \"…\", at = 1 }` with the fraction of that component's length",
};
pub static AXIS: Field = Field {
    name: "axis_m",
    kind: Kind::Corners(&LENGTH),
    unit: "m",
    absent: Absent::Needed,
    sentence: "corners of the elastic axis from the attachment point; the first is `[0, 0, 0]`",
};
pub static ELEMENTS: Field = Field {
    name: "elements",
    kind: Kind::WholeOrMore(1, MOST_ELEMENTS),
    unit: "",
    absent: Absent::Needed,
    sentence: "number of elements; a list when the axis has several segments",
};
pub static Y_AXIS: Field = Field {
    name: "y_axis",
    kind: Kind::Direction,
    unit: "",
    absent: Absent::Needed,
    sentence: "local y of the section, roughly (made perpendicular to each element); local x runs along the axis, z = x × y",
};
pub static AXIAL: Field = stiffness(EA, "N", "axial stiffness", Absent::Nothing);
pub static TORSIONAL: Field = stiffness(GJ, "N m²", "torsional stiffness", WITH_AXIAL);
pub static BENDING_Y: Field = stiffness(EI_Y, "N m²", "bending stiffness in local z (∫E z² dA)", WITH_AXIAL);
pub static BENDING_Z: Field = stiffness(EI_Z, "N m²", "bending stiffness in local y", WITH_AXIAL);
pub static CHORD: Field = Field {
    name: "chord_m",
    kind: Kind::Law(&POSITIVE_LENGTH, &FORMS_OF_CHORD),
    unit: "m",
    absent: Absent::Found("none; needed where something uses it"),
    sentence: "the chord, which surfaces and whatever is in chords use; by any form but `root` and `multiple_of`",
};
pub static DISTRIBUTED_MASSES: Field = carried("distributed_mass", &DISTRIBUTED_MASS, "structure, fuel");
pub static POINT_MASSES_FIELD: Field = carried("point_masses", &POINT_MASSES, "engines, gear, payload");
pub static SURFACES: Field = carried("surface", &SURFACE, "aerodynamic strips");

/// In the order in which a component holds its stiffnesses.
pub static STIFFNESSES: [&Field; 4] = [&AXIAL, &TORSIONAL, &BENDING_Y, &BENDING_Z];

/// What says how stiff a component is.
pub static SOURCES: [&Field; 3] = [&AXIAL, &SECTION_STIFFNESS, &BOX_FIELD];

const WITH_AXIAL: Absent = Absent::Found("needed with `EA_N`");

const fn stiffness(name: &'static str, unit: &'static str, sentence: &'static str, absent: Absent) -> Field {
    Field { name, kind: Kind::Law(&BEAM_STIFFNESS, &FORMS), unit, absent, sentence }
}

/// Tables of what a component carries, of which there may be any number.
const fn carried(name: &'static str, table: &'static Table, sentence: &'static str) -> Field {
    Field { name, kind: Kind::Tables(table, 0), unit: "", absent: Absent::Nothing, sentence }
}

pub static ORIGIN: Word = Word { word: "origin", sentence: "at O" };

static PARENT: Table = Table {
    path: "component.attached_to",
    sentence: "A node of a component above",
    fields: &[&PARENT_NAME, &PARENT_AT],
    rules: &[],
    former: &[],
};
pub static PARENT_NAME: Field = Field {
    name: "component",
    kind: Kind::Name,
    unit: "",
    absent: Absent::Needed,
    sentence: "a component above this one, or its mirror image",
};
pub static PARENT_AT: Field = Field {
    name: "at",
    kind: Kind::Number(&FRACTION),
    unit: "",
    absent: Absent::Needed,
    sentence: "the fraction of that component's length; there must be a node",
};

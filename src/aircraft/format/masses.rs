//! `[[component.distributed_mass]]` and `[[component.point_masses]]`.

use super::allowed::{ANY, CHORDS, GYRATION, INERTIA, INERTIA_PRODUCT, MASS, SHARE};
use super::law::FORMS;
use super::places::{ALONG, AT, AT_METRES, FROM, OFFSET, TO};
use super::table::{Absent, Field, Kind, Rule, Table};

pub(super) static DISTRIBUTED_MASS: Table = Table {
    path: "component.distributed_mass",
    sentence: "Structure, fuel: one rigid lump at the middle of each element, or of each part of one. Masses are those of one \
               side; the mirror image has its own",
    fields: &[&PARTS, &OFFSET_CHORDS, &OFFSET, &GYRATION_CHORDS, &GYRATION_LENGTHS, &ADDED_INERTIA],
    rules: &[],
    former: &[],
};

pub static PARTS: Field = Field {
    name: "parts",
    kind: Kind::Tables(&PART, 1),
    unit: "",
    absent: Absent::Needed,
    sentence: "list of `{ total_kg, chord_power, from, to }`: mass per length ∝ c^`chord_power` on the stretch `from` … `to`",
};
pub static OFFSET_CHORDS: Field = Field {
    name: "offset_chords",
    kind: Kind::Laws(&CHORDS, &FORMS),
    unit: "chords",
    absent: Absent::Zeros,
    sentence: "centre of mass from the elastic axis, body axes; added to `offset_m`. Each number may be a law",
};
pub static GYRATION_CHORDS: Field = Field {
    name: "gyration_chords",
    kind: Kind::Laws(&GYRATION, &FORMS),
    unit: "chords",
    absent: Absent::Zeros,
    sentence: "radii of gyration about body axes through the centre of mass. Each number may be a law; squares are added to \
               those of `gyration_lengths`",
};
pub static GYRATION_LENGTHS: Field = Field {
    name: "gyration_lengths",
    kind: Kind::Vector(&GYRATION),
    unit: "lengths",
    absent: Absent::Zeros,
    sentence: "radii of gyration about body axes through the centre of mass, in lengths of the element or its part (slender: 1/√12 = \
               0.2887 lengths); squares are added to those of `gyration_chords`",
};
pub static ADDED_INERTIA: Field = Field {
    name: "added_inertia_kg_m2",
    kind: Kind::Vector(&INERTIA),
    unit: "kg m²",
    absent: Absent::Zeros,
    sentence: "added to the moments of inertia of each element's lump",
};

static PART: Table = Table {
    path: "component.distributed_mass.parts",
    sentence: "A mass on a stretch of the component",
    fields: &[&PART_TOTAL, &CHORD_POWER, &FROM, &TO],
    rules: &[],
    former: &[],
};
pub static PART_TOTAL: Field = Field {
    name: "total_kg",
    kind: Kind::Number(&MASS),
    unit: "kg",
    absent: Absent::Needed,
    sentence: "the mass on the stretch",
};
pub static CHORD_POWER: Field = Field {
    name: "chord_power",
    kind: Kind::Number(&ANY),
    unit: "",
    absent: Absent::Number(0.0),
    sentence: "the power of the chord that mass per length goes with",
};

pub(super) static POINT_MASSES: Table = Table {
    path: "component.point_masses",
    sentence: "Engines, gear, payload: rigid masses at some places",
    fields: &[
        &AT_METRES,
        &AT,
        &EACH_MASS,
        &TOTAL,
        &SHARES,
        &SHARES_OF,
        &OFFSET,
        &GYRATION_RADII,
        &MOMENTS_OF_INERTIA,
        &PRODUCTS,
    ],
    rules: &[
        Rule::ExactlyOne(&ALONG),
        Rule::ExactlyOne(&MASSES),
        Rule::Needs(&TOTAL, &SHARES),
        Rule::Needs(&SHARES, &TOTAL),
        Rule::Needs(&SHARES_OF, &TOTAL),
        Rule::AtMostOne(&INERTIAS),
    ],
    former: &[],
};

/// Which masses there are.
pub static MASSES: [&Field; 2] = [&EACH_MASS, &TOTAL];

/// How they resist turning.
pub static INERTIAS: [&Field; 2] = [&GYRATION_RADII, &MOMENTS_OF_INERTIA];

pub static EACH_MASS: Field = Field {
    name: "mass_kg",
    kind: Kind::NumberOrMore(&MASS),
    unit: "kg",
    absent: Absent::Nothing,
    sentence: "one mass for all places, or a list",
};
pub static TOTAL: Field = Field {
    name: "total_kg",
    kind: Kind::Number(&MASS),
    unit: "kg",
    absent: Absent::Nothing,
    sentence: "a total that is divided in proportion to `shares`",
};
pub static SHARES: Field = Field {
    name: "shares",
    kind: Kind::Numbers(&SHARE),
    unit: "",
    absent: Absent::Nothing,
    sentence: "of `total_kg`, one for each place",
};
pub static SHARES_OF: Field = Field {
    name: "shares_of",
    kind: Kind::Number(&SHARE),
    unit: "",
    absent: Absent::Found("the sum of `shares`"),
    sentence: "the whole that shares are parts of, when other components carry the rest",
};
pub static GYRATION_RADII: Field = Field {
    name: "gyration_m",
    kind: Kind::Vector(&GYRATION),
    unit: "m",
    absent: Absent::Zeros,
    sentence: "radii of gyration about body axes through the centre of mass",
};
pub static MOMENTS_OF_INERTIA: Field = Field {
    name: "inertia_kg_m2",
    kind: Kind::Vector(&INERTIA),
    unit: "kg m²",
    absent: Absent::Zeros,
    sentence: "moments of inertia about body axes through the centre of mass",
};
pub static PRODUCTS: Field = Field {
    name: "products_kg_m2",
    kind: Kind::Vector(&INERTIA_PRODUCT),
    unit: "kg m²",
    absent: Absent::Zeros,
    sentence: "off-diagonal terms xy, xz, yz of the inertia matrix",
};

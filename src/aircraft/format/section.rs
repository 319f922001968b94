//! What a component may say of its sections beyond EA, GJ and two EI: coupling, axes apart, 6 × 6 matrices, a box, and the hinge
//! at its root.

use super::allowed::{
    DENSITY, FRACTION, LENGTH, MASS_ENTRY, MODULUS, POSITIVE_LENGTH, SPRING, STIFFNESS_ENTRY,
    STIFFNESS_PRODUCT,
};
use super::law::{FORMS, FORMS_OF_BOX};
use super::table::{Absent, Field, Kind, Rule, Table};

pub static BENDING_PRODUCT: Field =
    coupling("EI_yz_N_m2", "∫E y z dA about the tension axis: turns the principal axes of bending");
pub static BEND_TWIST_Y: Field = coupling(
    "bend_twist_y_N_m2",
    "torsion coupled with bending in local z: positive on a wing with y forward turns the nose down as it bends up (wash-out), \
     on both sides",
);
pub static BEND_TWIST_Z: Field = coupling("bend_twist_z_N_m2", "torsion coupled with bending in local y");
pub static TENSION_Y: Field = place(
    "tension_axis_y_m",
    "local y of the tension axis, where an axial force bends nothing, from the axis `axis_m`",
);
pub static TENSION_Z: Field = place("tension_axis_z_m", "local z of the tension axis");
pub static SHEAR_Y: Field = place(
    "shear_centre_y_m",
    "local y of the shear centre, where a transverse force does not twist, from the axis `axis_m`",
);
pub static SHEAR_Z: Field = place("shear_centre_z_m", "local z of the shear centre");

/// What stands beside stiffnesses or a box, and is in a matrix already.
pub static BESIDE: [&Field; 7] =
    [&BENDING_PRODUCT, &BEND_TWIST_Y, &BEND_TWIST_Z, &TENSION_Y, &TENSION_Z, &SHEAR_Y, &SHEAR_Z];

const fn coupling(name: &'static str, sentence: &'static str) -> Field {
    let kind = Kind::Law(&STIFFNESS_PRODUCT, &FORMS);
    Field { name, kind, unit: "N m²", absent: Absent::Number(0.0), sentence }
}

const fn place(name: &'static str, sentence: &'static str) -> Field {
    let kind = Kind::Law(&LENGTH, &FORMS_OF_BOX);
    Field { name, kind, unit: "m", absent: Absent::Number(0.0), sentence }
}

pub static SECTION_STIFFNESS: Field = Field {
    name: "section_stiffness",
    kind: Kind::Tables(&STIFFNESS_AT, 1),
    unit: "",
    absent: Absent::Nothing,
    sentence: "6 × 6 stiffnesses of the section at places along the component, in place of all fields from `EA_N` on",
};
pub static SECTION_MASS: Field = Field {
    name: "section_mass",
    kind: Kind::Tables(&MASS_AT, 1),
    unit: "",
    absent: Absent::Nothing,
    sentence: "6 × 6 masses per length of the section at places along the component",
};
pub static BOX_FIELD: Field = Field {
    name: "box",
    kind: Kind::Table(&BOX),
    unit: "",
    absent: Absent::Nothing,
    sentence: "a rectangular tube, in place of `EA_N`, `GJ_N_m2`, `EI_y_N_m2`, `EI_z_N_m2`",
};
pub static HINGE_FIELD: Field = Field {
    name: "hinge",
    kind: Kind::Table(&HINGE),
    unit: "",
    absent: Absent::Nothing,
    sentence: "springs by which the component turns against the node that it hangs on",
};

static STIFFNESS_AT: Table = Table {
    path: "component.section_stiffness",
    sentence: "A section's 6 × 6 stiffness at a place; its entries are linear between places, constant beyond them",
    fields: &[&PLACE_OF_MATRIX, &STIFFNESS_MATRIX],
    rules: &[],
    former: &[],
};
static MASS_AT: Table = Table {
    path: "component.section_mass",
    sentence: "A section's 6 × 6 mass per length at a place; its entries are linear between places, constant beyond them",
    fields: &[&PLACE_OF_MATRIX, &MASS_MATRIX],
    rules: &[],
    former: &[],
};
pub static PLACE_OF_MATRIX: Field = Field {
    name: "at",
    kind: Kind::Number(&FRACTION),
    unit: "",
    absent: Absent::Number(0.0),
    sentence: "the place as a fraction of the component's length; those of several tables increase",
};
pub static STIFFNESS_MATRIX: Field = Field {
    name: "matrix",
    kind: Kind::Matrix(&STIFFNESS_ENTRY),
    unit: "",
    absent: Absent::Needed,
    sentence: "six rows of six numbers, N, N m, N m²: force along the beam, shear forces in local y and z, torque, bending moments about \
               local y and z, by the strains that they work on, about the axis `axis_m`; positive definite",
};
pub static MASS_MATRIX: Field = Field {
    name: "matrix",
    kind: Kind::Matrix(&MASS_ENTRY),
    unit: "",
    absent: Absent::Needed,
    sentence: "six rows of six numbers, kg/m, kg, kg m: in the same order, of velocity and spin at the axis `axis_m`, local axes",
};

static BOX: Table = Table {
    path: "component.box",
    sentence: "A rectangular tube with thin walls of one material",
    fields: &[&HEIGHT, &WIDTH, &SKIN, &WEB, &YOUNG, &SHEAR_MODULUS, &BOX_DENSITY],
    rules: &[],
    former: &[],
};
pub static HEIGHT: Field = of_box("height_m", Absent::Needed, "its outer height, along local z");
pub static WIDTH: Field = of_box("width_m", Absent::Needed, "its outer width, along local y");
pub static SKIN: Field = of_box(
    "skin_m",
    Absent::Needed,
    "the thickness of the walls above and below, a quarter of the height at most",
);
pub static WEB: Field = of_box(
    "web_m",
    Absent::Found("`skin_m`"),
    "the thickness of the walls before and behind, a quarter of the width at most",
);
pub static YOUNG: Field = modulus("E_Pa", "Young's modulus");
pub static SHEAR_MODULUS: Field = modulus("G_Pa", "the shear modulus");
pub static BOX_DENSITY: Field = Field {
    name: "density_kg_m3",
    kind: Kind::Number(&DENSITY),
    unit: "kg/m³",
    absent: Absent::Nothing,
    sentence: "the material's density: with it each element carries the mass and inertia of its walls; without it the box weighs nothing, \
               and its mass is to be written as `distributed_mass`",
};

const fn of_box(name: &'static str, absent: Absent, sentence: &'static str) -> Field {
    Field { name, kind: Kind::Law(&POSITIVE_LENGTH, &FORMS_OF_BOX), unit: "m", absent, sentence }
}

const fn modulus(name: &'static str, sentence: &'static str) -> Field {
    Field { name, kind: Kind::Number(&MODULUS), unit: "Pa", absent: Absent::Needed, sentence }
}

static HINGE: Table = Table {
    path: "component.hinge",
    sentence: "Springs about one axis, or about the three local axes of the first element. It carries forces rigidly, weighs nothing, has no stop and no damping",
    fields: &[&HINGE_AXIS, &HINGE_STIFFNESS, &HINGE_STIFFNESSES],
    rules: &[
        Rule::ExactlyOne(&HINGE_SPRINGS),
        Rule::Needs(&HINGE_AXIS, &HINGE_STIFFNESS),
        Rule::Needs(&HINGE_STIFFNESS, &HINGE_AXIS),
    ],
    former: &[],
};

/// How stiff a hinge is.
pub static HINGE_SPRINGS: [&Field; 2] = [&HINGE_STIFFNESS, &HINGE_STIFFNESSES];

pub static HINGE_AXIS: Field = Field {
    name: "axis",
    kind: Kind::Direction,
    unit: "",
    absent: Absent::Nothing,
    sentence: "the one axis about which the component turns, body axes; about others it does not",
};
pub static HINGE_STIFFNESS: Field = Field {
    name: "stiffness_N_m_per_rad",
    kind: Kind::Number(&SPRING),
    unit: "N m/rad",
    absent: Absent::Nothing,
    sentence: "of the spring about `axis`",
};
pub static HINGE_STIFFNESSES: Field = Field {
    name: "stiffnesses_N_m_per_rad",
    kind: Kind::Vector(&SPRING),
    unit: "N m/rad",
    absent: Absent::Nothing,
    sentence: "of three springs, about local x (along the beam), y and z of the first element",
};

//! The forms of a law: how a quantity varies along a component.

use super::allowed::{ANY, FRACTION};
use super::table::{Absent, Field, Kind, Table, Word};

/// All forms besides a number.
pub static FORMS: [&Table; 5] = [&EACH_ELEMENT, &PIECEWISE, &POLYNOMIAL, &CHORD_POWER, &MULTIPLE];

/// Those that do without another law of the component.
pub(super) static FORMS_OF_CHORD: [&Table; 3] = [&EACH_ELEMENT, &PIECEWISE, &POLYNOMIAL];

/// Those of sizes of a section, which are no multiples of stiffnesses.
pub(super) static FORMS_OF_BOX: [&Table; 4] = [&EACH_ELEMENT, &PIECEWISE, &POLYNOMIAL, &CHORD_POWER];

/// A field of a form, which it needs.
const fn of_form(name: &'static str, kind: Kind, sentence: &'static str) -> Field {
    Field { name, kind, unit: "", absent: Absent::Needed, sentence }
}

/// A form by its fields, of which the first tells it apart.
const fn form(path: &'static str, fields: &'static [&'static Field], sentence: &'static str) -> Table {
    Table { path, sentence, fields, rules: &[], former: &[] }
}

pub static EACH_ELEMENT: Table =
    form("per_element", &[&PER_ELEMENT], "one value for each element, root first");
pub static PIECEWISE: Table =
    form("at", &[&AT, &VALUES], "linear in s between the pairs, constant beyond them");
pub static POLYNOMIAL: Table =
    form("polynomial", &[&TERMS], "a polynomial in s, the fraction of the component's length from its root");
pub static CHORD_POWER: Table =
    form("root", &[&ROOT, &POWER], "a power of the chord: `root` · (c / c(0))^`chord_power`");
pub static MULTIPLE: Table = form(
    "multiple_of",
    &[&MULTIPLE_OF, &FACTOR],
    "`factor` times a stiffness of the same component (not itself such a multiple)",
);

pub static PER_ELEMENT: Field =
    of_form("per_element", Kind::LawNumbers, "one value for each element, root first");
pub static AT: Field =
    of_form("at", Kind::Numbers(&FRACTION), "increasing fractions of the component's length");
pub static VALUES: Field = of_form("values", Kind::LawNumbers, "the value at each of these places");
pub static TERMS: Field = of_form("polynomial", Kind::Numbers(&ANY), "coefficients of 1, s, s² …");
pub static ROOT: Field = of_form("root", Kind::LawNumber, "the value at the root");
pub static POWER: Field = of_form("chord_power", Kind::Number(&ANY), "the power of c / c(0)");
pub static MULTIPLE_OF: Field = of_form("multiple_of", Kind::OneOf(&STIFFNESSES), "which stiffness");
pub static FACTOR: Field = of_form("factor", Kind::Number(&ANY), "how many times that stiffness");

/// The stiffnesses of a component, by the names of their fields.
static STIFFNESSES: [Word; 4] = [
    Word { word: EA, sentence: "axial stiffness" },
    Word { word: GJ, sentence: "torsional stiffness" },
    Word { word: EI_Y, sentence: "bending stiffness in local z" },
    Word { word: EI_Z, sentence: "bending stiffness in local y" },
];

pub(super) const EA: &str = "EA_N";
pub(super) const GJ: &str = "GJ_N_m2";
pub(super) const EI_Y: &str = "EI_y_N_m2";
pub(super) const EI_Z: &str = "EI_z_N_m2";

//! `[[component.surface]]`: aerodynamic strips, their flaps and what turns these.

use super::allowed::{
    ANGLE_DEG, DRAG_COEFFICIENT, FLAP_DRAG_COEFFICIENT, FLAP_LIFT_SLOPE, FRACTION, GAIN, INSIDE_THE_CHORD,
    LIFT_SLOPE, MOMENT_COEFFICIENT, MOMENT_COEFFICIENT_SLOPE, NEAR_THE_CHORD, POSITIVE_LENGTH,
};
use super::law::FORMS;
use super::places::{FROM, TO};
use super::table::{Absent, Field, Kind, Rule, Table, Word};

pub(super) static SURFACE: Table = Table {
    path: "component.surface",
    sentence: "Aerodynamic strips, one for each element or part of one. Lift is along -n, n = forward × span: down for a wing, \
               to the right for a fin",
    fields: &[
        &POSITION,
        &FROM,
        &TO,
        &ELASTIC_AXIS,
        &CHORD,
        &SPAN_AXIS,
        &INCIDENCE,
        &WIDTH,
        &LIFT,
        &ZERO_LIFT_OFFSET,
        &ZERO_LIFT_MOMENT,
        &MOMENT_SLOPE,
        &PROFILE_DRAG,
        &SUCTION,
        &FLAP,
        &MOVES,
    ],
    rules: &[Rule::Needs(&MOVES, &FLAP)],
    former: &[],
};

pub static POSITION: Field = Field {
    name: "position_in_element",
    kind: Kind::Number(&FRACTION),
    unit: "",
    absent: Absent::Number(0.5),
    sentence: "0 inner end, 1 outer end of the element or its part",
};
pub static ELASTIC_AXIS: Field = law(
    "elastic_axis",
    Kind::Law(&NEAR_THE_CHORD, &FORMS),
    "",
    Absent::Needed,
    "where the beam runs, as a fraction of the chord behind the leading edge",
);
pub static CHORD: Field = law(
    "chord_m",
    Kind::Law(&POSITIVE_LENGTH, &FORMS),
    "m",
    Absent::Found("the component's chord"),
    "the chord of the strips",
);
pub static SPAN_AXIS: Field = Field {
    name: "span_axis",
    kind: Kind::Direction,
    unit: "",
    absent: Absent::Found("the beam's direction across x, to the right, or up for a fin"),
    sentence: "axis about which nose-up is positive. Surfaces of one component may share a stretch only where their span axes \
               are at least 45° apart, as on a body that lifts up and sideways",
};
pub static INCIDENCE: Field = law(
    "incidence_deg",
    Kind::Law(&ANGLE_DEG, &FORMS),
    "deg",
    Absent::Number(0.0),
    "the section's setting against body x, nose-up positive; a law for washout: `{ at = [0, 1], values = [2, -1] }`",
);
pub static WIDTH: Field = law(
    "width_m",
    Kind::Law(&POSITIVE_LENGTH, &FORMS),
    "m",
    Absent::Found("the element's extent along the span"),
    "the width of a whole element's strip",
);
pub static LIFT: Field =
    law("lift_slope_per_rad", Kind::Law(&LIFT_SLOPE, &FORMS), "per rad", Absent::Needed, "CLα of the strips");
pub static ZERO_LIFT_OFFSET: Field = law(
    "zero_lift_offset_deg",
    Kind::Law(&ANGLE_DEG, &FORMS),
    "deg",
    Absent::Number(0.0),
    "angle of the zero-lift line, nose-up positive (camber)",
);
pub static ZERO_LIFT_MOMENT: Field = law(
    "zero_lift_moment",
    Kind::Law(&MOMENT_COEFFICIENT, &FORMS),
    "",
    Absent::Number(0.0),
    "c_m0, moment coefficient about the aerodynamic centre, nose-up positive (camber: about −0.05 to −0.1); a moment of \
     ½ρU²·chord² · c_m0 per span",
);
pub static MOMENT_SLOPE: Field = law(
    "moment_slope",
    Kind::Law(&MOMENT_COEFFICIENT_SLOPE, &FORMS),
    "",
    Absent::Number(0.0),
    "c_mα per rad, slope of the moment coefficient about the quarter chord, nose-up positive: c_mα/CLα is how far the aerodynamic centre is \
     ahead of it, in chords",
);
pub static PROFILE_DRAG: Field =
    law("profile_drag", Kind::Law(&DRAG_COEFFICIENT, &FORMS), "", Absent::Needed, "CD0");
pub static SUCTION: Field = law(
    "leading_edge_suction",
    Kind::Law(&FRACTION, &FORMS),
    "",
    Absent::Number(0.0),
    "recovered share; CLα/2π gives lifting-line induced drag",
);
pub static FLAP: Field = Field {
    name: "flap",
    kind: Kind::Table(&FLAP_TABLE),
    unit: "",
    absent: Absent::Nothing,
    sentence: "`{ lift_slope_per_rad, hinge }`, and `moment_slope` or `drag` where they are known: a flap at the trailing edge",
};
pub static MOVES: Field = Field {
    name: "control",
    kind: Kind::Tables(&MOVE, 0),
    unit: "",
    absent: Absent::Nothing,
    sentence: "what turns the flap. Several controls may turn the same one: their angles add up",
};

const fn law(
    name: &'static str,
    kind: Kind,
    unit: &'static str,
    absent: Absent,
    sentence: &'static str,
) -> Field {
    Field { name, kind, unit, absent, sentence }
}

static FLAP_TABLE: Table = Table {
    path: "component.surface.flap",
    sentence: "A flap at the trailing edge",
    fields: &[&FLAP_LIFT, &HINGE, &FLAP_MOMENT, &FLAP_DRAG],
    rules: &[],
    former: &[],
};
pub static FLAP_LIFT: Field = law(
    "lift_slope_per_rad",
    Kind::Law(&FLAP_LIFT_SLOPE, &FORMS),
    "per rad",
    Absent::Needed,
    "CLδ, of the angle of the flap",
);
pub static HINGE: Field = law(
    "hinge",
    Kind::Law(&INSIDE_THE_CHORD, &FORMS),
    "",
    Absent::Needed,
    "the hinge as a fraction of the chord behind the leading edge",
);

pub static FLAP_MOMENT: Field = law(
    "moment_slope",
    Kind::Law(&MOMENT_COEFFICIENT_SLOPE, &FORMS),
    "",
    Absent::Found("that of thin-aerofoil theory by `lift_slope_per_rad` and `hinge`"),
    "c_mδ per rad, of the angle of the flap: moment coefficient about the quarter chord, nose-up positive (usual ones are negative)",
);
pub static FLAP_DRAG: Field = law(
    "drag",
    Kind::Law(&FLAP_DRAG_COEFFICIENT, &FORMS),
    "",
    Absent::Number(0.0),
    "drag by the square of the angle, k per rad²: the flap turned by δ adds kδ² to CD0 (in linear models 2kδ of the trim's δ is the slope). A law, `{ per_element = [0.2, 1.6, 0.2] }`, where airbrakes and ailerons share a surface",
);

static MOVE: Table = Table {
    path: "component.surface.control",
    sentence: "A control that turns the flap of this surface",
    fields: &[&INPUT, &GAIN_FIELD, &FROM, &TO, &SIDE],
    rules: &[],
    former: &[],
};
pub static INPUT: Field = Field {
    name: "input",
    kind: Kind::Name,
    unit: "",
    absent: Absent::Needed,
    sentence: "the `name` of a control",
};
pub static GAIN_FIELD: Field = Field {
    name: "gain",
    kind: Kind::Number(&GAIN),
    unit: "",
    absent: Absent::Needed,
    sentence: "flap angle per angle of the control; a positive flap angle moves the trailing edge towards n: down on wings, to \
               the right on fins",
};
pub static SIDE: Field = Field {
    name: "side",
    kind: Kind::OneOf(&[RIGHT, LEFT]),
    unit: "",
    absent: Absent::Nothing,
    sentence: "for controls with `mirror = \"none\"` on a component that has an image, and only for those: which of the two it is \
               on (a component in the plane y = 0 is on the right as written)",
};

pub const RIGHT: Word = Word { word: "right", sentence: "the right one" };
pub const LEFT: Word = Word { word: "left", sentence: "the left one" };

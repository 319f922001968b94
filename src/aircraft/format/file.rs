//! The top of an aircraft file, and the tables that are there once.

use super::allowed::{
    AIRSPEED, ALTITUDE, DENSITY, FLIGHT_SPEED, GRAVITY, PITCH_DEG, POSITIVE_LENGTH, REFERENCE_AREA,
    TEMPERATURE, TEMPERATURE_OFFSET, TURN_DEG,
};
use super::component::COMPONENT;
use super::control::CONTROL;
use super::joint::JOINT;
use super::limits::LIMITS;
use super::places::{CUT, ENGINE, STATION};
use super::table::{Absent, Field, Kind, Rule, Table, Word};
use crate::aircraft::fidelity::Fidelity;
use crate::aircraft::model::MOST_INFLOW_STATES;

/// A whole aircraft file.
pub static FILE: Table = Table {
    path: "",
    sentence: "An aircraft: beams, the masses and aerodynamic surfaces that they carry, engines, and points to watch",
    fields: &[
        &FORMAT,
        &NAME,
        &GRAVITY_FIELD,
        &SUPPORT,
        &MODE_BASIS,
        &MODEL,
        &INFLOW_STATES,
        &AIRSPEED_FIELD,
        &ALTITUDE_FIELD,
        &OFFSET_FIELD,
        &DENSITY_FIELD,
        &TEMPERATURE_FIELD,
        &MOUNT,
        &SYMMETRIC,
        &BASIS,
        &REFERENCE,
        &LIMITS_FIELD,
        &CONTROLS,
        &COMPONENTS,
        &JOINTS,
        &ENGINES,
        &STATIONS,
        &CUTS,
    ],
    rules: &[
        Rule::AtMostOne(&[&ALTITUDE_FIELD, &DENSITY_FIELD]),
        Rule::AtMostOne(&[&OFFSET_FIELD, &DENSITY_FIELD]),
        Rule::Needs(&TEMPERATURE_FIELD, &DENSITY_FIELD),
        Rule::OnlyWhere(&DENSITY_FIELD, &SUPPORT, CLAMPED.word),
        Rule::OnlyWhere(&MOUNT, &SUPPORT, CLAMPED.word),
        Rule::Narrower(&AIRSPEED_FIELD, &FLIGHT_SPEED, &SUPPORT, FREE.word),
    ],
    former: &[],
};

pub static FORMAT: Field = Field {
    name: "format",
    kind: Kind::Whole(1, 1),
    unit: "",
    absent: Absent::Needed,
    sentence: "the version of this format",
};
pub static NAME: Field = Field {
    name: "name",
    kind: Kind::Text,
    unit: "",
    absent: Absent::Needed,
    sentence: "for people; no control characters",
};
pub static GRAVITY_FIELD: Field = Field {
    name: "gravity_m_s2",
    kind: Kind::Number(&GRAVITY),
    unit: "m/s²",
    absent: Absent::Number(9.80665),
    sentence: "gravitational acceleration",
};
pub static SUPPORT: Field = Field {
    name: "support",
    kind: Kind::OneOf(&[FREE, CLAMPED]),
    unit: "",
    absent: Absent::Needed,
    sentence: "whether it flies",
};
pub static MODE_BASIS: Field = Field {
    name: "mode_basis",
    kind: Kind::OneOf(&[BENDING_TORSION, FULL]),
    unit: "",
    absent: Absent::Needed,
    sentence: "which natural modes span the deformation",
};
pub static MODEL: Field = Field {
    name: "model",
    kind: Kind::OneOf(&LEVELS),
    unit: "",
    absent: Absent::Word(Fidelity::USUAL.name()),
    sentence: "the level of fidelity at which it flies unless the FMU's parameter `model` or an option says otherwise",
};
pub static INFLOW_STATES: Field = Field {
    name: "inflow_states",
    kind: Kind::Whole(0, MOST_INFLOW_STATES),
    unit: "",
    absent: Absent::Whole(5),
    sentence: "Peters inflow states of each strip; 0 is steady",
};
pub static AIRSPEED_FIELD: Field = Field {
    name: "airspeed_m_s",
    kind: Kind::Number(&AIRSPEED),
    unit: "m/s",
    absent: Absent::Number(127.0),
    sentence: "where it is trimmed unless the FMU's parameter `airspeed` says otherwise, from 1 on if it flies; in a wind tunnel \
               the speed of the air, which may be 0",
};
pub static ALTITUDE_FIELD: Field = Field {
    name: "altitude_m",
    kind: Kind::Number(&ALTITUDE),
    unit: "m",
    absent: Absent::Number(7620.0),
    sentence: "where it is trimmed unless the FMU's parameter `altitude` says otherwise; in a wind tunnel its air is that of the \
               standard atmosphere there",
};
pub static OFFSET_FIELD: Field = Field {
    name: "temperature_offset_K",
    kind: Kind::Number(&TEMPERATURE_OFFSET),
    unit: "K",
    absent: Absent::Number(0.0),
    sentence: "by how much the air is warmer than the standard atmosphere at every altitude, at the same pressure, unless the FMU's \
               parameter `temperature_offset` says otherwise; density and speed of sound follow",
};
pub static DENSITY_FIELD: Field = Field {
    name: "density_kg_m3",
    kind: Kind::Number(&DENSITY),
    unit: "kg/m³",
    absent: Absent::Nothing,
    sentence: "clamped only: the tunnel's air, the same everywhere, in place of `altitude_m` and `temperature_offset_K`; the FMU then has no \
               `altitude` and no `temperature_offset`",
};
pub static TEMPERATURE_FIELD: Field = Field {
    name: "temperature_K",
    kind: Kind::Number(&TEMPERATURE),
    unit: "K",
    absent: Absent::Number(288.15),
    sentence: "with `density_kg_m3` only: that air's temperature. It moves no load; it is for the outputs `air.temperature`, \
               `air.pressure` (ρRT), `air.mach` and `air.calibrated`",
};
pub static MOUNT: Field = Field {
    name: "mount_attitude_deg",
    kind: Kind::Attitude(&TURN_DEG, &PITCH_DEG),
    unit: "deg",
    absent: Absent::Zeros,
    sentence: "clamped only: roll, pitch, yaw of the aircraft in the tunnel, against a level one that heads into the flow. Turns \
               gravity and the flow about it: `[-90, 0, 0]` stands a right wing on its root, `[0, 3, 0]` gives 3° of incidence",
};
pub static SYMMETRIC: Field = Field {
    name: "symmetric",
    kind: Kind::Flag,
    unit: "",
    absent: Absent::Flag(false),
    sentence: "`true` declares that symmetric modes will be asked for; then every beam, mass and engine must have its mirror \
               image in y = 0, on the mirrored branch of beams",
};
pub static BASIS: Field = once("basis", &BASIS_TABLE, "what stands beside the natural modes");
pub static REFERENCE: Field = once(
    "reference",
    &REFERENCE_TABLE,
    "lengths by which coefficients and the static margin are made dimensionless",
);
pub static LIMITS_FIELD: Field = once("limits", &LIMITS, "what it is flown within");
pub static CONTROLS: Field = listed("control", &CONTROL, "what turns the flaps");
pub static COMPONENTS: Field = Field {
    name: "component",
    kind: Kind::Tables(&COMPONENT, 1),
    unit: "",
    absent: Absent::Needed,
    sentence: "the beams; each hangs on one above it, and elements are numbered in the order of the file",
};
pub static JOINTS: Field = listed("joint", &JOINT, "nodes that move together");
pub static ENGINES: Field = listed("engine", &ENGINE, "where thrust acts");
pub static STATIONS: Field = listed("station", &STATION, "points whose deflections are outputs");
pub static CUTS: Field = listed("cut", &CUT, "where section loads are outputs");

/// A table that is there once, or not.
const fn once(name: &'static str, table: &'static Table, sentence: &'static str) -> Field {
    Field { name, kind: Kind::Table(table), unit: "", absent: Absent::Nothing, sentence }
}

/// Tables of which there may be any number.
const fn listed(name: &'static str, table: &'static Table, sentence: &'static str) -> Field {
    Field { name, kind: Kind::Tables(table, 0), unit: "", absent: Absent::Nothing, sentence }
}

pub const FREE: Word = Word { word: "free", sentence: "flies, or glides if it has no engine" };
pub const CLAMPED: Word = Word { word: "clamped", sentence: "is held at O in a wind tunnel" };
pub const BENDING_TORSION: Word = Word {
    word: "bending_torsion",
    sentence: "modes without axial stretch, as beam theories of aircraft have them",
};
pub const FULL: Word = Word { word: "full", sentence: "all" };

static LEVELS: [Word; Fidelity::ALL.len()] = {
    let mut words = [Word { word: "", sentence: "" }; Fidelity::ALL.len()];
    let mut number = 0;
    while number < words.len() {
        let level = Fidelity::ALL[number];
        words[number] = Word { word: level.name(), sentence: level.description() };
        number += 1;
    }
    words
};

static BASIS_TABLE: Table = Table {
    path: "basis",
    sentence: "What stands beside the natural modes",
    fields: &[&LOAD_MODES],
    rules: &[],
    former: &[],
};
pub static LOAD_MODES: Field = Field {
    name: "load_modes",
    kind: Kind::Flag,
    unit: "",
    absent: Absent::Flag(false),
    sentence: "`true` puts load modes beside the natural ones: the shapes that typical static loads (lift of each pair of wings \
               or tails, weight, roll, sideslip, each control) give the structure. A few of them spare many natural modes where \
               the wing bends far or a tail bends by itself. They belong to the natural modes in use, whatever their number, \
               and the FMU's parameter `load_modes` switches them off. `flexair` does the same with `--load-modes`",
};

static REFERENCE_TABLE: Table = Table {
    path: "reference",
    sentence: "Lengths by which coefficients and the static margin are made dimensionless; they change no flight",
    fields: &[&REFERENCE_CHORD, &REFERENCE_AREA_FIELD, &REFERENCE_SPAN],
    rules: &[],
    former: &[],
};
pub static REFERENCE_CHORD: Field = Field {
    name: "chord_m",
    kind: Kind::Number(&POSITIVE_LENGTH),
    unit: "m",
    absent: Absent::Found("Σ c² Δy / S of the wing's strips"),
    sentence: "the mean aerodynamic chord c̄ that the static margin is measured by",
};
pub static REFERENCE_AREA_FIELD: Field = Field {
    name: "area_m2",
    kind: Kind::Number(&REFERENCE_AREA),
    unit: "m²",
    absent: Absent::Found("S = Σ c Δy, Δy along the span"),
    sentence: "the wing area S",
};
pub static REFERENCE_SPAN: Field = Field {
    name: "span_m",
    kind: Kind::Number(&POSITIVE_LENGTH),
    unit: "m",
    absent: Absent::Found("that of the wing's strips"),
    sentence: "the span from tip to tip",
};

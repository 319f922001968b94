//! Table 5.1: deflections in trim.

use std::fmt::Write;

use flexible_aircraft::simulation::Fidelity;

use super::cases::{Case, Flight, UNSTEADY, symbol};
use super::history::{History, Quantity};

/// One row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The model.
    pub fidelity: Fidelity,
    /// The trim.
    pub case: Case,
    /// Of the wing.
    pub wing: Tip,
    /// Of the horizontal tail.
    pub tail: Tip,
}

/// Upward deflections of a tip, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tip {
    /// As printed in the thesis, if it is.
    pub thesis: Option<f64>,
    /// What two earlier programs, written independently of this one, found for the shipped jet
    /// (physics.md §8).
    pub expected: f64,
    /// What we find.
    pub ours: Option<f64>,
}

impl Tip {
    /// ours/thesis − 1.
    pub fn difference(&self) -> Option<f64> {
        Some(self.ours? / self.thesis? - 1.0)
    }
}

/// What is known of a row: wing first, then tail.
struct Known(Fidelity, Case, [Option<f64>; 2], [f64; 2]);

/// The nominal wing tip is in the text of [5.2.1], the rest in Table 5.1; 127 m/s, 7620 m, 8 symmetric modes.
const KNOWN: [Known; 5] = [
    Known(Fidelity::Exact, Case::ElevatorNominal, [Some(0.58), None], [0.5577, 0.0244]),
    Known(Fidelity::Exact, Case::ElevatorTenth, [Some(2.84), Some(0.26)], [2.831, 0.1597]),
    Known(Fidelity::ConsistentlyLinearised, Case::ElevatorTenth, [Some(4.93), Some(0.26)], [4.992, 0.2908]),
    Known(Fidelity::Inconsistent, Case::ElevatorTenth, [Some(4.93), Some(0.26)], [4.986, 0.2883]),
    Known(Fidelity::RuthlesslyLinearised, Case::ElevatorTenth, [Some(4.95), Some(0.14)], [5.009, 0.2497]),
];

/// The table, from the beginnings of the flights.
pub fn rows(histories: &[History]) -> Vec<Row> {
    let row = |Known(fidelity, case, thesis, expected): Known| {
        let flight = Flight { case, fidelity, inflow_states: UNSTEADY };
        let history = histories.iter().find(|history| history.flight == flight);
        let trim = history.and_then(|history| history.samples.first());
        let ours = |quantity| trim.map(|sample| sample.value(quantity));
        Row {
            fidelity,
            case,
            wing: Tip { thesis: thesis[0], expected: expected[0], ours: ours(Quantity::WingTip) },
            tail: Tip { thesis: thesis[1], expected: expected[1], ours: ours(Quantity::TailTip) },
        }
    };
    KNOWN.into_iter().map(row).collect()
}

/// Over the cells.
pub const HEADINGS: [&str; 9] = [
    "model, stiffness",
    "wing tip: thesis (m)",
    "ours (m)",
    "difference",
    "independent programs (m)",
    "tail tip: thesis (m)",
    "ours (m)",
    "difference",
    "independent programs (m)",
];

/// The cells of a row.
pub fn cells(row: &Row) -> [String; 9] {
    let stiffness = if row.case == Case::ElevatorNominal { "nominal" } else { "a tenth" };
    let metres = |value: Option<f64>, digits: usize| value.map_or("–".into(), |m| format!("{m:.digits$}"));
    let tip = |tip: &Tip| {
        let difference = tip.difference().map_or("–".into(), |d| format!("{:+.1} %", 100.0 * d));
        [
            metres(tip.thesis, 2),
            metres(tip.ours, 4),
            difference.replace('-', "−"),
            metres(Some(tip.expected), 4),
        ]
    };
    let [a, b, c, d] = tip(&row.wing);
    let [e, f, g, h] = tip(&row.tail);
    [format!("{}, {stiffness}", symbol(row.fidelity)), a, b, c, d, e, f, g, h]
}

/// The table for a README or a terminal.
pub fn markdown(rows: &[Row]) -> String {
    let mut table = format!("| {} |\n|{}\n", HEADINGS.join(" | "), " --- |".repeat(HEADINGS.len()));
    for row in rows {
        // PROOF: writing to a string does not fail.
        let _ = writeln!(table, "| {} |", cells(row).join(" | "));
    }
    table
}

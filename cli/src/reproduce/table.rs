//! Table 5.1: deflections in trim [theory: thesis-runs.trims; thesis table 5.1].

use std::fmt::Write;

use flexible_aircraft::equations::Fidelity;

use super::cases::{Case, Flight, UNSTEADY};
use super::history::{History, Quantity};
use super::page::number;

/// The table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Whether the aircraft is the one that others have computed too.
    pub is_shipped: bool,
    /// Its rows.
    pub rows: Vec<Row>,
}

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
    /// [theory: thesis-runs.trims].
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

impl Row {
    /// Model and stiffness.
    pub fn title(&self) -> String {
        let stiffness = if self.is_soft() { "a tenth" } else { "nominal" };
        format!("{}, {stiffness}", self.fidelity.symbol())
    }

    /// Whether it has a tenth of the stiffness.
    pub fn is_soft(&self) -> bool {
        self.case != Case::ElevatorNominal
    }
}

/// What is known of a row: wing first, then tail.
struct Known(Fidelity, Case, [Option<f64>; 2], [f64; 2]);

/// The nominal wing tip is in the text of thesis §5.2.1, the rest in Table 5.1; 127 m/s, 7620 m, 8 symmetric modes.
const KNOWN: [Known; 5] = [
    Known(Fidelity::Exact, Case::ElevatorNominal, [Some(0.58), None], [0.5577, 0.0244]),
    Known(Fidelity::Exact, Case::ElevatorTenth, [Some(2.84), Some(0.26)], [2.831, 0.1597]),
    Known(Fidelity::ConsistentlyLinearised, Case::ElevatorTenth, [Some(4.93), Some(0.26)], [4.992, 0.2908]),
    Known(Fidelity::Inconsistent, Case::ElevatorTenth, [Some(4.93), Some(0.26)], [4.986, 0.2883]),
    Known(Fidelity::RuthlesslyLinearised, Case::ElevatorTenth, [Some(4.95), Some(0.14)], [5.009, 0.2497]),
];

impl Table {
    /// From the beginnings of the flights.
    pub fn new(is_shipped: bool, histories: &[History]) -> Self {
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
        Table { is_shipped, rows: KNOWN.into_iter().map(row).collect() }
    }

    /// Over the cells.
    pub fn headings(&self) -> Vec<String> {
        let tip = |tip: &str| {
            let mut headings = vec![format!("{tip} tip: thesis (m)"), "ours (m)".into(), "difference".into()];
            headings.extend(self.is_shipped.then(|| "independent programs (m)".to_owned()));
            headings
        };
        [vec!["model, stiffness".to_owned()], tip("wing"), tip("tail")].concat()
    }

    /// The cells of a row.
    pub fn cells(&self, row: &Row) -> Vec<String> {
        let metres = |value: Option<f64>, digits: usize| value.map_or("–".into(), |m| number(m, digits));
        let tip = |tip: &Tip| {
            let difference = tip.difference().map_or("–".into(), |d| format!("{:+.1} %", 100.0 * d));
            let mut cells = vec![metres(tip.thesis, 2), metres(tip.ours, 4), difference.replace('-', "−")];
            cells.extend(self.is_shipped.then(|| metres(Some(tip.expected), 4)));
            cells
        };
        [vec![row.title()], tip(&row.wing), tip(&row.tail)].concat()
    }

    /// For a README or a terminal.
    pub fn markdown(&self) -> String {
        let headings = self.headings();
        let mut table = format!("| {} |\n|{}\n", headings.join(" | "), " --- |".repeat(headings.len()));
        for row in &self.rows {
            // PROOF: writing to a string does not fail.
            let _ = writeln!(table, "| {} |", self.cells(row).join(" | "));
        }
        table
    }
}

//! What is compared between numbers of modes: quantities, each with a value for every number, and by how much it moves.

use flexible_aircraft::stability::Complex;

use crate::numbers::fixed;

/// What a quantity is, for the verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An angle or the thrust of the trim.
    Trim,
    /// Of a station.
    Deflection,
    /// An airspeed at which flutter or divergence begins.
    Critical,
    /// A root at the trim.
    Root,
}

/// A quantity with its value for each number of modes.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// None: for information.
    pub kind: Option<Kind>,
    /// For people.
    pub name: String,
    pub unit: &'static str,
    /// Decimal places for people.
    pub places: usize,
    /// What changes are measured by, in its unit.
    pub scale: f64,
    pub values: Vec<Value>,
}

/// What is known of a quantity with one number of modes.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Number(f64),
    /// An eigenvalue, 1/s.
    Root(Complex<f64>),
    /// There is none, or it lies where it was not looked for: a finding, which others may share.
    Outside(String),
    /// Nothing is known, and why.
    Unknown(&'static str),
}

impl Kind {
    pub const ALL: [Kind; 4] = [Kind::Trim, Kind::Deflection, Kind::Critical, Kind::Root];

    /// The quantities of the kind, for people.
    pub fn plural(self) -> &'static str {
        match self {
            Kind::Trim => "trims",
            Kind::Deflection => "deflections",
            Kind::Critical => "critical speeds",
            Kind::Root => "roots",
        }
    }
}

impl Value {
    pub fn number(&self) -> Option<f64> {
        match self {
            Value::Number(number) => Some(*number),
            _ => None,
        }
    }
}

impl Quantity {
    /// Whether its values are eigenvalues.
    pub fn is_root(&self) -> bool {
        self.values.iter().any(|value| matches!(value, Value::Root(_)))
    }

    /// By how much it moves from one number of modes to another, as a share of its scale: without bound where only one of them has
    /// a value, or nothing is known.
    pub fn change(&self, from: usize, to: usize) -> f64 {
        match (&self.values[from], &self.values[to]) {
            (Value::Number(from), Value::Number(to)) => share((to - from).abs(), self.scale),
            (Value::Root(from), Value::Root(to)) => share((to - from).norm(), to.norm()),
            (Value::Outside(from), Value::Outside(to)) if from == to => 0.0,
            _ => f64::INFINITY,
        }
    }

    /// A value with so many places as the quantity has.
    pub fn text(&self, row: usize) -> String {
        match &self.values[row] {
            Value::Number(number) => fixed(*number, self.places),
            Value::Root(root) => {
                format!("{} ± {}i", fixed(root.re, self.places), fixed(root.im, self.places))
            }
            Value::Outside(finding) => finding.clone(),
            Value::Unknown(reason) => (*reason).to_owned(),
        }
    }

    /// A value with its unit.
    pub fn text_with_unit(&self, row: usize) -> String {
        let text = self.text(row);
        match self.values[row] {
            Value::Number(_) | Value::Root(_) => format!("{text} {}", self.unit),
            _ => text,
        }
    }
}

fn share(change: f64, scale: f64) -> f64 {
    if change == 0.0 { 0.0 } else { change / scale }
}

//! Why no aircraft is found of some numbers, and which of them to change.

use std::fmt;

use flexible_aircraft::plant::NoStaticStability;

use super::interview::Interview;
use super::quantity::{self, Quantity, SPAN, in_three_digits};
use super::sizing::Sizing;
use super::{Given, fit};
use crate::numbers::short;

/// Why a search ended without an aircraft.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Failure {
    /// The last that was looked at.
    #[error("it does not come to rest; the last that was tried had {0}")]
    Restless(String),
    #[error("the equations of its level flight have no solution that is found")]
    NoTrim,
    #[error("its wing gives way: it carries no more at a greater angle of attack")]
    Liftless,
    #[error("its structure finds no rest in the air: the wing is about to diverge")]
    Divergent,
    /// Degrees.
    #[error("it would need a {part} at {} deg", in_three_digits(*.angle))]
    Turned { part: &'static str, angle: f64 },
    #[error("its elevons would have to hold a zero-lift moment coefficient of {}, which no aerofoil has", in_three_digits(*.0))]
    Moment(f64),
    /// m ahead of O.
    #[error("its payload would have to be {} m from its wing, further than the wing is wide", in_three_digits(.0.abs()))]
    Payload(f64),
    #[error("none of its {0} lowest modes bends the wing")]
    Unbent(usize),
    /// What the reader or the structure says of what was tried.
    #[error("what was tried is no aircraft: {0}")]
    Refused(String),
}

impl From<NoStaticStability> for Failure {
    fn from(error: NoStaticStability) -> Self {
        match error {
            NoStaticStability::Liftless { .. } => Failure::Liftless,
            NoStaticStability::Restless => Failure::Divergent,
            NoStaticStability::Clamped | NoStaticStability::CurvedPath => Failure::Refused(error.to_string()),
        }
    }
}

/// A number that was given, and what is usual in its place beside the others, with their unit.
#[derive(Clone, Debug, PartialEq)]
struct Change {
    option: &'static str,
    found: String,
    usual: String,
}

/// No aircraft was found of what was given.
#[derive(Clone, Debug, PartialEq)]
pub struct NotFound {
    failure: Failure,
    /// One with which alone an aircraft is found, or else all that there may be.
    changes: Vec<Change>,
    is_tried: bool,
}

impl NotFound {
    /// Looks for the number that is to be changed: what comes last follows from the others by rules.
    pub fn of(failure: Failure, given: &Given) -> Box<Self> {
        let mut changes = Vec::new();
        for quantity in quantity::ALL.iter().rev().filter(|quantity| quantity.option != SPAN.option) {
            let Some((change, sizing)) = without(given, quantity) else { continue };
            if fit::fit("tried", &sizing).is_ok() {
                return Box::new(NotFound { failure, changes: vec![change], is_tried: true });
            }
            changes.push(change);
        }
        Box::new(NotFound { failure, changes, is_tried: false })
    }
}

/// The aircraft with what is usual in place of a number; none where it is not given, or the others do not go together then.
fn without(given: &Given, quantity: &Quantity) -> Option<(Change, Sizing)> {
    let mut given = given.clone();
    let found = (quantity.of)(&mut given).take()?;
    let sizing = Sizing::new(&mut Interview::new(None, given)).ok()?;
    let usual = sizing.choices.iter().find(|choice| choice.label == quantity.label)?.value.clone();
    let found = format!("{} {}", short(found), quantity.unit);
    (found != usual).then_some((Change { option: quantity.option, found, usual }, sizing))
}

impl fmt::Display for NotFound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let NotFound { failure, changes, is_tried } = self;
        match changes.as_slice() {
            [] => write!(f, "no such aircraft is found: {failure}; allowed is another --kind or --span"),
            [Change { option, found, usual }] if *is_tried => write!(
                f,
                "{option}: found {found}, and no such aircraft: {failure}; allowed is {usual}, usual beside the other numbers, and what \
                 is near it"
            ),
            several => {
                let told: Vec<String> = several
                    .iter()
                    .map(|Change { option, found, usual }| format!("{option} {usual} in place of {found}"))
                    .collect();
                write!(
                    f,
                    "no such aircraft is found: {failure}; allowed is what is nearer to usual numbers: {}",
                    told.join(", ")
                )
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::kind::Kind;
    use super::*;

    #[test]
    fn the_number_is_told_without_which_an_aircraft_is_found() {
        let given = Given {
            kind: Some(Kind::Conventional),
            span: Some(11.0),
            sweep: Some(0.0),
            bending_frequency: Some(31.0),
            ..Given::default()
        };
        let told = NotFound::of(Failure::Liftless, &given).to_string();
        assert_eq!(
            told,
            "--bending-frequency: found 31 Hz, and no such aircraft: its wing gives way: it carries no more at a greater angle of \
             attack; allowed is 6.36 Hz, usual beside the other numbers, and what is near it"
        );
    }

    #[test]
    fn numbers_that_are_usual_are_not_blamed() {
        let given =
            Given { kind: Some(Kind::Conventional), span: Some(11.0), sweep: Some(0.0), ..Given::default() };
        let told = NotFound::of(Failure::NoTrim, &given).to_string();
        assert!(told.ends_with("allowed is another --kind or --span"), "{told}");
    }
}

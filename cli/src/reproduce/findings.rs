//! What the page says. The constants tell what was done and how to read it; what came out is computed from the
//! flights that were flown, for whatever aircraft, and nothing else is said of them.

use super::figures::{Comparison, Group};
use super::fit::Verdict;
use super::history::{History, Quantity};
use super::page::number;
use super::plots::Plot;
use super::table::{Row, Table, Tip};

/// What the page is.
pub const INTRODUCTION: &str = "B. C. B. Tse, <cite>Effects of Inertial and Geometric Nonlinearities in \
    the Simulation of Flexible Aircraft Dynamics</cite> (MASc thesis, University of Toronto, 2013) flies a \
    flexible business jet with five models: E (exact), CL (consistently linearised), I (inconsistent), RL \
    (ruthlessly linearised) and Rigid. Here are the same flights with this program, figure by figure, and \
    Table 5.1.";

/// Of the aircraft file that comes with the program.
const SHIPPED: &str = "The thesis' data are not public: this aircraft is a reconstruction, fitted to the thesis' \
    deflections of the wing tip in trim. That these agree shows that one set of data serves all models; it is no \
    prediction.";

/// Of any other file.
const OTHER: &str = "This is not the aircraft that comes with the program as a reconstruction of the thesis' jet: \
    the thesis' figures and numbers are of another aircraft and stand here for orientation.";

/// What the windows tell.
pub const HOW_TO_READ: &str = "The plain field is the window of the thesis' axis, from its printed tick \
    labels; shaded is what we had to add to show our curves. The thesis gives no numbers of its curves, \
    but its axes are Matlab's: the narrowest range from tick to tick that holds all curves. So a figure of \
    ours can do three things: get the same axis (both extremes within one tick of the thesis'), lie inside \
    but fill less, or leave the window.";

/// Under both inputs.
pub const INPUT: &str = "About the trim. Window of the thesis −0.05 to 0.05 rad and 0 to 15 s.";

/// What is known of the inputs, and what accelerations are.
pub const INPUTS: &str = "The thesis describes a 2-3-1-1 of the elevator through 1/(0.05 s + 1), and its \
    figures give only the ranges of the axes. The amplitude of 0.05 rad, the unit time of 0.7 s, the start \
    at 1 s, the first pulse nose-up, and the rudder doublet (0.05 rad, 2 s each way, first nose right, \
    same filter) are our choice. Figure 5.33 is captioned as the elevator's and is the rudder's. \
    Accelerations are the rates of change of the body-axis velocity components.";

/// On the column that only the shipped aircraft has.
pub const INDEPENDENT: &str = "In the last column of each tip is what two programs written independently of this one \
    found for the same file: it checks this program and not the data.";

/// On the table of all windows.
pub const WINDOWS: &str = "The lowest and highest value of all curves of a figure, and the share of the \
    window that they fill. Percentages of leaving are of the window's width; the curves that leave are \
    named.";

/// On the wings of others.
pub const WINGS: &str = "The thesis' five models superpose displacements; the sixth, geometrically exact, superposes strains. \
    With a real axial stiffness superposed displacements are far too stiff as soon as a wing bends visibly: there the sixth is \
    the one to fly. These wings are clamped in a wind tunnel, whatever aircraft flew above.";

/// Between the two ends of the flight that are compared to see whether an oscillation grows, s.
const SPELL: f64 = 2.0;

/// An oscillation grows when its height in the last spell is this much of that in the one before …
const GROWTH: f64 = 1.1;
/// … and at least this share of the quantity's range.
const NOTICEABLE: f64 = 0.02;

/// The result in short.
pub fn in_short(table: &Table) -> Vec<String> {
    let mut found = vec![(if table.is_shipped { SHIPPED } else { OTHER }).to_owned()];
    found.extend(largest_difference(table, "wing", |row| row.wing));
    found.extend(largest_difference(table, "tail", |row| row.tail));
    let soft = table.rows.iter().filter(|row| row.is_soft());
    let mut soft: Vec<(&Row, f64)> = soft.filter_map(|row| Some((row, row.wing.ours?))).collect();
    soft.sort_by(|a, b| a.1.total_cmp(&b.1));
    if let [(least, low), .., (most, high)] = soft[..] {
        found.push(format!(
            "At a tenth of the stiffness {} deflects least ({} m), {} most ({} m).",
            least.fidelity.symbol(),
            number(low, 2),
            most.fidelity.symbol(),
            number(high, 2)
        ));
    }
    found
}

fn largest_difference(table: &Table, part: &str, tip: fn(&Row) -> Tip) -> Option<String> {
    let differences = table.rows.iter().filter_map(|row| Some((row, tip(row).difference()?)));
    let (row, difference) = differences.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    let (percent, row) = (number(100.0 * difference.abs(), 1), row.title());
    Some(format!(
        "The {part} tip's deflections in trim differ from the thesis' by at most {percent} % ({row})."
    ))
}

/// What the flights of a group of figures show.
pub fn of(group: &Group, plots: &[Plot], histories: &[History]) -> Vec<String> {
    let flights = group.comparison.flights();
    let flown: Vec<(&str, &History)> = flights
        .iter()
        .filter_map(|(flight, label)| {
            let history = histories.iter().find(|history| history.flight == *flight)?;
            (!history.samples.is_empty()).then_some((label.as_str(), history))
        })
        .collect();
    let quantities: Vec<Quantity> = plots.iter().map(|plot| plot.figure.quantity).collect();
    let mut found = Vec::new();
    found.extend(trims(&flown));
    found.extend(differences(group.comparison, &flown, &quantities));
    found.extend(leaving(&flown, plots));
    found.extend(flown.iter().filter_map(|(label, history)| growth(label, history)));
    found
}

/// Pitch and wing tip at the start.
fn trims(flown: &[(&str, &History)]) -> Option<String> {
    let each = |quantity: Quantity, digits: usize| {
        let shown = flown.iter().filter(|(_, history)| quantity.is_of(&history.flight));
        let values = shown.filter_map(|(label, history)| {
            Some(format!("{label} {}", number(history.samples.first()?.value(quantity), digits)))
        });
        values.collect::<Vec<_>>().join(", ")
    };
    (!flown.is_empty()).then(|| {
        format!("Trim: pitch {} rad; wing tip up {} m.", each(Quantity::Pitch, 3), each(Quantity::WingTip, 2))
    })
}

/// How far the motions about the trims are from those of the first curve.
fn differences(
    comparison: Comparison,
    flown: &[(&str, &History)],
    quantities: &[Quantity],
) -> Option<String> {
    let ((first, reference), others) = flown.split_first()?;
    let each: Vec<String> = others
        .iter()
        .filter_map(|(label, history)| {
            let shown = quantities.iter().filter(|quantity| quantity.is_of(&history.flight));
            let shares = shown.filter_map(|&q| Some((q, distance(reference, history, q)?)));
            let (quantity, share) = shares.max_by(|a, b| a.1.total_cmp(&b.1))?;
            Some(format!("{label} {} % ({})", number(100.0 * share, 0), quantity.name()))
        })
        .collect();
    let what = match comparison {
        Comparison::Models(_) => "models",
        Comparison::Aerodynamics(_) => "aerodynamics",
    };
    (!each.is_empty()).then(|| {
        format!(
            "Motion about the trim, largest distance of the {what} from {first} in parts of {first}'s range: {}.",
            each.join(", ")
        )
    })
}

/// The largest distance of two motions about their trims, in parts of the range of the first.
fn distance(reference: &History, history: &History, quantity: Quantity) -> Option<f64> {
    let motion = |history: &History| -> Option<Vec<f64>> {
        let start = history.samples.first()?.value(quantity);
        Some(history.samples.iter().map(|sample| sample.value(quantity) - start).collect())
    };
    let (reference, other) = (motion(reference)?, motion(history)?);
    let largest = reference.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let range = height(&reference);
    (range > 0.0).then(|| largest / range)
}

/// Which curve leaves which windows.
fn leaving(flown: &[(&str, &History)], plots: &[Plot]) -> Option<String> {
    let figures = |label: &str| {
        let left = plots.iter().filter(|plot| match plot.fit.as_ref().map(|fit| &fit.verdict) {
            Some(Verdict::Outside { curves, .. }) => curves.iter().any(|curve| curve == label),
            _ => false,
        });
        left.map(|plot| format!("5.{}", plot.figure.number)).collect::<Vec<_>>().join(", ")
    };
    let each: Vec<String> = flown
        .iter()
        .map(|(label, _)| match figures(label) {
            none if none.is_empty() => format!("{label} none"),
            some => format!("{label} {some}"),
        })
        .collect();
    (!each.is_empty()).then(|| format!("Windows of the thesis that are left: {}.", each.join("; ")))
}

/// Whether the downward acceleration still grows at the end.
fn growth(label: &str, history: &History) -> Option<String> {
    let end = history.samples.last()?.time;
    let values = |from: f64, to: f64| -> Vec<f64> {
        let within = history.samples.iter().filter(|sample| sample.time > from && sample.time <= to);
        within.map(|sample| sample.value(Quantity::AccelerationZ)).collect()
    };
    let (before, last) = (height(&values(end - 2.0 * SPELL, end - SPELL)), height(&values(end - SPELL, end)));
    let whole = height(&values(f64::NEG_INFINITY, end));
    (end >= 2.0 * SPELL && last > GROWTH * before && last > NOTICEABLE * whole).then(|| {
        format!(
            "{label} grows at the end: its downward acceleration moves by {} m/s² from peak to peak in the last {SPELL} s, by {} m/s² \
             in the {SPELL} s before.",
            number(last, 2),
            number(before, 2)
        )
    })
}

/// Highest less lowest.
fn height(values: &[f64]) -> f64 {
    let (low, high) =
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
    (high - low).max(0.0)
}

#[cfg(test)]
mod tests {
    use flexible_aircraft::equations::Fidelity;

    use super::*;
    use crate::reproduce::cases::{Case, Flight, UNSTEADY};
    use crate::reproduce::figures::GROUPS;

    /// What is said of two models in the first group of figures, with these motions.
    fn said(exact: fn(Quantity, f64) -> f64, linear: fn(Quantity, f64) -> f64) -> Vec<String> {
        let flight = |fidelity| Flight { case: Case::ElevatorNominal, fidelity, inflow_states: UNSTEADY };
        let histories = [
            History::made_up(flight(Fidelity::Exact), exact),
            History::made_up(flight(Fidelity::RuthlesslyLinearised), linear),
        ];
        let plots: Vec<Plot> = GROUPS[0].figures().map(|figure| Plot::new(figure, &histories)).collect();
        of(&GROUPS[0], &plots, &histories)
    }

    #[test]
    fn what_is_said_follows_the_flights() {
        let calm = said(|_, time| time, |_, time| time);
        assert!(calm.iter().any(|text| text.contains("RL 0 %")), "{calm:?}");
        let apart = said(|_, time| time, |_, time| 1.0 + 1.3 * time);
        assert!(apart.iter().any(|text| text.contains("RL 30 %")), "{apart:?}");
        assert!(apart.iter().any(|text| text.contains("pitch E 0.000, RL 1.000 rad")), "{apart:?}");
        // Figure 5.5, pitch, shows 0.12 to 0.17 rad.
        let inside = said(|_, _| 0.15, |q, _| if q == Quantity::Pitch { 0.18 } else { 0.15 });
        let left = inside.iter().find(|text| text.starts_with("Windows")).unwrap();
        assert!(!left.split(';').next().unwrap().contains("5.5") && left.ends_with("5.5."), "{left}");
    }

    #[test]
    fn only_an_oscillation_that_grows_is_said_to_grow() {
        let decays = |_: Quantity, time: f64| (-0.1 * time).exp() * (9.0 * time).sin();
        let grows = |_: Quantity, time: f64| (0.1 * time).exp() * (9.0 * time).sin();
        let found = said(decays, grows);
        let growing: Vec<_> = found.iter().filter(|text| text.contains("grows at the end")).collect();
        assert!(growing.len() == 1 && growing[0].starts_with("RL "), "{found:?}");
    }

    #[test]
    fn another_aircraft_is_not_said_to_be_the_thesis_jet() {
        let mut table = Table::new(false, &[]);
        assert_eq!(in_short(&table), [OTHER]);
        table.rows[1].wing.ours = Some(1.42);
        let found = in_short(&table);
        // 1.42 m instead of the thesis' 2.84.
        assert!(found[1].contains("at most 50.0 % (E, a tenth)"), "{found:?}");
        assert!(!table.markdown().contains("independent"));
        table.is_shipped = true;
        assert_eq!(in_short(&table)[0], SHIPPED);
        assert!(table.markdown().contains("independent"));
    }
}

//! How many modes are enough, in a sentence.

use super::quantity::{Kind, Quantity, Value};

/// What moves by less has converged, as a share.
const CONVERGED: f64 = 0.01;

/// Numbers that are a smaller share of their scale are nothing but rounding.
const NOTHING: f64 = 1e-9;

/// How many modes are enough.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// There is but one number of modes.
    Alone,
    /// Those of a row are; with more, each kind of quantity moves by at most such a share.
    Enough { row: usize, moves: Vec<(Kind, f64)> },
    /// Only those of the last row are, all modes of the structure.
    All,
    /// Not those of the last row: this quantity, of those that moved most in the last step, shows it.
    Not { quantity: usize },
}

impl Verdict {
    /// Of quantities with a value for each of some numbers of modes; `has_no_more` tells whether the last has all there are.
    pub fn of(quantities: &[Quantity], rows: usize, has_no_more: impl FnOnce() -> bool) -> Self {
        if rows < 2 {
            return Verdict::Alone;
        }
        for row in 0..rows - 1 {
            let moves = moves(quantities, row, rows);
            if moves.iter().all(|(_, share)| *share <= CONVERGED) {
                return Verdict::Enough { row, moves };
            }
        }
        if has_no_more() {
            return Verdict::All;
        }
        // Roots speak where nothing else does; of equals the first.
        let moved = |place: &usize| match quantities[*place].change(rows - 2, rows - 1) {
            share if quantities[*place].kind == Some(Kind::Root) => [0.0, share],
            share => [if share > CONVERGED { share } else { 0.0 }, 0.0],
        };
        let judged = (0..quantities.len()).rev().filter(|&place| quantities[place].kind.is_some());
        let compare = |a: &[f64; 2], b: &[f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
        let quantity = judged.max_by(|a, b| compare(&moved(a), &moved(b))).unwrap_or(0);
        Verdict::Not { quantity }
    }

    /// For people; `labels` are the numbers of modes.
    pub fn text(&self, quantities: &[Quantity], labels: &[String], with_loads: bool) -> String {
        let last = labels.len().saturating_sub(1);
        let label = |row: usize| labels.get(row).map_or("", String::as_str);
        match self {
            Verdict::Alone => {
                "One number of modes says nothing of convergence: ask for several (--modes N,N,…).".to_owned()
            }
            Verdict::Enough { moves, .. } if moves.is_empty() => {
                "Nothing was found that could move with the number of modes.".to_owned()
            }
            Verdict::Enough { row, moves } => {
                let verbs = std::iter::once(" move").chain(std::iter::repeat(""));
                let moves = moves
                    .iter()
                    .zip(verbs)
                    .map(|((kind, share), verb)| format!("{}{verb} by {}", kind.plural(), at_most(*share)));
                let more = if row + 1 == last { String::new() } else { " up to".to_owned() };
                let are = if label(*row) == "1" { "mode is" } else { "modes are" };
                format!(
                    "{} {are} enough: with more,{more} {}, {} at most.",
                    label(*row),
                    label(last),
                    moves.collect::<Vec<_>>().join(", ")
                )
            }
            Verdict::All => {
                format!("Of these numbers only {} modes will do: all that the structure has.", label(last))
            }
            Verdict::Not { quantity } => {
                let moved = quantities.get(*quantity).map_or(String::new(), |quantity| {
                    let (name, by) = (&quantity.name, by(quantity, last));
                    match &quantity.values[last] {
                        Value::Unknown(reason) => format!("{name} is not known ({reason})"),
                        _ => format!("{name} still moved{by} at the last step ({})", from_to(quantity, last)),
                    }
                });
                let loads = if with_loads { "" } else { " or for load modes (--load-modes)" };
                format!("Not converged with {} modes: {moved}; ask for more (--modes …){loads}.", label(last))
            }
        }
    }
}

/// By how much each kind of quantity moves at most from a row to those after it.
fn moves(quantities: &[Quantity], row: usize, rows: usize) -> Vec<(Kind, f64)> {
    let of_kind = |kind| {
        let is_found = |value: &Value, scale: f64| match value {
            Value::Number(number) => number.abs() > NOTHING * scale,
            Value::Root(_) | Value::Unknown(_) => true,
            Value::Outside(_) => false,
        };
        let is_known = |quantity: &&Quantity| {
            quantity.kind == Some(kind)
                && quantity.values[row..].iter().any(|value| is_found(value, quantity.scale))
        };
        let changes = quantities
            .iter()
            .filter(is_known)
            .flat_map(|quantity| (row + 1..rows).map(|more| quantity.change(row, more)));
        changes.reduce(f64::max).map(|share| (kind, share))
    };
    Kind::ALL.into_iter().filter_map(of_kind).collect()
}

/// A line for each quantity that the last step moved by more than what has converged does.
pub fn moved(quantities: &[Quantity], labels: &[String]) -> Vec<String> {
    let Some(last) = labels.len().checked_sub(1).filter(|last| *last > 0) else { return Vec::new() };
    let moved = quantities
        .iter()
        .filter(|quantity| quantity.kind.is_some() && quantity.change(last - 1, last) > CONVERGED);
    let line = |quantity: &Quantity| {
        format!(
            "{} moved{} from {} to {} modes ({})",
            quantity.name,
            by(quantity, last),
            labels[last - 1],
            labels[last],
            from_to(quantity, last)
        )
    };
    moved.map(line).collect()
}

/// By how much the last step moved a quantity, if that can be told, and of what.
fn by(quantity: &Quantity, last: usize) -> String {
    let share = quantity.change(last - 1, last);
    let of = match (quantity.kind, quantity.unit) {
        (Some(Kind::Trim), "rad") => " of the greatest trim angle",
        (Some(Kind::Deflection), _) => " of the greatest deflection",
        _ => "",
    };
    if share.is_finite() { format!(" by {}{of}", percent(share)) } else { String::new() }
}

fn from_to(quantity: &Quantity, last: usize) -> String {
    format!("{} to {}", quantity.text_with_unit(last - 1), quantity.text_with_unit(last))
}

/// A share of two digits or so.
pub fn percent(share: f64) -> String {
    match 100.0 * share {
        percent if !percent.is_finite() => "–".to_owned(),
        percent if percent >= 9.95 => format!("{percent:.0} %"),
        percent if percent >= 0.095 => format!("{percent:.1} %"),
        percent => format!("{percent:.2} %"),
    }
}

/// The same, of what is bounded by it.
fn at_most(share: f64) -> String {
    if share < 1e-4 { "0.01 %".to_owned() } else { percent(share) }
}

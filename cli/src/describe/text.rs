//! A description for people.

use nalgebra::Matrix3;

use super::Description;
use super::balance::Balance;
use super::facts::Facts;
use super::modes::NaturalMode;
use crate::numbers::{aligned, fixed, rounded, short};

/// All of it.
pub fn text(description: &Description) -> String {
    let Description { facts, balance, modes, warnings } = description;
    let mut text = format!("{}\n\n{}\n{}", facts.name, mass(facts), reference(facts));
    let counts = facts.counts.iter().map(|&(what, count)| format!("{count} {}", counted(what, count)));
    let counts: Vec<String> = counts.collect();
    let joints: String = facts
        .joints
        .iter()
        .map(|joint| {
            format!(
                "
{joint}"
            )
        })
        .collect();
    text += &format!(
        "{}{joints}

{}
{}",
        counts.join(", "),
        stability(balance),
        natural_modes(modes)
    );
    for warning in warnings {
        text += &format!("\nwarning: {warning}");
    }
    text.trim_end().to_owned() + "\n"
}

/// Mass, centre of mass, inertia.
fn mass(facts: &Facts) -> String {
    let [x, y, z] = [0, 1, 2].map(|axis| fixed(facts.centre_of_mass[axis], 4));
    format!(
        "mass {} kg, centre of mass x {x}, y {y}, z {z} m from O (forward, right, down)\n\n\
         inertia about the centre of mass, kg m² (rows x, y, z; the products with their sign as matrix entries)\n{}\n\
         inertia about O, kg m²\n{}",
        short(facts.mass),
        matrix(&facts.about_centre),
        matrix(&facts.about_origin)
    )
}

/// With its zeros, which rounding hides, as such.
fn matrix(inertia: &Matrix3<f64>) -> String {
    let smallest = 1e-12 * inertia.amax();
    let cell = |row: usize, column: usize| {
        let entry = inertia[(row, column)];
        let name = ["x", "y", "z"];
        let name = format!("I{}{}", name[row], name[column]);
        [name, if entry.abs() <= smallest { "0".to_owned() } else { rounded(entry) }]
    };
    let row = |row: usize| [0, 1, 2].map(|column| cell(row, column)).concat();
    let lines = aligned(&[0, 1, 2].map(row));
    lines.lines().map(|line| format!("  {line}\n")).collect()
}

fn reference(facts: &Facts) -> String {
    let Some(lengths) = facts.reference else {
        return "no reference lengths: there are no strips, and the file has no [reference]\n".to_owned();
    };
    let wing = facts.wing.join(" and ");
    let source = match (facts.gives_some, wing.as_str()) {
        (_, "") => "the file".to_owned(),
        (true, wing) => format!("the file, where it gives them, else of {wing}"),
        (false, wing) => wing.to_owned(),
    };
    let [chord, area, span] = [lengths.chord, lengths.area, lengths.span].map(short);
    format!("reference chord {chord} m, area {area} m², span {span} m, of {source}\n")
}

/// A word for one or several.
fn counted(what: &'static str, count: usize) -> &'static str {
    if count == 1 { what.trim_end_matches('s') } else { what }
}

fn stability(balance: &Balance) -> String {
    let found = match (&balance.stability, &balance.margin) {
        (Ok(stability), Some(margin)) => format!(
            "static margin {} of the chord, neutral point x {} m, C_Lα {} per rad; in this trim the centre of mass is at x {} m",
            fixed(margin.margin, 4),
            fixed(stability.neutral_point(), 4),
            fixed(margin.lift_slope, 4),
            fixed(stability.centre_of_mass.x, 4)
        ),
        (Ok(stability), None) => {
            format!(
                "neutral point x {} m; no static margin without a reference chord",
                fixed(stability.neutral_point(), 4)
            )
        }
        (Err(reason), _) => format!("no static margin: {reason}"),
    };
    format!("{}\n  {found}\n", balance.condition)
}

fn natural_modes(modes: &[NaturalMode]) -> String {
    if modes.is_empty() {
        return "no natural mode flies\n".to_owned();
    }
    let head = ["mode", "Hz", "rad/s", "motion", "moves"].map(str::to_owned).to_vec();
    let row = |mode: &NaturalMode| {
        let moves = mode.kinetic.iter().map(|(name, share)| format!("{name} {} %", fixed(100.0 * share, 0)));
        vec![
            mode.number.to_string(),
            fixed(mode.frequency(), 3),
            fixed(mode.angular_frequency, 3),
            mode.motion.clone(),
            moves.collect::<Vec<_>>().join(", "),
        ]
    };
    let mut lines: Vec<Vec<String>> = std::iter::once(head).chain(modes.iter().map(row)).collect();
    for column in [3, 4] {
        let width = lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
        // Words stand to the left.
        lines.iter_mut().for_each(|line| line[column] = format!("{:<width$}", line[column]));
    }
    let table = aligned(&lines);
    let table = table.lines().map(|line| format!("{}\n", line.trim_end()));
    format!("natural modes of the structure held at O\n{}", table.collect::<String>())
}

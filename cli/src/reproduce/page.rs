//! The page that shows it all: one HTML file that needs nothing else.

use std::fmt::Write;

use crate::chart::{escaped, legend};

use super::figures::Comparison;
use super::fit::Verdict;
use super::plots::Plot;
use super::wings::Wing;
use super::{Reproduction, Section, findings};

/// Light and dark by the reader's preference; the drawings are inverted in the dark.
const STYLE: &str = "
:root { color-scheme: light dark; --line: #8886; --soft: #8882; }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 78rem; margin: 0 auto; padding: 1rem; }
h1 { line-height: 1.2; } h2 { margin-top: 3rem; border-top: 1px solid var(--line); padding-top: 1rem; }
p, ul { max-width: 46rem; } .wide { overflow-x: auto; }
nav a { display: inline-block; margin: 0 1rem .3rem 0; }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .6rem; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th:first-child, td:first-child, .words { text-align: left; white-space: normal; }
th { vertical-align: bottom; white-space: normal; }
.figures { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 28rem), 1fr)); }
figure { margin: 0; border: 1px solid var(--line); border-radius: .4rem; overflow: hidden; }
figure svg { display: block; width: 100%; height: auto; }
.legend { position: sticky; top: 0; z-index: 1; background: Canvas; padding: .3rem 0; }
.legend svg { display: block; max-width: 100%; height: auto; }
figcaption { padding: .4rem .7rem; font-size: .85rem; background: var(--soft); }
@media (prefers-color-scheme: dark) { figure > svg, .legend svg { filter: invert(.88) hue-rotate(180deg); } }
";

/// The most width of a legend, px: so much that its letters can be read on a phone.
const LEGEND: f64 = 560.0;

/// The page.
pub fn html(reproduction: &Reproduction) -> String {
    let mut page = String::from("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    let _ =
        write!(page, "<title>Reproduction of the thesis</title>\n<style>{STYLE}</style>\n</head>\n<body>\n");
    page += &introduction(reproduction);
    page += &trims(reproduction);
    for section in &reproduction.sections {
        page += &figures(reproduction, section);
    }
    page += &fits(reproduction);
    page += &wings(reproduction);
    page += "</body>\n</html>\n";
    page
}

fn introduction(reproduction: &Reproduction) -> String {
    let links = reproduction.sections.iter().map(|Section { group, plots, .. }| {
        format!("<a href=\"#{}\">{}</a> ", anchor(plots), escaped(&group.comparison.title()))
    });
    let inputs = reproduction.inputs.iter().map(|(number, svg)| {
        format!(
            "<figure id=\"figure-5.{number}\">{svg}<figcaption>{}</figcaption></figure>\n",
            findings::INPUT
        )
    });
    format!(
        "<h1>The flights of the thesis, flown again</h1>\n<p>{}</p>\n<p>Aircraft: {}. <strong>{}</strong></p>\n\
         {}<p>{}</p>\n<nav><a href=\"#table-5.1\">Table 5.1</a> {}<a href=\"#fits\">All windows</a> \
         <a href=\"#wings\">Wings that bend far</a></nav>\n\
         <h2 id=\"inputs\">The inputs</h2>\n<p>{}</p>\n<div class=\"figures\">\n{}</div>\n",
        findings::INTRODUCTION,
        escaped(&reproduction.name),
        reproduction.summary(),
        list(&findings::in_short(&reproduction.table)),
        findings::HOW_TO_READ,
        links.collect::<String>(),
        findings::INPUTS,
        inputs.collect::<String>(),
    )
}

/// Sentences of plain text.
fn list(sentences: &[String]) -> String {
    let items: String =
        sentences.iter().map(|sentence| format!("<li>{}</li>\n", escaped(sentence))).collect();
    if items.is_empty() { items } else { format!("<ul>\n{items}</ul>\n") }
}

fn trims(reproduction: &Reproduction) -> String {
    let table = &reproduction.table;
    let row = |cells: Vec<String>| format!("<tr><td>{}</td></tr>\n", cells.join("</td><td>"));
    let rows = table.rows.iter().map(|line| row(table.cells(line)));
    let note = if table.is_shipped { format!("<p>{}</p>\n", findings::INDEPENDENT) } else { String::new() };
    format!(
        "<h2 id=\"table-5.1\">Table 5.1: deflections in trim, 127 m/s</h2>\n{note}<div class=\"wide\"><table>\n\
         <tr><th>{}</th></tr>\n{}</table></div>\n",
        table.headings().join("</th><th>"),
        rows.collect::<String>(),
    )
}

fn figures(reproduction: &Reproduction, section: &Section) -> String {
    let Section { group, plots, findings } = section;
    let mut html = format!(
        "<h2 id=\"{}\">{}</h2>\n<p>{}</p>\n<p><strong>{}</strong></p>\n{}",
        anchor(plots),
        escaped(&group.comparison.title()),
        conditions(group.comparison),
        count(plots.iter()),
        list(findings),
    );
    let flights = group.comparison.flights();
    for (flight, reason) in &reproduction.ended {
        if let Some((_, label)) = flights.iter().find(|(shown, _)| shown == flight) {
            let _ = writeln!(html, "<p>{} ends early: {}.</p>", escaped(label), escaped(reason));
        }
    }
    let labels: Vec<&str> = flights.iter().map(|(_, label)| label.as_str()).collect();
    let _ =
        writeln!(html, "<div class=\"legend\">{}</div>\n<div class=\"figures\">", legend(&labels, LEGEND));
    for plot in plots {
        html += &drawing(plot);
    }
    html + "</div>\n"
}

fn drawing(plot: &Plot) -> String {
    let fit = plot.fit.as_ref().map_or("nothing flew".to_owned(), |fit| {
        let digits = digits(plot);
        let ours = format!("ours {} to {}", number(fit.ours.min, digits), number(fit.ours.max, digits));
        format!("{ours}: {}", fit.verdict)
    });
    let clipped = if plot.is_clipped { "; the curves go on beyond the drawing" } else { "" };
    format!(
        "<figure id=\"figure-5.{}\">{}<figcaption>Figure 5.{}: {}. Window of the thesis {}; {}{clipped}.\
         </figcaption></figure>\n",
        plot.figure.number,
        plot.panel,
        plot.figure.number,
        plot.figure.quantity.name(),
        window(plot),
        escaped(&fit),
    )
}

/// Every figure in one table.
fn fits(reproduction: &Reproduction) -> String {
    let rows = reproduction.plots().filter_map(|plot| {
        let (fit, digits, n) = (plot.fit.as_ref()?, digits(plot), plot.figure.number);
        Some(format!(
            "<tr><td><a href=\"#figure-5.{n}\">5.{n}</a></td><td class=\"words\">{}, {}</td><td>{}</td>\
             <td>{} to {}</td><td>{:.0} %</td><td class=\"words\">{}</td></tr>\n",
            plot.figure.quantity.name(),
            plot.figure.quantity.label(),
            window(plot),
            number(fit.ours.min, digits),
            number(fit.ours.max, digits),
            100.0 * fit.filling(&plot.figure.window),
            escaped(&fit.verdict.to_string()),
        ))
    });
    format!(
        "<h2 id=\"fits\">All windows</h2>\n<p>{}</p>\n<div class=\"wide\"><table>\n<tr><th>figure</th><th class=\"words\">quantity\
         </th><th>window of the thesis</th><th>ours</th><th>ours/window</th><th class=\"words\">verdict</th></tr>\n{}</table></div>\n",
        findings::WINDOWS,
        rows.collect::<String>(),
    )
}

/// What the thesis does not have: the level that is right for large deflections, against what others found.
fn wings(reproduction: &Reproduction) -> String {
    let figures = reproduction.wings.iter().map(|Wing { slug, chart, caption }| {
        format!("<figure id=\"{slug}\">{}<figcaption>{caption}</figcaption></figure>\n", chart.to_svg())
    });
    format!(
        "<h2 id=\"wings\">Beyond the thesis: wings that bend far</h2>\n<p>{}</p>\n<div class=\"figures\">\n{}</div>\n",
        findings::WINGS,
        figures.collect::<String>()
    )
}

/// How many figures fit, in one sentence.
pub fn count<'a>(plots: impl Iterator<Item = &'a Plot>) -> String {
    let (mut all, mut same, mut inside) = (0, 0, 0);
    for plot in plots {
        all += 1;
        match plot.fit.as_ref().map(|fit| &fit.verdict) {
            Some(Verdict::SameAxis) => same += 1,
            Some(Verdict::Inside) => inside += 1,
            Some(Verdict::Outside { .. }) | None => {}
        }
    }
    format!(
        "Of {all} figures, {same} would get the thesis' own axis, {inside} lie inside of it but fill less, and {} \
         leave it.",
        all - same - inside
    )
}

fn conditions(comparison: Comparison) -> String {
    let describe = |(flight, label): &(super::cases::Flight, String)| match comparison {
        Comparison::Models(_) => label.clone(),
        Comparison::Aerodynamics(_) => format!("{} {label}", flight.fidelity.symbol()),
    };
    let (case, flights) = (comparison.case(), comparison.flights());
    let family = match case.modes() {
        (count, flexible_aircraft::plant::ModeSelection::All) => {
            format!("{count} modes of both families")
        }
        (count, flexible_aircraft::plant::ModeSelection::Symmetric) => {
            format!("{count} symmetric modes")
        }
    };
    let models: Vec<String> = flights.iter().map(describe).collect();
    format!("{}; 7620 m; {family}; {}.", escaped(case.title()), models.join(", "))
}

fn anchor(plots: &[Plot]) -> String {
    plots.first().map_or(String::new(), |plot| format!("from-5.{}", plot.figure.number))
}

fn window(plot: &Plot) -> String {
    let (window, digits) = (plot.figure.window, digits(plot).saturating_sub(1));
    format!("{} to {}", number(window.min, digits), number(window.max, digits))
}

/// One more digit than the ticks have.
fn digits(plot: &Plot) -> usize {
    1 + (0..5).find(|&digits| (plot.figure.tick * 10_f64.powi(digits)).fract() < 1e-9).unwrap_or(5) as usize
}

/// With a true minus, and none before a zero.
pub fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let is_zero = text.chars().all(|c| "-0.".contains(c));
    if is_zero { text.replace('-', "") } else { text.replace('-', "−") }
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, OnceLock};

    use flexible_aircraft::aircraft::Aircraft;
    use flexible_aircraft::equations::Fidelity;
    use flexible_aircraft::structure::ReducedModel;

    use super::*;
    use crate::reproduce::cases::{Case, Flight, UNSTEADY};
    use crate::reproduce::history::{History, Places, Quantity};
    use crate::reproduce::wings;

    /// One second of one flight: enough for the trim and for a page.
    fn reproduction() -> &'static Reproduction {
        static REPRODUCTION: OnceLock<Reproduction> = OnceLock::new();
        REPRODUCTION.get_or_init(|| {
            let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../aircraft/generic-business-jet.toml");
            let aircraft = Aircraft::read(file).unwrap();
            let model = Arc::new(ReducedModel::new(&aircraft, ReducedModel::USUAL_MODES).unwrap());
            let flight =
                Flight { case: Case::ElevatorTenth, fidelity: Fidelity::Exact, inflow_states: UNSTEADY };
            let mut history = History::fly(&model, Places::of(&model).unwrap(), flight, 2.0);
            assert_eq!(history.end, None);
            assert_eq!(history.samples.len(), 201);
            // The first pulse is nose-up.
            assert!(
                history.samples[200].value(Quantity::Pitch)
                    > history.samples[0].value(Quantity::Pitch) + 0.005
            );
            assert_eq!(history.to_csv().lines().count(), 202);
            history.end = Some(flexible_aircraft::flight::SimulationError::NotFinite { time: 2.0 });
            Reproduction::new(&aircraft, &[history], wings::all().unwrap())
        })
    }

    #[test]
    fn the_page_has_every_figure_once_and_needs_no_other_file() {
        let page = html(reproduction());
        for number in 1..=57 {
            assert_eq!(page.matches(&format!("<figure id=\"figure-5.{number}\">")).count(), 1, "{number}");
        }
        for external in ["href=\"http", "src=", "url(http", "@import", "<link"] {
            assert!(!page.contains(external), "{external}");
        }
        let links = page.split("href=\"#").skip(1).filter_map(|rest| rest.split('"').next());
        for target in links {
            assert!(page.contains(&format!("id=\"{target}\"")), "{target}");
        }
    }

    #[test]
    fn a_flight_that_ends_early_is_drawn_as_far_as_it_went_with_the_reason() {
        let page = html(reproduction());
        assert!(page.contains("E ends early: at 2 s the state is no longer finite"));
        let plot = reproduction().plots().find(|plot| plot.figure.number == 11).unwrap();
        assert!(plot.fit.is_some() && plot.svg.contains("E ends"));
    }

    #[test]
    fn only_the_shipped_aircraft_is_compared_with_what_others_found_for_it() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../aircraft/generic-business-jet.toml");
        let mut aircraft = Aircraft::read(file).unwrap();
        assert!(Reproduction::new(&aircraft, &[], wings::all().unwrap()).table.is_shipped);
        aircraft.bays[0].mass += 1.0;
        let page = html(&Reproduction::new(&aircraft, &[], wings::all().unwrap()));
        assert!(!page.contains("independent programs") && page.contains("another aircraft"));
    }

    #[test]
    fn table_5_1_agrees_with_the_independent_programs_in_every_printed_digit() {
        let row = reproduction().table.rows.iter().find(|row| row.wing.ours.is_some()).unwrap();
        assert_eq!((row.fidelity, row.case), (Fidelity::Exact, Case::ElevatorTenth));
        for (tip, last_digit) in [(row.wing, 1e-3), (row.tail, 1e-4)] {
            assert!((tip.ours.unwrap() - tip.expected).abs() <= 0.5 * last_digit, "{tip:?}");
        }
        assert!((row.wing.difference().unwrap() + 0.003).abs() < 5e-4);
    }
}

//! The thesis' figures drawn with our curves.

use flexible_aircraft::equations::Fidelity;

use crate::chart::{Axis, Chart, Curve, FONT, Mark, Window, escaped, legend, nested};

use super::cases::Surface;
use super::figures::{Comparison, Figure};
use super::fit::Fit;
use super::history::{DURATION, History};

/// A figure with its curves, drawn.
#[derive(Clone, Debug)]
pub struct Plot {
    /// What it reproduces.
    pub figure: Figure,
    /// Against the thesis' window; absent when nothing flew.
    pub fit: Option<Fit>,
    /// Whether a curve leaves what is drawn.
    pub is_clipped: bool,
    /// An SVG element that stands alone.
    pub svg: String,
    /// The same without its legend, for a page where many share one.
    pub panel: String,
}

impl Plot {
    /// Draws a figure with the histories of its flights.
    pub fn new(figure: Figure, histories: &[History]) -> Plot {
        let (mut curves, mut marks) = (Vec::new(), Vec::new());
        for (flight, label) in figure.flights() {
            let Some(history) = histories.iter().find(|history| history.flight == flight) else { continue };
            if let (Some(_), Some(last)) = (&history.end, history.samples.last()) {
                marks.push(Mark::Vertical(last.time, format!("{label} ends")));
            }
            curves.push(Curve { label, points: history.curve(figure.quantity) });
        }
        let fit = Fit::of(&figure, &curves);
        let shown = fit.as_ref().map_or(figure.window, |fit| shown(&figure, &fit.ours));
        let is_clipped =
            fit.as_ref().is_some_and(|fit| !(shown.contains(fit.ours.min) && shown.contains(fit.ours.max)));
        let chart = Chart {
            title: format!("Figure 5.{}{}: {}", figure.number, subtitle(&figure), figure.quantity.name()),
            x: time_axis(),
            y: Axis {
                tick: Some(figure.tick * (shown.width() / figure.tick / 8.0).ceil()),
                ..Axis::new(figure.quantity.label(), shown)
            },
            curves,
            marks,
            frame: Some(figure.window),
        };
        Plot { figure, fit, is_clipped, svg: chart.to_svg(), panel: chart.to_svg_without_legend() }
    }
}

fn subtitle(figure: &Figure) -> String {
    match figure.comparison {
        Comparison::Models(_) => String::new(),
        Comparison::Aerodynamics(fidelity) => format!(", model {}", fidelity.symbol()),
    }
}

/// The thesis' window, widened by whole ticks to hold our curves, but at most by twice itself on either side.
fn shown(figure: &Figure, ours: &Window) -> Window {
    let Figure { window, tick, .. } = figure;
    let ticks =
        |excess: f64| tick * (excess / tick - 1e-6).ceil().clamp(0.0, (2.0 * window.width() / tick).round());
    Window::new(window.min - ticks(window.min - ours.min), window.max + ticks(ours.max - window.max))
}

/// Figures 5.1 and 5.33: an input by the name of the control that it moves, with the window that the thesis shows of it.
pub fn input(surface: Surface, control: &str) -> String {
    let manoeuvre = surface.manoeuvre();
    let times = (0..=3000).map(|step| DURATION / 3000.0 * f64::from(step));
    let (number, symbol, name) = match surface {
        Surface::Elevator => (1, "δe (rad)", format!("{control} about its trim")),
        Surface::Rudder => (33, "δr (rad)", control.to_owned()),
    };
    let chart = Chart {
        title: format!("Figure 5.{number}: {name}"),
        x: time_axis(),
        y: Axis { tick: Some(0.05), ..Axis::new(symbol, Window::new(-0.05, 0.05)) },
        curves: vec![Curve {
            label: name,
            points: times.map(|time| (time, manoeuvre.value(time))).collect(),
        }],
        marks: Vec::new(),
        frame: None,
    };
    // The title says what the only curve is.
    chart.to_svg_without_legend()
}

fn time_axis() -> Axis {
    Axis { tick: Some(5.0), ..Axis::new("Time (s)", Window::new(0.0, DURATION)) }
}

/// Some drawings side by side as one, in rows of two, under one title and above one legend of their models.
pub fn overview(title: &str, panels: &[&str]) -> String {
    let (width, height, head, foot) = (720.0, 440.0, 44.0, 44.0);
    let whole = 2.0 * width;
    let rows = panels.len().div_ceil(2) as f64;
    let placed = panels.iter().enumerate().map(|(index, panel)| {
        let (x, y) = (width * (index % 2) as f64, head + height * (index / 2) as f64);
        format!("<svg x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\">{}</svg>", nested(panel))
    });
    let labels =
        Fidelity::OF_THESIS.map(|fidelity| format!("{}, {}", fidelity.symbol(), fidelity.in_words()));
    let legend = legend(&labels.each_ref().map(String::as_str), whole);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {whole} {}\"><rect width=\"100%\" height=\"100%\" \
         fill=\"#ffffff\"/><text x=\"{width}\" y=\"32\" text-anchor=\"middle\" font-size=\"24\" \
         font-family=\"{FONT}\">{}</text>{}<svg x=\"10\" y=\"{}\">{legend}</svg></svg>\n",
        head + height * rows + foot,
        escaped(title),
        placed.collect::<String>(),
        head + height * rows + 8.0
    )
}

/// Some charts with legends of up to three rows, one below the other, as one.
pub fn column(drawings: &[String]) -> String {
    let (width, height) = (720.0, 524.0);
    let place = |(index, drawing): (usize, &String)| {
        let (y, drawing) = (height * index as f64, nested(drawing));
        format!("<svg y=\"{y}\" width=\"{width}\" height=\"{height}\">{drawing}</svg>")
    };
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {}\"><rect width=\"100%\" height=\"100%\" \
         fill=\"#ffffff\"/>{}</svg>\n",
        height * drawings.len() as f64,
        drawings.iter().enumerate().map(place).collect::<String>()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::figures::GROUPS;

    #[test]
    fn the_axis_grows_by_whole_ticks_and_only_where_needed() {
        let figure = GROUPS[0].figures().next().unwrap();
        assert_eq!(shown(&figure, &Window::new(125.2, 126.9)), Window::new(125.0, 127.0));
        assert_eq!(shown(&figure, &Window::new(124.2, 127.1)), Window::new(124.0, 127.5));
        assert_eq!(shown(&figure, &Window::new(-1e9, 127.0)), Window::new(121.0, 127.0));
    }
}

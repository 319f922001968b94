//! Line charts as SVG: curves over fixed axis windows, told apart by colour, dash and width together.
//!
//! The colours are those of M. Okabe and K. Ito, "Color Universal Design" (2008), which colour-blind readers
//! can tell apart; the dashes do the same in print without colour.

mod dots;
mod legend;
mod stack;
mod thinning;
mod ticks;
mod window;

use kuva::plot::LinePlot;
use kuva::plot::line::LineStyle;
use kuva::render::annotations::{ReferenceLine, ShadedRegion};
use kuva::render::layout::{ComputedLayout, Layout};
use kuva::render::plots::Plot;

use crate::mark_labels::upright_labels;
use dots::dots;
pub use legend::legend;
use legend::{Sign, entries};
pub use stack::stacked;
use thinning::thinned;
use ticks::Scale;
pub use window::Window;

/// Size of a chart, px of its view box; it scales.
const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 440.0;

/// Left and right of the axes, px.
const MARGINS: (f64, f64) = (92.0, 18.0);

/// Of the root element: a narrow window shows all of the chart, smaller.
const SCALES: &str = " style=\"max-width:100%;height:auto\"";

/// Of all letters.
pub const FONT: &str = "system-ui, sans-serif";

/// Points farther than this many windows outside of the window are brought there.
const FAR_OUTSIDE: f64 = 20.0;

/// Black, blue, vermilion, bluish green, reddish purple, orange, sky blue.
const COLOURS: [&str; 7] = ["#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

/// Strokes and gaps, px; coprime in number to the colours, so that 35 curves differ.
const DASHES: [&str; 5] = ["", "9 4", "9 3 2 3", "2 3", "14 3 2 3 2 3"];

/// Of the lines under the curves.
const MARK_COLOUR: &str = "#666666";

/// Curves over a common window.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Above the chart.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// In the order of drawing and of the legend; the n-th has the n-th style.
    pub curves: Vec<Curve>,
    /// Lines with a label at particular values, under the curves; points over them.
    pub marks: Vec<Mark>,
    /// A range of y that is to stand out: what lies outside of it is shaded.
    pub frame: Option<Window>,
}

/// An axis with its window.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Quantity and unit.
    pub label: String,
    /// What is shown.
    pub window: Window,
    /// Distance of the grid lines; chosen by the chart when absent.
    pub tick: Option<f64>,
    /// What its numbers stand for.
    pub scale: Scale,
}

/// A labelled curve; it may leave the window.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// In the legend.
    pub label: String,
    /// (x, y) in ascending order of drawing.
    pub points: Vec<(f64, f64)>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Style {
    colour: &'static str,
    /// Strokes and gaps, px; empty for a solid line.
    dash: &'static str,
    /// px.
    width: f64,
}

/// A labelled line across the chart, or labelled points.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// At a value of x.
    Vertical(f64, String),
    /// At a value of y that parts what is in order from what is not: stronger, without a label.
    Limit(f64),
    /// What others found: rings over the curves, in the legend behind them.
    Points(String, Vec<(f64, f64)>),
}

impl Chart {
    /// The chart with its legend as an SVG element that stands alone in a file and scales within a page.
    pub fn to_svg(&self) -> String {
        let (drawing, height) = self.with_legend(HEIGHT);
        element(WIDTH, height, &drawing)
    }

    /// The same without the legend, for several charts that share one.
    pub fn to_svg_without_legend(&self) -> String {
        element(WIDTH, HEIGHT, &self.panel(HEIGHT))
    }

    /// The chart, so high (px), above its legend, and the height of both, px.
    fn with_legend(&self, height: f64) -> (String, f64) {
        let curves = self.curves.iter().enumerate();
        let curves = curves.map(|(index, curve)| (curve.label.as_str(), Sign::Stroke(Style::of(index))));
        let points = self.marks.iter().filter_map(|mark| match mark {
            Mark::Points(label, _) => Some((label.as_str(), Sign::Ring)),
            Mark::Vertical(..) | Mark::Limit(_) => None,
        });
        let named: Vec<(&str, Sign)> = curves.chain(points).collect();
        let (legend, legend_height) = entries(&named, MARGINS.0, WIDTH, height);
        (self.panel(height) + &legend, height + legend_height)
    }

    fn panel(&self, height: f64) -> String {
        let plots: Vec<Plot> = self.curves.iter().enumerate().map(|(i, curve)| self.plot(i, curve)).collect();
        let layout = self.layout(&plots, height);
        let computed = ComputedLayout::from_layout(&layout);
        let frame = [computed.margin_top, height - computed.margin_bottom];
        kuva::render_to_svg(plots, layout)
            + &self.upright_label(height)
            + &dots(self, frame)
            + &self.mark_labels(frame)
    }

    /// What the vertical marks are, written at their lines.
    fn mark_labels(&self, top_and_bottom: [f64; 2]) -> String {
        let (left, right) = (MARGINS.0, WIDTH - MARGINS.1);
        let place = |x: f64| left + (x - self.x.window.min) / self.x.window.width() * (right - left);
        let lines = self.marks.iter().filter_map(|mark| match mark {
            Mark::Vertical(x, label) => Some((place(*x), label.as_str())),
            Mark::Limit(_) | Mark::Points(..) => None,
        });
        upright_labels(&lines.collect::<Vec<_>>(), [left, right], top_and_bottom)
    }

    /// The label of the vertical axis, where no tick label reaches.
    fn upright_label(&self, height: f64) -> String {
        format!(
            "<text transform=\"rotate(-90)\" x=\"{}\" y=\"22\" text-anchor=\"middle\" font-size=\"17\">{}</text>",
            -0.495 * height,
            escaped(&self.y.label)
        )
    }

    fn plot(&self, index: usize, curve: &Curve) -> Plot {
        let shown = curve.points.iter().filter(|(x, y)| x.is_finite() && y.is_finite());
        let points: Vec<(f64, f64)> = shown.map(|&(x, y)| (self.x.limit(x), self.y.limit(y))).collect();
        let scale = (self.x.window.width(), self.y.window.width());
        let Style { colour, dash, width } = Style::of(index);
        let plot = LinePlot::new().with_data(thinned(&points, scale)).with_color(colour);
        Plot::Line(plot.with_stroke_width(width).with_line_style(LineStyle::Custom(dash.to_owned())))
    }

    fn layout(&self, plots: &[Plot], height: f64) -> Layout {
        // So much wider that rounding does not hide the ticks at the ends.
        let shown =
            |Window { min, max }: Window| Window::new(min - 1e-9 * (max - min), max + 1e-9 * (max - min));
        let (x, y) = (&shown(self.x.window), &shown(self.y.window));
        let mut layout = Layout::auto_from_plots(plots)
            .with_width(WIDTH)
            .with_height(height)
            .with_title(&self.title)
            .with_x_label(&self.x.label)
            .with_x_axis_min(x.min)
            .with_x_axis_max(x.max)
            .with_y_axis_min(y.min)
            .with_y_axis_max(y.max)
            .with_box_axes()
            .with_force_margins(MARGINS.0, MARGINS.1)
            .with_x_tick_format(self.x.scale.format())
            .with_y_tick_format(self.y.scale.format())
            .with_title_size(title_size(&self.title))
            .with_label_size(17)
            .with_tick_size(15)
            .with_font_family(FONT);
        if let Some(step) = self.x.tick {
            layout = layout.with_x_tick_step(step);
        }
        if let Some(step) = self.y.tick {
            layout = layout.with_y_tick_step(step);
        }
        if let Some(frame) = self.frame {
            layout = shade_outside(layout, &self.y.window, &frame);
        }
        self.marks.iter().fold(layout, draw_mark)
    }
}

impl Axis {
    /// An axis whose grid the chart chooses.
    pub fn new(label: impl Into<String>, window: Window) -> Self {
        Axis { label: label.into(), window, tick: None, scale: Scale::Plain }
    }

    /// An axis of powers of ten, with a grid line at each.
    pub fn of_decades(label: impl Into<String>, window: Window) -> Self {
        Axis { tick: Some(1.0), scale: Scale::Decades, ..Axis::new(label, window) }
    }

    /// Brings values from very far outside nearer, for the sake of programs that draw.
    fn limit(&self, value: f64) -> f64 {
        let Window { min, max } = self.window;
        let margin = FAR_OUTSIDE * self.window.width();
        value.clamp(min - margin, max + margin)
    }
}

impl Style {
    /// The style of the n-th curve. The first one lies under the others and is wide enough to be seen there.
    fn of(index: usize) -> Self {
        let width = if index == 0 { 2.8 } else { 1.9 };
        Style { colour: COLOURS[index % COLOURS.len()], dash: DASHES[index % DASHES.len()], width }
    }
}

/// A white SVG element of a size, px, with a content.
fn element(width: f64, height: f64, content: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\"{SCALES} role=\"img\" font-family=\"{FONT}\">\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>{content}</svg>\n"
    )
}

/// A chart as an element of another drawing, where it has the size that this one gives it.
pub fn nested(chart: &str) -> String {
    chart.replacen(SCALES, "", 1)
}

/// Text as the content of an XML element.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The size, px, at which a title of some letters fits over the axes.
fn title_size(title: &str) -> u32 {
    let letters = title.chars().count().max(1) as f64;
    (1080.0 / letters).clamp(11.0, 20.0) as u32
}

/// Grey where the chart shows more than the frame, and the frame's edges.
fn shade_outside(layout: Layout, shown: &Window, frame: &Window) -> Layout {
    let regions = [(shown.min, frame.min), (frame.max, shown.max)];
    let outside = regions.into_iter().zip([frame.min, frame.max]).filter(|((low, high), _)| low < high);
    outside.fold(layout, |layout, ((low, high), edge)| {
        layout
            .with_shaded_region(ShadedRegion::horizontal(low, high).with_color("#808080").with_opacity(0.14))
            .with_reference_line(
                ReferenceLine::horizontal(edge).with_color(MARK_COLOUR).with_dasharray("5 3"),
            )
    })
}

fn draw_mark(layout: Layout, mark: &Mark) -> Layout {
    let line = match mark {
        Mark::Points(..) => return layout,
        Mark::Vertical(x, _) => ReferenceLine::vertical(*x).with_color(MARK_COLOUR).with_dasharray("5 3"),
        Mark::Limit(y) => {
            ReferenceLine::horizontal(*y).with_color("#000000").with_stroke_width(2.2).with_dasharray("none")
        }
    };
    layout.with_reference_line(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart() -> Chart {
        let wave = (0..=1500).map(|i| (0.01 * f64::from(i), (0.05 * f64::from(i)).sin())).collect();
        Chart {
            title: "A < B & C".into(),
            x: Axis { tick: Some(5.0), ..Axis::new("time (s)", Window::new(0.0, 15.0)) },
            y: Axis { tick: Some(0.5), ..Axis::new("wave", Window::new(-0.5, 1.5)) },
            curves: vec![
                Curve { label: "wave".into(), points: wave },
                Curve { label: "ramp".into(), points: vec![(0.0, 0.0), (7.0, 1.0), (8.0, f64::NAN)] },
            ],
            marks: vec![Mark::Vertical(3.0, "here".into())],
            frame: Some(Window::new(0.0, 1.0)),
        }
    }

    #[test]
    fn a_chart_names_everything_as_text_and_scales() {
        let svg = chart().to_svg();
        for text in
            ["A &lt; B &amp; C", "time (s)", "wave", "ramp", "here", ">15<", ">−0.5<", "viewBox=\"0 0 "]
        {
            assert!(svg.contains(text), "{text} is missing");
        }
        assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>") && !svg.contains("NaN"));
    }

    /// Browsers show a drawing of its own with its width, cut off where the window is narrower, unless it says otherwise.
    #[test]
    fn a_chart_alone_is_no_wider_than_its_window_and_a_nested_one_keeps_its_size() {
        let svg = chart().to_svg();
        let (root, rest) = svg.split_once('>').unwrap();
        assert!(
            root.contains(" style=\"max-width:100%;height:auto\"") && !rest.contains("max-width"),
            "{root}"
        );
        assert!(!nested(&svg).contains("max-width") && nested(&svg).len() + SCALES.len() == svg.len());
    }

    /// −0.15 = −3 × 0.05, but not in floating-point numbers.
    #[test]
    fn both_ends_of_an_axis_have_their_ticks() {
        let y = Axis { tick: Some(0.05), ..Axis::new("ωy", Window::new(-0.15, 0.1)) };
        let svg = Chart { y, frame: None, ..chart() }.to_svg();
        for tick in [">−0.15<", ">−0.1<", ">0<", ">0.1<"] {
            assert!(svg.contains(tick), "{tick}");
        }
    }

    #[test]
    fn charts_can_share_one_legend() {
        let (with, without) = (chart().to_svg(), chart().to_svg_without_legend());
        assert!(with.contains(">ramp<") && !without.contains(">ramp<"));
        let shared = legend(&["wave", "ramp"], 700.0);
        for label in [">wave<", ">ramp<"] {
            assert_eq!(shared.matches(label).count(), 1);
        }
    }

    #[test]
    fn what_is_outside_of_the_frame_is_shaded_on_both_sides() {
        assert_eq!(chart().to_svg().matches("#808080").count(), 2);
        let whole = Chart { frame: Some(Window::new(-0.5, 1.5)), ..chart() };
        assert_eq!(whole.to_svg().matches("#808080").count(), 0);
    }

    #[test]
    fn no_two_of_thirty_five_curves_look_alike() {
        let styles = (0..35).map(Style::of).map(|style| (style.colour, style.dash));
        assert_eq!(styles.collect::<std::collections::HashSet<_>>().len(), 35);
    }
}

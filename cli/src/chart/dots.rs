//! Points: curves of one, which no line shows, and what others found.

use super::{Axis, Chart, Curve, MARGINS, Mark, Style, WIDTH};

/// A dot for each curve of one point and a ring for each point of others, as far as they are inside of the axes, whose frame
/// has its top and bottom there, px.
pub fn dots(chart: &Chart, [top, bottom]: [f64; 2]) -> String {
    let (left, right) = (MARGINS.0, WIDTH - MARGINS.1);
    let share = |axis: &Axis, value: f64| (value - axis.window.min) / axis.window.width();
    let place = |(x, y): (f64, f64)| {
        let is_inside = chart.x.window.contains(x) && chart.y.window.contains(y);
        let [x, y] =
            [left + share(&chart.x, x) * (right - left), bottom - share(&chart.y, y) * (bottom - top)];
        is_inside.then_some((x, y))
    };
    let dot = |(index, curve): (usize, &Curve)| {
        let [point] = curve.points[..] else { return None };
        let ((x, y), colour) = (place(point)?, Style::of(index).colour);
        Some(format!("<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"4\" fill=\"{colour}\"/>"))
    };
    let rings = chart.marks.iter().filter_map(|mark| match mark {
        Mark::Points(_, points) => Some(points),
        Mark::Vertical(..) | Mark::Limit(_) => None,
    });
    let rings = rings.flatten().filter_map(|&point| place(point)).map(|(x, y)| ring(x, y));
    chart.curves.iter().enumerate().filter_map(dot).chain(rings).collect()
}

/// A ring about a place, px.
pub fn ring(x: f64, y: f64) -> String {
    format!(
        "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"6\" fill=\"#ffffff\" fill-opacity=\"0.7\" stroke=\"#000000\" \
         stroke-width=\"1.8\"/>"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Window;

    #[test]
    fn curves_of_one_point_are_dots_and_points_of_others_rings_inside_of_the_axes() {
        let curve = |points: &[(f64, f64)]| Curve { label: "root".into(), points: points.to_vec() };
        let chart = Chart {
            title: "dots".into(),
            x: Axis::new("airspeed (m/s)", Window::new(5.0, 25.0)),
            y: Axis::new("growth (1/s)", Window::new(-1.0, 3.0)),
            curves: vec![
                curve(&[(15.0, 2.0)]),
                curve(&[(30.0, 2.0)]),
                curve(&[(15.0, 4.0)]),
                curve(&[(5.0, 0.0), (25.0, 0.0)]),
            ],
            marks: vec![Mark::Points("others".into(), vec![(15.0, 1.0), (15.0, 5.0)])],
            frame: None,
        };
        // In the middle across, a quarter of the height below the top.
        let middle = 0.5 * (MARGINS.0 + WIDTH - MARGINS.1);
        let dot = format!("<circle cx=\"{middle:.2}\" cy=\"200.00\" r=\"4\" fill=\"#000000\"/>");
        assert_eq!(dots(&chart, [100.0, 500.0]), dot + &ring(middle, 300.0));
        assert!(chart.to_svg().contains(&format!("<circle cx=\"{middle:.2}\"")));
        assert!(chart.to_svg().contains(">others<"));
    }
}

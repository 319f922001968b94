//! Curves of one point, which no line shows.

use super::{Axis, Chart, Curve, MARGINS, Style, WIDTH};

/// A dot for each of them that is inside of the axes, whose frame has its top and bottom there, px.
pub fn dots(chart: &Chart, [top, bottom]: [f64; 2]) -> String {
    let (left, right) = (MARGINS.0, WIDTH - MARGINS.1);
    let share = |axis: &Axis, value: f64| (value - axis.window.min) / axis.window.width();
    let dot = |(index, curve): (usize, &Curve)| {
        let [(x, y)] = curve.points[..] else { return None };
        let is_inside = chart.x.window.contains(x) && chart.y.window.contains(y);
        let [x, y] =
            [left + share(&chart.x, x) * (right - left), bottom - share(&chart.y, y) * (bottom - top)];
        let colour = Style::of(index).colour;
        is_inside.then(|| format!("<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"4\" fill=\"{colour}\"/>"))
    };
    chart.curves.iter().enumerate().filter_map(dot).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Window;

    #[test]
    fn a_curve_of_one_point_is_a_dot_where_it_is_inside_of_the_axes() {
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
            marks: Vec::new(),
            frame: None,
        };
        // In the middle across, a quarter of the height below the top.
        let middle = 0.5 * (MARGINS.0 + WIDTH - MARGINS.1);
        let expected = format!("<circle cx=\"{middle:.2}\" cy=\"200.00\" r=\"4\" fill=\"#000000\"/>");
        assert_eq!(dots(&chart, [100.0, 500.0]), expected);
        assert!(chart.to_svg().contains(&format!("<circle cx=\"{middle:.2}\"")));
    }
}

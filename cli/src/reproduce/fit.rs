//! How our curves lie in the thesis' windows.

use std::fmt;

use crate::chart::{Curve, Window};

use super::figures::Figure;

/// Values this small a share of a tick beyond a tick are on it.
const ROUNDING: f64 = 1e-6;

/// All curves of a figure against its window.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Lowest and highest value of any curve.
    pub ours: Window,
    /// The judgement.
    pub verdict: Verdict,
}

/// Where the curves are, as far as the thesis' axis tells.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// An automatic axis would be the thesis' own: both extremes are where its are, to one tick.
    SameAxis,
    /// Inside the window, but an extreme is farther from its end than one tick.
    Inside,
    /// Some curves leave the window.
    Outside {
        /// Beyond the lower end, in widths of the window.
        below: f64,
        /// Beyond the upper end, in widths of the window.
        above: f64,
        /// Those that do.
        curves: Vec<String>,
    },
}

impl Fit {
    /// Nothing, when there is no curve.
    pub fn of(figure: &Figure, curves: &[Curve]) -> Option<Fit> {
        let values = curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1));
        let ours = range(values)?;
        let Figure { window, tick, .. } = figure;
        let slack = ROUNDING * tick;
        let leaves = |range: &Window| range.min < window.min - slack || range.max > window.max + slack;
        let verdict = if leaves(&ours) {
            let out = curves.iter().filter(|curve| {
                range(curve.points.iter().map(|point| point.1)).is_some_and(|range| leaves(&range))
            });
            Verdict::Outside {
                below: ((window.min - ours.min) / window.width()).max(0.0),
                above: ((ours.max - window.max) / window.width()).max(0.0),
                curves: out.map(|curve| curve.label.clone()).collect(),
            }
        } else if ours.min < window.min + tick - slack && ours.max > window.max - tick + slack {
            Verdict::SameAxis
        } else {
            Verdict::Inside
        };
        Some(Fit { ours, verdict })
    }

    /// The share of the window that our curves fill; more than 1 when they leave it.
    pub fn filling(&self, window: &Window) -> f64 {
        self.ours.width() / window.width()
    }
}

/// Lowest and highest of some numbers.
fn range(values: impl Iterator<Item = f64>) -> Option<Window> {
    values.fold(None, |range, value| {
        let Window { min, max } = range.unwrap_or(Window::new(value, value));
        Some(Window::new(min.min(value), max.max(value)))
    })
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Verdict::SameAxis => f.write_str("same axis"),
            Verdict::Inside => f.write_str("inside, narrower"),
            Verdict::Outside { below, above, curves } => {
                let percent = |share: f64| 100.0 * share;
                write!(f, "leaves it")?;
                if *below > 0.0 {
                    write!(f, " below by {:.0} %", percent(*below).ceil())?;
                }
                if *below > 0.0 && *above > 0.0 {
                    write!(f, " and")?;
                }
                if *above > 0.0 {
                    write!(f, " above by {:.0} %", percent(*above).ceil())?;
                }
                write!(f, " ({})", curves.join(", "))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use flexible_aircraft::equations::Fidelity;

    use super::*;
    use crate::reproduce::figures::Comparison;
    use crate::reproduce::history::Quantity;

    fn verdict(extremes: &[(f64, f64)]) -> Verdict {
        let figure = Figure {
            number: 3,
            comparison: Comparison::Aerodynamics(Fidelity::Exact),
            quantity: Quantity::VelocityZ,
            window: Window::new(16.0, 20.0),
            tick: 1.0,
        };
        let curve = |(index, &(low, high)): (usize, &(f64, f64))| Curve {
            label: format!("c{index}"),
            points: vec![(0.0, low), (1.0, high)],
        };
        Fit::of(&figure, &extremes.iter().enumerate().map(curve).collect::<Vec<_>>()).unwrap().verdict
    }

    #[test]
    fn the_axis_is_the_thesis_own_when_both_extremes_are_in_its_last_ticks() {
        assert_eq!(verdict(&[(16.2, 18.0), (17.0, 19.3)]), Verdict::SameAxis);
        assert_eq!(verdict(&[(17.2, 19.3)]), Verdict::Inside);
        assert_eq!(verdict(&[(16.0, 18.9)]), Verdict::Inside);
        assert_eq!(verdict(&[(16.0, 20.0)]), Verdict::SameAxis);
    }

    #[test]
    fn curves_that_leave_are_named_with_how_far() {
        let outside = verdict(&[(16.2, 18.0), (15.0, 20.4)]);
        assert_eq!(outside.to_string(), "leaves it below by 25 % and above by 10 % (c1)");
    }
}

//! The figures of and their axes [theory: thesis-runs.cases; thesis §5.2–5.4].
//!
//! The windows and the distances of the ticks are the tick labels printed at the thesis' figures. The thesis
//! gives no numbers of its curves, but its axes have been chosen by Matlab: the narrowest range between
//! ticks that holds all curves. So the lowest value of each figure lies within one tick above the window's
//! lower end, the highest within one tick below its upper end: that much is known of the thesis' curves.

use flexible_aircraft::equations::Fidelity;

use crate::chart::Window;

use super::cases::{Case, Flight, UNSTEADY};
use super::history::Quantity::{
    self, AccelerationX, AccelerationY, AccelerationZ, Pitch, RateX, RateY, RateZ, Roll, VelocityX,
    VelocityY, VelocityZ, WingTip, Yaw,
};

/// Figures of the same flights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Group {
    /// What they show.
    pub comparison: Comparison,
    /// Number of the first, after "5."; the others follow.
    first: u8,
    /// Quantity, lower and upper end of its axis, distance of its ticks, one row per figure.
    axes: &'static [(Quantity, f64, f64, f64)],
}

/// What the curves of a figure differ in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// The models, in one case.
    Models(Case),
    /// Unsteady and steady aerodynamics, with one model at the higher speed.
    Aerodynamics(Fidelity),
}

/// One figure of the thesis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// After "5.".
    pub number: u8,
    /// What its curves differ in.
    pub comparison: Comparison,
    /// What it shows over time.
    pub quantity: Quantity,
    /// Of the vertical axis, in the unit of the quantity.
    pub window: Window,
    /// Distance of the ticks on the vertical axis.
    pub tick: f64,
}

/// All of them, in the order of the thesis.
#[rustfmt::skip]
pub const GROUPS: [Group; 7] = [
    Group {
        comparison: Comparison::Models(Case::ElevatorNominal),
        first: 2,
        axes: &[
            (VelocityX, 125.0, 127.0, 0.5),
            (VelocityZ, 16.0, 19.0, 1.0),
            (RateY, -0.02, 0.02, 0.01),
            (Pitch, 0.12, 0.17, 0.01),
            (AccelerationX, -0.4, 0.4, 0.2),
            (AccelerationZ, -3.0, 2.0, 1.0),
        ],
    },
    Group {
        comparison: Comparison::Models(Case::ElevatorTenth),
        first: 8,
        axes: &[
            (VelocityX, 125.0, 127.0, 0.5),
            (VelocityZ, 12.0, 20.0, 2.0),
            (RateY, -0.04, 0.04, 0.02),
            (Pitch, 0.1, 0.16, 0.02),
            (AccelerationX, -0.5, 0.5, 0.5),
            (AccelerationZ, -4.0, 4.0, 2.0),
        ],
    },
    Group {
        comparison: Comparison::Models(Case::ElevatorTenthFast),
        first: 14,
        axes: &[
            (VelocityX, 176.5, 179.0, 0.5),
            (VelocityZ, 0.0, 20.0, 5.0),
            (RateY, -0.15, 0.1, 0.05),
            (Pitch, 0.0, 0.1, 0.02),
            (AccelerationX, -1.0, 1.0, 0.5),
            (AccelerationZ, -20.0, 20.0, 10.0),
            (WingTip, 2.0, 8.0, 2.0),
        ],
    },
    Group {
        comparison: Comparison::Aerodynamics(Fidelity::Exact),
        first: 21,
        axes: &[
            (VelocityX, 176.8, 177.8, 0.2),
            (VelocityZ, 6.0, 16.0, 2.0),
            (RateY, -0.1, 0.1, 0.05),
            (Pitch, 0.02, 0.1, 0.02),
            (AccelerationX, -1.0, 1.0, 0.5),
            (AccelerationZ, -15.0, 10.0, 5.0),
        ],
    },
    Group {
        comparison: Comparison::Aerodynamics(Fidelity::ConsistentlyLinearised),
        first: 27,
        axes: &[
            (VelocityX, 177.0, 178.5, 0.5),
            (VelocityZ, 0.0, 15.0, 5.0),
            (RateY, -0.15, 0.1, 0.05),
            (Pitch, 0.0, 0.1, 0.02),
            (AccelerationX, -1.0, 1.0, 0.5),
            (AccelerationZ, -20.0, 20.0, 10.0),
        ],
    },
    Group {
        comparison: Comparison::Models(Case::RudderTenth),
        first: 34,
        axes: &[
            (VelocityX, 125.7, 126.2, 0.1),
            (VelocityY, -4.0, 4.0, 2.0),
            (VelocityZ, 15.0, 18.0, 1.0),
            (RateX, -0.1, 0.1, 0.05),
            (RateY, -0.001, 0.003, 0.001),
            (RateZ, -0.04, 0.04, 0.02),
            (Roll, -0.02, 0.04, 0.02),
            (Pitch, 0.12, 0.145, 0.005),
            (Yaw, -0.02, 0.03, 0.01),
            (AccelerationX, -0.1, 0.1, 0.05),
            (AccelerationY, -6.0, 4.0, 2.0),
            (AccelerationZ, -0.2, 0.6, 0.2),
        ],
    },
    Group {
        comparison: Comparison::Models(Case::RudderTenthFast),
        first: 46,
        axes: &[
            (VelocityX, 168.0, 178.0, 2.0),
            (VelocityY, -10.0, 15.0, 5.0),
            (VelocityZ, 8.0, 18.0, 2.0),
            (RateX, -0.3, 0.2, 0.1),
            (RateY, -0.04, 0.06, 0.02),
            (RateZ, -0.2, 0.2, 0.1),
            (Roll, -0.1, 0.1, 0.05),
            (Pitch, 0.0, 0.2, 0.05),
            (Yaw, -0.1, 0.1, 0.05),
            (AccelerationX, -1.5, 0.5, 0.5),
            (AccelerationY, -40.0, 40.0, 20.0),
            (AccelerationZ, -10.0, 10.0, 5.0),
        ],
    },
];

impl Comparison {
    /// What is flown.
    pub fn case(self) -> Case {
        match self {
            Comparison::Models(case) => case,
            Comparison::Aerodynamics(fidelity) => Flight::steady(fidelity).case,
        }
    }

    /// The flights whose curves are in the figures, with their labels.
    pub fn flights(self) -> Vec<(Flight, String)> {
        match self {
            Comparison::Models(case) => {
                let flight = |fidelity| Flight { case, fidelity, inflow_states: UNSTEADY };
                Fidelity::OF_THESIS.map(|fidelity| (flight(fidelity), fidelity.symbol().to_owned())).into()
            }
            Comparison::Aerodynamics(fidelity) => {
                let steady = Flight::steady(fidelity);
                let unsteady = Flight { inflow_states: UNSTEADY, ..steady };
                vec![(unsteady, "unsteady".into()), (steady, "steady (N = 0)".into())]
            }
        }
    }

    /// For people.
    pub fn title(self) -> String {
        match self {
            Comparison::Models(case) => case.title().to_owned(),
            Comparison::Aerodynamics(fidelity) => {
                format!("{}, unsteady and steady aerodynamics, 177.8 m/s", fidelity.symbol())
            }
        }
    }
}

impl Group {
    /// Its figures.
    pub fn figures(&self) -> impl Iterator<Item = Figure> {
        let Group { comparison, first, axes } = *self;
        (first..).zip(axes).map(move |(number, &(quantity, min, max, tick))| Figure {
            number,
            comparison,
            quantity,
            window: Window::new(min, max),
            tick,
        })
    }
}

impl Figure {
    /// The flights whose curves it shows, with their labels.
    pub fn flights(&self) -> Vec<(Flight, String)> {
        let mut flights = self.comparison.flights();
        flights.retain(|(flight, _)| self.quantity.is_of(flight));
        flights
    }

    /// Its file.
    pub fn file_name(&self) -> String {
        format!("figure-5.{:02}-{}.svg", self.number, self.quantity.slug())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figures() -> Vec<Figure> {
        GROUPS.iter().flat_map(Group::figures).collect()
    }

    #[test]
    fn every_response_of_the_thesis_is_there_once_and_in_order() {
        let numbers: Vec<u8> = figures().iter().map(|figure| figure.number).collect();
        // 5.1 and 5.33 are the inputs.
        let expected: Vec<u8> = (2..=32).chain(34..=57).collect();
        assert_eq!(numbers, expected);
    }

    #[test]
    fn every_window_is_a_whole_number_of_ticks_from_tick_to_tick() {
        for Figure { number, window, tick, .. } in figures() {
            for ticks in [window.min / tick, window.max / tick] {
                assert!((ticks - ticks.round()).abs() < 1e-6, "figure 5.{number}");
            }
            assert!((2..=6).contains(&((window.width() / tick).round() as u8)), "figure 5.{number}");
        }
    }

    #[test]
    fn every_window_of_a_symmetric_flight_holds_the_trim() {
        for figure in figures() {
            let speed = figure.comparison.case().airspeed();
            match figure.quantity {
                VelocityX => assert!(figure.window.min < speed && figure.window.max > 0.97 * speed),
                Pitch | VelocityZ | WingTip => assert!(figure.window.max > 0.0),
                _ => assert!(figure.window.contains(0.0), "figure 5.{}", figure.number),
            }
        }
    }

    #[test]
    fn every_figure_has_its_flights_and_its_own_file() {
        let flown = Flight::all();
        let mut files = std::collections::HashSet::new();
        for figure in figures() {
            let flights = figure.flights();
            let models = matches!(figure.comparison, Comparison::Models(_));
            let expected = if !models {
                2
            } else if figure.quantity == WingTip {
                4
            } else {
                5
            };
            assert_eq!(flights.len(), expected);
            assert!(flights.iter().all(|(flight, _)| flown.contains(flight)));
            assert!(files.insert(figure.file_name()));
        }
    }
}

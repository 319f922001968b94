//! The flights of: which aircraft, how fast, which input, which models.
//!
//! [theory: thesis-runs.cases, thesis-runs.inputs; thesis §5.2–5.4]
//!
//! The thesis prints the inputs only as figures 5.1 and 5.33, which give an axis range; amplitude, unit time
//! and start are ours. What it captions 203 m/s has V_x ≈ 178 m/s on its axes and was flown
//! at 177.8 m/s, 1.4 × 127.

use flexible_aircraft::aircraft::TrimRole;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::{ModeSelection, PlantSettings};
use flexible_aircraft::structure::ReducedModel;

use crate::manoeuvre::Manoeuvre;

/// Time constant of the low-pass filter 1/(0.05 s + 1) before the surfaces, s [theory: thesis-runs.inputs; thesis §5.2].
const LAG: f64 = 0.05;
/// Deflection of either surface, rad.
const AMPLITUDE: f64 = 0.05;
/// When either manoeuvre begins, s.
const START: f64 = 1.0;
/// Inflow states per strip [theory: thesis-runs.cases; thesis §5.1].
pub const UNSTEADY: usize = 5;

/// One flight condition with one input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Case {
    /// Figures 5.2–5.7.
    ElevatorNominal,
    /// Figures 5.8–5.13.
    ElevatorTenth,
    /// Figures 5.14–5.32.
    ElevatorTenthFast,
    /// Figures 5.34–5.45.
    RudderTenth,
    /// Figures 5.46–5.57.
    RudderTenthFast,
}

/// The surface that moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surface {
    /// 2-3-1-1, first pulse nose-up.
    Elevator,
    /// Doublet, first nose right.
    Rudder,
}

/// A case flown with one model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Flight {
    /// What is flown.
    pub case: Case,
    /// The model.
    pub fidelity: Fidelity,
    /// N; 0 is steady aerodynamics.
    pub inflow_states: usize,
}

impl Surface {
    /// What the control that moves it holds in trim.
    pub fn role(self) -> TrimRole {
        match self {
            Surface::Elevator => TrimRole::Pitch,
            Surface::Rudder => TrimRole::Yaw,
        }
    }

    /// Its angle about the trim as a function of time, rad and s.
    pub fn manoeuvre(self) -> Manoeuvre {
        match self {
            // Negative is trailing edge up: nose-up.
            Surface::Elevator => Manoeuvre::two_three_one_one(-AMPLITUDE, 0.7, START, LAG),
            Surface::Rudder => Manoeuvre::doublet(AMPLITUDE, 2.0, START, LAG),
        }
    }
}

impl Case {
    /// In the order of the thesis.
    pub const ALL: [Case; 5] = [
        Case::ElevatorNominal,
        Case::ElevatorTenth,
        Case::ElevatorTenthFast,
        Case::RudderTenth,
        Case::RudderTenthFast,
    ];

    /// What moves.
    pub fn surface(self) -> Surface {
        match self {
            Case::ElevatorNominal | Case::ElevatorTenth | Case::ElevatorTenthFast => Surface::Elevator,
            Case::RudderTenth | Case::RudderTenthFast => Surface::Rudder,
        }
    }

    /// m/s.
    pub fn airspeed(self) -> f64 {
        match self {
            Case::ElevatorNominal | Case::ElevatorTenth | Case::RudderTenth => 127.0,
            Case::ElevatorTenthFast | Case::RudderTenthFast => 177.8,
        }
    }

    /// Of the nominal stiffness.
    pub fn stiffness_scale(self) -> f64 {
        if self == Case::ElevatorNominal { 1.0 } else { 0.1 }
    }

    /// Number of modes and their families.
    pub fn modes(self) -> (usize, ModeSelection) {
        match self.surface() {
            Surface::Elevator => (8, ModeSelection::Symmetric),
            Surface::Rudder => (12, ModeSelection::All),
        }
    }

    /// For file names.
    pub fn slug(self) -> &'static str {
        match self {
            Case::ElevatorNominal => "elevator-nominal-127",
            Case::ElevatorTenth => "elevator-tenth-127",
            Case::ElevatorTenthFast => "elevator-tenth-178",
            Case::RudderTenth => "rudder-tenth-127",
            Case::RudderTenthFast => "rudder-tenth-178",
        }
    }

    /// For people.
    pub fn title(self) -> &'static str {
        match self {
            Case::ElevatorNominal => "Elevator, nominal stiffness, 127 m/s",
            Case::ElevatorTenth => "Elevator, a tenth of the stiffness, 127 m/s",
            Case::ElevatorTenthFast => "Elevator, a tenth of the stiffness, 177.8 m/s (captioned 203 m/s)",
            Case::RudderTenth => "Rudder, a tenth of the stiffness, 127 m/s",
            Case::RudderTenthFast => "Rudder, a tenth of the stiffness, 177.8 m/s (captioned 203 m/s)",
        }
    }
}

impl Flight {
    /// Every flight that some figure or table needs, once.
    pub fn all() -> Vec<Flight> {
        let unsteady =
            |case| Fidelity::OF_THESIS.map(|fidelity| Flight { case, fidelity, inflow_states: UNSTEADY });
        let steady = [Fidelity::Exact, Fidelity::ConsistentlyLinearised].map(Flight::steady);
        Case::ALL.into_iter().flat_map(unsteady).chain(steady).collect()
    }

    /// The flight without inflow states that figures 5.21–5.32 compare with.
    pub fn steady(fidelity: Fidelity) -> Flight {
        Flight { case: Case::ElevatorTenthFast, fidelity, inflow_states: 0 }
    }

    /// The parameters of the simulation of an aircraft.
    pub fn settings(&self, model: &ReducedModel) -> Settings {
        let (mode_count, mode_selection) = self.case.modes();
        Settings::from(PlantSettings {
            fidelity: self.fidelity,
            airspeed: self.case.airspeed(),
            altitude: 7620.0,
            stiffness_scale: self.case.stiffness_scale(),
            mode_selection,
            mode_count,
            inflow_states: self.inflow_states,
            ..PlantSettings::of(model)
        })
    }

    /// For file names.
    pub fn slug(&self) -> String {
        let steady = if self.inflow_states == 0 { "-steady" } else { "" };
        format!("{}-{}{steady}", self.case.slug(), self.fidelity.symbol())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn five_cases_with_five_models_and_two_without_inflow_are_flown_once_each() {
        let flights = Flight::all();
        assert_eq!(flights.len(), 27);
        assert_eq!(flights.iter().collect::<HashSet<_>>().len(), 27);
        assert_eq!(flights.iter().map(Flight::slug).collect::<HashSet<_>>().len(), 27);
        assert_eq!(flights.iter().filter(|flight| flight.inflow_states == 0).count(), 2);
    }

    #[test]
    fn the_elevator_first_raises_the_nose_and_the_rudder_first_turns_it_right() {
        assert!(Surface::Elevator.manoeuvre().value(2.0) < -0.049);
        assert!(Surface::Rudder.manoeuvre().value(2.0) > 0.049);
    }

    #[test]
    fn the_second_speed_is_that_of_the_axes_and_not_of_the_captions() {
        assert_eq!(Case::ElevatorTenthFast.airspeed(), Case::RudderTenthFast.airspeed());
        assert!((Case::ElevatorTenthFast.airspeed() - 1.4 * 127.0).abs() < 1e-9);
    }
}

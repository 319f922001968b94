//! The modes of a flight by their names, and what its elevator does for long [theory: stability.modes, linearisation.load-factor-slope].

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use crate::flight::{Settings, SimulationError};
use crate::plant::{Manoeuvre, SteadyFlight, Trim, TrimCondition, TrimPoint};
use crate::stability::FlightModes;
use crate::structure::ReducedModel;

use super::at_trim::AtTrim;
use super::linear_model::{Inflow, LinearContents, LinearModel};
use super::linear_names::Name;

/// Step of the bank angle or of the sideslip in which names are carried from symmetric flight, rad.
const STEP: f64 = PI / 36.0;

/// Less of an angle of attack than this, rad per rad of a control, is rounding.
const LEAST_ALPHA: f64 = 1e-6;

/// Names of states that are held where an elevator is asked what it does for long: all of the rigid motion but heave and
/// pitch rate.
const HELD: [&str; 8] = [
    "position.down",
    "attitude.roll",
    "attitude.pitch",
    "velocity.x",
    "velocity.y",
    "rate.x",
    "rate.z",
    "attitude.yaw",
];

/// The modes of the aircraft itself, without actuators and engines that lag, in the trim of some settings. In flights that are
/// not symmetric names are carried there from symmetric flight. Allocates.
///
/// # Errors
/// As for [`LinearModel::new`].
pub fn flight_modes(
    model: impl Into<Arc<ReducedModel>>,
    settings: &Settings,
    inflow: Inflow,
) -> Result<FlightModes, SimulationError> {
    let contents = LinearContents { inflow, ..LinearContents::default() };
    Ok(AtTrim::new(model.into(), settings, contents)?.flight_modes())
}

impl AtTrim {
    /// The modes of the aircraft itself there. Allocates.
    fn flight_modes(&self) -> FlightModes {
        let (plant, condition) = (&self.plant, self.settings.plant.along_course().trim_condition());
        let followed = |before: Option<FlightModes>, trim: &Trim| {
            let modes = FlightModes::new(&plant.linearise(trim));
            match before {
                Some(before) => modes.named_after(&before),
                None => modes,
            }
        };
        // A flight on the way that cannot be trimmed is passed over.
        let on_the_way = way_to(&condition, &self.trim.point).into_iter();
        let trims = on_the_way.filter_map(|condition| plant.trim(&condition).ok());
        let before = trims.fold(None, |before, trim| Some(followed(before, &trim)));
        followed(before, &self.trim)
    }
}

/// From symmetric flight to one that is not: the flights between, without the last.
fn way_to(condition: &TrimCondition, point: &TrimPoint) -> Vec<TrimCondition> {
    let Manoeuvre { flight, climb_angle, .. } = condition.manoeuvre;
    if condition.manoeuvre.is_symmetric() {
        return Vec::new();
    }
    let (angle, flight): (f64, fn(f64) -> SteadyFlight) = match flight {
        SteadyFlight::Turn { .. } | SteadyFlight::TurnAtLoadFactor { .. } => {
            (point.roll, |bank_angle| SteadyFlight::Turn { bank_angle })
        }
        SteadyFlight::Banked { bank_angle } => (bank_angle, |bank_angle| SteadyFlight::Banked { bank_angle }),
        SteadyFlight::Straight { sideslip } => (sideslip, |sideslip| SteadyFlight::Straight { sideslip }),
        SteadyFlight::PullUp { .. } => (0.0, |_| SteadyFlight::Straight { sideslip: 0.0 }),
    };
    let steps = libm::ceil(angle.abs() / STEP).max(1.0) as usize;
    let at = |step: usize| {
        let flight = match step {
            0 => SteadyFlight::Straight { sideslip: 0.0 },
            _ => flight(angle * step as f64 / steps as f64),
        };
        TrimCondition { manoeuvre: Manoeuvre { flight, climb_angle, failed_engine: None }, ..*condition }
    };
    (0..steps).map(at).collect()
}

impl LinearModel {
    /// n/α, 1/rad: the load factor at the centre of mass by the angle of attack that a control gives at last, height, attitude
    /// and airspeed along the body held. None where there is no such control, the aircraft is clamped, or the control
    /// gives no angle of attack.
    pub fn load_factor_slope(&self, control: &str) -> Option<f64> {
        let place = |names: &[Name], name: &str| names.iter().position(|other| other.name == name);
        let [load_factor, alpha] =
            ["load_factor_cg.z", "air.alpha"].map(|output| place(&self.outputs, output));
        let (load_factor, alpha) = (load_factor?, alpha?);
        place(&self.states, "velocity.z")?;
        let input = place(&self.inputs, control)?;
        // Behind an actuator the control is a state.
        let position = place(&self.states, &format!("actuator.{control}.position"));
        let is_free = |state: &usize| {
            let name = self.states[*state].name.as_str();
            !HELD.contains(&name)
                && !["actuator.", "engine.", "position.", "drift."].iter().any(|part| name.starts_with(part))
        };
        let free: Vec<usize> = (0..self.states.len()).filter(is_free).collect();
        let by_control: DVector<f64> = match position {
            Some(position) => self.a.column(position).into_owned(),
            None => self.b.column(input).into_owned(),
        };
        let at_once = |output: usize| match position {
            Some(position) => self.c[(output, position)],
            None => self.d[(output, input)],
        };
        let matrix = DMatrix::from_fn(free.len(), free.len(), |i, j| self.a[(free[i], free[j])]);
        let forcing = DVector::from_fn(free.len(), |i, _| -by_control[free[i]]);
        let steady = matrix.lu().solve(&forcing)?;
        let answer = |output: usize| {
            let by_states: f64 = free.iter().zip(steady.iter()).map(|(&j, x)| self.c[(output, j)] * x).sum();
            by_states + at_once(output)
        };
        let by_alpha = answer(alpha);
        let slope = answer(load_factor) / by_alpha;
        (by_alpha.abs() > LEAST_ALPHA && slope.is_finite()).then_some(slope)
    }
}

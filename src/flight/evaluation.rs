//! Evaluations of the plant at points of the flight, none of them twice.

use nalgebra::Vector3;

use crate::equations::{Controls, Workspace};
use crate::plant::Plant;
use crate::symmetry::{Form, Plants};

use super::point::Point;
use super::steering::Steering;

/// The present in the form that the inputs ask for, where that is not the form of the flight.
#[derive(Clone, Debug)]
pub(super) struct View {
    pub state: Vec<f64>,
    pub slope: Vec<f64>,
    /// Whether they are those of the present under the present inputs.
    pub is_fresh: bool,
}

/// Velocity of the air and its rate along the course, m/s and m/s².
pub(super) type Wind = (Vector3<f64>, Vector3<f64>);

impl View {
    /// Evaluates the plant of another form at a point of the flight.
    pub fn refresh(
        &mut self,
        point: &Point,
        plants: &Plants,
        form: Form,
        workspace: &mut Workspace,
        steering: &Steering,
        controls: &mut Controls,
    ) {
        if !self.is_fresh {
            plants.convert(&point.state, &mut self.state);
            steering.write_at(point.time, controls);
            plants.forms().of(form).rates(&self.state, controls, &mut self.slope, workspace);
            self.is_fresh = true;
        }
    }
}

/// Brings the slope at a point up to date with the inputs; `evaluated_in` is the wind of the last evaluation, if that
/// was at this point.
pub(super) fn refresh(
    point: &mut Point,
    plant: &Plant,
    workspace: &mut Workspace,
    steering: &Steering,
    controls: &mut Controls,
    evaluated_in: &mut Option<Wind>,
) {
    if point.slope_is_fresh {
        return;
    }
    steering.write_at(point.time, controls);
    let wind = (controls.wind, controls.wind_rate);
    if *evaluated_in == Some(wind) {
        plant.steer(controls, &mut point.slope, workspace);
    } else {
        plant.rates(&point.state, controls, &mut point.slope, workspace);
        *evaluated_in = Some(wind);
    }
    point.slope_is_fresh = true;
}

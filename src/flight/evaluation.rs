//! Evaluations of the plant at points of the flight, none of them twice.

use nalgebra::Vector3;

use crate::equations::Controls;
use crate::symmetry::ActivePlant;

use super::point::Point;
use super::steering::Steering;

/// Velocity of the air and its rate along the course, m/s and m/s².
pub(super) type Wind = (Vector3<f64>, Vector3<f64>);

/// Brings the slope at a point up to date with the inputs; `evaluated_in` is the wind of the last evaluation, if that
/// was at this point.
pub(super) fn refresh(
    point: &mut Point,
    plant: &mut ActivePlant,
    steering: &Steering,
    controls: &mut Controls,
    evaluated_in: &mut Option<Wind>,
) {
    if point.slope_is_fresh {
        return;
    }
    steering.write_at(point.time, &point.acting, controls);
    let wind = (controls.wind, controls.wind_rate);
    if *evaluated_in == Some(wind) {
        plant.steer(controls, &mut point.slope);
    } else {
        plant.rates(&point.state, controls, &mut point.slope);
        *evaluated_in = Some(wind);
    }
    point.slope_is_fresh = true;
}

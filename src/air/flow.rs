//! How the air moves: north-east-down where it is, in body axes as an aircraft meets it [theory: air.wind; thesis §4.1].
//!
//! A flow at an instant has a velocity W and a rate Ẇ at every point. What the aircraft meets of it depends on where a section is
//! and how that moves; of air that moves everywhere alike, on neither.

use nalgebra::Vector3;

use crate::math::{Arithmetic, Arrow, Attitude, Window};

/// Air that moves everywhere alike at an instant: a wind, the flow of a tunnel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UniformFlow {
    /// W, north-east-down, m/s.
    pub velocity: Vector3<f64>,
    /// Ẇ, m/s².
    pub rate: Vector3<f64>,
}

/// The air as an aircraft meets it at an instant, in body axes.
pub trait MetAir {
    /// At sections by their places X, and by their velocities relative to the body axes.
    fn at<S: Arithmetic, V: Arrow<S>>(&self, window: Window<S>, sections: [&V; 2]) -> MetAt<V>;
}

/// What sections meet of the air; vectors of a kind `V`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetAt<V> {
    /// v − W: how O moves relative to the air at the section, m/s.
    pub velocity: V,
    /// ω × W − Ẇ: the part of its rate that no acceleration of O makes, m/s².
    pub drift: V,
}

/// Air that all sections meet alike.
#[derive(Clone, Copy, Debug)]
pub struct UniformlyMet(MetAt<Vector3<f64>>);

impl UniformFlow {
    /// As it is met by an aircraft whose axes move at v and ω.
    pub fn met_by(&self, attitude: &Attitude, [velocity, rate]: [&Vector3<f64>; 2]) -> UniformlyMet {
        let wind = attitude.body_from_inertial * self.velocity;
        UniformlyMet(MetAt {
            velocity: velocity - wind,
            drift: rate.cross(&wind) - attitude.body_from_inertial * self.rate,
        })
    }
}

impl UniformlyMet {
    /// At O.
    pub fn at_origin(&self) -> &MetAt<Vector3<f64>> {
        &self.0
    }
}

impl MetAir for UniformlyMet {
    #[inline(always)]
    fn at<S: Arithmetic, V: Arrow<S>>(&self, window: Window<S>, _: [&V; 2]) -> MetAt<V> {
        let MetAt { velocity, drift } = &self.0;
        MetAt { velocity: V::splat(window, velocity), drift: V::splat(window, drift) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::quaternion_of_euler_angles;

    #[test]
    fn an_aircraft_that_turns_in_a_steady_wind_and_moves_with_it_meets_no_air_but_sees_the_wind_turn() {
        let attitude = Attitude::from_quaternion(&quaternion_of_euler_angles(&Vector3::new(0.3, -0.2, 1.1)));
        let flow = UniformFlow { velocity: Vector3::new(7.0, -3.0, 1.0), rate: Vector3::zeros() };
        let wind = attitude.body_from_inertial * flow.velocity;
        let rate = Vector3::new(0.1, 0.4, -0.2);
        let met = *flow.met_by(&attitude, [&wind, &rate]).at_origin();
        assert_eq!(met, MetAt { velocity: Vector3::zeros(), drift: rate.cross(&wind) });
    }
}

//! The loads of strips as the theory writes them, one strip after the other, from the state alone: nothing of the
//! program's load summation is used. Steady inflow (N = 0): λ₀ = 0.
//!
//! [theory: air-loads.lift, air-loads.moment, air-loads.suction, air-loads.drag, gusts.chord, gusts.strip; thesis §4.1]

use std::f64::consts::PI;

use flexible_aircraft::equations::{Controls, EquationsOfMotion};
use flexible_aircraft::math::Attitude;
use flexible_aircraft::structure::ReducedStrip;
use nalgebra::Vector3;

use super::plain_points::{Fixed, Moving, Point};

/// A state of the aircraft, and what acts on it.
pub struct Instant<'a> {
    /// The state's layout.
    pub equations: &'a EquationsOfMotion,
    /// How sections move.
    pub moving: Moving<'a>,
    /// Surfaces and the motion of the air.
    pub controls: &'a Controls,
    /// The whole state.
    pub state: &'a [f64],
    /// Its rates: the accelerations of the loads are taken from them.
    pub rates: &'a [f64],
    /// What the aircraft flies into.
    pub gust: Option<&'a PlainGust<'a>>,
}

/// A gust that is frozen in the air.
pub struct PlainGust<'a> {
    /// Along the track, to the right, down, over the distance from where it begins: m/s over m.
    pub velocity: &'a dyn Fn(f64) -> [f64; 3],
    /// e.
    pub along: Vector3<f64>,
    /// Where O was at the start, plus how far the air has gone since, m.
    pub origin: Vector3<f64>,
}

/// f, s, n of a strip, V and what follows.
pub struct Flow {
    forward: Vector3<f64>,
    span: Vector3<f64>,
    normal: Vector3<f64>,
    /// V.
    velocity: Vector3<f64>,
    /// U.
    chordwise: f64,
    /// n·V.
    across: f64,
    /// w.
    pub upwash: f64,
    /// W̄, body axes.
    gust: Vector3<f64>,
    /// g₁.
    gust_gradient: f64,
    /// Ω.
    pub pitch_rate: f64,
    at: Point,
}

/// What acts on a strip at its elastic axis.
pub struct StripLoad {
    /// Body axes, N.
    pub force: Vector3<f64>,
    /// About s, N·m.
    pub moment: f64,
    /// s.
    pub span: Vector3<f64>,
}

impl Instant<'_> {
    /// The flow at a strip in a state and a wind.
    fn flow_in(&self, strip: &ReducedStrip, state: &[f64], wind: &Vector3<f64>) -> Flow {
        let at = Fixed::from(strip).point(self.moving, self.equations, state);
        let attitude = Attitude::from_quaternion(&state[self.equations.layout().attitude()]);
        let (forward, span) = (at.turn * strip.forward, at.turn * strip.span);
        let normal = forward.cross(&span);
        let [gust, change] = self.gust_along_chord(strip, state, (&at.place, &forward));
        let velocity = at.velocity - attitude.body_from_inertial * wind - gust;
        let gust_gradient = -(normal + forward * strip.zero_lift_offset).dot(&change);
        let (chordwise, across) = (forward.dot(&velocity), normal.dot(&velocity));
        let upwash = across + chordwise * strip.zero_lift_offset;
        let pitch_rate = span.dot(&at.spin);
        Flow {
            forward,
            span,
            normal,
            velocity,
            chordwise,
            across,
            upwash,
            gust,
            gust_gradient,
            pitch_rate,
            at,
        }
    }

    /// W̄ and W̄₁ of a strip at X with its f, body axes.
    fn gust_along_chord(
        &self,
        strip: &ReducedStrip,
        state: &[f64],
        (place, forward): (&Vector3<f64>, &Vector3<f64>),
    ) -> [Vector3<f64>; 2] {
        let Some(PlainGust { velocity, along, origin }) = self.gust else { return [Vector3::zeros(); 2] };
        let layout = self.equations.layout();
        let to_body = Attitude::from_quaternion(&state[layout.attitude()]).body_from_inertial;
        let position = Vector3::from_column_slice(&state[layout.position()]);
        let right = Vector3::z().cross(along);
        let (mut mean, mut change) = (Vector3::zeros(), Vector3::zeros());
        for xi in [0.75_f64.sqrt(), 0.0, -(0.75_f64.sqrt())] {
            let on_chord = place + forward * (strip.elastic_axis_aft_of_midchord - strip.semichord * xi);
            let point = position + to_body.transpose() * on_chord;
            let [ahead, aside, down] = velocity(along.dot(&(point - origin)));
            let gust = to_body * (along * ahead + right * aside + Vector3::z() * down);
            mean += gust / 3.0;
            change += gust * (2.0 / 3.0 * xi);
        }
        [mean, change]
    }

    /// The flow at a strip some time later, on the tangent to the motion.
    pub fn flow_after(&self, strip: &ReducedStrip, time: f64) -> Flow {
        let state: Vec<f64> =
            self.state.iter().zip(self.rates).map(|(state, rate)| state + time * rate).collect();
        self.flow_in(strip, &state, &(self.controls.wind + self.controls.wind_rate * time))
    }

    /// ẇ and Ω̇ as the theory writes them [theory: air-loads.rates].
    pub fn flow_rates(&self, strip: &ReducedStrip, flow: &Flow) -> [f64; 2] {
        let Flow { forward, span, normal, velocity, gust, at, .. } = flow;
        let layout = self.equations.layout();
        let part =
            |numbers: &[f64], range: std::ops::Range<usize>| Vector3::from_column_slice(&numbers[range]);
        let (omega, omega_dot) = (part(self.state, layout.rate()), part(self.rates, layout.rate()));
        let [q, q_ddot] = [&self.state[layout.coordinates()], &self.rates[layout.coordinate_rates()]];
        let [accelerating, spinning_up] = Fixed::from(strip).rows_times(self.moving, q, q_ddot);
        let [bias, spin_bias] = at.biases;
        let sigma = at.true_spin;

        let attitude = Attitude::from_quaternion(&self.state[layout.attitude()]).body_from_inertial;
        let (wind, wind_rate) = (attitude * self.controls.wind, attitude * self.controls.wind_rate);
        let velocity_change = part(self.rates, layout.velocity())
            + omega_dot.cross(&at.place)
            + accelerating
            + bias
            + omega.cross(&at.relative_velocity)
            + omega.cross(&(wind + gust))
            - wind_rate;
        let m = normal + forward * strip.zero_lift_offset;
        [
            m.dot(&velocity_change) + sigma.cross(&m).dot(velocity),
            span.dot(&(omega_dot + spinning_up + spin_bias)) + sigma.cross(span).dot(&at.spin),
        ]
    }

    /// What acts on a strip, with the apparent mass of the accelerations among the rates.
    pub fn load(&self, strip: &ReducedStrip) -> StripLoad {
        let flow = self.flow_in(strip, self.state, &self.controls.wind);
        let [w_dot, omega_dot] = self.flow_rates(strip, &flow);
        let Flow {
            forward,
            span,
            normal,
            velocity,
            chordwise: u,
            across,
            upwash: w,
            gust_gradient: g1,
            pitch_rate: omega,
            ..
        } = flow;
        let (b, d) = (strip.semichord, strip.elastic_axis_aft_of_midchord);
        let rho = self.equations.air(self.state).density;
        let FlapLift { lift: c1_delta, moment: c4_delta, drag: flap_drag } = self.flap_lift(strip);

        let circulatory =
            strip.lift_slope * rho * u * b * (w + (0.5 * b - d) * omega + 0.5 * g1) - PI * rho * b * u * g1;
        let flap_lift = rho * b * u * u * c1_delta;
        let lift = PI * rho * b * b * (w_dot - d * omega_dot) + circulatory + flap_lift;
        let moment = (0.5 * b + d) * (circulatory + flap_lift)
            + PI * rho * b * b * (d * w_dot - 0.5 * b * u * omega - (d * d + b * b / 8.0) * omega_dot)
            + rho * b * b * u * u * (c4_delta + 2.0 * strip.zero_lift_moment)
            + 2.0 * strip.moment_slope * rho * b * b * u * (w + (0.5 * b - d) * omega + 0.5 * g1);
        let w_s = across - d * omega;
        let n1 = strip.lift_slope * (w_s + u * strip.zero_lift_offset) + c1_delta * u;
        let lost = if strip.lift_slope == 0.0 {
            0.0
        } else {
            (1.0 - strip.leading_edge_suction) * n1 * n1 / strip.lift_slope
        };
        let suction = rho * b * (w_s * n1 - lost);
        let section_velocity = forward * forward.dot(&velocity) + normal * normal.dot(&velocity);
        let drag = section_velocity * ((strip.profile_drag + flap_drag) * rho * b * section_velocity.norm());
        StripLoad {
            force: (forward * suction - normal * lift - drag) * strip.width,
            moment: moment * strip.width,
            span,
        }
    }

    /// CLδ c1 δ, CLδ c4 δ or 2 c_mδ δ, and k δ² of a strip.
    fn flap_lift(&self, strip: &ReducedStrip) -> FlapLift {
        let Some(flap) = &strip.flap else { return FlapLift { lift: 0.0, moment: 0.0, drag: 0.0 } };
        let angle: f64 = flap.gains.iter().zip(&self.controls.angles).map(|(gain, angle)| gain * angle).sum();
        let hinge = libm::acos(2.0 * flap.hinge - 1.0);
        let (sin, cos) = libm::sincos(hinge);
        FlapLift {
            lift: flap.lift_slope * angle * (hinge + sin) / PI,
            moment: match flap.moment_slope {
                Some(slope) => 2.0 * slope * angle,
                None => -flap.lift_slope * angle * sin * (1.0 + cos) / (2.0 * PI),
            },
            drag: flap.drag * angle * angle,
        }
    }
}

/// CLδ c1 δ, CLδ c4 δ or 2 c_mδ δ, k δ².
struct FlapLift {
    lift: f64,
    moment: f64,
    drag: f64,
}

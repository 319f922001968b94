//! The single gust into which an aircraft flies, as a field that the page draws [theory: gusts.field, gusts.one-minus-cosine].

use std::f64::consts::PI;

use flexible_aircraft::air::{GustSettings, GustShape};
use flexible_aircraft::aircraft::{Strip, Support};
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::Outputs;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde_json::{Value, json};

use crate::numbers::short as rounded;

use super::airframe::Airframe;
use super::outline;
use super::scene::{short, vector};

/// Points of a profile.
const POINTS: usize = 33;

/// A gust along the track.
#[derive(Clone, Debug, PartialEq)]
pub struct Gust {
    /// Earth axes.
    along: Vector3<f64>,
    /// From where O begins, m.
    start: f64,
    end: f64,
    /// Earth axes.
    direction: Vector3<f64>,
    /// m/s.
    profile: Vec<f64>,
    text: String,
    /// With which the air carries it over the earth, m/s; none where that rests.
    drift: Option<Vector3<f64>>,
}

impl Gust {
    /// That of some settings, before an aircraft whose flight begins with these outputs; none where there is none.
    pub fn of(airframe: &Airframe, settings: &Settings, begin: &Outputs) -> Option<Self> {
        let GustSettings { shape, gradient, direction, inclination, start, .. } = settings.gust;
        if shape == GustShape::None {
            return None;
        }
        let (velocity, drift) = match airframe.aircraft.support {
            Support::Free => {
                let [w, x, y, z] = begin.quaternion;
                let to_earth = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
                (to_earth * begin.velocity, None)
            }
            Support::Clamped => {
                let (sin, cos) = settings.plant.heading.sin_cos();
                let velocity = Vector3::new(cos, sin, 0.0) * settings.plant.airspeed;
                (velocity, Some(-velocity))
            }
        };
        let speed = velocity.xy().norm();
        let along = Vector3::new(velocity.x, velocity.y, 0.0).try_normalize(0.0).unwrap_or_else(Vector3::x);
        let right = Vector3::new(-along.y, along.x, 0.0);
        let across = right * direction.sin() - Vector3::z() * direction.cos();
        let nose = airframe.aircraft.strips.iter().map(|strip| leading_edge(airframe, strip));
        let begins = speed * start + nose.fold(f64::NEG_INFINITY, f64::max).max(0.0);
        let peak = begin.gust_peak_velocity;
        let share = |point: usize| point as f64 / (POINTS - 1) as f64;
        let profile = (0..POINTS).map(|point| 0.5 * peak * (1.0 - (2.0 * PI * share(point)).cos()));
        Some(Gust {
            along,
            start: begins,
            end: begins + 2.0 * gradient,
            direction: across * inclination.cos() + along * inclination.sin(),
            profile: profile.collect(),
            text: format!("1 − cos gust, H = {} m, {} m/s", rounded(gradient), rounded(peak)),
            drift,
        })
    }

    pub fn json(&self) -> Value {
        let mut value = json!({
            "along": vector(&self.along),
            "start": short(self.start),
            "end": short(self.end),
            "direction": vector(&self.direction),
            "profile": self.profile.iter().copied().map(short).collect::<Vec<_>>(),
            "text": self.text,
        });
        if let Some(drift) = &self.drift {
            value["drift"] = json!(vector(drift));
        }
        value
    }
}

/// How far ahead of O a leading edge is, m.
fn leading_edge(airframe: &Airframe, strip: &Strip) -> f64 {
    let chordwise = strip.forward * (strip.elastic_axis_aft_of_midchord + strip.semichord);
    (outline::place(&airframe.aircraft, strip) + chordwise).x
}

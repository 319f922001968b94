//! Why there is no trim, for people.

use std::fmt;

use crate::aircraft::{Control, Support, TrimRole};
use crate::kinematics::GeneralisedVector;

use super::manoeuvre::Manoeuvre;
use super::trim::TrimPoint;

/// Why there is no trim.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TrimFailure {
    /// Newton's method ended elsewhere.
    NotFound,
    /// The wings do not carry the weight.
    TooSlow {
        /// Of the weight, at 15° of incidence.
        share: f64,
    },
    /// The unknowns do not move the forces independently.
    NoAuthority,
    /// Nothing is to hold pitch: no control has the role, or the one that has it moves nothing.
    NoPitchControl,
    /// The plane of symmetry is in balance, the rest is not, and nothing steers it.
    NoLateralControl {
        /// To the right, N.
        side_force: f64,
        /// About O, right wing down, N m.
        rolling: f64,
        /// About O, nose right, N m.
        yawing: f64,
    },
    /// The flight leaves the plane of symmetry, and there are not enough controls for roll and yaw to hold it.
    NoControlAside,
    /// A clamped aircraft finds no shape at rest.
    NoRest,
    /// A clamped aircraft under point loads finds no shape at rest to which more of its load leads.
    NoRestUnderLoad {
        /// Of all loads, at which it still rests.
        share: f64,
    },
}

/// Accelerations below this, m/s² and rad/s², are not worth a word.
const NEGLIGIBLE: f64 = 1e-7;

/// A trim that was not found, and where the search ended.
#[derive(Clone, Debug, PartialEq)]
pub struct TrimError {
    /// Why.
    pub failure: TrimFailure,
    /// m/s.
    pub airspeed: f64,
    /// m.
    pub altitude: f64,
    /// Of the air there, kg/m³.
    pub density: f64,
    /// Newton steps taken.
    pub steps: usize,
    /// Where they ended.
    pub point: TrimPoint,
    /// Which flight it was to be.
    pub manoeuvre: Manoeuvre,
    /// Those of the aircraft.
    pub controls: Vec<Control>,
    /// Whether it flies.
    pub support: Support,
    /// Whether anything drives the aircraft.
    pub has_engines: bool,
    /// v̇ and ω̇ that remained, m/s² and rad/s².
    pub rigid: [f64; 6],
    /// Largest |q̈| that remained.
    pub modal: f64,
}

impl std::error::Error for TrimError {}

impl fmt::Display for TrimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let TrimError { airspeed, altitude, density, steps, modal, .. } = self;
        let failure = self.failure_text();
        if matches!(self.failure, TrimFailure::NoPitchControl | TrimFailure::NoControlAside) {
            return write!(f, "{failure}");
        }
        if self.support == Support::Clamped {
            return write!(
                f,
                "{failure} at {airspeed} m/s in air of {density:.4} kg/m³: {steps} Newton steps ended with the largest modal \
                 acceleration {modal:.2e}"
            );
        }
        write!(f, "{failure} at {airspeed} m/s and {altitude} m: ")?;
        if let TrimFailure::TooSlow { share } = self.failure {
            let enough = airspeed / libm::sqrt(share);
            write!(
                f,
                "too slow: at 15° of incidence the wings carry {:.1} % of the weight, at {enough:.0} m/s all of it; ",
                100.0 * share
            )?;
        }
        write!(f, "{steps} Newton steps ended at {}", self.point.describe(&self.controls, self.has_engines))?;
        let GeneralisedVector { translation: v, rotation: w, .. } = GeneralisedVector::of(&self.rigid);
        write!(
            f,
            " with the imbalance v̇ = ({:.2e}, {:.2e}, {:.2e}) m/s², ω̇ = ({:.2e}, {:.2e}, {:.2e}) rad/s², \
             largest modal acceleration {modal:.2e}",
            v.x, v.y, v.z, w.x, w.y, w.z
        )?;
        if let Some((name, what)) = self.most_unbalanced() {
            write!(f, "; most of all {name} ({what}) stays unbalanced")?;
        }
        Ok(())
    }
}

impl TrimError {
    /// Why, without where.
    fn failure_text(&self) -> String {
        let flight = self.manoeuvre.name(self.has_engines);
        let engine = if self.has_engines { ", an engine" } else { "" };
        match self.failure {
            TrimFailure::NotFound | TrimFailure::TooSlow { .. } => format!("no steady {flight} found"),
            TrimFailure::NoAuthority => format!(
                "no steady {flight}: what should balance the aircraft does not act independently (is there a wing{engine}, does \
                 {} pitch the aircraft, for one that is not symmetric is there a fin or a control with trim = \"yaw\"?)",
                self.pitch_control().map_or("a control", |control| control.name.as_str())
            ),
            TrimFailure::NoPitchControl => format!("no steady {flight}: {}", self.what_lacks_for_pitch()),
            TrimFailure::NoLateralControl { side_force, rolling, yawing } => format!(
                "no steady {flight}: the aircraft is not symmetric, and no control with trim = \"roll\" or \"yaw\" moves anything; a side force of \
                 {side_force:.1} N, a rolling moment of {rolling:.1} N m and a yawing moment of {yawing:.1} N m about O \
                 stay unbalanced"
            ),
            TrimFailure::NoControlAside => {
                let needed = if self.manoeuvre.is_held_by_one_control() {
                    "a control with trim = \"roll\" or trim = \"yaw\" that moves"
                } else {
                    "controls with trim = \"roll\" and trim = \"yaw\" that move"
                };
                format!("no steady {flight}: it needs {needed} something")
            }
            TrimFailure::NoRest => "no deformation at rest found in the wind tunnel".to_owned(),
            TrimFailure::NoRestUnderLoad { share } => format!(
                "no deformation at rest found in the wind tunnel to which more than {:.1} % of the load leads",
                100.0 * share
            ),
        }
    }

    fn pitch_control(&self) -> Option<&Control> {
        self.controls.iter().find(|control| control.role == Some(TrimRole::Pitch))
    }

    /// What to do where nothing holds pitch.
    fn what_lacks_for_pitch(&self) -> String {
        if let Some(control) = self.pitch_control() {
            return format!("{} has trim = \"pitch\" and moves no flap", control.name);
        }
        let free = self.controls.iter().filter(|control| control.role.is_none());
        let free: Vec<&str> = free.map(|control| control.name.as_str()).collect();
        let remedy = match (free.as_slice(), self.controls.as_slice()) {
            ([], []) => "there are no controls: add a [[control]] for it".to_owned(),
            ([], _) => "all controls have other roles: add a [[control]] for it".to_owned(),
            (free, _) => format!("give it to one of: {}", free.join(", ")),
        };
        format!("no control has trim = \"pitch\"; {remedy}")
    }

    /// The component of the rigid motion with the largest acceleration, rotations by those of a point at 1 m.
    fn most_unbalanced(&self) -> Option<(&'static str, &'static str)> {
        let components = self.rigid.into_iter().zip(GeneralisedVector::RIGID_COMPONENTS);
        let (left, component) = components.max_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs()))?;
        (left.abs() > NEGLIGIBLE).then_some(component)
    }
}

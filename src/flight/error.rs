//! Why a flight cannot start or go on.

use crate::plant::{SettingError, TrimError};

/// Why a flight cannot start or go on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SimulationError {
    /// A setting is outside its range.
    #[error(transparent)]
    Setting(#[from] SettingError),
    /// A time is not finite or beyond the time grid.
    #[error("time: found {found:e} s, allowed is -{most:e} to {most:e} s", most = super::LATEST)]
    Time {
        /// s.
        found: f64,
    },
    /// A step is so long that nobody would wait for it.
    #[error("step: found {found} s, allowed is up to {most} s, a day, at once", most = super::LONGEST_STEP)]
    Step {
        /// s.
        found: f64,
    },
    /// The aircraft cannot be trimmed.
    #[error(transparent)]
    Trim(#[from] Box<TrimError>),
    /// The trim needs what an actuator or an engine cannot give.
    #[error(
        "the trim needs {part} at {needed} {unit}, and `{limit}` is {found} {unit}: no steady flight can be held within it"
    )]
    BeyondLimit {
        /// The control or the engine.
        part: String,
        /// rad or N.
        needed: f64,
        /// Name of the parameter.
        limit: String,
        /// rad or N.
        found: f64,
        /// `rad` or `N`.
        unit: &'static str,
    },
    /// A lifting strip meets the air backwards.
    #[error(
        "at {time} s the air meets strip {strip} (on {component}) from behind: the strip theory is not valid there"
    )]
    ReverseFlow {
        /// s.
        time: f64,
        /// Index of the strip.
        strip: usize,
        /// The component it belongs to.
        component: String,
    },
    /// The state is no longer a number.
    #[error("at {time} s the state is no longer finite: the flight has left the range of the model")]
    NotFinite {
        /// s.
        time: f64,
    },
    /// The aircraft points straight up or down.
    #[error(
        "at {time} s the pitch angle is {pitch} rad: the nose points straight up or down, where roll and yaw angle are one"
    )]
    Vertical {
        /// s.
        time: f64,
        /// rad.
        pitch: f64,
    },
    /// A rate takes an input beyond all numbers.
    #[error("at {time} s an input is no longer finite: its rate has taken it beyond all numbers")]
    Inputs {
        /// s.
        time: f64,
    },
    /// The tolerance cannot be met.
    #[error("at {time} s steps of {step} s do not meet the relative tolerance {tolerance}")]
    Tolerance {
        /// s.
        time: f64,
        /// Smallest step tried, s.
        step: f64,
        /// What was asked for.
        tolerance: f64,
    },
    /// The bytes are not a snapshot of this simulation.
    #[error("not a snapshot of this flight: {0}")]
    Snapshot(&'static str),
}

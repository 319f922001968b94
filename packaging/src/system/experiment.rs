//! How long a system is run, and in which steps.

/// What a master does with the system when nobody says otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Experiment {
    /// Communication step, s, greater than zero.
    pub step: f64,
    /// End, s; the beginning is 0.
    pub stop_time: f64,
}

//! What is asked of an actuator or an engine: a quantity that is linear in time between settings.
//!
//! [theory: actuators.command]

/// From this magnitude on a limit is none, in the unit of what it limits.
pub const LIMITLESS: f64 = 1e9;

/// A quantity that is asked for, from an instant on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Command {
    /// At the instant: rad or N.
    pub value: f64,
    /// Per second.
    pub rate: f64,
}

impl Command {
    /// The value after a time, s.
    pub fn after(self, time: f64) -> f64 {
        self.value + self.rate * time
    }

    /// The command as it stands after a time, s.
    pub(super) fn from(self, time: f64) -> Command {
        Command { value: self.after(time), rate: self.rate }
    }

    /// The command as limits leave it at the instant.
    pub(super) fn clamped(self, [minimum, maximum]: [f64; 2]) -> Command {
        let held = |limit: f64| Command { value: limit, rate: 0.0 };
        if self.value > maximum || (self.value == maximum && self.rate > 0.0) {
            held(maximum)
        } else if self.value < minimum || (self.value == minimum && self.rate < 0.0) {
            held(minimum)
        } else {
            self
        }
    }
}

/// Limits as they act: none where they are beyond all that is meant.
pub(super) fn acting_limits(minimum: f64, maximum: f64) -> [f64; 2] {
    [
        if minimum <= -LIMITLESS { f64::NEG_INFINITY } else { minimum },
        if maximum >= LIMITLESS { f64::INFINITY } else { maximum },
    ]
}

//! Engines that lag: of first order behind a command within limits [theory: actuators.engines].

use super::command::{Command, LIMITLESS, acting_limits};

/// How an engine follows its command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EngineLag {
    /// τ, s; 0 where the thrust is the command.
    pub time_constant: f64,
    /// N; from −[`LIMITLESS`] down there is none.
    pub minimum: f64,
    /// N; from [`LIMITLESS`] on there is none.
    pub maximum: f64,
}

impl Default for EngineLag {
    /// None: the thrust is the command.
    fn default() -> Self {
        EngineLag { time_constant: 0.0, minimum: -LIMITLESS, maximum: LIMITLESS }
    }
}

impl EngineLag {
    /// Whether the thrust lags behind the command.
    pub fn lags(&self) -> bool {
        self.time_constant > 0.0
    }

    /// Whether the thrust is the command, whatever that is.
    pub fn is_direct(&self) -> bool {
        // As it starts: whoever moves a limit from there is asked whether it acts alike on both sides.
        !self.lags() && [self.minimum, self.maximum] == [-LIMITLESS, LIMITLESS]
    }

    /// The same with limits that no thrust at all is within.
    pub fn with_zero(self) -> Self {
        EngineLag { minimum: self.minimum.min(0.0), maximum: self.maximum.max(0.0), ..self }
    }

    /// Minimum and maximum, N, infinite where there is none.
    pub fn limits(&self) -> [f64; 2] {
        acting_limits(self.minimum, self.maximum)
    }

    /// The command within the limits, as it stands.
    pub fn at_once(&self, command: Command) -> Command {
        command.clamped(self.limits())
    }

    /// The thrust (N) a time (s) after it was so much, under a command from then on.
    pub fn after(&self, thrust: f64, command: Command, time: f64) -> f64 {
        let [minimum, maximum] = self.limits();
        let Command { value, rate } = command;
        if rate == 0.0 {
            return self.follow(thrust, self.at_once(command), time);
        }
        // The command comes from beyond the one limit, and passes the other.
        let (near, far) = if rate > 0.0 { (minimum, maximum) } else { (maximum, minimum) };
        let inside = ((near - value) / rate).max(0.0);
        let outside = ((far - value) / rate).max(inside);
        let held = |limit: f64| Command { value: limit, rate: 0.0 };
        let pieces = [(0.0, held(near)), (inside, command.from(inside)), (outside, held(far))];
        let mut thrust = thrust;
        for (piece, (begin, command)) in pieces.into_iter().enumerate() {
            let end = pieces.get(piece + 1).map_or(time, |(end, _)| end.min(time));
            if end > begin {
                thrust = self.follow(thrust, command, end - begin);
            }
        }
        thrust
    }

    /// T = u₀ + u₁(t − τ) + (T₀ − u₀ + τ u₁) e^{−t/τ}.
    fn follow(&self, thrust: f64, command: Command, time: f64) -> f64 {
        if time == 0.0 {
            return thrust;
        }
        let behind = self.time_constant * command.rate;
        let decay = libm::exp(-time / self.time_constant);
        command.after(time) - behind + (thrust - command.value + behind) * decay
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_through_both_limits_is_followed_alike_in_one_piece_and_in_many() {
        let engine = EngineLag { time_constant: 0.3, minimum: 1000.0, maximum: 5000.0 };
        for command in
            [Command { value: -3000.0, rate: 20_000.0 }, Command { value: 9000.0, rate: -20_000.0 }]
        {
            let whole = engine.after(2000.0, command, 1.0);
            let parts = (0..100).fold(2000.0, |thrust, part| {
                engine.after(thrust, command.from(0.01 * f64::from(part)), 0.01)
            });
            assert!((whole - parts).abs() < 1e-9, "{whole} {parts}");
        }
    }

    #[test]
    fn a_command_that_no_limit_meets_is_followed_with_a_constant_lag_in_the_end() {
        let engine = EngineLag { time_constant: 0.1, ..EngineLag::default() };
        let ramp = Command { value: 0.0, rate: 1000.0 };
        assert!((engine.after(0.0, ramp, 10.0) - (10_000.0 - 100.0)).abs() < 1e-9);
    }

    #[test]
    fn the_smallest_time_constant_leaves_the_command_within_the_limits() {
        let limits = EngineLag { minimum: 0.0, maximum: 5000.0, ..EngineLag::default() };
        for time_constant in [f64::MIN_POSITIVE, 1e-300, 1e-12] {
            let engine = EngineLag { time_constant, ..limits };
            for (value, rate) in [(3000.0, 0.0), (3000.0, 1e5), (-1e3, 2e5), (9000.0, 0.0)] {
                let command = Command { value, rate };
                let expected = limits.at_once(command.from(0.01)).value;
                let found = engine.after(100.0, command, 0.01);
                assert!((found - expected).abs() < 1e-6, "{time_constant:e} {command:?}: {found} {expected}");
            }
        }
    }
}

//! Inputs that excite an aircraft: the elevator 2-3-1-1 and the rudder doublet of, as they come out
//! of the actuator, a first-order lag [theory: thesis-runs.inputs; thesis §5.2, §5.4].
//!
//! A manoeuvre is a step function, so the lag's answer is a sum of exponentials and needs no integration:
//! 1/(τs + 1) turns a jump Δ at t_j into Δ (1 − exp(−(t − t_j)/τ)).

/// A piecewise constant command that begins and ends at zero, seen through a first-order lag.
#[derive(Clone, Debug, PartialEq)]
pub struct Manoeuvre {
    jumps: Vec<Jump>,
    time_constant: f64,
}

/// A sudden change of the command.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Jump {
    /// s.
    time: f64,
    /// In the unit of the command.
    change: f64,
}

impl Manoeuvre {
    /// Four pulses of alternating sign that last 2, 3, 1 and 1 `unit` times, s, from `start`, s.
    ///
    /// The first one has the value `amplitude`; `time_constant` is that of the lag, s, greater than zero.
    pub fn two_three_one_one(amplitude: f64, unit: f64, start: f64, time_constant: f64) -> Self {
        Self::alternating(amplitude, &[2.0 * unit, 3.0 * unit, unit, unit], start, time_constant)
    }

    /// Two pulses of opposite sign that last `duration` each, s, from `start`, s.
    ///
    /// The first one has the value `amplitude`; `time_constant` is that of the lag, s, greater than zero.
    pub fn doublet(amplitude: f64, duration: f64, start: f64, time_constant: f64) -> Self {
        Self::alternating(amplitude, &[duration, duration], start, time_constant)
    }

    fn alternating(amplitude: f64, durations: &[f64], start: f64, time_constant: f64) -> Self {
        let mut jumps = Vec::with_capacity(durations.len() + 1);
        let (mut time, mut command, mut pulse) = (start, 0.0, amplitude);
        for duration in durations {
            jumps.push(Jump { time, change: pulse - command });
            (time, command, pulse) = (time + duration, pulse, -pulse);
        }
        jumps.push(Jump { time, change: -command });
        Manoeuvre { jumps, time_constant }
    }

    /// What comes out of the lag at `time`, s.
    pub fn value(&self, time: f64) -> f64 {
        let past = self.jumps.iter().filter(|jump| jump.time <= time);
        past.map(|jump| -jump.change * ((jump.time - time) / self.time_constant).exp_m1()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AMPLITUDE: f64 = -0.05;
    const LAG: f64 = 0.05;

    /// The lag has settled to 1e-6 of a jump after 14 time constants, the length of the shortest pulse.
    fn assert_settled(manoeuvre: &Manoeuvre, time: f64, value: f64) {
        let found = manoeuvre.value(time);
        assert!((found - value).abs() < 2e-6 * AMPLITUDE.abs(), "at {time} s: {found} instead of {value}");
    }

    #[test]
    fn the_2_3_1_1_holds_its_pulses_for_two_three_one_and_one_unit_times() {
        let manoeuvre = Manoeuvre::two_three_one_one(AMPLITUDE, 0.7, 1.0, LAG);
        let ends = [(2.4, AMPLITUDE), (4.5, -AMPLITUDE), (5.2, AMPLITUDE), (5.9, -AMPLITUDE), (7.0, 0.0)];
        for (end, value) in ends {
            assert_settled(&manoeuvre, end, value);
        }
    }

    #[test]
    fn the_doublet_goes_equally_long_each_way() {
        let manoeuvre = Manoeuvre::doublet(AMPLITUDE, 2.0, 1.0, LAG);
        for (end, value) in [(3.0, AMPLITUDE), (5.0, -AMPLITUDE), (6.0, 0.0)] {
            assert_settled(&manoeuvre, end, value);
        }
    }

    #[test]
    fn nothing_happens_before_the_start() {
        assert_eq!(Manoeuvre::two_three_one_one(AMPLITUDE, 0.7, 1.0, LAG).value(1.0), 0.0);
    }

    /// Against the differential equation τẏ + y = u, by its central difference within the second pulse.
    #[test]
    fn the_value_obeys_the_equation_of_the_lag() {
        let manoeuvre = Manoeuvre::two_three_one_one(AMPLITUDE, 0.7, 1.0, LAG);
        for time in [2.41, 2.45, 2.6] {
            let step = 1e-6;
            let rate = (manoeuvre.value(time + step) - manoeuvre.value(time - step)) / (2.0 * step);
            assert!((LAG * rate + manoeuvre.value(time) + AMPLITUDE).abs() < 1e-9);
        }
    }
}

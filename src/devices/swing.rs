//! The free motion of z̈ + 2ζω ż + ω² z = 0, whatever the damping [theory: actuators.motion].

/// A damped oscillator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swing {
    /// ω, rad/s, > 0.
    pub frequency: f64,
    /// ζ, ≥ 0.
    pub damping: f64,
}

impl Swing {
    /// z and ż after a time (s) from z and ż at its beginning.
    pub fn after(self, time: f64, [z, speed]: [f64; 2]) -> [f64; 2] {
        let Swing { frequency, damping } = self;
        let [even, odd] = self.shapes(time);
        let drag = damping * frequency;
        [z * even + (speed + drag * z) * odd, speed * even - (frequency * frequency * z + drag * speed) * odd]
    }

    /// e^{−ζωt} cos ω_d t and e^{−ζωt} sin(ω_d t)/ω_d, s, and what becomes of them where nothing swings.
    fn shapes(self, time: f64) -> [f64; 2] {
        let Swing { frequency, damping } = self;
        // Exact where ζ is nearly 1.
        let root = libm::sqrt(((1.0 - damping) * (1.0 + damping)).abs());
        let apart = frequency * root;
        if apart == 0.0 {
            let decay = libm::exp(-frequency * time);
            [decay, decay * time]
        } else if damping < 1.0 {
            let decay = libm::exp(-damping * frequency * time);
            let (sin, cos) = libm::sincos(apart * time);
            [decay * cos, decay * (sin / apart)]
        } else {
            // By the slower of the two decays: neither differences of large numbers nor of alike ones.
            let slow = libm::exp(-frequency / (damping + root) * time);
            let lost = libm::expm1(-2.0 * apart * time);
            [slow * (1.0 + 0.5 * lost), slow * (-0.5 * lost / apart)]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the series of the matrix exponential, step by step.
    fn by_series(Swing { frequency, damping }: Swing, time: f64, start: [f64; 2]) -> [f64; 2] {
        let parts = 4096;
        let step = time / f64::from(parts);
        let slope =
            |[z, speed]: [f64; 2]| [speed, -frequency * frequency * z - 2.0 * damping * frequency * speed];
        (0..parts).fold(start, |state, _| {
            let (mut sum, mut term) = (state, state);
            for order in 1..12 {
                term = slope(term).map(|part| part * step / f64::from(order));
                sum = [sum[0] + term[0], sum[1] + term[1]];
            }
            sum
        })
    }

    #[test]
    fn the_motion_is_that_of_its_equation_below_at_and_above_critical_damping() {
        for damping in [0.0, 0.2, 0.7, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.3, 8.0] {
            let swing = Swing { frequency: 40.0, damping };
            for time in [1e-3, 0.02, 0.3] {
                let (found, expected) = (swing.after(time, [0.3, -2.0]), by_series(swing, time, [0.3, -2.0]));
                for (found, expected) in found.iter().zip(expected) {
                    assert!((found - expected).abs() < 3e-10, "{damping} {time}: {found} {expected}");
                }
            }
        }
    }

    #[test]
    fn what_is_much_damped_creeps_back_without_losing_digits() {
        let swing = Swing { frequency: 2.0, damping: 1e3 };
        // 1/(2ζω) is the fast time; the slow one is 2ζ/ω, to 1/(4ζ²).
        let [z, _] = swing.after(1e3, [1.0, 0.0]);
        assert!((z - libm::exp(-1.0)).abs() < 1e-6, "{z}");
    }
}

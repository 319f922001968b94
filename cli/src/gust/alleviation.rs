//! The flight profile alleviation factor of CS 25.341(a)(6) at sea level, from an aircraft's weights.

use std::f64::consts::FRAC_PI_4;

/// At which 1 − Z_mo/… is 0, m: 250 000 ft.
const CEILING: f64 = 76_200.0;

/// Maximum take-off, landing and zero-fuel weight, of any unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    take_off: f64,
    landing: f64,
    zero_fuel: f64,
}

impl Weights {
    /// F_g = ½ (F_gz + F_gm), F_gz = 1 − Z_mo/76 200 m, F_gm = √(R2 tan(πR1/4)), R1 = MLW/MTOW, R2 = MZFW/MTOW, of the
    /// maximum operating altitude, m.
    pub fn alleviation_at_sea_level(self, altitude: f64) -> f64 {
        let [r1, r2] = [self.landing, self.zero_fuel].map(|weight| weight / self.take_off);
        let by_altitude = 1.0 - altitude / CEILING;
        let by_weights = (r2 * (FRAC_PI_4 * r1).tan()).sqrt();
        (0.5 * (by_altitude + by_weights)).clamp(0.0, 1.0)
    }
}

/// Weights as they are written on the command line.
pub fn weights(text: &str) -> Result<Weights, String> {
    let parse = || {
        let mut parts = text.split(',').map(|part| part.parse::<f64>().ok());
        let weights =
            Weights { take_off: parts.next()??, landing: parts.next()??, zero_fuel: parts.next()?? };
        let Weights { take_off, landing, zero_fuel } = weights;
        let are_weights =
            0.0 < zero_fuel && zero_fuel <= landing && landing <= take_off && take_off.is_finite();
        (parts.next().is_none() && are_weights).then_some(weights)
    };
    parse().ok_or_else(|| "allowed is MTOW,MLW,MZFW with MTOW ≥ MLW ≥ MZFW > 0".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_that_are_alike_leave_what_the_altitude_takes() {
        // R1 = R2 = 1: F_gm = √tan(π/4) = 1.
        let of = |altitude| weights("10,10,10").unwrap().alleviation_at_sea_level(altitude);
        assert!((of(0.0) - 1.0).abs() < 1e-15 && (of(7620.0) - 0.95).abs() < 1e-15);
        // R1 = 2/3: tan(π/6) = 1/√3; R2 = ½.
        let half = weights("9,6,4.5").unwrap().alleviation_at_sea_level(0.0);
        assert!((half - 0.5 * (1.0 + (0.5 / 3.0_f64.sqrt()).sqrt())).abs() < 1e-15);
    }

    /// Of the DC-3, MTOW 11 883.98, MLW 11 793.40, MZFW 10 594.47 kg, Z_mo 8046.72 m: DLR-AE/LoadsKernel,
    /// doc/tutorials/DC3_model/JCLs/jcl_dc3_gust.py.
    #[test]
    fn the_dc_3_of_loads_kernel_has_its_alleviation() {
        let alleviation = weights("11883.98,11793.40,10594.47").unwrap().alleviation_at_sea_level(8046.72);
        assert!((alleviation - 0.91648).abs() < 5e-6, "{alleviation}");
    }

    #[test]
    fn weights_that_contradict_each_other_are_refused() {
        for wrong in ["5,6,4", "6,5,5.5", "6,5,0", "inf,1,1", "NaN,NaN,NaN", "6,5", "6,5,4,3", "a,b,c", ""] {
            assert!(weights(wrong).unwrap_err().contains("MTOW ≥ MLW ≥ MZFW > 0"), "{wrong}");
        }
    }
}

//! A gust of the shape 1 − cos, by its peak or by the criterion of CS-25 [theory: gusts.one-minus-cosine].

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use crate::math::ROUNDING;

use super::atmosphere::SEA_LEVEL_DENSITY;
use super::out_of_range::OutOfRange;

/// The shape of a single gust.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GustShape {
    /// There is none.
    None,
    /// ½ U (1 − cos(πs/H)).
    OneMinusCosine,
}

/// What the peak of a gust follows from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GustCriterion {
    /// The setting `peak`.
    Peak,
    /// CS 25.341(a) at the design cruising speed VC.
    Cs25Vc,
    /// CS 25.341(a) at the design dive speed VD: half of it.
    Cs25Vd,
}

/// A single gust that the aircraft flies into.
///
/// ```
/// use flexible_aircraft::air::{GustCriterion, GustSettings, GustShape};
///
/// let gust = GustSettings { shape: GustShape::OneMinusCosine, criterion: GustCriterion::Cs25Vc, ..Default::default() };
/// // At 7620 m, where the air has 0.5489 kg/m³: m/s of true airspeed.
/// assert!((gust.peak_velocity(7620.0, 0.54895) - 14.32).abs() < 0.01);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GustSettings {
    /// Its shape.
    pub shape: GustShape,
    /// H: from where it begins to where it peaks, m.
    pub gradient: f64,
    /// U, m/s of true airspeed; of account with [`GustCriterion::Peak`] alone.
    pub peak: f64,
    /// δ: 0 upwards, positive to the right, rad.
    pub direction: f64,
    /// ι: from across the track to along it, rad.
    pub inclination: f64,
    /// When the foremost strip meets it, s after the flight begins, ≥ 0.
    pub start: f64,
    /// What its peak follows from.
    pub criterion: GustCriterion,
    /// F_g at sea level, 0 … 1.
    pub alleviation: f64,
    /// Z_mo, at which F_g is 1, m.
    pub maximum_operating_altitude: f64,
}

/// Gradients that a gust may have, m.
pub const GUST_GRADIENTS: RangeInclusive<f64> = 0.01..=1e6;

/// When a gust or turbulence may begin, s after the flight does.
pub const GUST_STARTS: RangeInclusive<f64> = 0.0..=1e6;

/// Altitudes at which F_g may be 1, m.
pub const MAXIMUM_OPERATING_ALTITUDES: RangeInclusive<f64> = 1.0..=1e5;

/// Gradients that CS 25.341(a) speaks of, m.
pub const CS25_GRADIENTS: RangeInclusive<f64> = 9.144..=106.68;

/// Reference gust velocities of CS 25.341(a)(5)(i) over altitude: m, and m/s of equivalent airspeed.
const REFERENCE: [(f64, f64); 3] = [(0.0, 17.07), (4572.0, 13.41), (18_288.0, 6.36)];

/// Reference gust velocities of CS 25.341(b)(3) over altitude: m, and m/s of true airspeed.
const TURBULENCE_REFERENCE: [(f64, f64); 2] = [(0.0, 27.43), (7315.0, 24.08)];

impl Default for GustSettings {
    /// None; one that is switched on has H = 30 m, a peak of 10 m/s, and begins upwards a second after the flight.
    fn default() -> Self {
        GustSettings {
            shape: GustShape::None,
            gradient: 30.0,
            peak: 10.0,
            direction: 0.0,
            inclination: 0.0,
            start: 1.0,
            criterion: GustCriterion::Peak,
            alleviation: 1.0,
            maximum_operating_altitude: 12_500.0,
        }
    }
}

impl GustSettings {
    /// U, m/s of true airspeed, at an altitude (m) where the air has some density (kg/m³).
    pub fn peak_velocity(&self, altitude: f64, density: f64) -> f64 {
        let share = match (self.shape, self.criterion) {
            (GustShape::None, _) => return 0.0,
            (GustShape::OneMinusCosine, GustCriterion::Peak) => return self.peak,
            (GustShape::OneMinusCosine, GustCriterion::Cs25Vc) => 1.0,
            (GustShape::OneMinusCosine, GustCriterion::Cs25Vd) => 0.5,
        };
        let by_gradient = libm::pow(self.gradient / CS25_GRADIENTS.end(), 1.0 / 6.0);
        let design = share * reference_velocity(altitude) * self.alleviation_at(altitude) * by_gradient;
        design * libm::sqrt(SEA_LEVEL_DENSITY / density)
    }

    /// U_σ of CS 25.341(b) at an altitude, m, m/s of true airspeed: by which loads in continuous turbulence are multiplied that are
    /// those of 1 m/s; 0 without a criterion.
    pub fn turbulence_velocity(&self, altitude: f64) -> f64 {
        let share = match self.criterion {
            GustCriterion::Peak => 0.0,
            GustCriterion::Cs25Vc => 1.0,
            GustCriterion::Cs25Vd => 0.5,
        };
        share * between(TURBULENCE_REFERENCE, altitude) * self.alleviation_at(altitude)
    }

    /// F_g at an altitude, m.
    pub fn alleviation_at(&self, altitude: f64) -> f64 {
        let share = (altitude / self.maximum_operating_altitude).clamp(0.0, 1.0);
        self.alleviation + (1.0 - self.alleviation) * share
    }

    /// Checks every setting against its range.
    ///
    /// # Errors
    /// Names the first that is outside.
    pub fn check(&self) -> Result<(), OutOfRange> {
        let GustSettings { gradient, peak, direction, inclination, start, criterion, .. } = *self;
        OutOfRange::unless("gust.gradient", gradient, GUST_GRADIENTS.contains(&gradient), "0.01 to 1e6 (m)")?;
        OutOfRange::unless("gust.peak", peak, true, "a finite number (m/s)")?;
        OutOfRange::unless("gust.direction", direction, true, "a finite number (rad)")?;
        OutOfRange::unless("gust.inclination", inclination, true, "a finite number (rad)")?;
        OutOfRange::unless("gust.start", start, GUST_STARTS.contains(&start), "0 to 1e6 (s)")?;
        let (alleviation, altitude) = (self.alleviation, self.maximum_operating_altitude);
        OutOfRange::unless("gust.alleviation", alleviation, (0.0..=1.0).contains(&alleviation), "0 to 1")?;
        let setting = "gust.maximum_operating_altitude";
        let inside = MAXIMUM_OPERATING_ALTITUDES.contains(&altitude);
        OutOfRange::unless(setting, altitude, inside, "1 to 1e5 (m)")?;
        let is_of_cs25 = criterion != GustCriterion::Peak && self.shape != GustShape::None;
        let allowed = "9.144 to 106.68 (m) with a criterion of CS-25";
        OutOfRange::unless(
            "gust.gradient",
            gradient,
            !is_of_cs25 || CS25_GRADIENTS.contains(&gradient),
            allowed,
        )
    }
}

/// U_ref, m/s of equivalent airspeed, at an altitude, m.
fn reference_velocity(altitude: f64) -> f64 {
    let [bottom, middle, top] = REFERENCE;
    between(if altitude < middle.0 { [bottom, middle] } else { [middle, top] }, altitude)
}

/// Linear between two altitudes, and constant beyond them.
fn between([(low, below), (high, above)]: [(f64, f64); 2], altitude: f64) -> f64 {
    let share = ((altitude - low) / (high - low)).clamp(0.0, 1.0);
    below + (above - below) * share
}

/// The gust over the distance s from where it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneMinusCosine {
    /// H, m.
    gradient: f64,
    /// U times its direction: along the track, to the right, down, m/s.
    peak: [f64; 3],
}

impl OneMinusCosine {
    /// Of settings at an altitude (m) where the air has some density (kg/m³); `None` where there is none.
    pub fn new(settings: &GustSettings, altitude: f64, density: f64) -> Option<Self> {
        if settings.shape == GustShape::None {
            return None;
        }
        let (sin, cos) = libm::sincos(settings.direction);
        // Half a turn is down: of its sine nothing is left but rounding.
        let right = if sin.abs() <= ROUNDING { 0.0 } else { sin };
        let (along, across) = libm::sincos(settings.inclination);
        let peak = settings.peak_velocity(altitude, density);
        Some(OneMinusCosine {
            gradient: settings.gradient,
            peak: [peak * along, peak * across * right, -(peak * across * cos)],
        })
    }

    /// 2H, m.
    pub fn length(&self) -> f64 {
        2.0 * self.gradient
    }

    /// Along the track, to the right, down, m/s.
    pub fn velocity(&self, s: f64) -> [f64; 3] {
        if s > 0.0 && s < 2.0 * self.gradient {
            let share = 0.5 * (1.0 - libm::cos(PI * s / self.gradient));
            self.peak.map(|peak| peak * share)
        } else {
            [0.0; 3]
        }
    }

    /// Whether it blows in the plane of the track and the vertical.
    pub fn is_in_plane(&self) -> bool {
        self.peak[1] == 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::air::Air;

    fn cs25() -> GustSettings {
        GustSettings {
            shape: GustShape::OneMinusCosine,
            criterion: GustCriterion::Cs25Vc,
            ..GustSettings::default()
        }
    }

    #[test]
    fn the_criterion_gives_the_velocities_of_its_text() {
        // CS 25.341(a)(5)(i) at its corners, H = 350 ft: no share of the gradient, F_g = 1.
        let longest = GustSettings { gradient: 106.68, ..cs25() };
        for (altitude, velocity) in REFERENCE {
            assert!((longest.peak_velocity(altitude, 1.225) - velocity).abs() < 1e-12);
        }
        // An independent computation at 7620 m, H = 30 m: m/s of equivalent, then of true airspeed; F_g of 0.8 at sea level.
        let density = Air::at(7620.0).density;
        let true_airspeed = cs25().peak_velocity(7620.0, density);
        assert!((true_airspeed * libm::sqrt(density / 1.225) - 9.58621).abs() < 5e-6);
        assert!((true_airspeed - 14.3202).abs() < 5e-5, "{true_airspeed}");
        let alleviated = GustSettings { alleviation: 0.8, ..cs25() };
        assert!((alleviated.alleviation_at(7620.0) - 0.92192).abs() < 5e-6);
        assert!((alleviated.peak_velocity(7620.0, density) - 13.2021).abs() < 5e-5);
        let dive = GustSettings { criterion: GustCriterion::Cs25Vd, ..cs25() };
        assert!((dive.peak_velocity(7620.0, density) * 2.0 - true_airspeed).abs() < 1e-12);
        assert_eq!(alleviated.alleviation_at(15_000.0), 1.0);
    }

    #[test]
    fn continuous_turbulence_has_the_velocities_of_its_text() {
        // CS 25.341(b)(3): 27.43 m/s at sea level, 24.08 from 7315 m on, half of them at VD, all times F_g.
        let at = |altitude: f64, criterion| {
            GustSettings { criterion, alleviation: 0.8, ..cs25() }.turbulence_velocity(altitude)
        };
        let near = |found: f64, expected: f64| (found - expected).abs() < 1e-12;
        assert!(near(at(0.0, GustCriterion::Cs25Vc), 27.43 * 0.8));
        let half_way = 0.8 + 0.2 * 3657.5 / 12_500.0;
        assert!(near(at(3657.5, GustCriterion::Cs25Vc), 0.5 * (27.43 + 24.08) * half_way));
        assert!(near(at(15_000.0, GustCriterion::Cs25Vc), 24.08));
        assert!(near(at(15_000.0, GustCriterion::Cs25Vd), 12.04));
        assert_eq!(at(0.0, GustCriterion::Peak), 0.0);
    }

    #[test]
    fn the_gust_peaks_at_its_gradient_and_is_over_at_twice_of_it() {
        let settings = GustSettings { criterion: GustCriterion::Peak, ..cs25() };
        let gust = OneMinusCosine::new(&settings, 0.0, 1.225).unwrap();
        for (s, up) in
            [(-1.0, 0.0), (0.0, 0.0), (15.0, 5.0), (30.0, 10.0), (45.0, 5.0), (60.0, 0.0), (61.0, 0.0)]
        {
            let [along, right, down] = gust.velocity(s);
            assert!((along, right) == (0.0, 0.0) && (down + up).abs() < 1e-12, "{s}: {down}");
        }
    }

    #[test]
    fn directions_are_from_up_to_the_right_and_inclinations_forward() {
        let at = |direction: f64, inclination: f64| {
            let settings = GustSettings { criterion: GustCriterion::Peak, direction, inclination, ..cs25() };
            OneMinusCosine::new(&settings, 0.0, 1.225).unwrap()
        };
        let near = |gust: OneMinusCosine, expected: [f64; 3]| {
            let found = gust.velocity(30.0);
            let apart = found.iter().zip(expected).map(|(found, expected)| (found - expected).abs());
            assert!(apart.fold(0.0, f64::max) < 1e-14, "{found:?}");
        };
        near(at(0.5 * PI, 0.0), [0.0, 10.0, 0.0]);
        near(at(PI, 0.0), [0.0, 0.0, 10.0]);
        near(at(0.0, 0.5 * PI), [10.0, 0.0, 0.0]);
        near(at(-0.5 * PI, PI / 6.0), [5.0, -10.0 * libm::cos(PI / 6.0), 0.0]);
        assert!(at(PI, 0.3).is_in_plane() && at(-PI, 0.0).is_in_plane() && !at(1e-12, 0.0).is_in_plane());
    }

    #[test]
    fn what_is_out_of_range_is_named_with_its_unit() {
        let refused = |settings: GustSettings| settings.check().unwrap_err().to_string();
        let base = cs25();
        assert_eq!(
            refused(GustSettings { gradient: 5.0, ..base }),
            "gust.gradient: found 5, allowed is 9.144 to 106.68 (m) with a criterion of CS-25"
        );
        assert!(GustSettings { gradient: 5.0, shape: GustShape::None, ..base }.check().is_ok());
        assert!(refused(GustSettings { gradient: 0.0, ..base }).contains("allowed is 0.01 to 1e6 (m)"));
        assert!(refused(GustSettings { start: -1.0, ..base }).starts_with("gust.start: found -1"));
        assert!(refused(GustSettings { peak: f64::NAN, ..base }).contains("(m/s)"));
        assert!(refused(GustSettings { alleviation: 1.5, ..base }).contains("0 to 1"));
        assert!(refused(GustSettings { maximum_operating_altitude: 0.0, ..base }).contains("(m)"));
    }
}

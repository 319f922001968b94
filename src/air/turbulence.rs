//! Continuous turbulence: spectra of Dryden and von Kármán, and a field that is a function of seed and place alone.
//!
//! [theory: gusts.spectra, gusts.realisation]
//!
//! The field is a sum of harmonics over a length N Δx, evaluated as a periodic cubic spline whose coefficients are found once.

use std::f64::consts::{PI, TAU};
use std::ops::RangeInclusive;
use std::sync::Arc;

use nalgebra::Complex;

use crate::math::{GOLDEN, sum_of_harmonics, unit_number};

use super::gust::GUST_STARTS;
use super::out_of_range::OutOfRange;

/// The spectrum of the turbulence.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Spectrum {
    /// There is no turbulence.
    None,
    /// Of MIL-F-8785C.
    Dryden,
    /// Of MIL-F-8785C and CS 25.341(b).
    VonKarman,
}

/// Length scales that the field's waves of 8 m to 262 km have room for, m [theory: gusts.realisation].
pub const TURBULENCE_SCALES: RangeInclusive<f64> = 30.0..=2e4;

/// Which components of the turbulence blow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TurbulenceComponents {
    /// Along the track, to the right, and down.
    All,
    /// Down alone.
    Vertical,
    /// To the right alone.
    Lateral,
}

/// Continuous turbulence that the aircraft flies into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurbulenceSettings {
    /// Its spectrum.
    pub spectrum: Spectrum,
    /// σ of each component, m/s of true airspeed, ≥ 0.
    pub intensity: f64,
    /// L, m; 0 stands for 533.4 m (Dryden) or 762 m (von Kármán).
    pub scale: f64,
    /// Which of all fields.
    pub seed: i32,
    /// Which components blow.
    pub components: TurbulenceComponents,
    /// When the foremost strip meets it, s after the flight begins, ≥ 0.
    pub start: f64,
}

impl Default for TurbulenceSettings {
    /// None; what is switched on has σ = 1 m/s in all components from the beginning on.
    fn default() -> Self {
        TurbulenceSettings {
            spectrum: Spectrum::None,
            intensity: 1.0,
            scale: 0.0,
            seed: 1,
            components: TurbulenceComponents::All,
            start: 0.0,
        }
    }
}

impl TurbulenceSettings {
    /// Checks every setting against its range.
    ///
    /// # Errors
    /// Names the first that is outside.
    pub fn check(&self) -> Result<(), OutOfRange> {
        let TurbulenceSettings { intensity, scale, start, .. } = *self;
        OutOfRange::unless(
            "turbulence.intensity",
            intensity,
            intensity >= 0.0,
            "a finite number >= 0 (m/s)",
        )?;
        let inside = scale == 0.0 || TURBULENCE_SCALES.contains(&scale);
        let allowed = "30 to 2e4 (m), or 0 for that of the spectrum";
        OutOfRange::unless("turbulence.scale", scale, inside, allowed)?;
        OutOfRange::unless("turbulence.start", start, GUST_STARTS.contains(&start), "0 to 1e6 (s)")
    }

    /// L, m: `scale`, or that of the spectrum where it is 0.
    pub fn length(&self) -> f64 {
        match (self.scale, self.spectrum) {
            (0.0, Spectrum::Dryden) => 533.4,
            (0.0, _) => 762.0,
            (scale, _) => scale,
        }
    }

    /// Φ for σ = 1 m/s at a wave number Ω, rad/m, one-sided, (m/s)² per rad/m: of the component along the track, or of one across
    /// it [theory: gusts.spectra].
    ///
    /// ```
    /// use flexible_aircraft::air::{Spectrum, TurbulenceSettings};
    ///
    /// let turbulence = TurbulenceSettings { spectrum: Spectrum::VonKarman, ..Default::default() };
    /// let longest = turbulence.density(0.0, false); // L/π
    /// assert!((longest - 762.0 / std::f64::consts::PI).abs() < 1e-9);
    /// ```
    pub fn density(&self, wave_number: f64, is_along: bool) -> f64 {
        let length = self.length();
        let x = length * wave_number;
        let y = 1.339 * x;
        let [x2, y2] = [x * x, y * y];
        match (self.spectrum, is_along) {
            (Spectrum::None, _) => 0.0,
            (Spectrum::Dryden, true) => 2.0 * length / PI / (1.0 + x2),
            (Spectrum::Dryden, false) => length / PI * (1.0 + 3.0 * x2) / ((1.0 + x2) * (1.0 + x2)),
            (Spectrum::VonKarman, true) => 2.0 * length / PI * libm::pow(1.0 + y2, -5.0 / 6.0),
            (Spectrum::VonKarman, false) => {
                length / PI * (1.0 + 8.0 / 3.0 * y2) * libm::pow(1.0 + y2, -11.0 / 6.0)
            }
        }
    }
}

/// N: numbers of the field over its length.
const COUNT: usize = 1 << 17;
/// Δx, m.
const SPACING: f64 = 2.0;
/// Harmonics up to a wave of four spacings.
const HARMONICS: usize = COUNT / 4;
/// Over which the turbulence sets in, m.
const RAMP: f64 = 100.0;

/// Turbulence over the distance s from where it begins; what it consists of is shared.
#[derive(Clone, Debug)]
pub struct Turbulence {
    /// σ times the coefficients of the spline: along the track, to the right, down.
    components: [Option<Arc<[f64]>>; 3],
}

impl Turbulence {
    /// Of some settings; `None` where there is none.
    pub fn new(settings: &TurbulenceSettings) -> Option<Self> {
        if settings.spectrum == Spectrum::None {
            return None;
        }
        let blows = match settings.components {
            TurbulenceComponents::All => [true; 3],
            TurbulenceComponents::Vertical => [false, false, true],
            TurbulenceComponents::Lateral => [false, true, false],
        };
        let component = |place: usize| blows[place].then(|| coefficients(settings, place));
        Some(Turbulence { components: [0, 1, 2].map(component) })
    }

    /// Along the track, to the right, down, m/s.
    pub fn velocity(&self, s: f64) -> [f64; 3] {
        if s <= 0.0 {
            return [0.0; 3];
        }
        let ramp = if s < RAMP { 0.5 * (1.0 - libm::cos(PI * s / RAMP)) } else { 1.0 };
        let place = s / SPACING;
        let cell = libm::floor(place);
        let weights = spline(place - cell).map(|weight| ramp * weight);
        let before = (cell % COUNT as f64) as usize + COUNT - 1;
        self.components.each_ref().map(|component| match component {
            None => 0.0,
            Some(coefficients) => {
                let terms = weights.iter().enumerate();
                terms.fold(0.0, |sum, (next, weight)| sum + weight * coefficients[(before + next) % COUNT])
            }
        })
    }

    /// Whether it blows in the plane of the track and the vertical.
    pub fn is_in_plane(&self) -> bool {
        self.components[1].is_none()
    }
}

/// σ times the coefficients of the spline of one component, numbered 0, 1, 2 along the track, to the right, down.
fn coefficients(settings: &TurbulenceSettings, component: usize) -> Arc<[f64]> {
    let step = TAU / (COUNT as f64 * SPACING);
    let seed = u64::from_ne_bytes(i64::from(settings.seed).to_ne_bytes()).wrapping_mul(GOLDEN);
    let places = seed.wrapping_add((component as u64 + 1).wrapping_mul(0xD134_2543_DE82_EF95));
    let mut harmonics = vec![Complex::new(0.0, 0.0); COUNT];
    for (k, harmonic) in harmonics.iter_mut().enumerate().take(HARMONICS + 1).skip(1) {
        // The first stands for all longer waves too.
        let share = if k == 1 { 1.5 } else { 1.0 };
        let density = settings.density(k as f64 * step, component == 0);
        let amplitude = settings.intensity * libm::sqrt(2.0 * density * step * share);
        let (sin, cos) = libm::sincos(TAU * unit_number(places.wrapping_add(k as u64)));
        let angle = PI * k as f64 / COUNT as f64;
        let sinc = libm::sin(angle) / angle;
        let scaled = amplitude / (sinc * sinc * sinc * sinc);
        *harmonic = Complex::new(scaled * cos, scaled * sin);
    }
    sum_of_harmonics(&mut harmonics);
    harmonics.iter().map(|number| number.re).collect()
}

/// Weights of a cubic spline's four coefficients at a share of a cell.
fn spline(u: f64) -> [f64; 4] {
    let (left, square) = (1.0 - u, u * u);
    let cube = square * u;
    [
        left * left * left / 6.0,
        (3.0 * cube - 6.0 * square + 4.0) / 6.0,
        (3.0 * (square + u - cube) + 1.0) / 6.0,
        cube / 6.0,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// T(s) beyond where the turbulence sets in, and before it as if it did not.
    fn plain(turbulence: &Turbulence, component: usize, s: f64) -> f64 {
        // A whole length further on, so that no ramp takes part.
        turbulence.velocity(s + COUNT as f64 * SPACING)[component]
    }

    #[test]
    fn the_field_has_the_numbers_of_an_independent_computation() {
        // From a prototype in numpy: σ = 1 m/s, seed 1, at s = 0, 3.7 and 1234.5 m.
        let settings = TurbulenceSettings { spectrum: Spectrum::VonKarman, ..TurbulenceSettings::default() };
        let von_karman = Turbulence::new(&settings).unwrap();
        let dryden = TurbulenceSettings { spectrum: Spectrum::Dryden, ..settings };
        let dryden = Turbulence::new(&dryden).unwrap();
        for (s, down, along) in
            [(0.0, -0.337157, -0.462933), (3.7, -0.499072, -0.365651), (1234.5, -1.477854, 0.446250)]
        {
            let found = [plain(&von_karman, 2, s), plain(&dryden, 0, s)];
            assert!((found[0] - down).abs() < 1e-6 && (found[1] - along).abs() < 1e-6, "{s}: {found:?}");
        }
    }

    #[test]
    fn the_spectra_have_the_variance_of_their_intensity() {
        // ∫Φ dΩ over a logarithmic grid; what is beyond both ends is below 1e-3.
        for spectrum in [Spectrum::Dryden, Spectrum::VonKarman] {
            let settings = TurbulenceSettings { spectrum, ..TurbulenceSettings::default() };
            for is_along in [true, false] {
                let step = 1e-3;
                let term = |place: i32| {
                    let wave_number = 1e-8 * libm::exp(step * f64::from(place));
                    settings.density(wave_number, is_along) * wave_number * step
                };
                let variance: f64 = (0..23_000).map(term).sum();
                assert!((variance - 1.0).abs() < 2e-3, "{spectrum:?} {is_along}: {variance}");
            }
        }
    }

    #[test]
    fn the_harmonics_hold_nearly_all_of_the_variance_at_any_scale_that_is_allowed() {
        let step = TAU / (COUNT as f64 * SPACING);
        for (spectrum, scale) in [Spectrum::Dryden, Spectrum::VonKarman].into_iter().flat_map(|spectrum| {
            [(spectrum, *TURBULENCE_SCALES.start()), (spectrum, *TURBULENCE_SCALES.end())]
        }) {
            let settings = TurbulenceSettings { spectrum, scale, ..TurbulenceSettings::default() };
            for is_along in [true, false] {
                let share = |k: usize| if k == 1 { 1.5 } else { 1.0 };
                let term = |k: usize| share(k) * settings.density(k as f64 * step, is_along) * step;
                let rms = libm::sqrt((1..=HARMONICS).map(term).sum());
                assert!((0.9..1.01).contains(&rms), "{spectrum:?} {scale} m, along {is_along}: {rms}");
            }
        }
    }

    #[test]
    fn the_field_has_the_variance_of_its_harmonics_and_other_seeds_give_others() {
        let settings = TurbulenceSettings {
            spectrum: Spectrum::VonKarman,
            intensity: 3.0,
            components: TurbulenceComponents::Vertical,
            ..TurbulenceSettings::default()
        };
        let fields =
            [1, 2, -7].map(|seed| Turbulence::new(&TurbulenceSettings { seed, ..settings }).unwrap());
        for field in &fields {
            let square = |place: usize| {
                let down = plain(field, 2, place as f64 * SPACING);
                down * down / COUNT as f64
            };
            let rms = libm::sqrt((0..COUNT).map(square).sum::<f64>());
            // Waves below 8 m, 1.1 % of the variance, are left out.
            assert!((rms / 3.0 - libm::sqrt(0.989)).abs() < 2e-3, "{rms}");
            assert_eq!(field.velocity(500.0)[..2], [0.0, 0.0]);
            assert!(field.is_in_plane());
        }
        assert!(plain(&fields[0], 2, 0.0) != plain(&fields[1], 2, 0.0));
    }

    #[test]
    fn the_turbulence_sets_in_over_a_hundred_metres() {
        let settings = TurbulenceSettings { spectrum: Spectrum::Dryden, ..TurbulenceSettings::default() };
        let turbulence = Turbulence::new(&settings).unwrap();
        for s in [-1.0, 0.0] {
            assert_eq!(turbulence.velocity(s), [0.0; 3]);
        }
        let half = turbulence.velocity(50.0);
        for (component, half) in half.into_iter().enumerate() {
            assert!((half - 0.5 * plain(&turbulence, component, 50.0)).abs() < 1e-12);
        }
        assert!(!turbulence.is_in_plane());
    }

    #[test]
    fn what_is_out_of_range_is_named_with_its_unit() {
        let refused = |settings: TurbulenceSettings| settings.check().unwrap_err().to_string();
        let base = TurbulenceSettings::default();
        assert!(
            refused(TurbulenceSettings { intensity: -1.0, ..base })
                .contains("found -1, allowed is a finite number >= 0 (m/s)")
        );
        for scale in [f64::INFINITY, 29.0, -1.0] {
            let refusal = refused(TurbulenceSettings { scale, ..base });
            assert!(
                refusal.starts_with("turbulence.scale") && refusal.contains("30 to 2e4 (m)"),
                "{refusal}"
            );
        }
        assert!(refused(TurbulenceSettings { start: -0.1, ..base }).contains("(s)"));
    }
}

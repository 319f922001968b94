//! An aircraft in the middle of an oblique gust and turbulence.

use std::sync::Arc;

use flexible_aircraft::air::{
    Extent, FrozenGust, GustSettings, GustShape, Spectrum, Track, TurbulenceSettings,
};
use nalgebra::Vector3;

/// A gust of 20 m/s in all directions at once, 30 m long, in turbulence of 5 m/s.
pub struct Encounter {
    /// What is frozen in the air.
    pub gust: Arc<FrozenGust>,
    /// e, 37° off north.
    pub along: Vector3<f64>,
    /// Where O was at the start, m.
    pub start: Vector3<f64>,
}

impl Encounter {
    /// With O in the middle of the gust once the air has gone some way, m.
    pub fn around(position: &Vector3<f64>, air_travel: &Vector3<f64>) -> Self {
        let along = Vector3::new(0.8, 0.6, 0.0);
        let start = position - air_travel - along * 15.0;
        let single = GustSettings {
            shape: GustShape::OneMinusCosine,
            gradient: 15.0,
            peak: 20.0,
            direction: 0.7,
            inclination: 0.4,
            start: 0.0,
            ..GustSettings::default()
        };
        let turbulence = TurbulenceSettings {
            spectrum: Spectrum::Dryden,
            intensity: 5.0,
            ..TurbulenceSettings::default()
        };
        let gust = FrozenGust::new(
            Track::new(&start, &along, Extent { nose: 0.0, reach: 100.0 }),
            (&single, &turbulence),
            7620.0,
            0.55,
        );
        Encounter { gust: Arc::new(gust.unwrap()), along, start }
    }
}

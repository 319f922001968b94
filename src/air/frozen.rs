//! A gust that is frozen in the air and varies along the track: what the aircraft flies into [theory: gusts.field], or what is put
//! there to see what it does [theory: linearisation.gusts].
//!
//! Symbols: e the direction of the track, s the distance along it, D how far the air itself has gone.

use nalgebra::Vector3;

use crate::math::Attitude;

use super::gust::{GustSettings, OneMinusCosine};
use super::imposed::ImposedGust;
use super::turbulence::{Turbulence, TurbulenceSettings};

/// The way through the air on which the aircraft begins, horizontally: north-east-down or forward-right-down as the state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Track {
    /// e.
    along: Vector3<f64>,
    /// O at the start, m.
    origin: Vector3<f64>,
    /// V cos γ, m/s.
    speed: f64,
    aircraft: Extent,
}

/// How far an aircraft reaches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// By how much the foremost point of any strip is ahead of O on the undeformed aircraft, m.
    pub nose: f64,
    /// No point of any chord is ever further from O, m.
    pub reach: f64,
}

/// All that is frozen in the air along a track.
#[derive(Clone, Debug)]
pub struct FrozenGust {
    track: Track,
    field: Field,
}

/// What is frozen in the air. Whoever asks for it at many places chooses first.
#[derive(Clone, Debug)]
pub(crate) enum Field {
    /// What settings put before the aircraft.
    Ahead(AheadGust),
    /// What is there from the beginning on.
    Imposed(ImposedGust),
}

/// A gust and turbulence that begin ahead of the aircraft.
#[derive(Clone, Debug)]
pub(crate) struct AheadGust {
    /// Of the single gust, m/s of true airspeed.
    peak_velocity: f64,
    /// With the distance from O at the start to where it begins, m.
    single: Option<(f64, OneMinusCosine)>,
    turbulence: Option<(f64, Turbulence)>,
}

/// A velocity of the air that depends on the place along the track alone.
pub(crate) trait AlongTrack {
    /// Along the track, to the right, down, m/s, at a distance along the track from O at the start, m.
    fn velocity(&self, ahead: f64) -> [f64; 3];
}

/// The axes of a track as an aircraft sees them, and how far along it O is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackSeen {
    /// Along the track, to the right, down: body axes.
    pub axes: [Vector3<f64>; 3],
    /// From O at the start to O, through the air, m.
    pub origin: f64,
}

impl Track {
    /// Of an aircraft of some extent at a position that moves through the air at a velocity, in the same axes with z down;
    /// forward where it does not move horizontally.
    pub fn new(position: &Vector3<f64>, velocity: &Vector3<f64>, aircraft: Extent) -> Self {
        let speed = libm::hypot(velocity.x, velocity.y);
        let along = if speed > 0.0 {
            Vector3::new(velocity.x / speed, velocity.y / speed, 0.0)
        } else {
            Vector3::x()
        };
        Track { along, origin: *position, speed, aircraft }
    }

    /// e.
    pub(crate) fn along(&self) -> Vector3<f64> {
        self.along
    }

    /// How fast the aircraft goes along it, m/s.
    pub(crate) fn speed(&self) -> f64 {
        self.speed
    }

    /// s0: from O at the start to where that begins which the foremost point meets at a time, s.
    fn begin(&self, start: f64) -> f64 {
        self.speed * start + self.aircraft.nose
    }
}

impl FrozenGust {
    /// Of settings, at an altitude (m) where the air has some density (kg/m³); `None` where nothing blows.
    pub fn new(
        track: Track,
        (single, turbulence): (&GustSettings, &TurbulenceSettings),
        altitude: f64,
        density: f64,
    ) -> Option<Self> {
        let ahead = AheadGust {
            single: OneMinusCosine::new(single, altitude, density)
                .map(|gust| (track.begin(single.start), gust)),
            turbulence: Turbulence::new(turbulence).map(|field| (track.begin(turbulence.start), field)),
            peak_velocity: single.peak_velocity(altitude, density),
        };
        let blows = ahead.single.is_some() || ahead.turbulence.is_some();
        blows.then_some(FrozenGust { track, field: Field::Ahead(ahead) })
    }

    /// That which is imposed, along a track.
    pub fn imposed(track: Track, gust: ImposedGust) -> Self {
        FrozenGust { track, field: Field::Imposed(gust) }
    }

    /// What is frozen.
    #[inline(always)]
    pub(crate) fn field(&self) -> &Field {
        &self.field
    }

    /// Along the track, to the right, down, m/s, at a distance along the track from O at the start, m.
    pub fn velocity(&self, ahead: f64) -> [f64; 3] {
        match &self.field {
            Field::Ahead(field) => field.velocity(ahead),
            Field::Imposed(field) => field.velocity(ahead),
        }
    }

    /// Of the single gust, m/s of true airspeed; 0 where there is none.
    pub fn peak_velocity(&self) -> f64 {
        match &self.field {
            Field::Ahead(field) => field.peak_velocity,
            Field::Imposed(_) => 0.0,
        }
    }

    /// Whether nothing blows at an aircraft whose O is so far along the track from O at the start, m.
    pub fn is_calm(&self, ahead: f64) -> bool {
        let Field::Ahead(field) = &self.field else { return false };
        let reach = self.track.aircraft.reach;
        let before = |begin: f64| ahead + reach <= begin;
        field.turbulence.as_ref().is_none_or(|(begin, _)| before(*begin))
            && field
                .single
                .as_ref()
                .is_none_or(|(begin, gust)| before(*begin) || ahead - reach >= begin + gust.length())
    }

    /// Whether it blows in the mirror plane of an aircraft that flies straight along the first axis.
    pub fn is_in_plane(&self) -> bool {
        let is_in_plane = match &self.field {
            Field::Ahead(field) => field.is_in_plane(),
            Field::Imposed(field) => field.is_in_plane(),
        };
        self.track.along.y == 0.0 && is_in_plane
    }

    /// The track as an aircraft sees it whose O is at a position, once the air has gone some way, m.
    pub fn seen_by(&self, attitude: &Attitude, [position, drift]: [&Vector3<f64>; 2]) -> TrackSeen {
        let Track { along, origin, .. } = &self.track;
        let right = Vector3::new(-along.y, along.x, 0.0);
        let axes = [*along, right, Vector3::z()];
        TrackSeen {
            axes: axes.map(|axis| attitude.body_from_inertial * axis),
            origin: along.dot(&(position - origin - drift)),
        }
    }

    /// The air's velocity at O, body axes, m/s.
    pub fn at_origin(&self, seen: &TrackSeen) -> Vector3<f64> {
        seen.vector(self.velocity(seen.origin))
    }
}

impl AheadGust {
    fn is_in_plane(&self) -> bool {
        self.single.as_ref().is_none_or(|(_, gust)| gust.is_in_plane())
            && self.turbulence.as_ref().is_none_or(|(_, field)| field.is_in_plane())
    }
}

impl AlongTrack for AheadGust {
    fn velocity(&self, ahead: f64) -> [f64; 3] {
        let single = self.single.as_ref().map_or([0.0; 3], |(begin, gust)| gust.velocity(ahead - begin));
        match &self.turbulence {
            None => single,
            Some((begin, field)) => {
                let turbulence = field.velocity(ahead - begin);
                [0, 1, 2].map(|axis| single[axis] + turbulence[axis])
            }
        }
    }
}

impl AlongTrack for ImposedGust {
    fn velocity(&self, ahead: f64) -> [f64; 3] {
        self.at(ahead)
    }
}

impl TrackSeen {
    /// In body axes, of components along the track, to the right, down.
    pub fn vector(&self, components: [f64; 3]) -> Vector3<f64> {
        let [along, right, down] = &self.axes;
        along * components[0] + right * components[1] + down * components[2]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::air::{GustShape, Spectrum};
    use crate::math::quaternion_of_euler_angles;

    #[test]
    fn the_foremost_point_meets_the_gust_when_it_starts_and_wherever_the_air_has_gone() {
        let (single, still) = (
            GustSettings { shape: GustShape::OneMinusCosine, start: 2.0, ..GustSettings::default() },
            TurbulenceSettings::default(),
        );
        let (position, velocity) = (Vector3::new(5.0, 7.0, -300.0), Vector3::new(30.0, 40.0, -10.0));
        let track = Track::new(&position, &velocity, Extent { nose: 12.0, reach: 20.0 });
        let gust = FrozenGust::new(track, (&single, &still), 0.0, 1.225).unwrap();
        // After two seconds the nose has gone 100 m along the track, and the air has carried both.
        let attitude = Attitude::from_quaternion(&quaternion_of_euler_angles(&Vector3::new(0.2, 0.1, 0.9)));
        let drift = Vector3::new(-3.0, 8.0, 4.0);
        let seen = gust.seen_by(&attitude, [&(position + velocity * 2.0 + drift), &drift]);
        assert!((seen.origin - 100.0).abs() < 1e-12);
        assert_eq!(gust.velocity(seen.origin + 12.0 - 1e-9), [0.0; 3]);
        let peak = gust.velocity(seen.origin + 12.0 + 30.0);
        assert!((peak[2] + 10.0).abs() < 1e-12);
        // Upwards in north-east-down, whatever the attitude.
        let up = attitude.body_from_inertial.tr_mul(&seen.vector(peak));
        assert!((up + Vector3::z() * 10.0).norm() < 1e-12, "{up}");
        assert!(!gust.is_in_plane());
        // The gust is 60 m long and begins 12 m ahead of what is 100 m down the track; the aircraft reaches 20 m.
        let calm = [90.0, 92.0, 93.0, 191.0, 192.0].map(|ahead| gust.is_calm(ahead));
        assert_eq!(calm, [true, true, false, false, true]);
    }

    #[test]
    fn what_is_switched_off_is_not_there_and_what_is_on_adds() {
        let track =
            Track::new(&Vector3::zeros(), &Vector3::new(20.0, 0.0, 0.0), Extent { nose: 1.0, reach: 5.0 });
        let (off, calm) = (GustSettings::default(), TurbulenceSettings::default());
        assert!(FrozenGust::new(track, (&off, &calm), 0.0, 1.225).is_none());
        let single = GustSettings { shape: GustShape::OneMinusCosine, start: 6.0, ..off };
        let turbulence = TurbulenceSettings { spectrum: Spectrum::Dryden, ..calm };
        let gust = |single, turbulence| FrozenGust::new(track, (single, turbulence), 0.0, 1.225).unwrap();
        let [one, other, both] = [
            gust(&single, &calm).velocity(150.0),
            gust(&off, &turbulence).velocity(150.0),
            gust(&single, &turbulence).velocity(150.0),
        ];
        for axis in 0..3 {
            assert_eq!(both[axis], one[axis] + other[axis]);
        }
        assert!(one[2] != 0.0 && other[0] != 0.0);
        assert!(gust(&single, &calm).is_in_plane() && !gust(&single, &turbulence).is_in_plane());
    }
}

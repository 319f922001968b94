//! A gust that is there from the beginning on: what an aircraft answers to small ones is asked with it [theory: linearisation.gusts].

use std::sync::Arc;

/// How a gust varies along the track, as a part of its strength.
#[derive(Clone, Debug, PartialEq)]
pub enum GustWave {
    /// cos Ωs, Ω in rad/m.
    Cosine(f64),
    /// sin Ωs, Ω in rad/m.
    Sine(f64),
    /// 1 at one of several planes across the track, 0 at the others, linear between them and constant beyond the first and the
    /// last.
    Plane {
        /// Their distances along the track from O at the start, m, the foremost first.
        places: Arc<[f64]>,
        /// Which of them, from 0 on.
        plane: usize,
    },
}

/// A gust of some strength along the track on which an aircraft is.
#[derive(Clone, Debug, PartialEq)]
pub struct ImposedGust {
    /// How it varies.
    pub wave: GustWave,
    /// Along the track, to the right, down, m/s, where the wave is 1.
    pub strength: [f64; 3],
}

impl ImposedGust {
    /// Along the track, to the right, down, m/s, at a distance along the track from O at the start, m.
    pub(super) fn at(&self, s: f64) -> [f64; 3] {
        let share = self.wave.at(s);
        self.strength.map(|strength| strength * share)
    }

    /// Whether it blows in the plane of the track and the vertical.
    pub(super) fn is_in_plane(&self) -> bool {
        self.strength[1] == 0.0
    }
}

impl GustWave {
    /// At a distance along the track from O at the start, m.
    fn at(&self, s: f64) -> f64 {
        match self {
            GustWave::Cosine(wave_number) => libm::cos(wave_number * s),
            GustWave::Sine(wave_number) => libm::sin(wave_number * s),
            GustWave::Plane { places, plane } => {
                let here = places[*plane];
                // On the side of a neighbour the way there counts, on the other nothing does.
                let neighbour = if s > here { plane.checked_sub(1) } else { Some(plane + 1) };
                match neighbour.and_then(|neighbour| places.get(neighbour)) {
                    Some(neighbour) => (1.0 - (s - here) / (neighbour - here)).max(0.0),
                    None => 1.0,
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane(plane: usize) -> GustWave {
        GustWave::Plane { places: Arc::new([10.0, 4.0, -2.0]), plane }
    }

    #[test]
    fn between_planes_a_gust_is_linear_and_beyond_them_constant() {
        for (s, expected) in [
            (12.0, [1.0, 0.0, 0.0]),
            (10.0, [1.0, 0.0, 0.0]),
            (8.5, [0.75, 0.25, 0.0]),
            (4.0, [0.0, 1.0, 0.0]),
            (-0.5, [0.0, 0.25, 0.75]),
            (-2.0, [0.0, 0.0, 1.0]),
            (-7.0, [0.0, 0.0, 1.0]),
        ] {
            assert_eq!([0, 1, 2].map(|number| plane(number).at(s)), expected, "{s}");
        }
    }

    #[test]
    fn waves_have_their_phase_where_the_aircraft_is_and_a_direction() {
        let gust = ImposedGust { wave: GustWave::Sine(0.5), strength: [0.0, 0.0, -2.0] };
        assert_eq!(gust.at(0.0), [0.0, 0.0, -0.0]);
        assert!((gust.at(0.2)[2] + 2.0 * libm::sin(0.1)).abs() < 1e-15 && gust.is_in_plane());
        let aside = ImposedGust { wave: GustWave::Cosine(0.5), strength: [0.0, 3.0, 0.0] };
        assert!((aside.at(-0.2)[1] - 3.0 * libm::cos(0.1)).abs() < 1e-15 && !aside.is_in_plane());
    }
}

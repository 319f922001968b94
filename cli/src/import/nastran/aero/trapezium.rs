//! A trapezium whose chords run along x: what a panel is to the air, and what its boxes divide.

use nalgebra::Vector3;

#[derive(Clone, Debug)]
pub struct Trapezium {
    /// Of the leading edge, inboard and outboard, m from O.
    pub corners: [Vector3<f64>; 2],
    /// There, m.
    pub chords: [f64; 2],
}

impl Trapezium {
    /// Across x, from the inboard to the outboard edge, m.
    pub fn span(&self) -> Vector3<f64> {
        let along = self.corners[1] - self.corners[0];
        Vector3::new(0.0, along.y, along.z)
    }

    /// How far out a place is: 0 at the inboard edge, 1 at the outboard one.
    pub fn fraction(&self, place: &Vector3<f64>) -> f64 {
        let span = self.span();
        (place - self.corners[0]).dot(&span) / span.norm_squared()
    }

    pub fn chord(&self, fraction: f64) -> f64 {
        self.chords[0] + fraction * (self.chords[1] - self.chords[0])
    }

    pub fn leading_edge(&self, fraction: f64) -> Vector3<f64> {
        self.corners[0] + (self.corners[1] - self.corners[0]) * fraction
    }

    /// A place by fractions of the span and of the chord.
    pub fn at(&self, fraction: f64, behind: f64) -> Vector3<f64> {
        self.leading_edge(fraction) - Vector3::x() * (behind * self.chord(fraction))
    }

    /// How far behind the leading edge a place is, in chords.
    pub fn chord_fraction(&self, place: &Vector3<f64>, fraction: f64) -> f64 {
        (self.leading_edge(fraction).x - place.x) / self.chord(fraction)
    }

    /// Its area between two fractions of the span, m².
    pub fn area(&self, from: f64, to: f64) -> f64 {
        self.span().norm() * (to - from) * self.chord(0.5 * (from + to))
    }

    /// The part between two fractions of the span.
    pub fn part(&self, ends: [f64; 2]) -> Trapezium {
        Trapezium {
            corners: ends.map(|fraction| self.leading_edge(fraction)),
            chords: ends.map(|fraction| self.chord(fraction)),
        }
    }
}

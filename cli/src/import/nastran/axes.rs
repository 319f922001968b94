//! From the deck's axes to body axes: x forward, y right, z down [theory: frames.axes].

use clap::ValueEnum;
use nalgebra::{Matrix3, Vector3};

/// Which way the deck's x, y and z point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DeckAxes {
    /// x aft, y to the right, z up: usual with aerodynamics
    AftRightUp,
    /// x aft, y to the left, z down
    AftLeftDown,
    /// x forward, y to the left, z up
    ForwardLeftUp,
    /// x forward, y to the right, z down: body axes
    ForwardRightDown,
}

impl DeckAxes {
    pub fn name(self) -> &'static str {
        match self {
            DeckAxes::AftRightUp => "x aft, y right, z up",
            DeckAxes::AftLeftDown => "x aft, y left, z down",
            DeckAxes::ForwardLeftUp => "x forward, y left, z up",
            DeckAxes::ForwardRightDown => "x forward, y right, z down",
        }
    }

    /// Body components of a vector of the deck's.
    pub fn to_body(self) -> Matrix3<f64> {
        let signs = match self {
            DeckAxes::AftRightUp => [-1.0, 1.0, -1.0],
            DeckAxes::AftLeftDown => [-1.0, -1.0, 1.0],
            DeckAxes::ForwardLeftUp => [1.0, -1.0, -1.0],
            DeckAxes::ForwardRightDown => [1.0; 3],
        };
        Matrix3::from_diagonal(&Vector3::from(signs))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_of_them_are_right_handed() {
        for axes in DeckAxes::value_variants() {
            assert_eq!(axes.to_body().determinant(), 1.0, "{}", axes.name());
        }
    }
}

//! Coordinates of vectors.

/// A coordinate: x, y, z; north, east, down; or roll, pitch, yaw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// x, north, roll.
    X,
    /// y, east, pitch.
    Y,
    /// z, down, yaw.
    Z,
}

impl Axis {
    /// All three.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    pub(super) fn index(self) -> usize {
        self as usize
    }
}

//! What computes: numbers in registers, vectors and matrices of them, small linear systems, rotations. No aircraft.

mod arithmetic;
mod attitude;
mod columns;
mod differences;
mod fourier;
mod lane_vectors;
mod lanes;
mod linear_solve;
mod magnitudes;
mod mix;
mod rotation;
mod square_matrix;

pub(crate) use arithmetic::{Arithmetic, Counting, Machine, Work};
pub use attitude::Attitude;
pub(crate) use attitude::{
    euler_angle_rates, quaternion_of_euler_angles, quaternion_of_turn, quaternion_product, quaternion_rate,
};
pub(crate) use columns::Columns;
pub(crate) use differences::{WIDTHS, central, derivative, slope};
pub(crate) use fourier::sum_of_harmonics;
pub(crate) use lane_vectors::{Arrow, EightVectors, LaneVector, PlaneVector};
pub(crate) use lanes::{AlignedNumbers, Eight, LANES, Lanes, Window, zeros};
pub(crate) use linear_solve::{LinearSystem, solve};
pub(crate) use magnitudes::{ROUNDING, are_alike, largest};
pub(crate) use mix::GOLDEN;
pub use mix::{mix, normal_number, unit_number};
pub(crate) use rotation::{PlaneRotation, Rotation};
pub(crate) use square_matrix::{SPARE, SquareMatrix};

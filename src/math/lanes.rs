//! Eight strips side by side: numbers of a group of strips, or eight of a row or of a vector of states, computed as many
//! at a time as the machine's vectors hold.
//!
//! [`Eight`] is memory, one number per strip of a group; [`Lanes`] is a register with the part of it at which a
//! [`Window`] points. Every lane sees the same IEEE operations in the same order whatever the width of the
//! registers, products and sums are never fused, and sums over lanes are taken in one fixed order: results do not
//! depend on the machine.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use aligned_vec::{AVec, avec};
use pulp::Scalar;

use super::arithmetic::Arithmetic;

/// How many strips a group has.
pub const LANES: usize = 8;

/// Numbers the first of which stands where a register fits.
pub type AlignedNumbers = AVec<f64>;

/// So many zeros.
pub fn zeros(count: usize) -> AlignedNumbers {
    avec![0.0; count]
}

/// One number for each strip of a group.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Eight(pub [f64; LANES]);

impl Eight {
    /// Nothing in every lane.
    pub const ZERO: Eight = Eight([0.0; LANES]);

    /// A number of each of up to eight strips, and another one where there is none.
    pub fn of<T>(strips: &[T], value: impl Fn(&T) -> f64, empty: f64) -> Self {
        Eight(std::array::from_fn(|lane| strips.get(lane).map_or(empty, &value)))
    }

    /// Sum over the lanes, in a fixed order.
    pub fn sum(&self) -> f64 {
        let [a, b, c, d, e, f, g, h] = self.0;
        ((a + e) + (c + g)) + ((b + f) + (d + h))
    }
}

/// The strips of a group that one register holds.
#[derive(Clone, Copy, Debug)]
pub struct Window<S: Arithmetic> {
    simd: S,
    index: usize,
}

impl Window<Scalar> {
    /// On a single number.
    pub fn single() -> Self {
        Window { simd: Scalar::new(), index: 0 }
    }
}

impl<S: Arithmetic> Window<S> {
    /// All windows on a group.
    #[inline(always)]
    pub fn all(simd: S) -> impl Iterator<Item = Window<S>> {
        (0..LANES / S::WIDTH).map(move |index| Window { simd, index })
    }

    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(self, value: f64) -> Lanes<S> {
        Lanes { value: self.simd.splat(value), simd: self.simd }
    }

    /// The numbers here.
    #[inline(always)]
    pub fn load(self, numbers: &Eight) -> Lanes<S> {
        self.load_slice(&numbers.0)
    }

    /// The numbers here of eight in a slice.
    #[inline(always)]
    pub fn load_slice(self, eight: &[f64]) -> Lanes<S> {
        Lanes { value: S::registers(eight)[self.index], simd: self.simd }
    }

    /// Writes the numbers here.
    #[inline(always)]
    pub fn store(self, numbers: &mut Eight, lanes: Lanes<S>) {
        self.store_slice(&mut numbers.0, lanes);
    }

    /// Writes the numbers here of eight in a slice.
    #[inline(always)]
    pub fn store_slice(self, eight: &mut [f64], lanes: Lanes<S>) {
        S::registers_mut(eight)[self.index] = lanes.value;
    }

    /// The lane of the group that a lane of this register is.
    pub fn lane(self, lane: usize) -> usize {
        self.index * S::WIDTH + lane
    }
}

/// One number for each strip in a register.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<S: Arithmetic> {
    value: S::Register,
    simd: S,
}

impl<S: Arithmetic> Lanes<S> {
    /// The same number in every lane of as wide a register.
    #[inline(always)]
    pub fn splat(self, value: f64) -> Self {
        Lanes { value: self.simd.splat(value), ..self }
    }

    /// Square roots.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Lanes { value: self.simd.sqrt(self.value), ..self }
    }

    /// Magnitudes.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Lanes { value: self.simd.abs(self.value), ..self }
    }

    /// The largest number, if all are numbers.
    #[inline(always)]
    pub fn largest(self) -> f64 {
        self.simd.largest(self.value)
    }

    /// The least number, if all are numbers.
    #[inline(always)]
    pub fn least(self) -> f64 {
        self.simd.least(self.value)
    }

    /// The numbers, one by one.
    #[inline(always)]
    pub fn numbers(&self) -> &[f64] {
        S::numbers(&self.value)
    }

    /// The numbers, one by one, to be changed.
    #[inline(always)]
    pub fn numbers_mut(&mut self) -> &mut [f64] {
        S::numbers_mut(&mut self.value)
    }
}

impl<S: Arithmetic> Add for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Lanes { value: self.simd.add(self.value, other.value), ..self }
    }
}

impl<S: Arithmetic> AddAssign for Lanes<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<S: Arithmetic> Sub for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Lanes { value: self.simd.subtract(self.value, other.value), ..self }
    }
}

impl<S: Arithmetic> Mul for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Lanes { value: self.simd.multiply(self.value, other.value), ..self }
    }
}

impl<S: Arithmetic> Mul<f64> for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self * self.splat(factor)
    }
}

impl<S: Arithmetic> Div for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Lanes { value: self.simd.divide(self.value, other.value), ..self }
    }
}

impl<S: Arithmetic> Neg for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Lanes { value: self.simd.negate(self.value), ..self }
    }
}

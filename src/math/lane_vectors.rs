//! Vectors of eight strips side by side: in space, and in the mirror plane y = 0.

use std::ops::{Add, Mul, Sub};

use nalgebra::Vector3;
use pulp::Scalar;

use super::arithmetic::Arithmetic;
use super::lanes::{Eight, LANES, Lanes, Window};

/// One vector for each strip of a group.
#[derive(Clone, Copy, Debug)]
pub struct EightVectors {
    /// x components.
    pub x: Eight,
    /// y components.
    pub y: Eight,
    /// z components.
    pub z: Eight,
}

impl EightVectors {
    /// A vector for each strip.
    pub fn new(vectors: [Vector3<f64>; LANES]) -> Self {
        let component = |axis: usize| Eight(vectors.map(|vector| vector[axis]));
        EightVectors { x: component(0), y: component(1), z: component(2) }
    }

    /// A vector of each of up to eight strips, and another one where there is none.
    pub fn of<T>(strips: &[T], value: impl Fn(&T) -> Vector3<f64>, empty: Vector3<f64>) -> Self {
        EightVectors::new(std::array::from_fn(|lane| strips.get(lane).map_or(empty, &value)))
    }

    /// Sum over the lanes, in a fixed order.
    pub fn sum(&self) -> Vector3<f64> {
        Vector3::new(self.x.sum(), self.y.sum(), self.z.sum())
    }

    /// One of the vectors.
    pub fn of_lane(&self, lane: usize) -> Vector3<f64> {
        Vector3::new(self.x.0[lane], self.y.0[lane], self.z.0[lane])
    }
}

/// What can be projected on others of its kind and stretched, one for each strip in a register.
pub trait Arrow<S: Arithmetic>: Copy + Add<Output = Self> + Mul<Lanes<S>, Output = Self> {
    /// The same vector in every lane, as far as it has components.
    fn splat(window: Window<S>, vector: &Vector3<f64>) -> Self;

    /// Scalar products.
    fn dot(&self, other: &Self) -> Lanes<S>;
}

/// One vector for each strip in a register.
#[derive(Clone, Copy, Debug)]
pub struct LaneVector<S: Arithmetic> {
    /// x components.
    pub x: Lanes<S>,
    /// y components.
    pub y: Lanes<S>,
    /// z components.
    pub z: Lanes<S>,
}

/// One vector in the mirror plane for each strip in a register.
#[derive(Clone, Copy, Debug)]
pub struct PlaneVector<S: Arithmetic> {
    /// x components.
    pub x: Lanes<S>,
    /// z components.
    pub z: Lanes<S>,
}

impl LaneVector<Scalar> {
    /// A single vector.
    pub fn single(vector: &Vector3<f64>) -> Self {
        LaneVector::splat(Window::single(), vector)
    }

    /// The single vector.
    pub fn vector(&self) -> Vector3<f64> {
        Vector3::new(self.x.numbers()[0], self.y.numbers()[0], self.z.numbers()[0])
    }
}

impl<S: Arithmetic> LaneVector<S> {
    /// The vectors in a window on a group.
    #[inline(always)]
    pub fn load(window: Window<S>, vectors: &EightVectors) -> Self {
        LaneVector { x: window.load(&vectors.x), y: window.load(&vectors.y), z: window.load(&vectors.z) }
    }

    /// Writes them into a window on a group.
    #[inline(always)]
    pub fn store(&self, window: Window<S>, vectors: &mut EightVectors) {
        window.store(&mut vectors.x, self.x);
        window.store(&mut vectors.y, self.y);
        window.store(&mut vectors.z, self.z);
    }

    /// Along axis 0 (x), 1 (y) or 2 (z).
    #[inline(always)]
    pub fn component(&self, axis: usize) -> Lanes<S> {
        match axis {
            0 => self.x,
            1 => self.y,
            _ => self.z,
        }
    }

    /// Vector products.
    #[inline(always)]
    pub fn cross(&self, other: &Self) -> Self {
        LaneVector {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }
}

impl<S: Arithmetic> Arrow<S> for LaneVector<S> {
    #[inline(always)]
    fn splat(window: Window<S>, vector: &Vector3<f64>) -> Self {
        LaneVector { x: window.splat(vector.x), y: window.splat(vector.y), z: window.splat(vector.z) }
    }

    #[inline(always)]
    fn dot(&self, other: &Self) -> Lanes<S> {
        self.x * other.x + self.y * other.y + self.z * other.z
    }
}

impl<S: Arithmetic> Add for LaneVector<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        LaneVector { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<S: Arithmetic> Sub for LaneVector<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        LaneVector { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl<S: Arithmetic> Mul<Lanes<S>> for LaneVector<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: Lanes<S>) -> Self {
        LaneVector { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}

impl<S: Arithmetic> PlaneVector<S> {
    /// The vectors in a window on a group, by their x and z components.
    #[inline(always)]
    pub fn load(window: Window<S>, [x, z]: [&Eight; 2]) -> Self {
        PlaneVector { x: window.load(x), z: window.load(z) }
    }

    /// Vector products, which point along y.
    #[inline(always)]
    pub fn cross(&self, other: &Self) -> Lanes<S> {
        self.z * other.x - self.x * other.z
    }

    /// The vector product of a vector along y and these: a quarter turn that takes z to x.
    #[inline(always)]
    pub fn turned_by(&self, along_y: Lanes<S>) -> Self {
        PlaneVector { x: along_y * self.z, z: -(along_y * self.x) }
    }
}

impl<S: Arithmetic> Arrow<S> for PlaneVector<S> {
    #[inline(always)]
    fn splat(window: Window<S>, vector: &Vector3<f64>) -> Self {
        PlaneVector { x: window.splat(vector.x), z: window.splat(vector.z) }
    }

    #[inline(always)]
    fn dot(&self, other: &Self) -> Lanes<S> {
        self.x * other.x + self.z * other.z
    }
}

impl<S: Arithmetic> Add for PlaneVector<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        PlaneVector { x: self.x + other.x, z: self.z + other.z }
    }
}

impl<S: Arithmetic> Sub for PlaneVector<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        PlaneVector { x: self.x - other.x, z: self.z - other.z }
    }
}

impl<S: Arithmetic> Mul<Lanes<S>> for PlaneVector<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: Lanes<S>) -> Self {
        PlaneVector { x: self.x * factor, z: self.z * factor }
    }
}

//! What computes: the machine's vectors, or arithmetic that counts what it does.
//!
//! The same formulas run with either. Counted are the multiplications of numbers in registers; those of single
//! numbers between them are not.

use std::cell::Cell;
use std::fmt::Debug;

use pulp::bytemuck::{cast_slice, cast_slice_mut};
use pulp::{Arch, Simd, WithSimd};

/// IEEE operations on all numbers of a register.
pub trait Arithmetic: Copy + Debug {
    /// A register.
    type Register: Copy + Debug;

    /// How many numbers it holds.
    const WIDTH: usize;

    /// The same number everywhere.
    fn splat(self, value: f64) -> Self::Register;
    /// Sums.
    fn add(self, a: Self::Register, b: Self::Register) -> Self::Register;
    /// Differences.
    fn subtract(self, a: Self::Register, b: Self::Register) -> Self::Register;
    /// Products.
    fn multiply(self, a: Self::Register, b: Self::Register) -> Self::Register;
    /// Quotients.
    fn divide(self, a: Self::Register, b: Self::Register) -> Self::Register;
    /// Numbers of the opposite sign.
    fn negate(self, a: Self::Register) -> Self::Register;
    /// Square roots.
    fn sqrt(self, a: Self::Register) -> Self::Register;
    /// Magnitudes.
    fn abs(self, a: Self::Register) -> Self::Register;
    /// The largest number, if all are numbers.
    fn largest(self, a: Self::Register) -> f64;
    /// The least number, if all are numbers.
    fn least(self, a: Self::Register) -> f64;
    /// Numbers as registers; what does not fill one is left out.
    fn registers(numbers: &[f64]) -> &[Self::Register];
    /// The same to be changed.
    fn registers_mut(numbers: &mut [f64]) -> &mut [Self::Register];
    /// The numbers of a register.
    fn numbers(register: &Self::Register) -> &[f64];
    /// The same to be changed.
    fn numbers_mut(register: &mut Self::Register) -> &mut [f64];
}

impl<S: Simd> Arithmetic for S {
    type Register = S::f64s;

    const WIDTH: usize = S::F64_LANES;

    #[inline(always)]
    fn splat(self, value: f64) -> S::f64s {
        self.splat_f64s(value)
    }

    #[inline(always)]
    fn add(self, a: S::f64s, b: S::f64s) -> S::f64s {
        self.add_f64s(a, b)
    }

    #[inline(always)]
    fn subtract(self, a: S::f64s, b: S::f64s) -> S::f64s {
        self.sub_f64s(a, b)
    }

    #[inline(always)]
    fn multiply(self, a: S::f64s, b: S::f64s) -> S::f64s {
        self.mul_f64s(a, b)
    }

    #[inline(always)]
    fn divide(self, a: S::f64s, b: S::f64s) -> S::f64s {
        self.div_f64s(a, b)
    }

    #[inline(always)]
    fn negate(self, a: S::f64s) -> S::f64s {
        self.neg_f64s(a)
    }

    #[inline(always)]
    fn sqrt(self, a: S::f64s) -> S::f64s {
        self.sqrt_f64s(a)
    }

    #[inline(always)]
    fn abs(self, a: S::f64s) -> S::f64s {
        self.abs_f64s(a)
    }

    #[inline(always)]
    fn largest(self, a: S::f64s) -> f64 {
        self.reduce_max_f64s(a)
    }

    #[inline(always)]
    fn least(self, a: S::f64s) -> f64 {
        self.reduce_min_f64s(a)
    }

    #[inline(always)]
    fn registers(numbers: &[f64]) -> &[S::f64s] {
        S::as_simd_f64s(numbers).0
    }

    #[inline(always)]
    fn registers_mut(numbers: &mut [f64]) -> &mut [S::f64s] {
        S::as_mut_simd_f64s(numbers).0
    }

    #[inline(always)]
    fn numbers(register: &S::f64s) -> &[f64] {
        cast_slice(std::slice::from_ref(register))
    }

    #[inline(always)]
    fn numbers_mut(register: &mut S::f64s) -> &mut [f64] {
        cast_slice_mut(std::slice::from_mut(register))
    }
}

/// One number at a time, multiplications counted.
#[derive(Clone, Copy, Debug)]
pub struct Counting<'a> {
    /// How many there were.
    pub multiplications: &'a Cell<usize>,
}

impl Arithmetic for Counting<'_> {
    type Register = f64;

    const WIDTH: usize = 1;

    fn splat(self, value: f64) -> f64 {
        value
    }

    fn add(self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn subtract(self, a: f64, b: f64) -> f64 {
        a - b
    }

    fn multiply(self, a: f64, b: f64) -> f64 {
        self.multiplications.set(self.multiplications.get() + 1);
        a * b
    }

    fn divide(self, a: f64, b: f64) -> f64 {
        a / b
    }

    fn negate(self, a: f64) -> f64 {
        -a
    }

    fn sqrt(self, a: f64) -> f64 {
        libm::sqrt(a)
    }

    fn abs(self, a: f64) -> f64 {
        a.abs()
    }

    fn largest(self, a: f64) -> f64 {
        a
    }

    fn least(self, a: f64) -> f64 {
        a
    }

    fn registers(numbers: &[f64]) -> &[f64] {
        numbers
    }

    fn registers_mut(numbers: &mut [f64]) -> &mut [f64] {
        numbers
    }

    fn numbers(register: &f64) -> &[f64] {
        std::slice::from_ref(register)
    }

    fn numbers_mut(register: &mut f64) -> &mut [f64] {
        std::slice::from_mut(register)
    }
}

/// Work that any arithmetic can do.
pub trait Work {
    /// What comes of it.
    type Output;

    /// Does it.
    fn with<S: Arithmetic>(self, arithmetic: S) -> Self::Output;
}

/// What has an arithmetic.
pub trait Machine: Copy {
    /// Lets it do some work.
    fn run<W: Work>(self, work: W) -> W::Output;
}

impl Machine for Arch {
    #[inline(always)]
    fn run<W: Work>(self, work: W) -> W::Output {
        self.dispatch(Dispatched(work))
    }
}

impl Machine for Counting<'_> {
    fn run<W: Work>(self, work: W) -> W::Output {
        work.with(self)
    }
}

/// Work as pulp wants it.
struct Dispatched<W>(W);

impl<W: Work> WithSimd for Dispatched<W> {
    type Output = W::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> W::Output {
        self.0.with(simd)
    }
}

//! Diagonal matrices times states, of which some are real and some the parts of complex ones.

use std::ops::Range;

use pulp::{Simd, WithSimd};

use crate::math::{LANES, Lanes, Window};
use crate::plant::{LinearPart, Spectrum};

/// target = base + Σ D · vector.
pub struct Combine<'a, const TERMS: usize> {
    /// Which states are complex.
    pub spectrum: &'a Spectrum,
    /// Where the sum goes.
    pub target: &'a mut [f64],
    /// What is added to.
    pub base: &'a [f64],
    /// D and the vector of each term.
    pub terms: [(&'a [f64], &'a [f64]); TERMS],
}

impl<const TERMS: usize> WithSimd for Combine<'_, TERMS> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Combine { spectrum, target, base, terms } = self;
        for range in &spectrum.real {
            let (target, base) = (&mut target[range.clone()], &base[range.clone()]);
            let terms = terms.map(|(diagonal, vector)| (&diagonal[range.clone()], &vector[range.clone()]));
            for begin in (0..whole_groups(range.len())).step_by(LANES) {
                for window in Window::all(simd) {
                    combine(window, begin..begin + LANES, target, base, terms);
                }
            }
            for i in whole_groups(range.len())..range.len() {
                combine(Window::single(), i..i + 1, target, base, terms);
            }
        }
        for (re, im) in &spectrum.complex {
            let mut target = both_mut(target, re, im);
            let base = both(base, re, im);
            let terms = terms.map(|(diagonal, vector)| [both(diagonal, re, im), both(vector, re, im)]);
            for begin in (0..whole_groups(re.len())).step_by(LANES) {
                for window in Window::all(simd) {
                    combine_complex(window, begin..begin + LANES, &mut target, base, terms);
                }
            }
            for i in whole_groups(re.len())..re.len() {
                combine_complex(Window::single(), i..i + 1, &mut target, base, terms);
            }
        }
    }
}

/// Real and imaginary parts.
type Parts<'a> = (&'a [f64], &'a [f64]);

/// How many of so many numbers fill whole groups of lanes; the rest is taken one by one. (Sharing these loops through
/// a trait costs 3 % of a step.)
#[inline(always)]
fn whole_groups(count: usize) -> usize {
    count - count % LANES
}

/// Those states that one register holds, of a group of lanes or a single one.
#[inline(always)]
fn combine<S: Simd, const TERMS: usize>(
    window: Window<S>,
    states: Range<usize>,
    target: &mut [f64],
    base: &[f64],
    terms: [(&[f64], &[f64]); TERMS],
) {
    let mut sum = window.load_slice(&base[states.clone()]);
    for (diagonal, vector) in terms {
        sum += window.load_slice(&diagonal[states.clone()]) * window.load_slice(&vector[states.clone()]);
    }
    window.store_slice(&mut target[states], sum);
}

/// The same of complex states.
#[inline(always)]
fn combine_complex<S: Simd, const TERMS: usize>(
    window: Window<S>,
    states: Range<usize>,
    target: &mut (&mut [f64], &mut [f64]),
    base: Parts,
    terms: [[Parts; 2]; TERMS],
) {
    let [mut sum_re, mut sum_im] = load_complex(window, &states, base);
    for [diagonal, vector] in terms {
        let [d_re, d_im] = load_complex(window, &states, diagonal);
        let [x_re, x_im] = load_complex(window, &states, vector);
        sum_re += d_re * x_re - d_im * x_im;
        sum_im += d_im * x_re + d_re * x_im;
    }
    window.store_slice(&mut target.0[states.clone()], sum_re);
    window.store_slice(&mut target.1[states], sum_im);
}

#[inline(always)]
fn load_complex<S: Simd>(window: Window<S>, states: &Range<usize>, (re, im): Parts) -> [Lanes<S>; 2] {
    [window.load_slice(&re[states.clone()]), window.load_slice(&im[states.clone()])]
}

/// slope −= L · (to − from).
pub struct TakeOff<'a> {
    /// Which states are complex.
    pub spectrum: &'a Spectrum,
    /// L.
    pub linear: &'a [f64],
    /// Where the state is.
    pub to: &'a [f64],
    /// Where it came from.
    pub from: &'a [f64],
    /// What the linear part is taken off.
    pub slope: &'a mut [f64],
}

impl<'a> TakeOff<'a> {
    /// Of a plant's linear part.
    #[inline(always)]
    pub fn new(linear: &'a LinearPart, to: &'a [f64], from: &'a [f64], slope: &'a mut [f64]) -> Self {
        TakeOff { spectrum: linear.spectrum(), linear: linear.diagonal(), to, from, slope }
    }
}

impl WithSimd for TakeOff<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let TakeOff { spectrum, linear, to, from, slope } = self;
        for range in &spectrum.real {
            let [linear, to, from] = [linear, to, from].map(|slice| &slice[range.clone()]);
            let slope = &mut slope[range.clone()];
            for begin in (0..whole_groups(range.len())).step_by(LANES) {
                for window in Window::all(simd) {
                    take_off(window, begin..begin + LANES, linear, [to, from], slope);
                }
            }
            for i in whole_groups(range.len())..range.len() {
                take_off(Window::single(), i..i + 1, linear, [to, from], slope);
            }
        }
        for (re, im) in &spectrum.complex {
            let [linear, to, from] = [linear, to, from].map(|slice| both(slice, re, im));
            let mut slope = both_mut(slope, re, im);
            for begin in (0..whole_groups(re.len())).step_by(LANES) {
                for window in Window::all(simd) {
                    take_off_complex(window, begin..begin + LANES, linear, [to, from], &mut slope);
                }
            }
            for i in whole_groups(re.len())..re.len() {
                take_off_complex(Window::single(), i..i + 1, linear, [to, from], &mut slope);
            }
        }
    }
}

/// Of those states that one register holds, of a group of lanes or a single one.
#[inline(always)]
fn take_off<S: Simd>(
    window: Window<S>,
    states: Range<usize>,
    linear: &[f64],
    [to, from]: [&[f64]; 2],
    slope: &mut [f64],
) {
    let [linear, to, from, left] =
        [linear, to, from, slope].map(|slice| window.load_slice(&slice[states.clone()]));
    window.store_slice(&mut slope[states], left - linear * (to - from));
}

/// The same of complex states.
#[inline(always)]
fn take_off_complex<S: Simd>(
    window: Window<S>,
    states: Range<usize>,
    linear: Parts,
    [to, from]: [Parts; 2],
    slope: &mut (&mut [f64], &mut [f64]),
) {
    let [linear, to, from] = [linear, to, from].map(|parts| load_complex(window, &states, parts));
    let (x_re, x_im) = (to[0] - from[0], to[1] - from[1]);
    let [left_re, left_im] = load_complex(window, &states, (&*slope.0, &*slope.1));
    window.store_slice(&mut slope.0[states.clone()], left_re - (linear[0] * x_re - linear[1] * x_im));
    window.store_slice(&mut slope.1[states], left_im - (linear[1] * x_re + linear[0] * x_im));
}

/// The real and the imaginary parts of complex states.
#[inline(always)]
fn both<'a>(slice: &'a [f64], re: &Range<usize>, im: &Range<usize>) -> Parts<'a> {
    (&slice[re.clone()], &slice[im.clone()])
}

/// The real and the imaginary parts of complex states, whichever stand first.
#[inline(always)]
fn both_mut<'a>(
    slice: &'a mut [f64],
    re: &Range<usize>,
    im: &Range<usize>,
) -> (&'a mut [f64], &'a mut [f64]) {
    let (before, after) = slice.split_at_mut(re.start.max(im.start));
    if re.start < im.start {
        (&mut before[re.clone()], &mut after[..im.len()])
    } else {
        (&mut after[..re.len()], &mut before[im.clone()])
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;
    use pulp::Arch;

    use super::*;
    use crate::equations::StateLayout;
    use crate::strips::InflowLayout;

    fn wave(layout: &StateLayout, phase: f64) -> Vec<f64> {
        (0..layout.len()).map(|i| libm::sin(phase + 1.7 * i as f64)).collect()
    }

    /// Each state with its place, complex ones by those of both parts.
    fn states(spectrum: &Spectrum) -> Vec<[usize; 2]> {
        let real = spectrum.real.iter().flat_map(|range| range.clone().map(|place| [place, place]));
        let complex = spectrum.complex.iter().flat_map(|(re, im)| re.clone().zip(im.clone()));
        real.chain(complex.map(|(re, im)| [re, im])).collect()
    }

    /// The state in a vector; imaginary only if it has two places.
    fn number(vector: &[f64], [re, im]: [usize; 2]) -> Complex<f64> {
        Complex::new(vector[re], if re == im { 0.0 } else { vector[im] })
    }

    #[test]
    fn sums_and_differences_are_those_of_complex_numbers_with_the_same_bits_at_every_width() {
        let layout = StateLayout::new(11, InflowLayout::new(2, 1, 2));
        let spectrum = Spectrum::new(&layout);
        let [base, d, x, e, y] = [0.0, 1.0, 2.0, 3.0, 4.0].map(|phase| wave(&layout, phase));
        let run = |arch: Arch| {
            let mut sums = vec![f64::NAN; layout.len()];
            let terms: [Parts; 2] = [(&d, &x), (&e, &y)];
            arch.dispatch(Combine { spectrum: &spectrum, target: &mut sums, base: &base, terms });
            let mut slope = base.clone();
            arch.dispatch(TakeOff { spectrum: &spectrum, linear: &d, to: &x, from: &y, slope: &mut slope });
            [sums, slope]
        };
        let [sums, slope] = run(Arch::Scalar);
        for state in states(&spectrum) {
            let [base, d, x, e, y] = [&base, &d, &x, &e, &y].map(|vector| number(vector, state));
            assert!((number(&sums, state) - (base + d * x + e * y)).norm() < 1e-15 * 4.0);
            assert!((number(&slope, state) - (base - d * (x - y))).norm() < 1e-15 * 4.0);
        }
        assert_eq!(run(Arch::new()), [sums.clone(), slope.clone()]);
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = pulp::x86::V3::try_new() {
            assert_eq!(run(Arch::V3(avx2)), [sums, slope]);
        }
    }
}

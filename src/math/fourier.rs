//! The inverse Fourier transform of a power of two of numbers, with one order of sums on every machine.

use nalgebra::Complex;

/// Σ_k x_k exp(2πi kn/N) for n = 0 … N − 1, in place, without dividing by N; N is a power of two.
///
/// Decimation in time: numbers in the order of their reversed bits, then pairs, fours, … of them are joined.
pub fn sum_of_harmonics(numbers: &mut [Complex<f64>]) {
    let count = numbers.len();
    debug_assert!(count.is_power_of_two());
    reverse_bits(numbers);
    let turns = turns(count);
    let mut size = 2;
    while size <= count {
        let (half, stride) = (size / 2, count / size);
        for block in numbers.chunks_exact_mut(size) {
            let (even, odd) = block.split_at_mut(half);
            for (place, (even, odd)) in even.iter_mut().zip(odd).enumerate() {
                let turned = *odd * turns[place * stride];
                (*even, *odd) = (*even + turned, *even - turned);
            }
        }
        size *= 2;
    }
}

/// exp(2πi n/N) for the first half of the n.
fn turns(count: usize) -> Vec<Complex<f64>> {
    let angle = |place: usize| std::f64::consts::TAU * (place as f64 / count as f64);
    let turn = |place: usize| {
        let (sin, cos) = libm::sincos(angle(place));
        Complex::new(cos, sin)
    };
    (0..count / 2).map(turn).collect()
}

fn reverse_bits<T>(numbers: &mut [T]) {
    let count = numbers.len();
    if count < 2 {
        return;
    }
    let unused = usize::BITS - count.trailing_zeros();
    for place in 0..count {
        let other = place.reverse_bits() >> unused;
        if other > place {
            numbers.swap(place, other);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_transform_is_the_sum_of_its_harmonics() {
        for count in [1, 2, 8, 64] {
            let amplitudes: Vec<Complex<f64>> = (0..count)
                .map(|k| Complex::new(libm::sin(1.0 + k as f64), libm::cos(3.0 * k as f64)))
                .collect();
            let mut found = amplitudes.clone();
            sum_of_harmonics(&mut found);
            for (n, found) in found.iter().enumerate() {
                let harmonic = |(k, amplitude): (usize, &Complex<f64>)| {
                    let (sin, cos) =
                        libm::sincos(std::f64::consts::TAU * (k * n % count) as f64 / count as f64);
                    amplitude * Complex::new(cos, sin)
                };
                let plain: Complex<f64> = amplitudes.iter().enumerate().map(harmonic).sum();
                assert!((found - plain).norm() < 1e-13, "{count}: {n}: {found} {plain}");
            }
        }
    }
}

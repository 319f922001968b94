//! Numbers over time as few shapes with a coefficient each: what is shown at thousands of moments is the motion of a dozen modes.
//!
//! value = mean + Σ coefficient · shape, shapes and coefficients as whole numbers of 16 bits with a scale. Shapes are taken one after the other
//! from what is left over, in the rounded form, so that what rounding costs is left over too and goes into the next.

/// Passes of power iteration that turn the worst row into the shape that most rows share.
const TURNS: usize = 2;

/// The largest whole number of a shape or of its coefficients.
const LARGEST: f64 = 32767.0;

/// A matrix in parts.
#[derive(Clone, Debug, PartialEq)]
pub struct LowRank {
    pub rows: usize,
    /// Of each column.
    pub mean: Vec<f32>,
    pub terms: Vec<Term>,
}

/// A shape and how much of it there is in each row.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// A number for each column.
    pub shape: Rounded,
    /// A number for each row.
    pub coefficients: Rounded,
}

/// Whole numbers with a scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Rounded {
    pub scale: f64,
    pub numbers: Vec<i16>,
}

impl Rounded {
    fn of(values: &[f64]) -> Self {
        let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let scale = if largest > 0.0 { largest / LARGEST } else { 1.0 };
        Rounded { scale, numbers: values.iter().map(|value| (value / scale).round() as i16).collect() }
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        self.numbers.iter().map(|&number| f64::from(number) * self.scale)
    }
}

impl LowRank {
    /// Of the values of a matrix, row by row, so that no column is off by more than its tolerance.
    pub fn of(values: &[f64], tolerances: &[f64]) -> Self {
        let columns = tolerances.len();
        let rows = values.len().checked_div(columns).unwrap_or(0);
        let mean: Vec<f32> = (0..columns).map(|column| mean(values, columns, column)).collect();
        let mut left = Left::new(values, &mean, tolerances);
        let mut terms = Vec::new();
        while let Some(worst) = left.worst() {
            let term = left.take(worst, tolerances);
            terms.push(term);
        }
        LowRank { rows, mean, terms }
    }

    /// A row as whoever reads it has it.
    #[cfg(test)]
    pub fn row(&self, row: usize) -> Vec<f64> {
        let mut values: Vec<f64> = self.mean.iter().map(|&mean| f64::from(mean)).collect();
        for Term { shape, coefficients } in &self.terms {
            let coefficient = f64::from(coefficients.numbers[row]) * coefficients.scale;
            values.iter_mut().zip(shape.values()).for_each(|(value, part)| *value += coefficient * part);
        }
        values
    }
}

fn mean(values: &[f64], columns: usize, column: usize) -> f32 {
    let of_column = values.iter().skip(column).step_by(columns);
    let count = of_column.len().max(1) as f64;
    (of_column.sum::<f64>() / count) as f32
}

/// What is not yet told, in tolerances of its columns.
struct Left {
    columns: usize,
    values: Vec<f64>,
}

impl Left {
    fn new(values: &[f64], mean: &[f32], tolerances: &[f64]) -> Self {
        let columns = tolerances.len();
        let by_column = mean.iter().zip(tolerances).cycle();
        let value = |(value, (&mean, tolerance)): (&f64, (&f32, &f64))| (value - f64::from(mean)) / tolerance;
        Left { columns, values: values.iter().zip(by_column).map(value).collect() }
    }

    /// The row with the largest error, if one is above its tolerance.
    fn worst(&self) -> Option<usize> {
        let (place, error) =
            self.values.iter().enumerate().fold((0, 0.0_f64), |(place, error), (at, value)| {
                if value.abs() > error { (at, value.abs()) } else { (place, error) }
            });
        (error > 1.0).then(|| place / self.columns)
    }

    /// Takes off a shape that a row has, and says how much of it there is in all rows.
    fn take(&mut self, row: usize, tolerances: &[f64]) -> Term {
        let mut direction = self.values[row * self.columns..][..self.columns].to_vec();
        for _ in 0..TURNS {
            let shares = self.along(&direction);
            direction = self.sum(&shares);
            let largest = direction.iter().fold(f64::MIN_POSITIVE, |most, part| most.max(part.abs()));
            direction.iter_mut().for_each(|part| *part /= largest);
        }
        let plain: Vec<f64> = direction.iter().zip(tolerances).map(|(part, unit)| part * unit).collect();
        let shape = Rounded::of(&plain);
        let rounded: Vec<f64> = shape.values().zip(tolerances).map(|(part, unit)| part / unit).collect();
        let square: f64 = rounded.iter().map(|part| part * part).sum();
        let shares: Vec<f64> = self.along(&rounded).iter().map(|share| share / square).collect();
        let coefficients = Rounded::of(&shares);
        for (row, coefficient) in self.values.chunks_exact_mut(self.columns).zip(coefficients.values()) {
            row.iter_mut().zip(&rounded).for_each(|(value, part)| *value -= coefficient * part);
        }
        Term { shape, coefficients }
    }

    /// The product of each row with a direction.
    fn along(&self, direction: &[f64]) -> Vec<f64> {
        let dot = |row: &[f64]| row.iter().zip(direction).map(|(value, part)| value * part).sum();
        self.values.chunks_exact(self.columns).map(dot).collect()
    }

    /// The sum of rows with these shares.
    fn sum(&self, shares: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.columns];
        for (row, share) in self.values.chunks_exact(self.columns).zip(shares) {
            sum.iter_mut().zip(row).for_each(|(sum, value)| *sum += share * value);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn largest_error(values: &[f64], tolerances: &[f64], found: &LowRank) -> f64 {
        let rows = values.chunks_exact(tolerances.len()).enumerate();
        let errors = rows.flat_map(|(row, values)| {
            let told = found.row(row).into_iter().zip(values).zip(tolerances);
            told.map(|((told, value), tolerance)| (told - value).abs() / tolerance).collect::<Vec<_>>()
        });
        errors.fold(0.0, f64::max)
    }

    /// Two waves of 40 columns, of which half are a thousand times smaller and told as much more finely.
    fn waves() -> (Vec<f64>, Vec<f64>) {
        let size = |column: usize| if column.is_multiple_of(2) { 1.0 } else { 1e-3 };
        let value = |row: usize, column: usize| {
            let (time, place) = (row as f64 * 0.02, column as f64 / 40.0);
            size(column) * (3.0 * time.sin() * place * place + 0.2 * (7.0 * time).cos() * (5.0 * place).sin())
        };
        let values = (0..500).flat_map(|row| (0..40).map(move |column| value(row, column))).collect();
        (values, (0..40).map(|column| 2e-4 * size(column)).collect())
    }

    #[test]
    fn rounded_numbers_are_within_the_tolerance_of_each_column() {
        let (values, tolerances) = waves();
        let found = LowRank::of(&values, &tolerances);
        assert!(largest_error(&values, &tolerances, &found) <= 1.0 + 1e-9);
        assert!((2..=6).contains(&found.terms.len()), "{}", found.terms.len());
    }

    #[test]
    fn a_long_way_is_told_to_a_fraction_of_a_millimetre() {
        let values: Vec<f64> =
            (0..3000).flat_map(|row| [f64::from(row) * 3.1, 0.0, -7620.0 + f64::from(row).sin()]).collect();
        let tolerances = [2e-4; 3];
        let found = LowRank::of(&values, &tolerances);
        assert!(largest_error(&values, &tolerances, &found) <= 1.0 + 1e-9);
        assert!(found.terms.len() <= 6, "{}", found.terms.len());
    }

    #[test]
    fn numbers_without_any_pattern_are_told_too() {
        let mut seed = 1_u32;
        let mut number = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed) / f64::from(u32::MAX) - 0.5
        };
        let values: Vec<f64> = (0..30 * 8).map(|_| number()).collect();
        let found = LowRank::of(&values, &[1e-5; 8]);
        assert!(largest_error(&values, &[1e-5; 8], &found) <= 1.0 + 1e-9);
    }

    #[test]
    fn what_stays_has_no_shapes_and_nothing_at_all_is_told_as_nothing() {
        let found = LowRank::of(&[0.5, -0.25, 0.5, -0.25], &[1e-6; 2]);
        assert_eq!((found.rows, found.mean.as_slice(), found.terms.len()), (2, [0.5, -0.25].as_slice(), 0));
        assert_eq!(LowRank::of(&[], &[]), LowRank { rows: 0, mean: Vec::new(), terms: Vec::new() });
    }
}

//! The points of a sweep: each a function of its number alone [theory: sweeps.points, sweeps.random].

use flexible_aircraft::math::{mix, normal_number, unit_number};

/// How a quantity varies.
#[derive(Clone, Debug, PartialEq)]
pub enum Axis {
    /// It takes these values, with all those of the other grids.
    Grid(Vec<f64>),
    /// Anything between two numbers, as likely.
    Uniform { least: f64, most: f64 },
    /// A normal distribution.
    Normal { mean: f64, deviation: f64 },
}

/// All points.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    axes: Vec<Axis>,
    /// Of the grid, and with random axes at each of its points.
    grid: u64,
    samples: u64,
    seed: u64,
}

impl Axis {
    fn length(&self) -> Option<u64> {
        match self {
            Axis::Grid(values) => Some(values.len() as u64),
            Axis::Uniform { .. } | Axis::Normal { .. } => None,
        }
    }

    pub fn is_random(&self) -> bool {
        self.length().is_none()
    }
}

impl Points {
    /// Of axes, with so many samples at each point of the grid, 1 where nothing is random; `None` where their number is
    /// beyond all numbers.
    pub fn new(axes: Vec<Axis>, samples: u64, seed: u64) -> Option<Self> {
        let lengths = axes.iter().filter_map(Axis::length);
        let grid = lengths.into_iter().try_fold(1, u64::checked_mul)?;
        grid.checked_mul(samples)?;
        Some(Points { axes, grid, samples, seed })
    }

    pub fn count(&self) -> u64 {
        self.grid * self.samples
    }

    /// What each axis has at a point, in their order. The first grid changes slowest, the samples fastest.
    pub fn values(&self, point: u64) -> Vec<f64> {
        let mut values = vec![0.0; self.axes.len()];
        let mut rest = point / self.samples;
        let stream = mix(mix(self.seed).wrapping_add(point));
        for (place, axis) in self.axes.iter().enumerate().rev() {
            let random = stream.wrapping_add(2 * place as u64);
            values[place] = match axis {
                Axis::Grid(numbers) => {
                    let length = numbers.len() as u64;
                    let digit = rest % length;
                    rest /= length;
                    numbers[digit as usize]
                }
                Axis::Uniform { least, most } => least + (most - least) * unit_number(random),
                Axis::Normal { mean, deviation } => mean + deviation * normal_number(random),
            };
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_has_every_combination_once_and_its_first_axis_is_the_slowest() {
        let points = Points::new(vec![Axis::Grid(vec![1.0, 2.0]), Axis::Grid(vec![5.0, 6.0, 7.0])], 1, 1);
        let points = points.unwrap();
        let all: Vec<Vec<f64>> = (0..points.count()).map(|point| points.values(point)).collect();
        assert_eq!(all, [[1.0, 5.0], [1.0, 6.0], [1.0, 7.0], [2.0, 5.0], [2.0, 6.0], [2.0, 7.0]]);
    }

    #[test]
    fn samples_are_taken_at_each_point_of_the_grid_and_differ_there() {
        let axes = vec![Axis::Uniform { least: 2.0, most: 4.0 }, Axis::Grid(vec![1.0, 2.0])];
        let points = Points::new(axes, 3, 1).unwrap();
        let all: Vec<Vec<f64>> = (0..points.count()).map(|point| points.values(point)).collect();
        assert_eq!(all.iter().map(|values| values[1]).collect::<Vec<_>>(), [1.0, 1.0, 1.0, 2.0, 2.0, 2.0]);
        let mut random: Vec<f64> = all.iter().map(|values| values[0]).collect();
        random.sort_by(f64::total_cmp);
        random.dedup();
        assert!(random.len() == 6 && random.iter().all(|number| (2.0..4.0).contains(number)), "{random:?}");
    }

    /// Of a program of its own (Python) that shares nothing with this one: mix(mix(7) + point) + 2 axis is the place.
    #[test]
    fn seed_point_and_axis_make_a_random_number_and_nothing_else_does() {
        let axes = vec![
            Axis::Uniform { least: -1.0, most: 3.0 },
            Axis::Grid(vec![0.0]),
            Axis::Normal { mean: 10.0, deviation: 2.0 },
        ];
        let points = Points::new(axes, 1_000_000, 7).unwrap();
        let expected = [
            (0, [1.437_578_098_272_7, 12.718_710_254_953_436]),
            (1, [2.934_228_453_348_08, 8.900_464_039_406_645]),
            (999_999, [0.171_182_047_303_540_59, 11.680_742_868_883_257]),
        ];
        for (point, [uniform, normal]) in expected {
            let found = points.values(point);
            assert!(
                (found[0] - uniform).abs() < 1e-14 && (found[2] - normal).abs() < 1e-13,
                "{point}: {found:?}"
            );
        }
    }

    #[test]
    fn many_samples_have_the_mean_and_the_deviation_asked_for() {
        let axes = vec![Axis::Normal { mean: 1.0, deviation: 0.5 }, Axis::Uniform { least: 0.0, most: 1.0 }];
        let count = 100_000;
        let points = Points::new(axes, count, 3).unwrap();
        let all: Vec<Vec<f64>> = (0..count).map(|point| points.values(point)).collect();
        for (axis, mean, deviation) in [(0, 1.0, 0.5), (1, 0.5, 1.0 / 12_f64.sqrt())] {
            let found = all.iter().map(|values| values[axis]).sum::<f64>() / count as f64;
            let square = all.iter().map(|values| (values[axis] - mean).powi(2)).sum::<f64>() / count as f64;
            // Of so many numbers the mean departs by 0.003 deviations, the deviation by 0.002.
            assert!((found - mean).abs() < 0.015 * deviation, "{axis}: {found}");
            assert!((square.sqrt() / deviation - 1.0).abs() < 0.01, "{axis}: {square}");
        }
    }

    #[test]
    fn more_points_than_can_be_counted_are_none() {
        let axes = vec![Axis::Grid(vec![0.0; 1 << 16]); 4];
        assert_eq!(Points::new(axes, 1, 1), None);
    }
}

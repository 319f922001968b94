//! Times of a flight: whole cells of the grid since its start, and a part of one [theory: integration.grid].
//!
//! The grid begins where the flight does, and a time is counted in its cells. So it is as exact after a year as in the
//! first second, and a flight that starts at 1.7e9 s, a calendar's time, is the flight that starts at 0, bit for bit.

/// Width of a grid cell, s: the usual communication step. In the standard flight of README.md one step over it keeps
/// pitch, wing tip and load factor within 2e-6 of their peaks; the error control halves from there.
pub(super) const CELL: f64 = 10e-3;

/// Communication points this close to a grid point, s, are on it.
pub(super) const ON_GRID: f64 = 1e-6 * CELL;

/// Times beyond this, s, leave too few digits to tell the cells of the grid apart: doubles there are 1.2e-4 s apart.
pub const LATEST: f64 = 1e12;

/// Longest step, s: a day. It is flown in minutes; beyond, a slip of the unit or a time taken for a step size would keep
/// its caller waiting for hours or for ever.
pub const LONGEST_STEP: f64 = 86_400.0;

/// What the time of a communication point carries, s: masters add up steps and round them to doubles, the spacing of
/// which is 2.4e-7 s at 1.7e9 s.
pub fn resolution(time: f64) -> f64 {
    1e-9 + 4.0 * f64::EPSILON * time.abs()
}

/// A time since the start of a flight.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) struct Moment {
    /// Whole cells: a natural number.
    cells: f64,
    /// What follows them, s, less than a cell.
    part: f64,
}

impl Moment {
    /// The start.
    pub const START: Moment = Moment { cells: 0.0, part: 0.0 };

    /// A time after the start (s), on the grid if that is within what is known of it (s); the start if it is before.
    pub fn after_start(elapsed: f64, resolution: f64) -> Self {
        let elapsed = elapsed.max(0.0);
        let nearest = libm::round(elapsed / CELL);
        if (elapsed - nearest * CELL).abs() <= resolution.max(ON_GRID) {
            return Moment { cells: nearest, part: 0.0 };
        }
        let cells = libm::floor(elapsed / CELL);
        Moment { cells, part: (elapsed - cells * CELL).max(0.0) }
    }

    /// As it stands in snapshots: whole cells, and s.
    pub fn numbers(self) -> [f64; 2] {
        [self.cells, self.part]
    }

    /// From what [`numbers`](Self::numbers) has written, if it can have.
    pub fn from_numbers([cells, part]: [f64; 2]) -> Option<Self> {
        let is_natural = (0.0..=2.0 * LATEST / CELL).contains(&cells) && libm::floor(cells) == cells;
        (is_natural && (0.0..CELL).contains(&part)).then_some(Moment { cells, part })
    }

    /// Whether a cell begins there.
    pub fn is_on_grid(self) -> bool {
        self.part == 0.0
    }

    /// How many cells a time (s) is that is a multiple of theirs.
    pub fn cells_in(period: f64) -> f64 {
        libm::round(period / CELL)
    }

    /// Whether whole periods of so many cells have passed.
    pub fn is_on_grid_of(self, period: f64) -> bool {
        self.part == 0.0 && self.cells % period == 0.0
    }

    /// How many whole periods of so many cells have passed.
    pub fn whole(self, period: f64) -> u64 {
        libm::floor(self.cells / period) as u64
    }

    /// s after the start.
    pub fn seconds(self) -> f64 {
        self.cells * CELL + self.part
    }

    /// s after another one.
    pub fn since(self, earlier: Moment) -> f64 {
        (self.cells - earlier.cells) * CELL + (self.part - earlier.part)
    }

    /// Where the cell ends that it is in or begins.
    pub fn cell_end(self) -> Moment {
        Moment { cells: self.cells + 1.0, part: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_close_to_the_grid_is_on_it_and_others_are_kept() {
        for (elapsed, resolution, expected) in [
            (0.0, 1e-9, [0.0, 0.0]),
            (-3.0, 1e-9, [0.0, 0.0]),
            (0.3, 1e-9, [30.0, 0.0]),
            (0.3 - 9e-9, 1e-9, [30.0, 0.0]),
            (0.3 + 2e-7, 1e-6, [30.0, 0.0]),
            (0.25e-2, 1e-9, [0.0, 0.25e-2]),
            (1e12, 5e-4, [1e14, 0.0]),
        ] {
            let moment = Moment::after_start(elapsed, resolution);
            assert_eq!(moment.numbers(), expected, "{elapsed}");
            assert_eq!(Moment::from_numbers(expected), Some(moment));
        }
        let [cells, part] = Moment::after_start(0.3 - 2e-7, 1e-9).numbers();
        assert!(cells == 29.0 && (part - (CELL - 2e-7)).abs() < 1e-15, "{part}");
    }

    #[test]
    fn cells_are_as_wide_after_a_year_as_at_the_start() {
        for elapsed in [0.0, 512.0, 3.2e7, 1e12] {
            let begin = Moment::after_start(elapsed, resolution(elapsed));
            assert_eq!(begin.cell_end().since(begin).to_bits(), CELL.to_bits(), "{elapsed}");
            assert!(begin < begin.cell_end() && begin.seconds() <= begin.cell_end().seconds());
        }
    }

    #[test]
    fn numbers_that_are_no_moment_are_refused() {
        for numbers in [[-1.0, 0.0], [0.5, 0.0], [1.0, CELL], [1.0, -1e-9], [f64::NAN, 0.0], [1e300, 0.0]] {
            assert_eq!(Moment::from_numbers(numbers), None, "{numbers:?}");
        }
    }
}

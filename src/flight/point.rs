//! Where a flight stands, and where its cell of time begins.

use std::mem::swap;

use super::acting::Acting;
use super::moment::Moment;

/// A place on the flight path, with what the integrator needs to go on from it.
#[derive(Clone, Debug)]
pub(super) struct Point {
    /// When.
    pub time: Moment,
    /// All states of the equations that fly, in the axes of the course.
    pub state: Vec<f64>,
    /// What lags behind the inputs.
    pub acting: Acting,
    /// Sub-steps to try in the next cell.
    pub substeps: u32,
    /// f at the time and state under the present inputs.
    pub slope: Vec<f64>,
    /// Whether `slope` is that.
    pub slope_is_fresh: bool,
}

impl Point {
    /// With room for a state of some length.
    pub fn new(time: Moment, state: &[f64], acting: &Acting, room: usize) -> Self {
        let with_room = |numbers: &[f64]| {
            let mut vector = Vec::with_capacity(room);
            vector.extend_from_slice(numbers);
            vector
        };
        let slope = with_room(&vec![0.0; state.len()]);
        let (state, acting) = (with_room(state), acting.clone());
        Point { time, state, acting, substeps: 1, slope, slope_is_fresh: false }
    }

    /// Takes the place of another point, in the room that it has; the slope there is not known.
    fn stand_at(&mut self, other: &Point) {
        self.time = other.time;
        self.state.clone_from(&other.state);
        self.acting.take_from(&other.acting);
        self.substeps = other.substeps;
        self.slope.resize(other.slope.len(), 0.0);
        self.slope_is_fresh = false;
    }

    /// The slope is no longer known, nor need the state be as long as it was.
    pub fn forget_slope(&mut self) {
        self.slope.resize(self.state.len(), 0.0);
        self.slope_is_fresh = false;
    }

    /// Takes a state of another length.
    pub fn resize(&mut self, length: usize) {
        self.state.resize(length, 0.0);
        self.forget_slope();
    }
}

/// The present of a flight and its anchor: where the present cell of time begins.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// Where the flight is.
    pub present: Point,
    /// Where the cell begins, unless that is the present.
    origin: Point,
    /// Whether it is.
    begins_here: bool,
    /// What present and origin were when they were last kept.
    before: [Point; 2],
    /// Whether the cell began at the present then.
    began_here: bool,
}

impl Path {
    /// At its beginning, with room for states of some length.
    pub fn new(time: Moment, state: &[f64], acting: &Acting, room: usize) -> Self {
        let point = Point::new(time, state, acting, room);
        let again = || Point::new(time, state, acting, room);
        Path {
            present: point,
            origin: again(),
            begins_here: true,
            before: [again(), again()],
            began_here: true,
        }
    }

    /// Where the cell begins.
    pub fn anchor(&self) -> &Point {
        if self.begins_here { &self.present } else { &self.origin }
    }

    /// Whether the cell begins at the present.
    pub fn begins_here(&self) -> bool {
        self.begins_here
    }

    /// Lets the cell begin at the present.
    pub fn begin_here(&mut self) {
        self.begins_here = true;
    }

    /// The anchor, and the present that is to be overwritten with what is flown to.
    pub fn set_off(&mut self) -> (&mut Point, &mut Point) {
        if self.begins_here {
            swap(&mut self.origin, &mut self.present);
            self.begins_here = false;
        }
        (&mut self.origin, &mut self.present)
    }

    /// Undoes the last cell, which set off from what then was the present.
    pub fn turn_back(&mut self) {
        swap(&mut self.origin, &mut self.present);
        self.begins_here = true;
    }

    /// Keeps everything as it is now.
    pub fn keep(&mut self) {
        let Path { present, origin, before: [present_before, origin_before], .. } = self;
        present_before.stand_at(present);
        origin_before.stand_at(origin);
        self.began_here = self.begins_here;
    }

    /// Goes back to what was kept.
    pub fn restore_kept(&mut self) {
        let Path { present, origin, before: [present_before, origin_before], .. } = self;
        present.stand_at(present_before);
        origin.stand_at(origin_before);
        self.begins_here = self.began_here;
    }

    /// Present and origin.
    pub fn points_mut(&mut self) -> [&mut Point; 2] {
        [&mut self.present, &mut self.origin]
    }

    /// What lags at present, and the states of present and origin.
    pub fn acting_and_states(&mut self) -> (&Acting, [&mut Vec<f64>; 2]) {
        let Path { present: Point { state, acting, .. }, origin, .. } = self;
        (acting, [state, &mut origin.state])
    }

    /// Takes times and sub-steps of the next cell at anchor and present, whose states are set by
    /// [`points_mut`](Self::points_mut).
    pub fn stand(&mut self, [anchor, present]: [(Moment, u32); 2]) {
        (self.origin.time, self.origin.substeps) = anchor;
        (self.present.time, self.present.substeps) = present;
        self.begins_here = anchor.0 == present.0;
    }
}

//! From O outward: where all sections are, how they move, and their twists by each generalised coordinate.
//!
//! [theory: geometrically-exact.recursion, geometrically-exact.rates, geometrically-exact.biases, geometrically-exact.jacobians]

use nalgebra::{Matrix3, Vector3};

use crate::math::{AlignedNumbers, Arithmetic, Eight, LANES, Window, zeros};
use crate::structure::BeamSection;

use super::super::kind::Coordinates;
use super::step::{EightConstants, EightMatrices, EightSteps};

/// What of the sections is constant.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The section before each, O's own for the first.
    parents: Vec<usize>,
    /// All but O's own, eight by eight.
    constants: Vec<EightConstants>,
    /// Dλ and Dφ of each section as rows over the modes.
    steps: Rows,
}

/// Six rows over the modes for each section, each padded to whole groups of lanes.
#[derive(Clone, Debug)]
pub struct Rows {
    width: usize,
    numbers: AlignedNumbers,
}

/// A section at an instant, relative to the body axes.
#[derive(Clone, Copy, Debug)]
pub struct Moving {
    /// R.
    pub turn: Matrix3<f64>,
    /// x, m.
    pub position: Vector3<f64>,
    /// w, m/s.
    pub velocity: Vector3<f64>,
    /// σ, rad/s.
    pub spin: Vector3<f64>,
    /// a, m/s².
    pub acceleration: Vector3<f64>,
    /// α, rad/s².
    pub angular_acceleration: Vector3<f64>,
}

/// All sections at an instant.
#[derive(Clone, Debug)]
pub struct MovingTree {
    steps: Vec<EightSteps>,
    /// Each section.
    pub sections: Vec<Moving>,
    /// J°_x, J°_y, J°_z, S_x, S_y, S_z of each section.
    pub twists: Rows,
}

impl Rows {
    /// Zeros.
    fn new(sections: usize, modes: usize) -> Self {
        let width = modes.next_multiple_of(LANES);
        Rows { width, numbers: zeros(6 * width * sections) }
    }

    /// Length of a row with what stands beyond the modes.
    #[inline(always)]
    pub fn width(&self) -> usize {
        self.width
    }

    /// The six rows of a section, one after the other.
    #[inline(always)]
    pub fn of(&self, section: usize) -> &[f64] {
        &self.numbers[6 * self.width * section..][..6 * self.width]
    }

    #[inline(always)]
    fn split(&mut self, section: usize) -> (&[f64], &mut [f64]) {
        let (before, own) = self.numbers.split_at_mut(6 * self.width * section);
        (before, &mut own[..6 * self.width])
    }
}

impl Moving {
    /// At rest.
    fn resting(position: Vector3<f64>) -> Self {
        let zero = Vector3::zeros();
        Moving {
            turn: Matrix3::identity(),
            position,
            velocity: zero,
            spin: zero,
            acceleration: zero,
            angular_acceleration: zero,
        }
    }

    /// What is fixed to the section at an offset [theory: geometrically-exact.attached].
    #[inline(always)]
    pub fn with_offset(&self, offset: &Vector3<f64>) -> Self {
        let arm = self.turn * offset;
        let circling = self.spin.cross(&arm);
        Moving {
            position: self.position + arm,
            velocity: self.velocity + circling,
            acceleration: self.acceleration
                + self.angular_acceleration.cross(&arm)
                + self.spin.cross(&circling),
            ..*self
        }
    }
}

impl Tree {
    /// Of sections, each after its parent, with the shapes of so many modes.
    pub fn new(sections: &[&BeamSection], parents: Vec<usize>, modes: usize) -> Self {
        let mut steps = Rows::new(sections.len(), modes);
        for (place, section) in sections.iter().enumerate() {
            let (_, own) = steps.split(place);
            for (row, own) in own.chunks_exact_mut(modes.next_multiple_of(LANES).max(1)).enumerate() {
                own[..modes].copy_from_slice(section.steps.row(row));
            }
        }
        let arms = sections.iter().zip(&parents);
        let arms: Vec<_> =
            arms.map(|(own, &parent)| (*own, own.position - sections[parent].position)).collect();
        let constants = arms[1..].chunks(LANES).map(|eight| EightConstants::new(eight, modes)).collect();
        Tree { parents, constants, steps }
    }

    /// Room for an evaluation; O's own section rests there.
    pub fn at_rest(&self, position: Vector3<f64>, modes: usize) -> MovingTree {
        MovingTree {
            steps: vec![EightSteps::NONE; self.constants.len()],
            sections: vec![Moving::resting(position); self.parents.len()],
            twists: Rows::new(self.parents.len(), modes),
        }
    }

    /// Writes all sections at some q and q̇.
    #[inline(always)]
    pub fn write<S: Arithmetic>(&self, simd: S, at: Coordinates, moving: &mut MovingTree) {
        for (constants, steps) in self.constants.iter().zip(&mut moving.steps) {
            constants.write(simd, at, steps);
        }
        for (section, &parent) in self.parents.iter().enumerate().skip(1) {
            let step = Step { eight: &moving.steps[(section - 1) / LANES], lane: (section - 1) % LANES };
            let before = moving.sections[parent];
            let own = before.after(step);
            moving.sections[section] = own;
            let tangent = before.turn * step.matrix(&step.eight.tangent);
            let bend = before.turn * step.matrix(&step.eight.bend) + own.position.cross_matrix() * tangent;
            let (twists, own) = moving.twists.split(section);
            let before = &twists[own.len() * parent..][..own.len()];
            add_steps(simd, [before, self.steps.of(section)], [&bend, &tangent], own);
        }
    }
}

/// The step to one of eight sections.
#[derive(Clone, Copy)]
struct Step<'a> {
    eight: &'a EightSteps,
    lane: usize,
}

impl Step<'_> {
    #[inline(always)]
    fn vector(self, eight: &[Eight; 3]) -> Vector3<f64> {
        Vector3::from(eight.each_ref().map(|component| component.0[self.lane]))
    }

    #[inline(always)]
    fn matrix(self, columns: &EightMatrices) -> Matrix3<f64> {
        Matrix3::from_columns(&columns.each_ref().map(|column| self.vector(column)))
    }
}

impl Moving {
    /// The section that a step leads to.
    #[inline(always)]
    fn after(&self, step: Step) -> Self {
        let Moving { turn, position, velocity, spin, acceleration, angular_acceleration } = self;
        let [distance, stretching, turning, bias, spin_bias] = {
            let EightSteps { distance, velocity, spin, bias, spin_bias, .. } = step.eight;
            [distance, velocity, spin, bias, spin_bias].map(|vectors| turn * step.vector(vectors))
        };
        let circling = spin.cross(&distance);
        Moving {
            turn: turn * step.matrix(&step.eight.turn),
            position: position + distance,
            velocity: velocity + circling + stretching,
            spin: spin + turning,
            acceleration: acceleration
                + angular_acceleration.cross(&distance)
                + spin.cross(&(circling + stretching * 2.0))
                + bias,
            angular_acceleration: angular_acceleration + spin.cross(&turning) + spin_bias,
        }
    }
}

/// Writes the twists of a section: those of the one before it, and what its own steps Dλ and Dφ add by C and A.
#[inline(always)]
fn add_steps<S: Arithmetic>(
    simd: S,
    [before, steps]: [&[f64]; 2],
    [bend, tangent]: [&Matrix3<f64>; 2],
    own: &mut [f64],
) {
    let width = own.len() / 6;
    for first in (0..width).step_by(LANES) {
        for window in Window::all(simd) {
            let load = |rows: &[f64], row: usize| window.load_slice(&rows[row * width + first..][..LANES]);
            let [slides, turns] = [0, 3].map(|row| [0, 1, 2].map(|axis| load(steps, row + axis)));
            for axis in 0..3 {
                let product = |matrix: &Matrix3<f64>, [x, y, z]: [_; 3]| {
                    x * matrix[(axis, 0)] + y * matrix[(axis, 1)] + z * matrix[(axis, 2)]
                };
                let translation = load(before, axis) + product(bend, turns) + product(tangent, slides);
                let rotation = load(before, 3 + axis) + product(tangent, turns);
                window.store_slice(&mut own[axis * width + first..][..LANES], translation);
                window.store_slice(&mut own[(3 + axis) * width + first..][..LANES], rotation);
            }
        }
    }
}

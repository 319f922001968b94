//! What bend–twist coupling changes of a trimmed wing, by the statics of a beam under strips: to the first order of all angles, from the loads
//! that the wing carries without it. Strips stand one on each element, in its middle.

use flexible_aircraft::aircraft::{Aircraft, Strip};
use flexible_aircraft::equations::SectionLoads;
use nalgebra::{DMatrix, DVector, Vector3};

/// Half of an element, between which and the other half the loads of the element act.
#[derive(Clone, Copy)]
struct Half {
    middle: Vector3<f64>,
    length: f64,
    /// Local x, and local y to the leading edge.
    along: Vector3<f64>,
    forward: Vector3<f64>,
    /// EI of w″ and GJ.
    stiffness: [f64; 2],
}

/// Bending that raises the tip, and torque about local x.
type Moments = [f64; 2];

impl Half {
    fn resolve(&self, moment: Vector3<f64>) -> Moments {
        [-self.forward.dot(&moment), self.along.dot(&moment)]
    }

    /// How far it turns the strips beyond it nose-up, about body y, with K = share · EI: by twist about x and by −w′ about y.
    fn turn(&self, share: f64, [bending, torque]: Moments) -> f64 {
        let [ei, gj] = self.stiffness;
        let k = share * ei;
        let determinant = ei * gj - k * k;
        let (curvature, twist) =
            ((gj * bending - k * torque) / determinant, (ei * torque - k * bending) / determinant);
        (self.along.y * twist - self.forward.y * curvature) * self.length
    }
}

/// A right wing of an aircraft that flies level: what a lift does at a place, and how much of it an angle makes.
pub struct Wing<'l> {
    halves: Vec<Half>,
    /// Where the lift of each strip acts, at its quarter chord, and its slope, N/rad.
    strips: Vec<(Vector3<f64>, f64)>,
    /// At all nodes, without coupling.
    base: &'l [SectionLoads],
    /// K/EI.
    share: f64,
}

impl<'l> Wing<'l> {
    /// Of an aircraft without coupling, at a dynamic pressure, Pa.
    pub fn new(
        aircraft: &Aircraft,
        component: &str,
        pressure: f64,
        share: f64,
        base: &'l [SectionLoads],
    ) -> Self {
        let beams = aircraft.beams.iter().enumerate().filter(|(_, beam)| beam.component == component);
        let (mut halves, mut strips) = (Vec::new(), Vec::new());
        for (index, beam) in beams {
            let [from, to] = beam.nodes.map(|node| aircraft.nodes[node]);
            let half = |at: f64| Half {
                middle: from + (to - from) * at,
                length: 0.5 * (to - from).norm(),
                along: (to - from).normalize(),
                forward: beam.y_axis,
                stiffness: [beam.bending_stiffness_y, beam.torsional_stiffness],
            };
            halves.extend([0.25, 0.75].map(half));
            let own = |strip: &Strip| strip.attachment.beam == index && strip.attachment.fraction == 0.5;
            strips.extend(aircraft.strips.iter().filter(|strip| own(strip)).map(|strip| {
                let ahead = 0.5 * strip.semichord + strip.elastic_axis_aft_of_midchord;
                let slope = pressure * 2.0 * strip.semichord * strip.width * strip.lift_slope;
                ((from + to) * 0.5 + Vector3::x() * ahead, slope)
            }));
        }
        assert_eq!((halves.len(), base.len()), (2 * strips.len(), strips.len() + 1));
        Wing { halves, strips, base, share }
    }

    /// What a strip's lift does at a place.
    fn by_lift(&self, strip: usize, half: &Half) -> Moments {
        half.resolve((self.strips[strip].0 - half.middle).cross(&-Vector3::z()))
    }

    /// The angle beyond so many halves, by which coupling turns the wing under the base loads.
    fn turned(&self, halves: usize) -> f64 {
        let of_half = |place: usize| {
            let [inboard, outboard] = [place / 2, place / 2 + 1].map(|node| &self.base[node]);
            let share = 0.25 + 0.5 * (place % 2) as f64;
            let between = |inboard: f64, outboard: f64| inboard + (outboard - inboard) * share;
            let moments =
                [between(inboard.bending, outboard.bending), between(inboard.torsion, outboard.torsion)];
            let half = &self.halves[place];
            half.turn(self.share, moments) - half.turn(0.0, moments)
        };
        (0..halves).map(of_half).sum()
    }

    /// The same by the lift of a strip, N, of what coupling makes of it.
    fn turned_by_lift(&self, halves: usize, strip: usize) -> f64 {
        let inboard = &self.halves[..halves.min(2 * strip + 1)];
        inboard.iter().map(|half| half.turn(self.share, self.by_lift(strip, half))).sum()
    }

    /// What coupling makes of the root's bending, as a ratio, and of the twist of the tip, rad, where a tail at this x keeps the balance of
    /// forces and moments.
    pub fn coupled(&self, tail: f64) -> [f64; 2] {
        let count = self.strips.len();
        // Lift of each strip of this side, that of the tail, and the angle of the aircraft.
        let (mut matrix, mut right) =
            (DMatrix::<f64>::zeros(count + 2, count + 2), DVector::<f64>::zeros(count + 2));
        for (strip, (place, slope)) in self.strips.iter().enumerate() {
            right[strip] = slope * self.turned(2 * strip + 1);
            for other in 0..count {
                matrix[(strip, other)] = -slope * self.turned_by_lift(2 * strip + 1, other);
            }
            matrix[(strip, strip)] += 1.0;
            matrix[(strip, count + 1)] = -slope;
            (matrix[(count, strip)], matrix[(count + 1, strip)]) = (2.0, 2.0 * place.x);
        }
        (matrix[(count, count)], matrix[(count + 1, count)]) = (1.0, tail);
        let lifts = matrix.lu().solve(&right).unwrap();
        let root = Half { middle: self.base[0].position, ..self.halves[0] };
        let bending: f64 = (0..count).map(|strip| self.by_lift(strip, &root)[0] * lifts[strip]).sum();
        let twist: f64 = (0..count).map(|strip| self.turned_by_lift(2 * count, strip) * lifts[strip]).sum();
        [1.0 + bending / self.base[0].bending, self.turned(2 * count) + twist]
    }
}

//! A rod in Kirchhoff's sense that stands out of a wall in a steady flow, by moments and curvatures alone: no modes, no
//! elements, nothing of the library.
//!
//! From a shape follow the loads, from them the moment at each place, from that the curvature, from that the shape; and
//! so on until nothing changes. The air's loads on a metre of span are, with U = f·V and w = n·V,
//!
//! ```text
//! −(ρbUCLα w + CD0 ρb|V| w) n + (η ρbCLα w² − CD0 ρb|V| U) f,    about s: (e − ¼) c ρbUCLα w
//! ```

use nalgebra::{Rotation3, Vector3};

/// Pieces of equal length, each of one curvature.
const PIECES: usize = 200;
/// The share of the change that each round makes: all of it would swing ever farther.
const SHARE: f64 = 0.3;
/// Rounds after which something is wrong.
const MOST_ROUNDS: usize = 1000;

/// A uniform wing whose lift may vary along the span, with its air: SI units.
pub struct Rod {
    pub length: f64,
    pub chord: f64,
    /// Behind the leading edge, of the chord.
    pub elastic_axis: f64,
    /// About the chord (up), the span (twist), the normal (in the plane of the chord).
    pub stiffness: Vector3<f64>,
    pub mass_per_length: f64,
    /// Centre of mass from the elastic axis, forward, of the chord.
    pub centre_of_mass: f64,
    pub tip_mass: f64,
    /// CLα and η at a fraction of the span.
    pub lift_slope: fn(f64) -> f64,
    pub suction: fn(f64) -> f64,
    pub profile_drag: f64,
    pub density: f64,
    pub gravity: f64,
    /// Of the root's chord, nose up, rad.
    pub incidence: f64,
}

impl Rod {
    /// The wing of Patil, Hodges and Cesnik (J. Aircraft 38 (2001) 88) with full suction.
    pub fn patils(density: f64, incidence: f64) -> Self {
        Rod {
            length: 16.0,
            chord: 1.0,
            elastic_axis: 0.5,
            stiffness: Vector3::new(2e4, 1e4, 4e6),
            mass_per_length: 0.75,
            centre_of_mass: 0.0,
            tip_mass: 0.0,
            lift_slope: |_| std::f64::consts::TAU,
            suction: |_| 1.0,
            profile_drag: 0.0,
            density,
            gravity: 9.80665,
            incidence,
        }
    }
}

/// A piece where it is: its middle, its turn, the force and the moment about its middle.
#[derive(Clone, Copy)]
struct Piece {
    middle: Vector3<f64>,
    turn: Rotation3<f64>,
    force: Vector3<f64>,
    moment: Vector3<f64>,
}

impl Rod {
    /// Displacement of the tip at rest: forward, outboard, up of the root's chord, m.
    pub fn tip(&self, airspeed: f64) -> Vector3<f64> {
        let mut curvatures = vec![Vector3::zeros(); PIECES];
        for _ in 0..MOST_ROUNDS {
            let (pieces, tip) = self.shape(&curvatures, airspeed);
            let next = self.curvatures(&pieces, &tip);
            let change =
                curvatures.iter().zip(&next).map(|(old, new)| (new - old).amax()).fold(0.0, f64::max);
            curvatures.iter_mut().zip(&next).for_each(|(old, new)| *old += (new - *old) * SHARE);
            if change * self.length < 1e-11 {
                let tip = self.root().inverse() * (tip - Vector3::y() * self.length);
                return Vector3::new(tip.x, tip.y, -tip.z);
            }
        }
        panic!("the rod does not come to rest at {airspeed} m/s");
    }

    /// Nose-up about the span, from axes that are level and head into the flow.
    fn root(&self) -> Rotation3<f64> {
        Rotation3::from_axis_angle(&Vector3::y_axis(), self.incidence)
    }

    /// The pieces with their loads, and the tip.
    fn shape(&self, curvatures: &[Vector3<f64>], airspeed: f64) -> (Vec<Piece>, Vector3<f64>) {
        let width = self.length / PIECES as f64;
        let (mut turn, mut place) = (self.root(), Vector3::zeros());
        let piece = |(index, curvature): (usize, &Vector3<f64>)| {
            let half = Rotation3::new(curvature * (0.5 * width));
            turn *= half;
            let middle = place + turn * Vector3::y() * (0.5 * width);
            let loads = self.loads(&turn, (index as f64 + 0.5) / PIECES as f64, airspeed);
            let piece = Piece { middle, turn, force: loads[0] * width, moment: loads[1] * width };
            place += turn * Vector3::y() * width;
            turn *= half;
            piece
        };
        (curvatures.iter().enumerate().map(piece).collect(), place)
    }

    /// Force, and moment about the elastic axis, of a metre of span.
    fn loads(&self, turn: &Rotation3<f64>, at: f64, airspeed: f64) -> [Vector3<f64>; 2] {
        let [forward, outboard, down] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| turn * axis);
        let (along, across) = (forward.x * airspeed, down.x * airspeed);
        let slope = 0.5 * self.density * self.chord * (self.lift_slope)(at);
        let drag = 0.5 * self.density * self.chord * self.profile_drag * along.hypot(across);
        let lift = slope * along * across;
        let air = forward * ((self.suction)(at) * slope * across * across - drag * along)
            - down * (lift + drag * across);
        let weight = Vector3::z() * (self.mass_per_length * self.gravity);
        let arm = forward * (self.centre_of_mass * self.chord);
        let pitching = outboard * ((self.elastic_axis - 0.25) * self.chord * lift);
        [air + weight, pitching + arm.cross(&weight)]
    }

    /// What the loads outboard of the middle of each piece bend it to; half of a piece is outboard of its middle.
    fn curvatures(&self, pieces: &[Piece], tip: &Vector3<f64>) -> Vec<Vector3<f64>> {
        let quarter = 0.25 * self.length / PIECES as f64;
        let mut force = Vector3::z() * (self.tip_mass * self.gravity);
        let mut moment = tip.cross(&force);
        let mut curvatures = vec![Vector3::zeros(); pieces.len()];
        for (piece, curvature) in pieces.iter().zip(&mut curvatures).rev() {
            let own = (piece.turn * Vector3::y() * quarter).cross(&piece.force) * 0.5 + piece.moment * 0.5;
            let here = moment - piece.middle.cross(&force) + own;
            *curvature = (piece.turn.inverse() * here).component_div(&self.stiffness);
            force += piece.force;
            moment += piece.middle.cross(&piece.force) + piece.moment;
        }
        curvatures
    }
}

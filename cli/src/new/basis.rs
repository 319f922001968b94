//! What an aircraft is built of: its main numbers, its layout, and what is still to be found by trying.

use super::engines::{self, Mount};
use super::kind::Kind;
use super::layout::{ELASTIC_AXIS, Layout};
use super::sizing::Sizing;
use super::stiffness;

/// What rules do not say, and the equations of the aircraft do.
#[derive(Clone, Copy, Debug)]
pub struct Unknowns {
    /// EI at the root of the wing, N m².
    pub bending: f64,
    /// Of the wing, degrees.
    pub incidence: f64,
    /// What relieves the control for pitch: the incidence of the tail, degrees, or the zero-lift moment of a wing without one.
    pub relief: f64,
    /// Where the payload is, m ahead of O.
    pub load: f64,
}

/// What is built of.
pub struct Basis<'s> {
    pub sizing: &'s Sizing,
    pub layout: Layout,
    pub unknowns: Unknowns,
    pub mounts: Vec<Mount>,
}

/// Payload this far out on a fuselage needs a longer one.
const MOST_LOAD_PLACE: f64 = 0.85;

impl Unknowns {
    /// From which the search begins.
    pub fn first(sizing: &Sizing) -> Self {
        let layout = Layout::new(sizing);
        let wing_mass = layout.masses.wing + layout.masses.fuel;
        let length = sizing.wing.axis_length(ELASTIC_AXIS);
        // Tapered wings have their mass inboard.
        let bending = 0.5 * stiffness::cantilever(sizing.frequency, [wing_mass, 0.0], length);
        let incidence = match sizing.kind {
            Kind::FlyingWing | Kind::WingOnWall => 0.0,
            _ => 2.0,
        };
        Unknowns { bending, incidence, relief: 0.0, load: -sizing.wing.setback() }
    }
}

impl<'s> Basis<'s> {
    pub fn new(sizing: &'s Sizing, unknowns: Unknowns) -> Self {
        let mut layout = Layout::new(sizing);
        layout.nose = layout.nose.max(unknowns.load / MOST_LOAD_PLACE);
        layout.aft = layout.aft.max(-unknowns.load / MOST_LOAD_PLACE);
        let mounts = engines::mounts(sizing, &layout);
        Basis { sizing, layout, unknowns, mounts }
    }
}

//! Where the equilibrium that is linearised is lost between two airspeeds [theory: stability.losses].
//!
//! Near divergence an aircraft may have several equilibria. The trim is one of them, and it may be another one at the
//! next airspeed: then no root leads across, and an unstable one appears without having crossed the stability limit.
//! Of a continuous change between two airspeeds less and less is left in the half of the interval that has most of it,
//! when it is halved again and again; a jump stays whole.

use crate::plant::TrimError;

use super::equilibrium::Equilibrium;
use super::points::Motions;

/// Equilibria that differ less are one: shares of the aircraft's size, rad.
const NEGLIGIBLE: f64 = 1e-7;

/// Halvings before a change can count as continuous, so that a jump shows above what is continuous.
const LEAST_HALVINGS: i32 = 3;

/// Halvings before a change can count as a jump.
const JUMP_HALVINGS: i32 = 10;

/// The share of the greatest change that is left of a jump, and of nothing else, when its interval has been halved so
/// often. (Of the square root with which an equilibrium ends in a fold 0.03 are.)
const JUMP: f64 = 0.2;

/// Losses are found to this relative accuracy of the airspeed.
const ACCURACY: f64 = 1e-5;

/// An airspeed at which the equilibrium is lost.
#[derive(Clone, Debug, PartialEq)]
pub struct EquilibriumLoss {
    /// The airspeeds, m/s, between which it is; a hundred-thousandth apart.
    pub between: [f64; 2],
    /// How.
    pub kind: LossKind,
}

/// How an equilibrium is lost.
#[derive(Clone, Debug, PartialEq)]
pub enum LossKind {
    /// Above there is another one.
    Jump {
        /// The component that moves most.
        component: String,
        /// By so much, m.
        displacement: f64,
    },
    /// Above no trim is found.
    NoneAbove(Box<TrimError>),
    /// Below no trim is found.
    NoneBelow(Box<TrimError>),
}

/// An airspeed, m/s, and the equilibrium there.
pub(super) type At = (f64, Equilibrium);

impl Motions<'_> {
    /// Where between two airspeeds in trim the equilibrium is lost, if it is.
    pub fn loss_between(&self, mut low: At, mut high: At) -> Option<EquilibriumLoss> {
        let size = self.size();
        let mut greatest = 0.0_f64;
        for halvings in 0.. {
            let change = low.1.distance(&high.1, size);
            greatest = greatest.max(change);
            // Half of what is continuous is left after every halving, or a little more.
            let is_continuous =
                halvings >= LEAST_HALVINGS && change < 2.0 * greatest * 0.5_f64.powi(halvings);
            if change < NEGLIGIBLE || is_continuous {
                return None;
            }
            if halvings >= JUMP_HALVINGS && high.0 - low.0 <= ACCURACY * high.0 {
                return (change > JUMP * greatest).then(|| self.jump(&low, &high));
            }
            let middle = 0.5 * (low.0 + high.0);
            let equilibrium = match self.equilibrium(middle) {
                Ok(equilibrium) => equilibrium,
                Err(reason) => return Some(self.end_of_trims(low.0, middle, reason)),
            };
            let below = low.1.distance(&equilibrium, size);
            let above = high.1.distance(&equilibrium, size);
            *(if below > above { &mut high } else { &mut low }) = (middle, equilibrium);
        }
        None
    }

    /// Where between an airspeed with trim and one without the trims end.
    pub fn end_of_trims(&self, mut with: f64, mut without: f64, reason: Box<TrimError>) -> EquilibriumLoss {
        let mut reason = reason;
        while (with - without).abs() > ACCURACY * with.max(without) {
            let middle = 0.5 * (with + without);
            match self.equilibrium(middle) {
                Ok(_) => with = middle,
                Err(error) => (without, reason) = (middle, error),
            }
        }
        if with < without {
            EquilibriumLoss { between: [with, without], kind: LossKind::NoneAbove(reason) }
        } else {
            EquilibriumLoss { between: [without, with], kind: LossKind::NoneBelow(reason) }
        }
    }

    fn jump(&self, low: &At, high: &At) -> EquilibriumLoss {
        let (strip, displacement) = low.1.farthest(&high.1).unwrap_or_default();
        let component = self.model.strips.get(strip).map_or(String::new(), |strip| strip.component.clone());
        EquilibriumLoss { between: [low.0, high.0], kind: LossKind::Jump { component, displacement } }
    }

    /// Of the aircraft, m: how far its strips reach.
    fn size(&self) -> f64 {
        let reach = self.model.strips.iter().map(|strip| strip.position.norm() + strip.semichord);
        reach.fold(f64::MIN_POSITIVE, f64::max)
    }
}

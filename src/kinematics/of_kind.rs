//! The kind of kinematics by which an aircraft moves, chosen with its level of fidelity [theory: kinematics.kinds].
//!
//! Code that works with kinds is compiled for each; [`by_kind`] chooses once, outside of all loops.

use crate::structure::{ModalIntegrals, ReducedModel, ReducedStrip};

use super::exact::GeometricallyExact;
use super::freedom::RigidFreedom;
use super::kind::Kinematics;
use super::linear::Superposition;

/// What each kind has its own of.
#[derive(Clone, Debug)]
pub enum OfKind<S, E> {
    /// Of the thesis' superposition.
    Superposition(S),
    /// Of geometrically exact kinematics.
    GeometricallyExact(E),
}

/// A kind.
pub type AnyKind = OfKind<Superposition, GeometricallyExact>;

/// What a kind writes for an instant.
pub type AnyMemory =
    OfKind<<Superposition as Kinematics>::Memory, <GeometricallyExact as Kinematics>::Memory>;

/// What mass does that moves by a kind.
pub type AnyInertia =
    OfKind<<Superposition as Kinematics>::Inertia, <GeometricallyExact as Kinematics>::Inertia>;

/// Does the same with something of whichever kind, compiled for each: `by_kind!(kind, |kind| …)`.
macro_rules! by_kind {
    ($thing:expr, |$name:pat_param| $work:expr) => {
        match $thing {
            OfKind::Superposition($name) => $work,
            OfKind::GeometricallyExact($name) => $work,
        }
    };
}
pub(crate) use by_kind;

impl<S, E> OfKind<S, E> {
    /// Two things of one kind together.
    ///
    /// # Panics
    /// When they are of different kinds, as a workspace and equations for which it was not made.
    #[inline(always)]
    pub fn with<T, F>(self, other: OfKind<T, F>) -> OfKind<(S, T), (E, F)> {
        let both = match (self, other) {
            (OfKind::Superposition(one), OfKind::Superposition(other)) => {
                Some(OfKind::Superposition((one, other)))
            }
            (OfKind::GeometricallyExact(one), OfKind::GeometricallyExact(other)) => {
                Some(OfKind::GeometricallyExact((one, other)))
            }
            _ => None,
        };
        // PROOF: a workspace goes with the equations for which it was made, and has all of one kind.
        both.expect("a workspace that was made for the equations")
    }

    /// A look at it.
    #[inline(always)]
    pub fn as_ref(&self) -> OfKind<&S, &E> {
        match self {
            OfKind::Superposition(own) => OfKind::Superposition(own),
            OfKind::GeometricallyExact(own) => OfKind::GeometricallyExact(own),
        }
    }

    /// The same, to write to.
    #[inline(always)]
    pub fn as_mut(&mut self) -> OfKind<&mut S, &mut E> {
        match self {
            OfKind::Superposition(own) => OfKind::Superposition(own),
            OfKind::GeometricallyExact(own) => OfKind::GeometricallyExact(own),
        }
    }
}

impl AnyKind {
    /// Of a model, and of other strips with the same modes that flow in the mirror plane meets edge-on.
    ///
    /// # Panics
    /// When a model whose joints close loops is to be geometrically exact: settings refuse that.
    pub fn new(model: &ReducedModel, edge_on: &[ReducedStrip], geometrically_exact: bool) -> Self {
        if geometrically_exact {
            assert!(
                model.joints.is_empty(),
                "geometrically exact kinematics has no loops: {:?}",
                model.joints
            );
            OfKind::GeometricallyExact(Kinematics::new(model, edge_on))
        } else {
            OfKind::Superposition(Kinematics::new(model, edge_on))
        }
    }

    /// Room for an evaluation.
    pub fn memory(&self) -> AnyMemory {
        match self {
            OfKind::Superposition(kind) => OfKind::Superposition(kind.memory()),
            OfKind::GeometricallyExact(kind) => OfKind::GeometricallyExact(kind.memory()),
        }
    }

    /// The inertia of the undeformed aircraft, whose integrals over the mass these are.
    pub fn inertia(&self, integrals: &ModalIntegrals, freedom: RigidFreedom) -> AnyInertia {
        match self {
            OfKind::Superposition(kind) => OfKind::Superposition(kind.inertia(integrals, freedom)),
            OfKind::GeometricallyExact(kind) => OfKind::GeometricallyExact(kind.inertia(integrals, freedom)),
        }
    }

    /// The largest displacement of any strip, without those edge-on, by a small unit coordinate, m.
    pub fn largest_displacement(&self) -> f64 {
        by_kind!(self, |kind| kind.largest_displacement())
    }

    /// The largest displacement or rotation, m or rad.
    pub fn largest_shape(&self) -> f64 {
        by_kind!(self, |kind| kind.largest_shape())
    }
}

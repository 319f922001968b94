//! From beams and masses to modes, modal integrals and strain-energy tensors.
//!
//! [theory: structure.tree, structure.modes, structure.integrals, strain-energy.polynomial; thesis §3]

mod archive;
mod assembly;
mod beam;
mod carrier;
mod cut_axes;
mod cuts;
mod eccentric;
mod elastic_forces;
mod error;
mod hinged;
mod load_modes;
mod loops;
mod mirror;
mod modal_integrals;
mod mode;
mod mode_count;
mod mode_motions;
mod modes;
mod modes_in_use;
mod monomials;
mod nodal;
mod pairs;
mod particles;
mod poses;
mod reduced;
mod sections;
mod shared_unknowns;
mod static_loads;
mod strain_energy;
mod superposed_strains;
#[cfg(test)]
pub(crate) mod test_jet;

pub use assembly::Structure;
pub use beam::{BeamGeometry, Gradients};
pub use carrier::Carrier;
pub use cuts::{Outboard, ReducedCut, ReducedMass};
pub use elastic_forces::{ElasticForces, ElasticScratch};
pub use error::StructureError;
pub use modal_integrals::ModalIntegrals;
pub use mode::{Mode, ModeFamily, ModeKind, ModeShapes};
pub use mode_count::ModeCount;
pub use mode_motions::{ModeMotion, StrainShares};
pub use modes::ModalBasis;
pub use modes_in_use::ModesInUse;
pub use nodal::{NodalMap, NodalRow};
pub use particles::Particle;
pub(crate) use poses::{linear_pose_after, linear_poses};
pub use reduced::{ReducedEngine, ReducedModel, ReducedStation, ReducedStrip};
pub use sections::{BeamSection, RigidBody};
pub use static_loads::StaticLoad;
pub use strain_energy::StrainEnergy;

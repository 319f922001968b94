//! From beams and masses to modes, modal integrals and strain-energy tensors [3; physics.md §1, §3].

mod archive;
mod assembly;
mod beam;
mod error;
mod half;
mod mirror;
mod modal_integrals;
mod modes;
mod particles;
mod reduced;
mod strain_energy;
mod strain_polynomial;

pub(crate) use archive::fnv1a;
pub use assembly::Structure;
pub use beam::{BeamGeometry, Gradients, NodalMap, NodalRow};
pub use error::StructureError;
pub use half::{Counterpart, SymmetricHalf};
pub use modal_integrals::ModalIntegrals;
pub use modes::ModalBasis;
pub use particles::Particle;
pub use reduced::{Mode, ModeFamily, ModeShapes, ReducedEngine, ReducedModel, ReducedStation, ReducedStrip};
pub use strain_energy::StrainEnergy;
pub use strain_polynomial::{PairProducts, StrainPolynomial};

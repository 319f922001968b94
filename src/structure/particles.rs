//! Equimomental particles: a rigid mass bay as six point masses [theory: structure.particles; thesis §3.1].
//!
//! Six masses m/6 at ±√(3 s_k/m) e_k from the centre of mass, with s_k, e_k the eigenpairs of
//! S = ½ tr(I) 1 − I, have the bay's mass, centre and inertia exactly; every integral over the mass is then
//! one sum over particles.

use nalgebra::Vector3;

use crate::aircraft::{Aircraft, Attachment, MassBay};

use super::StructureError;
use super::beam::BeamGeometry;
use super::nodal::NodalMap;

/// A point mass carried by a section of the elastic axis.
#[derive(Clone, Debug)]
pub struct Particle {
    /// kg.
    pub mass: f64,
    /// The carrying section.
    pub attachment: Attachment,
    /// From the elastic axis to the particle, body axes, m.
    pub offset: Vector3<f64>,
}

impl Particle {
    /// Displacement of the particle as a map of its element's nodal unknowns: u + φ × offset.
    ///
    /// [theory: structure.bay; thesis eq. 3.1, 3.2]
    pub fn displacement(&self, geometry: &BeamGeometry) -> NodalMap {
        let (translation, rotation) = geometry.section(self.attachment.fraction);
        translation - self.offset.cross_matrix() * rotation
    }
}

/// The six particles of every bay of the aircraft.
///
/// # Errors
/// When a bay's inertia tensor is not that of a mass distribution.
pub fn particles(aircraft: &Aircraft) -> Result<Vec<Particle>, StructureError> {
    let mut all = Vec::with_capacity(6 * aircraft.bays.len());
    for (index, bay) in aircraft.bays.iter().enumerate() {
        all.extend(equimomental(bay).ok_or(StructureError::UnphysicalInertia { bay: index })?);
    }
    Ok(all)
}

/// The six particles of one bay; `None` when its inertia violates the triangle inequality.
fn equimomental(bay: &MassBay) -> Option<[Particle; 6]> {
    let inertia = (bay.inertia + bay.inertia.transpose()) * 0.5;
    let second_moment = nalgebra::Matrix3::identity() * (0.5 * inertia.trace()) - inertia;
    let eigen = nalgebra::SymmetricEigen::try_new(second_moment, f64::EPSILON, 1000)?;
    let rounding = 1e-12 * inertia.trace();
    if eigen.eigenvalues.iter().any(|&s| s < -rounding) {
        return None;
    }
    Some(std::array::from_fn(|i| {
        let (axis, sign) = (i / 2, if i % 2 == 0 { 1.0 } else { -1.0 });
        let arm = (3.0 * eigen.eigenvalues[axis].max(0.0) / bay.mass).sqrt();
        Particle {
            mass: bay.mass / 6.0,
            attachment: bay.attachment,
            offset: bay.offset + eigen.eigenvectors.column(axis) * (sign * arm),
        }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix3;

    #[test]
    fn six_particles_have_the_mass_centre_and_inertia_of_the_bay() {
        let bay = MassBay {
            attachment: Attachment { beam: 0, fraction: 0.5 },
            mass: 7.0,
            offset: Vector3::new(0.1, -0.4, 0.2),
            inertia: Matrix3::new(3.0, 0.2, -0.1, 0.2, 4.0, 0.3, -0.1, 0.3, 5.0),
        };
        let particles = equimomental(&bay).unwrap();
        let mass: f64 = particles.iter().map(|p| p.mass).sum();
        let centre: Vector3<f64> = particles.iter().map(|p| p.offset * p.mass).sum::<Vector3<f64>>() / mass;
        let inertia: Matrix3<f64> = particles
            .iter()
            .map(|p| (p.offset - centre).cross_matrix())
            .map(|x| -x * x * (bay.mass / 6.0))
            .sum();
        assert!((mass - bay.mass).abs() < 1e-14);
        assert!((centre - bay.offset).norm() < 1e-14);
        assert!((inertia - bay.inertia).norm() < 1e-13);
    }

    #[test]
    fn inertia_that_no_mass_can_have_is_refused() {
        let bay = MassBay {
            attachment: Attachment { beam: 0, fraction: 0.5 },
            mass: 1.0,
            offset: Vector3::zeros(),
            inertia: Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 2.1)),
        };
        assert!(equimomental(&bay).is_none());
    }
}

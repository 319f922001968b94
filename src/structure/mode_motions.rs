//! What moves in a mode and what strains: its energies by component and by kind of strain [theory: structure.motions].

use nalgebra::{DMatrix, DVector};

use super::assembly::Structure;
use super::beam::GAUSS_2;
use super::cut_axes::Axes;

/// The energies of a mode, in parts of all of its kinetic and of all of its strain energy.
///
/// ```
/// use flexible_aircraft::Aircraft;
/// use flexible_aircraft::structure::{ModalBasis, ModeMotion, Structure};
///
/// let wing = Aircraft::read("aircraft/goland-wing.toml")?;
/// let structure = Structure::new(&wing)?;
/// let basis = ModalBasis::new(&structure, 2)?;
/// let first = ModeMotion::of_modes(&structure, &basis.shapes).swap_remove(0);
/// assert!((first.kinetic[0] - 1.0).abs() < 1e-12); // the wing is all that there is
/// assert!(first.strain[0].bending > 0.9); // its lowest mode bends it
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ModeMotion {
    /// Of each component of the aircraft.
    pub kinetic: Vec<f64>,
    /// Of each component of the aircraft.
    pub strain: Vec<StrainShares>,
}

/// Parts of a mode's strain energy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StrainShares {
    /// Of bending out of the surface: up and down of a wing, sideways of a fin, up and down of a body.
    pub bending: f64,
    /// Of bending in the surface: fore and aft of a wing or fin, sideways of a body.
    pub in_plane: f64,
    /// Of twist.
    pub torsion: f64,
    /// Of stretch along the beam.
    pub stretch: f64,
}

impl StrainShares {
    /// All together.
    pub fn sum(&self) -> f64 {
        self.bending + self.in_plane + self.torsion + self.stretch
    }

    /// Those of both.
    pub fn plus(&self, other: &StrainShares) -> StrainShares {
        StrainShares {
            bending: self.bending + other.bending,
            in_plane: self.in_plane + other.in_plane,
            torsion: self.torsion + other.torsion,
            stretch: self.stretch + other.stretch,
        }
    }

    /// Parts of their own sum.
    pub fn of_whole(&self) -> StrainShares {
        let sum = self.sum();
        if sum > 0.0 { self.scaled(1.0 / sum) } else { *self }
    }

    fn scaled(&self, factor: f64) -> StrainShares {
        let StrainShares { bending, in_plane, torsion, stretch } = *self;
        StrainShares {
            bending: bending * factor,
            in_plane: in_plane * factor,
            torsion: torsion * factor,
            stretch: stretch * factor,
        }
    }
}

impl ModeMotion {
    /// Of each of some modes of a structure, a column each.
    pub fn of_modes(structure: &Structure, shapes: &DMatrix<f64>) -> Vec<Self> {
        let components = structure.aircraft.components.len();
        let rest =
            ModeMotion { kinetic: vec![0.0; components], strain: vec![StrainShares::default(); components] };
        let mut motions = vec![rest; shapes.ncols()];
        let beams = 0..structure.aircraft.beams.len();
        let component: Vec<Option<usize>> = beams.map(|beam| structure.aircraft.component_of(beam)).collect();
        for particle in &structure.particles {
            let beam = particle.attachment.beam;
            let Some(component) = component[beam] else { continue };
            let rows = structure.apply_map(beam, &particle.displacement(&structure.geometry[beam]), shapes);
            for (mode, motion) in motions.iter_mut().enumerate() {
                let squares = (0..3).map(|axis| rows[axis * shapes.ncols() + mode].powi(2));
                motion.kinetic[component] += particle.mass * squares.sum::<f64>();
            }
        }
        for (beam, component) in component.iter().enumerate() {
            let Some(component) = *component else { continue };
            for (motion, energy) in motions.iter_mut().zip(strain_energies(structure, beam, shapes)) {
                motion.strain[component] = motion.strain[component].plus(&energy);
            }
        }
        motions.iter_mut().for_each(ModeMotion::normalise);
        motions
    }

    /// Makes parts of energies.
    fn normalise(&mut self) {
        let kinetic: f64 = self.kinetic.iter().sum();
        let strain: f64 = self.strain.iter().map(StrainShares::sum).sum();
        if kinetic > 0.0 {
            self.kinetic.iter_mut().for_each(|share| *share /= kinetic);
        }
        if strain > 0.0 {
            self.strain.iter_mut().for_each(|shares| *shares = shares.scaled(1.0 / strain));
        }
    }
}

/// Twice the strain energies of an element in each mode.
fn strain_energies(structure: &Structure, beam: usize, shapes: &DMatrix<f64>) -> Vec<StrainShares> {
    let (element, geometry) = (&structure.aircraft.beams[beam], &structure.geometry[beam]);
    let up = Axes::new(structure, beam).up;
    let [along_y, along_z] = [1, 2].map(|axis| geometry.axes.row(axis).dot(&up.transpose()).abs());
    let (is_w_out, coupling) = (along_z >= along_y, element.coupling);
    let mut energies = vec![StrainShares::default(); shapes.ncols()];
    for (fraction, weight) in GAUSS_2 {
        let gradients = geometry.gradients(fraction);
        let [w, v, twist, stretch] =
            [gradients.curvature_w, gradients.curvature_v, gradients.twist, gradients.stretch]
                .map(|row| structure.apply_row(beam, &row, shapes));
        let work = |strains: &DVector<f64>, stiffness: f64, coupled: [(&DVector<f64>, f64); 2]| {
            let own = strains.map(|strain| stiffness * strain * strain * weight * geometry.length);
            // A strain works on what others make of moments too.
            coupled.into_iter().filter(|(_, stiffness)| *stiffness != 0.0).fold(
                own,
                |sum, (other, stiffness)| {
                    sum + strains.component_mul(other) * (stiffness * weight * geometry.length)
                },
            )
        };
        let [by_w, by_v] = coupling.bend_twist;
        let in_w = work(&w, element.bending_stiffness_y, [(&twist, by_w), (&v, coupling.bending)]);
        let in_v = work(&v, element.bending_stiffness_z, [(&twist, by_v), (&w, coupling.bending)]);
        let twist = work(&twist, element.torsional_stiffness, [(&w, by_w), (&v, by_v)]);
        let stretch = work(&stretch, element.axial_stiffness, [(&w, 0.0), (&v, 0.0)]);
        let (bending, in_plane) = if is_w_out { (in_w, in_v) } else { (in_v, in_w) };
        for (mode, energy) in energies.iter_mut().enumerate() {
            *energy = energy.plus(&StrainShares {
                bending: bending[mode],
                in_plane: in_plane[mode],
                torsion: twist[mode],
                stretch: stretch[mode],
            });
        }
    }
    add_hinge((structure, beam), is_w_out, shapes, &mut energies);
    energies
}

/// Adds those of the springs at an element's beginning: each axis bends or twists, by its direction in the element.
fn add_hinge(
    (structure, beam): (&Structure, usize),
    is_w_out: bool,
    shapes: &DMatrix<f64>,
    energies: &mut [StrainShares],
) {
    let Some(hinge) = &structure.aircraft.beams[beam].hinge else { return };
    let geometry = &structure.geometry[beam];
    for (spring, (row, stiffness)) in hinge.springs.iter().zip(geometry.springs()) {
        // About local x it twists, about y it bends in w, about z in v.
        let parts = (geometry.axes * spring.axis).map(|part| part * part);
        let (bending, in_plane) = if is_w_out { (parts.y, parts.z) } else { (parts.z, parts.y) };
        let shares = StrainShares { bending, in_plane, torsion: parts.x, stretch: 0.0 };
        for (energy, angle) in energies.iter_mut().zip(structure.apply_row(beam, row, shapes).iter()) {
            *energy = energy.plus(&shares.scaled(stiffness * angle * angle));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aircraft::Aircraft;
    use crate::structure::ModalBasis;

    fn motions(text: &str, count: usize) -> (Aircraft, Vec<ModeMotion>) {
        let aircraft = Aircraft::parse(text, "aircraft.toml").unwrap();
        let structure = Structure::new(&aircraft).unwrap();
        let basis = ModalBasis::new(&structure, count).unwrap();
        let motions = ModeMotion::of_modes(&structure, &basis.shapes);
        (aircraft, motions)
    }

    #[test]
    fn shares_add_up_to_1_and_are_alike_on_both_sides() {
        let (jet, motions) = motions(include_str!("../../aircraft/generic-business-jet.toml"), 12);
        for motion in motions {
            let kinetic: f64 = motion.kinetic.iter().sum();
            let strain: f64 = motion.strain.iter().map(StrainShares::sum).sum();
            assert!((kinetic - 1.0).abs() < 1e-12 && (strain - 1.0).abs() < 1e-12);
            for (place, component) in jet.components.iter().enumerate() {
                let Some(image) = component.image else { continue };
                assert!((motion.kinetic[place] - motion.kinetic[image]).abs() < 1e-9);
                let [one, other] = [place, image].map(|side| motion.strain[side]);
                assert!((one.bending - other.bending).abs() < 1e-9, "{one:?} {other:?}");
            }
        }
    }

    /// A beam along y whose section is flat: its soft direction is w with y_axis forward and v with y_axis down.
    #[test]
    fn bending_out_of_the_surface_is_told_from_bending_in_it_however_the_section_is_turned() {
        let wing = include_str!("../../aircraft/goland-wing.toml");
        let turned = wing
            .replace("y_axis = [1, 0, 0]", "y_axis = [0, 0, 1]")
            .replace("EI_y_N_m2", "EI_other")
            .replace("EI_z_N_m2", "EI_y_N_m2")
            .replace("EI_other", "EI_z_N_m2");
        assert_ne!(wing, turned);
        let [one, other] = [wing, &turned].map(|text| motions(text, 2).1[0].strain[0]);
        assert!(one.bending > 0.9 && one.in_plane < 0.01, "{one:?}");
        assert!((one.bending - other.bending).abs() < 1e-9, "{one:?} {other:?}");
    }
}

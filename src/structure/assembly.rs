//! The assembled structure: stiffness and mass matrices clamped at node 0.
//!
//! [theory: structure.tree, structure.stiffness, structure.mass-matrix; thesis §3.1]

use nalgebra::{DMatrix, DVector, SVector};

use crate::aircraft::{Aircraft, Attachment, ModeBasis};

use super::beam::{BeamGeometry, axial_stiffness};
use super::nodal::{NodalMap, NodalRow};
use super::particles::{Particle, particles};
use super::shared_unknowns::SharedUnknowns;
use super::{ModeShapes, StructureError};

/// An aircraft's structure: beams with their geometry, particles, and the numbering of unknowns.
#[derive(Debug)]
pub struct Structure<'a> {
    /// Where it comes from.
    pub aircraft: &'a Aircraft,
    /// One per element.
    pub geometry: Vec<BeamGeometry>,
    /// All mass.
    pub particles: Vec<Particle>,
}

impl<'a> Structure<'a> {
    /// Prepares the geometry and the particles of an aircraft.
    ///
    /// # Errors
    /// When a bay's inertia is unphysical.
    pub fn new(aircraft: &'a Aircraft) -> Result<Self, StructureError> {
        let rigid = aircraft.mode_basis == ModeBasis::BendingTorsion;
        let beams = aircraft.beams.iter().zip(aircraft.elements_in_loops());
        let geometry =
            beams.map(|(beam, in_loop)| BeamGeometry::new(aircraft, beam, rigid && !in_loop)).collect();
        Ok(Structure { aircraft, geometry, particles: particles(aircraft)? })
    }

    /// Number of unknowns: six at each node but the clamped one.
    pub fn unknowns(&self) -> usize {
        6 * (self.aircraft.nodes.len() - 1)
    }

    /// Stiffness matrix of beams that no joints hold; with `axially_rigid` every EA beside the loops that joints close is raised until
    /// axial strain is negligible [theory: structure.axially-rigid, structure.loops].
    pub fn stiffness(&self, axially_rigid: bool) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.unknowns(), self.unknowns());
        let in_loops = self.aircraft.elements_in_loops();
        for (index, beam) in self.aircraft.beams.iter().enumerate() {
            let axial = axial_stiffness(beam, axially_rigid && !in_loops[index]);
            self.add_element(&mut matrix, index, &self.geometry[index].stiffness(beam, axial));
        }
        matrix
    }

    /// T of all unknowns x = T y of which joints make some equal, orthonormal: stiffness of y is TᵀKT, mass TᵀMT, load Tᵀf. The unit
    /// matrix without joints.
    ///
    /// ```
    /// use flexible_aircraft::{Aircraft, structure::Structure};
    ///
    /// let aircraft = Aircraft::read("tests/data/strut-braced.toml")?; // two struts, each pinned to its wing
    /// let structure = Structure::new(&aircraft)?;
    /// assert_eq!(structure.joined().ncols(), structure.unknowns() - 6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// [theory: structure.joints]
    pub fn joined(&self) -> DMatrix<f64> {
        let columns = SharedUnknowns::of(self.aircraft).columns();
        let mut joined = DMatrix::zeros(self.unknowns(), columns.len());
        for (column, terms) in columns.iter().enumerate() {
            terms.iter().for_each(|&(unknown, share)| joined[(unknown, column)] = share);
        }
        joined
    }

    /// Mass matrix (singular: lumps are fewer than unknowns) [theory: structure.mass-matrix].
    pub fn mass(&self) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.unknowns(), self.unknowns());
        for particle in &self.particles {
            let beam = particle.attachment.beam;
            let displacement = particle.displacement(&self.geometry[beam]);
            self.add_element(&mut matrix, beam, &(displacement.transpose() * displacement * particle.mass));
        }
        matrix
    }

    /// A linear form on an element's nodal unknowns, applied to each column of global `shapes`.
    pub fn apply_row(&self, beam: usize, row: &NodalRow, shapes: &DMatrix<f64>) -> DVector<f64> {
        DVector::from_fn(shapes.ncols(), |mode, _| row.dot(&self.element_values(beam, shapes, mode)))
    }

    /// Vector-valued map of an element's nodal unknowns, applied to each column of global `shapes`:
    /// row-major 3 × n.
    pub fn apply_map(&self, beam: usize, map: &NodalMap, shapes: &DMatrix<f64>) -> Vec<f64> {
        let mut rows = vec![0.0; 3 * shapes.ncols()];
        for mode in 0..shapes.ncols() {
            let value = map * self.element_values(beam, shapes, mode);
            for axis in 0..3 {
                rows[axis * shapes.ncols() + mode] = value[axis];
            }
        }
        rows
    }

    /// Mode shapes on the elastic axis [theory: structure.shapes].
    pub fn shapes_at(&self, attachment: Attachment, shapes: &DMatrix<f64>) -> ModeShapes {
        let (translation, rotation) = self.geometry[attachment.beam].section(attachment.fraction);
        ModeShapes {
            translation: self.apply_map(attachment.beam, &translation, shapes),
            rotation: self.apply_map(attachment.beam, &rotation, shapes),
        }
    }

    /// The 12 nodal values of an element in column `mode`; the clamped node has none.
    fn element_values(&self, beam: usize, shapes: &DMatrix<f64>, mode: usize) -> SVector<f64, 12> {
        let mut values = SVector::zeros();
        for (end, &node) in self.aircraft.beams[beam].nodes.iter().enumerate() {
            if node > 0 {
                let first = 6 * (node - 1);
                for i in 0..6 {
                    values[6 * end + i] = shapes[(first + i, mode)];
                }
            }
        }
        values
    }

    /// Adds numbers of an element's nodal unknowns to those of all.
    pub(super) fn add_nodal(&self, beam: usize, nodal: &NodalRow, all: &mut DVector<f64>) {
        for (end, &node) in self.aircraft.beams[beam].nodes.iter().enumerate() {
            if node > 0 {
                let first = 6 * (node - 1);
                for i in 0..6 {
                    all[first + i] += nodal[6 * end + i];
                }
            }
        }
    }

    fn add_element(&self, matrix: &mut DMatrix<f64>, beam: usize, element: &nalgebra::SMatrix<f64, 12, 12>) {
        let unknown = |local: usize| {
            let node = self.aircraft.beams[beam].nodes[local / 6];
            (node > 0).then(|| 6 * (node - 1) + local % 6)
        };
        for row in 0..12 {
            for column in 0..12 {
                if let (Some(i), Some(j)) = (unknown(row), unknown(column)) {
                    matrix[(i, j)] += element[(row, column)];
                }
            }
        }
    }
}

//! The straight 3D Euler–Bernoulli beam element.
//!
//! [theory: structure.beam, structure.gradients, structure.stiffness, structure.axially-rigid; thesis eq. 3.6]
//!
//! Bending in two planes is cubic, stretch and twist are linear along the element. Local axes: x from the
//! first node to the second, y the element's `y_axis`, z = x × y; right-handed rotations φ_y = −w′,
//! φ_z = v′. Nodal unknowns are [u, φ] of the first node, then of the second, all in *body* axes. What coupled sections and
//! hinges change in it comes from `eccentric` and `hinged`.

use nalgebra::{Matrix3, SMatrix, Vector3};

use crate::aircraft::{Aircraft, Beam};

use super::eccentric::Eccentric;
use super::hinged::Hinged;
use super::nodal::{NodalMap, NodalRow};

/// Abscissae and weights on (0, 1) of the 2-point Gauss rule: exact for the quadratic part of the energy.
pub const GAUSS_2: [(f64, f64); 2] = [(0.211_324_865_405_187_13, 0.5), (0.788_675_134_594_812_9, 0.5)];

/// The 5-point Gauss rule on (0, 1): exact to degree 9, as the quartic strain energy asks.
///
/// [theory: strain-energy.polynomial]
pub const GAUSS_5: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// EA of axially rigid elements, N [theory: structure.axially-rigid].
const RIGID_AXIAL_STIFFNESS: f64 = 1e12;

/// EA of an element, N; of one that is axially rigid raised until axial strain is negligible.
pub(super) fn axial_stiffness(beam: &Beam, axially_rigid: bool) -> f64 {
    if axially_rigid { beam.axial_stiffness.max(RIGID_AXIAL_STIFFNESS) } else { beam.axial_stiffness }
}

/// An element's geometry: what its interpolation needs.
#[derive(Clone, Debug)]
pub struct BeamGeometry {
    /// First node, body axes, m.
    pub origin: Vector3<f64>,
    /// m.
    pub length: f64,
    /// Rows are the local x, y, z axes in body axes.
    pub axes: Matrix3<f64>,
    /// What it does besides a plain one.
    eccentric: Option<Box<Eccentric>>,
    /// By which it turns against its first node.
    hinged: Option<Box<Hinged>>,
}

/// The displacement gradients at one section, each a linear form on the nodal unknowns.
///
/// [theory: structure.gradients; thesis eq. 3.4]
#[derive(Clone, Debug)]
pub struct Gradients {
    /// u′: stretch; e_n of a coupled section.
    pub stretch: NodalRow,
    /// v′: slope in the local x–y plane, of the line of shear centres.
    pub slope_v: NodalRow,
    /// w′: slope in the local x–z plane, of the line of shear centres.
    pub slope_w: NodalRow,
    /// φ′: twist per length, 1/m.
    pub twist: NodalRow,
    /// v″, 1/m.
    pub curvature_v: NodalRow,
    /// w″, 1/m.
    pub curvature_w: NodalRow,
}

impl BeamGeometry {
    /// Geometry of element `beam` of `aircraft`, whose modes have it axially rigid or not: its hinge balances it as it is there.
    pub fn new(aircraft: &Aircraft, beam: &Beam, axially_rigid: bool) -> Self {
        let [first, second] = beam.nodes;
        let origin = aircraft.nodes[first];
        let axis = aircraft.nodes[second] - origin;
        let length = axis.norm();
        let x = axis / length;
        let y = beam.y_axis;
        let z = x.cross(&y);
        let mut geometry = BeamGeometry {
            origin,
            length,
            axes: Matrix3::from_rows(&[x.transpose(), y.transpose(), z.transpose()]),
            eccentric: None,
            hinged: None,
        };
        let curvatures = [0.0, 1.0].map(|fraction| geometry.local_gradients(fraction));
        geometry.eccentric = Eccentric::of(beam, length, curvatures.each_ref()).map(Box::new);
        if let Some(hinge) = &beam.hinge {
            let axial = axial_stiffness(beam, axially_rigid);
            geometry.hinged = Hinged::of(hinge, &geometry.stiffness(beam, axial)).map(Box::new);
        }
        geometry
    }

    /// The angle of each spring of the hinge at its beginning, and its stiffness, N·m/rad [theory: coupled-sections.hinge].
    pub fn springs(&self) -> &[(NodalRow, f64)] {
        self.hinged.as_ref().map_or(&[], |hinged| &hinged.springs)
    }

    /// Undeformed position of the section at `fraction` of the length, body axes, m.
    pub fn position(&self, fraction: f64) -> Vector3<f64> {
        self.origin + self.axes.row(0).transpose() * (fraction * self.length)
    }

    /// Displacement and rotation vector (body axes) of the section at `fraction` of the length.
    ///
    /// [theory: structure.beam]
    pub fn section(&self, fraction: f64) -> (NodalMap, NodalMap) {
        let l = self.length;
        let s = fraction;
        let linear = [1.0 - s, s];
        // Hermite cubics for unit end values and unit end slopes, and their derivatives along the beam.
        let value = [1.0 - 3.0 * s * s + 2.0 * s * s * s, 3.0 * s * s - 2.0 * s * s * s];
        let slope = [l * s * (1.0 - s) * (1.0 - s), -l * s * s * (1.0 - s)];
        let value_prime = [-6.0 * s * (1.0 - s) / l, 6.0 * s * (1.0 - s) / l];
        let slope_prime = [1.0 - 4.0 * s + 3.0 * s * s, 3.0 * s * s - 2.0 * s];

        let (mut displacement, mut rotation) = (NodalMap::zeros(), NodalMap::zeros());
        for end in 0..2 {
            let (u, phi) = (6 * end, 6 * end + 3);
            displacement[(0, u)] = linear[end];
            displacement[(1, u + 1)] = value[end];
            displacement[(1, phi + 2)] = slope[end];
            displacement[(2, u + 2)] = value[end];
            displacement[(2, phi + 1)] = -slope[end];
            rotation[(0, phi)] = linear[end];
            rotation[(1, u + 2)] = -value_prime[end];
            rotation[(1, phi + 1)] = slope_prime[end];
            rotation[(2, u + 1)] = value_prime[end];
            rotation[(2, phi + 2)] = slope_prime[end];
        }
        if let Some(eccentric) = &self.eccentric {
            (displacement, rotation) = eccentric.section(fraction, displacement, rotation);
        }
        let back = self.axes.transpose();
        let [displacement, rotation] = [displacement, rotation].map(|map| back * self.in_body_axes(map));
        (self.beyond_the_hinge(displacement), self.beyond_the_hinge(rotation))
    }

    /// Displacement gradients at `fraction` of the length.
    pub fn gradients(&self, fraction: f64) -> Gradients {
        let mut rows = self.local_gradients(fraction);
        if let Some(eccentric) = &self.eccentric {
            rows = eccentric.gradients(fraction, rows);
        }
        let rows = self.beyond_the_hinge(self.in_body_axes(rows));
        let row = |i: usize| rows.row(i).transpose();
        Gradients {
            stretch: row(0),
            slope_v: row(1),
            slope_w: row(2),
            twist: row(3),
            curvature_v: row(4),
            curvature_w: row(5),
        }
    }

    /// The gradients of a plain element as linear forms on what its ends do, local axes.
    fn local_gradients(&self, fraction: f64) -> SMatrix<f64, 6, 12> {
        let l = self.length;
        let s = fraction;
        let value_prime = 6.0 * s * (1.0 - s) / l;
        let slope_prime = [1.0 - 4.0 * s + 3.0 * s * s, 3.0 * s * s - 2.0 * s];
        let value_second = (6.0 - 12.0 * s) / (l * l);
        let slope_second = [(6.0 * s - 4.0) / l, (6.0 * s - 2.0) / l];

        let mut rows = SMatrix::<f64, 6, 12>::zeros();
        for (end, sign) in [(0, -1.0), (1, 1.0)] {
            let (u, phi) = (6 * end, 6 * end + 3);
            rows[(0, u)] = sign / l;
            rows[(1, u + 1)] = sign * value_prime;
            rows[(1, phi + 2)] = slope_prime[end];
            rows[(2, u + 2)] = sign * value_prime;
            rows[(2, phi + 1)] = -slope_prime[end];
            rows[(3, phi)] = sign / l;
            rows[(4, u + 1)] = sign * value_second;
            rows[(4, phi + 2)] = slope_second[end];
            rows[(5, u + 2)] = sign * value_second;
            rows[(5, phi + 1)] = -slope_second[end];
        }
        rows
    }

    /// Stiffness matrix on the nodal unknowns in body axes, with the axial stiffness given.
    ///
    /// [theory: structure.stiffness, coupled-sections.energy]
    pub fn stiffness(&self, beam: &Beam, axial_stiffness: f64) -> SMatrix<f64, 12, 12> {
        let mut stiffness = SMatrix::zeros();
        for (fraction, weight) in GAUSS_2 {
            let gradients = self.gradients(fraction);
            for (row, rigidity) in [
                (gradients.stretch, axial_stiffness),
                (gradients.twist, beam.torsional_stiffness),
                (gradients.curvature_v, beam.bending_stiffness_z),
                (gradients.curvature_w, beam.bending_stiffness_y),
            ] {
                stiffness += row * row.transpose() * (weight * self.length * rigidity);
            }
            if !beam.coupling.is_none() {
                let Gradients { twist, curvature_v: v, curvature_w: w, .. } = &gradients;
                let [by_w, by_v] = beam.coupling.bend_twist;
                for (one, other, rigidity) in
                    [(v, w, beam.coupling.bending), (twist, w, by_w), (twist, v, by_v)]
                {
                    let product = one * other.transpose();
                    stiffness += (product + product.transpose()) * (weight * self.length * rigidity);
                }
            }
        }
        for (angle, spring) in self.springs() {
            stiffness += angle * angle.transpose() * *spring;
        }
        stiffness
    }

    /// Linear forms on what the ends of the element do, turned into linear forms on what its nodes do.
    fn beyond_the_hinge<const R: usize>(&self, forms: SMatrix<f64, R, 12>) -> SMatrix<f64, R, 12> {
        match &self.hinged {
            Some(hinged) => forms * hinged.ends,
            None => forms,
        }
    }

    /// Linear forms on local unknowns, turned into linear forms on unknowns in body axes.
    fn in_body_axes<const R: usize>(&self, local: SMatrix<f64, R, 12>) -> SMatrix<f64, R, 12> {
        let mut body = SMatrix::<f64, R, 12>::zeros();
        for block in 0..4 {
            let turned = local.fixed_columns::<3>(3 * block) * self.axes;
            body.fixed_columns_mut::<3>(3 * block).copy_from(&turned);
        }
        body
    }
}

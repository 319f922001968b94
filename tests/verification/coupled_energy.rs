//! The strain energy of coupled sections to its fourth order, tension axis and shear centre apart from each other and from the
//! reference axis: that of four stretched fibres and of torsion, however the section is described.
//!
//! [theory: coupled-sections.energy, coupled-sections.element, coupled-sections.higher, strain-energy.green]

use flexible_aircraft::aircraft::{Beam, Coupling};
use flexible_aircraft::structure::{ModalBasis, StrainEnergy, Structure};
use nalgebra::{DMatrix, DVector, Matrix2, SymmetricEigen, Vector3};

use super::record::Record;
use super::strain_energy::GAUSS_8;
use crate::support::beams::askew;
use crate::support::random;
use crate::support::redescribed::{about, turned};

/// All couplings at once; the two axes lie to different sides of the reference axis.
const COUPLED: Coupling = Coupling {
    bending: 9e3,
    bend_twist: [3e3, -4e3],
    stretch_by_twist: 2e-3,
    tension_axis: [0.12, -0.07],
    shear_centre: [-0.15, 0.09],
};

/// A number along the beam with its first and second derivative, 1/m.
type Jet = [f64; 3];

/// A cantilever without loads along it: v and w of the line of shear centres, cubic from a clamped root; u of the tension axis, by
/// the same axial force everywhere; twist by the same torque everywhere.
struct Deflected<'b> {
    beam: &'b Beam,
    length: f64,
    /// Of (x/ℓ)² and (x/ℓ)³, m.
    v: [f64; 2],
    w: [f64; 2],
    /// e_n.
    stretch: f64,
    /// N m.
    torque: f64,
}

impl Deflected<'_> {
    /// In random directions, to a size at which no order of the energy is far above another.
    fn random<'b>(beam: &'b Beam, length: f64, next: &mut impl FnMut() -> f64) -> Deflected<'b> {
        let mut bend = || [0.1 * length * next(), 0.1 * length * next()];
        let (v, w) = (bend(), bend());
        let torque = 0.1 * beam.torsional_stiffness / length * next();
        Deflected { beam, length, v, w, stretch: 5e-3 * next(), torque }
    }

    fn scaled(&self, by: f64) -> Self {
        let [v, w] = [self.v, self.w].map(|bend| bend.map(|c| c * by));
        Deflected { v, w, stretch: self.stretch * by, torque: self.torque * by, ..*self }
    }

    fn bend(&self, [square, cube]: [f64; 2], x: f64) -> Jet {
        let (l, s) = (self.length, x / self.length);
        [
            s * s * (square + s * cube),
            s * (2.0 * square + 3.0 * s * cube) / l,
            (2.0 * square + 6.0 * s * cube) / (l * l),
        ]
    }

    /// From GJ φ′ + K_y w″ + K_z v″ = torque, integrated from the root.
    fn twist(&self, x: f64) -> [f64; 2] {
        let [by_w, by_v] = self.beam.coupling.bend_twist;
        let [[_, slope_v, curvature_v], [_, slope_w, curvature_w]] =
            [self.v, self.w].map(|bend| self.bend(bend, x));
        let along =
            |torque: f64, w: f64, v: f64| (torque - by_w * w - by_v * v) / self.beam.torsional_stiffness;
        [along(self.torque * x, slope_w, slope_v), along(self.torque, curvature_w, curvature_v)]
    }

    /// Displacement and rotation of the reference axis at its end, local axes.
    fn tip(&self) -> [Vector3<f64>; 2] {
        let l = self.length;
        let Coupling { stretch_by_twist: k, tension_axis: [y_t, z_t], shear_centre: [y_s, z_s], .. } =
            self.beam.coupling;
        let ([v, slope_v, _], [w, slope_w, _], [twist, _]) =
            (self.bend(self.v, l), self.bend(self.w, l), self.twist(l));
        let rotation = Vector3::new(twist, -slope_w, slope_v);
        // The section is plane: from the axis that each is known of to the reference axis.
        let along = self.stretch * l + y_t * slope_v + z_t * slope_w - k * twist;
        [Vector3::new(along, v + z_s * twist, w - y_s * twist), rotation]
    }

    /// Green's strain of a fibre at (y, z) of the section from the tension axis, ½(|dr/dx|² − 1), at which the section is no longer
    /// than axial force makes it.
    fn strain(&self, [y, z]: [f64; 2], x: f64) -> f64 {
        let Coupling { tension_axis: [y_t, z_t], shear_centre: [y_s, z_s], .. } = self.beam.coupling;
        let [[_, slope_v, curvature_v], [_, slope_w, curvature_w]] =
            [self.v, self.w].map(|bend| self.bend(bend, x));
        let [_, twist] = self.twist(x);
        let from_shear_centre = [y_t + y - y_s, z_t + z - z_s];
        let tangent = Vector3::new(
            1.0 + self.stretch - y * curvature_v - z * curvature_w,
            slope_v - from_shear_centre[1] * twist,
            slope_w + from_shear_centre[0] * twist,
        );
        0.5 * (tangent.norm_squared() - 1.0)
    }

    /// Of four fibres of EA/4 where the second moments about the tension axis have them, of torsion and of its coupling with bending.
    fn energy(&self) -> f64 {
        let beam = self.beam;
        let second = Matrix2::new(
            beam.bending_stiffness_z,
            beam.coupling.bending,
            beam.coupling.bending,
            beam.bending_stiffness_y,
        );
        let principal = SymmetricEigen::new(second / beam.axial_stiffness);
        let arms = [0, 1].map(|i| principal.eigenvectors.column(i) * principal.eigenvalues[i].sqrt());
        let fibres =
            [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].map(|(a, b)| arms[0] * a + arms[1] * b);
        let [by_w, by_v] = beam.coupling.bend_twist;
        let density = |x: f64| {
            let ([_, _, curvature_v], [_, _, curvature_w]) = (self.bend(self.v, x), self.bend(self.w, x));
            let [_, twist] = self.twist(x);
            let stretched =
                fibres.iter().map(|fibre| self.strain([fibre.x, fibre.y], x).powi(2)).sum::<f64>();
            0.125 * beam.axial_stiffness * stretched
                + twist * (0.5 * beam.torsional_stiffness * twist + by_w * curvature_w + by_v * curvature_v)
        };
        let places =
            GAUSS_8.iter().flat_map(|&(x, weight)| [(0.5 - 0.5 * x, weight), (0.5 + 0.5 * x, weight)]);
        places.map(|(s, weight)| 0.5 * weight * self.length * density(s * self.length)).sum()
    }

    /// Its parts of second, third and fourth order, from those at other amplitudes.
    fn orders(&self) -> [f64; 3] {
        let at = |amplitude: f64| self.scaled(amplitude).energy();
        let [even, twice] = [1.0, 2.0].map(|amplitude| 0.5 * (at(amplitude) + at(-amplitude)));
        let fourth = (twice - 4.0 * even) / 12.0;
        [even - fourth, 0.5 * (at(1.0) - at(-1.0)), fourth]
    }
}

/// U₂, U₃ and U₄ of the program.
fn orders(energy: &StrainEnergy, q: &[f64]) -> [f64; 3] {
    let unused = &mut vec![0.0; q.len()];
    [energy.add_quadratic(q, unused), energy.add_cubic(q, unused), energy.add_quartic(q, unused)]
}

/// By how much they differ, over U₂, √(U₂U₄), which bounds U₃, and U₄.
fn differ(expected: [f64; 3], found: [f64; 3]) -> [f64; 3] {
    let sizes = [expected[0], (expected[0] * expected[2]).sqrt(), expected[2]];
    std::array::from_fn(|order| (found[order] - expected[order]).abs() / sizes[order])
}

fn larger(one: [f64; 3], other: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|order| one[order].max(other[order]))
}

/// More than U₄ has coefficients in six unknowns, so that no other polynomial has its values.
const DIRECTIONS: usize = 130;

#[test]
fn the_energy_of_a_coupled_section_is_that_of_four_fibres_and_of_torsion() {
    let mut record = Record::new(
        "coupled-energy",
        "U₂, U₃ and U₄ of one element as functions of all that its end does, tension axis and shear centre apart and EI_yz not zero: largest \
         differences in 130 random directions, over U₂, √(U₂U₄) and U₄",
        "lengths of four fibres, EA/4 each, in the deflected element, ½EA ε² with ε = ½(|dr/dx|² − 1), and torsion; the element's shape is written out in the \
         test: cubic v and w of the shear centres, constant stretch of the tension axis, constant torque; the fibres where the eigenvectors of ∫E r rᵀ dA/EA lead; orders by \
         energies at ± 1 and ± 2 times the amplitude",
    );
    let cases = [
        ("tension axis apart", Coupling { tension_axis: COUPLED.tension_axis, ..Coupling::NONE }),
        ("shear centre apart", Coupling { shear_centre: COUPLED.shear_centre, ..Coupling::NONE }),
        ("both, EI_yz", Coupling { bend_twist: [0.0; 2], stretch_by_twist: 0.0, ..COUPLED }),
        ("all couplings", COUPLED),
    ];
    let beam = askew();
    for (name, coupling) in cases {
        let aircraft = beam.coupled(1, coupling);
        let structure = Structure::new(&aircraft).unwrap();
        let energy = StrainEnergy::new(&structure, &DMatrix::identity(6, 6));
        let (mut next, mut worst) = (random(5), [0.0; 3]);
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for _ in 0..DIRECTIONS {
            let deflected = Deflected::random(&aircraft.beams[0], beam.length, &mut next);
            let unknowns = deflected.tip().map(|local| beam.axes() * local);
            let q: Vec<f64> = unknowns.iter().flat_map(|vector| vector.iter().copied()).collect();
            let expected = deflected.orders();
            let share = expected[2] / expected[0];
            (least, most) = (least.min(share), most.max(share));
            worst = larger(worst, differ(expected, orders(&energy, &q)));
        }
        // No order hides behind another.
        println!("{name}: U4/U2 from {least:.1e} to {most:.1e}");
        assert!(least > 1e-4 && most < 1e3, "{least} {most}");
        for (order, worst) in worst.into_iter().enumerate() {
            record.rounding(&format!("{name}: U{}", order + 2), [2e-12, 2e-12, 1e-11][order], worst);
        }
    }
    record.finish();
}

#[test]
fn a_coupled_section_has_one_energy_in_all_axes_in_which_it_is_described() {
    let mut record = Record::new(
        "redescribed-section",
        "Section with all couplings, its two axes apart, described with y and z turned by 0.7 rad, about a reference axis elsewhere with rigid arms, \
         and with both: stiffness matrix, U₂, U₃, U₄",
        "the same section in other axes",
    );
    let beam = askew();
    let (sin, cos) = libm::sincos(0.7);
    let (z_axis, shift) = (beam.axis.cross(&beam.y_axis), [-0.21, 0.13]);
    let y_axis = beam.y_axis * cos + z_axis * sin;
    let offset = beam.y_axis * shift[0] + z_axis * shift[1];
    let here = beam.coupled(4, COUPLED);
    let structure = Structure::new(&here).unwrap();
    let shapes = ModalBasis::new(&structure, 12).unwrap().shapes;
    let (stiffness, energy) = (structure.stiffness(false), StrainEnergy::new(&structure, &shapes));
    for (name, is_turned, is_moved) in
        [("turned", true, false), ("about another axis", false, true), ("both", true, true)]
    {
        let mut there = here.clone();
        for beam_there in &mut there.beams {
            if is_moved {
                beam_there.coupling = about(&beam_there.coupling, shift);
            }
            if is_turned {
                *beam_there = turned(beam_there, &beam.axis, y_axis);
            }
        }
        let structure = Structure::new(&there).unwrap();
        // What nodes at the offset do by what those on the axis do.
        let mut arms = DMatrix::<f64>::identity(structure.unknowns(), structure.unknowns());
        for node in (0..structure.unknowns()).step_by(6).filter(|_| is_moved) {
            arms.fixed_view_mut::<3, 3>(node, node + 3).copy_from(&-offset.cross_matrix());
        }
        let carried = arms.transpose() * structure.stiffness(false) * &arms;
        record.rounding(
            &format!("{name}: stiffness"),
            4e-15,
            (&stiffness - carried).amax() / stiffness.amax(),
        );
        let other = StrainEnergy::new(&structure, &(&arms * &shapes));
        let (mut next, mut worst) = (random(11), [0.0; 3]);
        for _ in 0..20 {
            let q = DVector::from_fn(shapes.ncols(), |_, _| next());
            worst = larger(worst, differ(orders(&energy, q.as_slice()), orders(&other, q.as_slice())));
        }
        for (order, worst) in worst.into_iter().enumerate() {
            record.rounding(&format!("{name}: U{}", order + 2), 2e-14, worst);
        }
    }
    record.finish();
}

//! The strain energy polynomial is the integral of Green's axial strain and of torsion over the beams, its
//! gradient and its Hessian are those of that integral, and its axial–bending coupling makes a stretched
//! string sing [theory: strain-energy.polynomial, strain-energy.force; thesis §3.2].

use std::path::Path;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::structure::{ModalBasis, StrainEnergy, Structure};
use nalgebra::{DMatrix, DVector, Matrix6xX, SymmetricEigen, Vector3};

use super::record::Record;
use crate::support::beams::{Cantilever, ENDS};
use crate::support::{derivative, random};

/// Abscissae and weights on (−1, 1) of the 8-point Gauss rule (Abramowitz, Stegun, table 25.4), positive half.
pub const GAUSS_8: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_3),
];

/// A section in an integral: EA, GJ, EI_y, EI_z times the length it stands for, and the rows of
/// [u′, v′, w′, φ′, v″, w″] per generalised coordinate.
struct Section {
    rigidity: [f64; 4],
    rows: Matrix6xX<f64>,
}

/// All sections, the gradients differenced from the interpolated displacements and rotations.
fn sections(structure: &Structure, shapes: &DMatrix<f64>) -> Vec<Section> {
    let mut all = Vec::new();
    for (index, beam) in structure.aircraft.beams.iter().enumerate() {
        let geometry = &structure.geometry[index];
        for (place, weight) in GAUSS_8.iter().flat_map(|&(x, w)| [(0.5 - 0.5 * x, w), (0.5 + 0.5 * x, w)]) {
            let length = 0.5 * weight * geometry.length;
            let rigidity = [
                beam.axial_stiffness,
                beam.torsional_stiffness,
                beam.bending_stiffness_y,
                beam.bending_stiffness_z,
            ];
            all.push(Section {
                rigidity: rigidity.map(|rigidity| rigidity * length),
                rows: gradient_rows(structure, shapes, index, place),
            });
        }
    }
    all
}

/// Displacements are cubic along an element, so differences with any step are exact but for rounding.
fn gradient_rows(structure: &Structure, shapes: &DMatrix<f64>, beam: usize, place: f64) -> Matrix6xX<f64> {
    let geometry = &structure.geometry[beam];
    let n = shapes.ncols();
    let local = |fraction: f64| {
        let (translation, rotation) = geometry.section(fraction);
        let [u, phi] = [translation, rotation].map(|map| {
            geometry.axes * DMatrix::from_row_slice(3, n, &structure.apply_map(beam, &map, shapes))
        });
        [u.row(0).into_owned(), u.row(1).into_owned(), u.row(2).into_owned(), phi.row(0).into_owned()]
    };
    const STEP: f64 = 0.25;
    let h = STEP * geometry.length;
    let [b2, b1, here, a1, a2] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| local(place + k * STEP));
    let first = |i: usize| ((&a1[i] - &b1[i]) * 8.0 - (&a2[i] - &b2[i])) / (12.0 * h);
    let second = |i: usize| (&a1[i] + &b1[i] - &here[i] * 2.0) / (h * h);
    Matrix6xX::from_rows(&[first(0), first(1), first(2), first(3), second(1), second(2)])
}

/// U by direct integration of ½E ε² over four booms and of ½GJ φ′².
fn integrated(sections: &[Section], q: &DVector<f64>) -> f64 {
    let energy = |section: &Section| {
        let [ea, gj, ei_y, ei_z] = section.rigidity;
        let g = &section.rows * q;
        let [stretch, slope_v, slope_w, twist, curvature_v, curvature_w] = g.as_slice() else {
            unreachable!("six gradients")
        };
        let mut energy = 0.5 * gj * twist * twist;
        for (sign_y, sign_z) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let (y, z) = (sign_y * libm::sqrt(ei_z / ea), sign_z * libm::sqrt(ei_y / ea));
            let e = stretch - y * curvature_v - z * curvature_w;
            let (v, w) = (slope_v - z * twist, slope_w + y * twist);
            let strain = e + 0.5 * (e * e + v * v + w * w);
            energy += 0.5 * (0.25 * ea) * strain * strain;
        }
        energy
    };
    sections.iter().map(energy).sum()
}

/// U of the program, with its gradient.
fn polynomial(energy: &StrainEnergy, q: &DVector<f64>) -> (f64, DVector<f64>) {
    let mut gradient = DVector::zeros(q.len());
    let (q, g) = (q.as_slice(), gradient.as_mut_slice());
    let value = energy.add_quadratic(q, g) + energy.add_cubic(q, g) + energy.add_quartic(q, g);
    (value, gradient)
}

/// q with one coordinate moved.
fn moved(q: &DVector<f64>, mode: usize, step: f64) -> DVector<f64> {
    let mut q = q.clone();
    q[mode] += step;
    q
}

#[test]
fn value_gradient_and_hessian_are_those_of_the_integral() {
    const MODES: usize = 12;
    const STEP: f64 = 10.0;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
    let aircraft = Aircraft::read(&path).unwrap();
    let structure = Structure::new(&aircraft).unwrap();
    let shapes = ModalBasis::new(&structure, MODES).unwrap().shapes;
    let energy = StrainEnergy::new(&structure, &shapes);
    let sections = sections(&structure, &shapes);
    let mut largest = [0.0_f64; 3];
    for seed in 0..5 {
        let mut next = random(seed);
        let q = DVector::from_fn(MODES, |_, _| 40.0 * next());
        let expected = integrated(&sections, &q);
        let (value, gradient) = polynomial(&energy, &q);
        let slopes =
            DVector::from_fn(MODES, |a, _| derivative(STEP, |s| integrated(&sections, &moved(&q, a, s))));
        let columns: Vec<_> = (0..MODES).map(|b| hessian_column(&energy, &q, b)).collect();
        let hessian = DMatrix::from_columns(&columns);
        let curvatures = DMatrix::from_fn(MODES, MODES, |a, b| {
            derivative(STEP, |s| derivative(STEP, |r| integrated(&sections, &moved(&moved(&q, a, s), b, r))))
        });
        let errors = [
            (value / expected - 1.0).abs(),
            (&gradient - &slopes).norm() / slopes.norm(),
            (&hessian - &curvatures).norm() / curvatures.norm(),
        ];
        largest = std::array::from_fn(|i| largest[i].max(errors[i]));
    }
    let mut record = Record::new(
        "strain-energy",
        "Jet with 12 modes, random q with tip deflections of metres: largest relative differences",
        "direct integration of ½Eε² and ½GJφ′² (8-point Gauss rule, strains differenced from the displacement field) \
         and its differences; five-point differences of a quartic are exact",
    );
    record.rounding("U", 2e-14, largest[0]);
    record.rounding("gradient", 3e-14, largest[1]);
    record.rounding("Hessian", 6e-14, largest[2]);
    record.finish();
}

/// A column of the Hessian of U, differenced from the program's gradient, which is cubic.
fn hessian_column(energy: &StrainEnergy, q: &DVector<f64>, mode: usize) -> DVector<f64> {
    let step = 10.0;
    let g = |s: f64| polynomial(energy, &moved(q, mode, s)).1;
    ((g(step) - g(-step)) * 8.0 - (g(2.0 * step) - g(-2.0 * step))) / (12.0 * step)
}

/// Tension of the string, N: TL²/EI = 400, nearly a string without stiffness.
const TENSION: f64 = 1000.0;

/// 10 m long, hung between a clamp and a pin.
fn string() -> Cantilever {
    Cantilever {
        axis: Vector3::y(),
        y_axis: Vector3::x(),
        length: 10.0,
        axial: 1e8,
        torsional: 1e5,
        bending_y: 250.0,
        bending_z: 1e5,
        mass_per_length: 2.0,
        gyration: 1e-3,
        lumps: ENDS,
    }
}

/// The three lowest frequencies (rad/s) of small motion in z about the stretched state, tip held in z: from the
/// Hessian of U in a `full` basis, whose axial modes carry the stretch.
fn string_frequencies(elements: usize) -> Vec<f64> {
    let beam = string();
    let aircraft = beam.aircraft(elements);
    let structure = Structure::new(&aircraft).unwrap();
    let basis = ModalBasis::new(&structure, 4 * elements).unwrap();
    let tip = structure.unknowns() - 6;
    let tip_u = |shape: usize| Vector3::from_fn(|i, _| basis.shapes[(tip + i, shape)]);

    // Axial modes answer the tension with q = φ(tip) T / ω²; together they are one static shape.
    let mut stretch = DVector::zeros(structure.unknowns());
    let mut bending = Vec::new();
    for (index, mode) in basis.modes.iter().enumerate() {
        let u = tip_u(index);
        if u.y.abs() > u.norm() / 2.0 {
            stretch += basis.shapes.column(index) * (u.y * TENSION / mode.angular_frequency.powi(2));
        } else if u.z.abs() > u.norm() / 2.0 && bending.len() < elements {
            bending.push(index);
        }
    }
    let mut columns = vec![stretch];
    columns.extend(bending.iter().map(|&index| basis.shapes.column(index).into_owned()));
    let energy = StrainEnergy::new(&structure, &DMatrix::from_columns(&columns));

    // At q = (1, 0, …) the string is stretched by TENSION, at q = 0 it is slack.
    let n = bending.len();
    let stretched = DVector::from_fn(n + 1, |i, _| f64::from(i == 0));
    let hessian = DMatrix::from_fn(n, n, |a, b| {
        let g = |s: f64| polynomial(&energy, &moved(&stretched, 1 + b, s)).1[1 + a];
        derivative(1e-2, g)
    });
    let held = DVector::from_fn(n, |i, _| tip_u(bending[i]).z);
    let free = null_space(&held);
    let mut squares: Vec<f64> =
        SymmetricEigen::new(free.transpose() * hessian * &free).eigenvalues.iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    squares[..3].iter().map(|square| libm::sqrt(*square)).collect()
}

/// Orthonormal columns perpendicular to a vector (Householder).
fn null_space(vector: &DVector<f64>) -> DMatrix<f64> {
    let mut normal = vector / vector.norm();
    normal[0] += 1.0_f64.copysign(normal[0]);
    let reflection = DMatrix::identity(vector.len(), vector.len())
        - &normal * normal.transpose() * (2.0 / normal.norm_squared());
    reflection.columns(1, vector.len() - 1).into_owned()
}

/// The same of the continuous beam: tan aL / a = tanh bL / b with b² − a² = T/EI and ω² = a²b² EI/μ.
fn tensioned_beam_frequency(mode: usize) -> f64 {
    let beam = string();
    let (l, ei) = (beam.length, beam.bending_y);
    let b = |a: f64| libm::sqrt(TENSION / ei + a * a);
    let mismatch = |a: f64| libm::sin(a * l) * b(a) - a * libm::cos(a * l) * libm::tanh(b(a) * l);
    // One root between mode·π and (mode + ½)·π.
    let (mut low, mut high) =
        (mode as f64 * std::f64::consts::PI / l, (mode as f64 + 0.5) * std::f64::consts::PI / l);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if (mismatch(middle) > 0.0) == (mismatch(high) > 0.0) { high = middle } else { low = middle }
    }
    low * b(low) * libm::sqrt(ei / beam.mass_per_length)
}

#[test]
fn a_stretched_string_sings_at_its_frequencies() {
    let mut record = Record::new(
        "string",
        "Stretched string, clamped and pinned, rad/s, extrapolated from 16 and 32 elements",
        "EI w⁗ − T w″ + μ ẅ = 0, clamped and pinned: tan aL / a = tanh bL / b, b² − a² = T/EI, ω = ab√(EI/μ); the tension \
         enters only through the cubic and quartic energy of axial and bending modes of a `full` basis",
    );
    let [coarse, fine] = [16, 32].map(string_frequencies);
    let beam = string();
    for mode in 0..3 {
        let expected = tensioned_beam_frequency(mode + 1);
        let found = fine[mode] + (fine[mode] - coarse[mode]) / 3.0;
        record.relative(&format!("mode {}", mode + 1), expected, 1e-4, found);
    }
    let limit = std::f64::consts::PI / beam.length * libm::sqrt(TENSION / beam.mass_per_length);
    record.remark(&format!(
        "A string without bending stiffness would have {limit:.3} rad/s and its multiples."
    ));
    record.finish();
}

/// Elastic forces balance the loads mode by mode, summed over the elements [theory: section-loads.not-by-modes].
#[test]
fn the_elastic_forces_of_all_elements_are_those_of_the_aircraft_mode_by_mode() {
    let mut record = Record::new(
        "strain-energy-by-element",
        "∂U/∂q of Goland's wing, six modes, at a random deformation: largest difference to the sum over its elements, over the largest",
        "each element by itself, all others with 1e-20 of their stiffness",
    );
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/goland-wing.toml");
    let aircraft = Aircraft::read(&path).unwrap();
    let structure = Structure::new(&aircraft).unwrap();
    let shapes = ModalBasis::new(&structure, 6).unwrap().shapes;
    let mut next = random(5);
    let q: Vec<f64> = (0..shapes.ncols()).map(|_| 3.0 * next()).collect();
    let gradient = |aircraft: &Aircraft| {
        let energy = StrainEnergy::new(&Structure::new(aircraft).unwrap(), &shapes);
        let mut gradient = vec![0.0; q.len()];
        energy.add_quadratic(&q, &mut gradient);
        energy.add_cubic(&q, &mut gradient);
        energy.add_quartic(&q, &mut gradient);
        DVector::from_vec(gradient)
    };
    const NOTHING: f64 = 1e-20;
    let alone = |element: usize| {
        let mut aircraft = aircraft.clone();
        for (_, beam) in aircraft.beams.iter_mut().enumerate().filter(|(other, _)| *other != element) {
            beam.axial_stiffness *= NOTHING;
            beam.torsional_stiffness *= NOTHING;
            beam.bending_stiffness_y *= NOTHING;
            beam.bending_stiffness_z *= NOTHING;
        }
        gradient(&aircraft)
    };
    let sum: DVector<f64> = (0..aircraft.beams.len()).map(alone).sum();
    let expected = gradient(&aircraft);
    record.rounding("six modes", 1e-12, (sum - &expected).amax() / expected.amax());
    record.finish();
}

//! Joints [theory: structure.joints, structure.loops]: frames that close on themselves deflect as textbooks say, swing as closed
//! forms and stiff springs in the joints' place say, and leave the mirror plane. Feet that no tree holds hang on members from O that
//! are 10⁶ times as stiff.

use flexible_aircraft::aircraft::{Aircraft, Hinge, ModeBasis, Spring};
use flexible_aircraft::structure::{ModalBasis, ModeFamily, Structure};
use nalgebra::{Cholesky, DMatrix, DVector, SMatrix, SymmetricEigen, Vector3};

use super::record::Record;

/// EI of all members, N·m², and how much stiffer those are that hold feet.
const EI: f64 = 2e5;
const STIFF: f64 = 1e6;

/// A component of a frame: where it hangs, where it goes, in how many elements, how much stiffer than usual.
fn member(name: &str, on: &str, to: [f64; 3], elements: usize, stiffer: f64) -> String {
    let ei = EI * stiffer;
    // Nothing stretches to five digits; of the stiff ones the format allows no more.
    let ea = if stiffer > 1.0 { 1e3 * ei } else { 1e6 * ei };
    let mass = if stiffer > 1.0 {
        String::new()
    } else {
        "[[component.distributed_mass]]\nparts = [{ total_kg = 12 }]\n".to_owned()
    };
    format!(
        "[[component]]\nname = \"{name}\"\nattached_to = {on}\naxis_m = [[0, 0, 0], {to:?}]\nelements = {elements}\n\
         y_axis = [1, 0, 0]\nEA_N = {ea}\nGJ_N_m2 = {ei}\nEI_y_N_m2 = {ei}\nEI_z_N_m2 = {ei}\n{mass}"
    )
}

fn frame(parts: &[String]) -> Aircraft {
    let head =
        "format = 1\nname = \"Frame\"\nsupport = \"clamped\"\nmode_basis = \"full\"\nmodel = \"exact\"\n";
    let text = head.to_owned() + &parts.join("");
    Aircraft::parse(&text, "frame.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn end_of(name: &str) -> String {
    format!("{{ component = \"{name}\", at = 1 }}")
}

fn joint(one: &str, at: f64, other: &str, rotations: &str) -> String {
    format!(
        "[[joint]]\ncomponent = \"{one}\"\nat = {at}\njoined_to = {{ component = \"{other}\", at = 1 }}\nrotations = {rotations}\n"
    )
}

/// The node at the end of an element of a component.
fn node(aircraft: &Aircraft, component: &str, number: usize) -> usize {
    let component = aircraft.components.iter().find(|other| other.name == component).unwrap();
    component.nodes[number]
}

/// The displacements of all unknowns under forces at nodes.
fn deflected(structure: &Structure, forces: &[(usize, Vector3<f64>)]) -> DVector<f64> {
    let mut load = DVector::zeros(structure.unknowns());
    for (node, force) in forces {
        let mut at = load.fixed_rows_mut::<3>(6 * (node - 1));
        at += force;
    }
    let joined = structure.joined();
    let stiffness = joined.transpose() * structure.stiffness(false) * &joined;
    &joined * Cholesky::new(stiffness).unwrap().solve(&(joined.transpose() * load))
}

fn at(unknowns: &DVector<f64>, node: usize) -> Vector3<f64> {
    unknowns.fixed_rows::<3>(6 * (node - 1)).into()
}

/// A beam along y with a prop under its tip.
fn propped(length: f64, elements: usize) -> Aircraft {
    let beam = member("beam", "\"origin\"", [0.0, length, 0.0], elements, 1.0);
    let prop = member("prop", "\"origin\"", [0.0, length, 0.0], 1, STIFF);
    frame(&[beam, prop, joint("beam", 1.0, "prop", "\"free\"")])
}

#[test]
fn a_propped_cantilever_sags_and_swings_as_the_closed_forms_say() {
    let length = 4.0;
    let aircraft = propped(length, 40);
    let structure = Structure::new(&aircraft).unwrap();
    let (middle, force) = (node(&aircraft, "beam", 20), 1000.0);
    let sagged = deflected(&structure, &[(middle, Vector3::z() * force)]);
    let mut record = Record::new(
        "joints",
        "Frames closed by joints: deflections (m), frequencies (rad/s)",
        "force method and slope-deflection, derived beside the numbers [theory: structure.joints]",
    );
    // A cantilever under F at half its length, held up at its tip by R: F (L/2)² (3L − L/2)/(6EI) = R L³/(3EI), so R = 5F/16; the
    // middle goes down by F (L/2)³/(3EI) − R (L/2)² (3L − L/2)/(6EI) = 7 F L³/(768 EI).
    let sag = 7.0 * force * length.powi(3) / (768.0 * EI);
    record.relative("propped cantilever, middle under a force there", sag, 1e-4, at(&sagged, middle).z);
    // Clamped and pinned: tan βL = tanh βL (for instance Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1).
    let basis = ModalBasis::new(&structure, 8).unwrap();
    for (number, product) in [3.926_602_3, 7.068_582_7].into_iter().enumerate() {
        let exact = libm::sqrt(EI / (12.0 / length)) * (product / length).powi(2);
        let nearest = basis.modes.iter().map(|mode| mode.angular_frequency);
        let nearest = nearest.min_by(|a, b| (a - exact).abs().total_cmp(&(b - exact).abs())).unwrap();
        // 40 lumps: of second order.
        record.relative(&format!("propped cantilever, frequency {}", number + 1), exact, 1e-4, nearest);
    }
    let (height, span) = (3.0, 5.0);
    let frame = portal(height, span, "\"fixed\"");
    let structure = Structure::new(&frame).unwrap();
    let corner = node(&frame, "column", 4);
    let swayed = at(&deflected(&structure, &[(corner, Vector3::y() * force)]), corner).y;
    // Slope-deflection, both feet fixed: corners turn by θ where 4θ/h − 6Δ/h² + 6θ/l = 0; F = 2 (12 Δ/h³ − 6 θ/h²) EI.
    let turn = 6.0 / height.powi(2) / (4.0 / height + 6.0 / span);
    let sway = force / (2.0 * EI * (12.0 / height.powi(3) - 6.0 * turn / height.powi(2)));
    record.relative("portal frame, sway under a force at a corner, feet fixed", sway, 1e-4, swayed);
    record.finish();
}

/// A portal frame in the plane of y and z, whose second foot stands on a stiff member.
fn portal(height: f64, span: f64, rotations: &str) -> Aircraft {
    frame(&[
        member("column", "\"origin\"", [0.0, 0.0, -height], 4, 1.0),
        member("lintel", &end_of("column"), [0.0, span, 0.0], 4, 1.0),
        member("other", &end_of("lintel"), [0.0, 0.0, height], 4, 1.0),
        member("ground", "\"origin\"", [0.0, span, 0.0], 1, STIFF),
        joint("other", 1.0, "ground", rotations),
    ])
}

#[test]
fn a_foot_that_shares_a_rotation_about_one_axis_is_held_about_that_alone() {
    let (height, span, force) = (3.0, 5.0, 1000.0);
    let sway = |rotations: &str| {
        let frame = portal(height, span, rotations);
        let structure = Structure::new(&frame).unwrap();
        let corner = node(&frame, "column", 4);
        at(&deflected(&structure, &[(corner, Vector3::y() * force)]), corner).y
    };
    // In the plane of y and z nothing turns but about x.
    let [fixed, about_x, free, about_y] = ["\"fixed\"", "[\"x\"]", "\"free\"", "[\"z\", \"y\"]"].map(sway);
    assert!((about_x / fixed - 1.0).abs() < 1e-9 && (about_y / free - 1.0).abs() < 1e-9);
    // With a pin under the second column, unknowns θ1, θ2 and Δ: 4θ1/h − 6Δ/h² + (4θ1 + 2θ2)/l = 0, 3θ2/h − 3Δ/h² + (2θ1 + 4θ2)/l = 0,
    // F = EI (12Δ/h³ − 6θ1/h² + 3Δ/h³ − 3θ2/h²).
    let (h, l) = (height, span);
    let corners = nalgebra::Matrix2::new(4.0 / h + 4.0 / l, 2.0 / l, 2.0 / l, 3.0 / h + 4.0 / l);
    let turns = corners.lu().solve(&nalgebra::Vector2::new(6.0 / (h * h), 3.0 / (h * h))).unwrap();
    let pinned = force / (EI * (15.0 / h.powi(3) - (6.0 * turns[0] + 3.0 * turns[1]) / (h * h)));
    assert!((free / pinned - 1.0).abs() < 1e-4, "{free} {pinned}");
}

/// The textbook stiffness of a space frame's member (Przemieniecki, Theory of Matrix Structural Analysis, eq. 5.116, without shear),
/// local axes, unknowns u, v, w, φx, φy, φz of both ends.
fn textbook(length: f64, [ea, gj, ei_y, ei_z]: [f64; 4]) -> SMatrix<f64, 12, 12> {
    let mut k = SMatrix::<f64, 12, 12>::zeros();
    let mut put = |i: usize, j: usize, value: f64| {
        k[(i, j)] += value;
        if i != j {
            k[(j, i)] += value;
        }
    };
    for (first, stiffness) in [(0, ea), (3, gj)] {
        let spring = stiffness / length;
        put(first, first, spring);
        put(first + 6, first + 6, spring);
        put(first, first + 6, -spring);
    }
    // Deflection, slope, and the sign of the slope in right-handed rotations.
    for (deflection, turn, stiffness, sign) in [(1, 5, ei_z, 1.0), (2, 4, ei_y, -1.0)] {
        let [a, b, c] = [12.0, 6.0, 4.0].map(|factor| factor * stiffness);
        let (l2, l3) = (length.powi(2), length.powi(3));
        put(deflection, deflection, a / l3);
        put(deflection + 6, deflection + 6, a / l3);
        put(deflection, deflection + 6, -a / l3);
        put(deflection, turn, sign * b / l2);
        put(deflection, turn + 6, sign * b / l2);
        put(deflection + 6, turn, -sign * b / l2);
        put(deflection + 6, turn + 6, -sign * b / l2);
        put(turn, turn, c / length);
        put(turn + 6, turn + 6, c / length);
        put(turn, turn + 6, 0.5 * c / length);
    }
    k
}

const BRACED: &str = include_str!("../data/strut-braced.toml");
const TWIN_BOOM: &str = include_str!("../data/twin-boom.toml");

/// The halves of its tailplane joined.
fn joined_twin_boom() -> String {
    TWIN_BOOM.to_owned() + &joint("tail_right", 1.0, "tail_left", "\"fixed\"")
}

fn parsed(text: &str) -> Aircraft {
    Aircraft::parse(text, "joined.toml").unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_braced_wing_deflects_as_a_textbook_frame_whose_members_meet_in_one_node() {
    let aircraft = parsed(BRACED);
    let structure = Structure::new(&aircraft).unwrap();
    // The number of each unknown: a strut's end has the displacements of its wing's node, and rotations of its own.
    let mut number: Vec<usize> = (0..6 * aircraft.nodes.len()).collect();
    for (strut, wing) in [("strut_right", "wing_right"), ("strut_left", "wing_left")] {
        let (end, on) = (node(&aircraft, strut, 4), node(&aircraft, wing, 4));
        assert!((aircraft.nodes[end] - aircraft.nodes[on]).norm() < 1e-12);
        (0..3).for_each(|axis| number[6 * end + axis] = 6 * on + axis);
    }
    let size = number.len();
    let mut stiffness = DMatrix::<f64>::zeros(size, size);
    for beam in &aircraft.beams {
        let [from, to] = beam.nodes.map(|node| aircraft.nodes[node]);
        let x = (to - from).normalize();
        let axes = nalgebra::Matrix3::from_rows(&[
            x.transpose(),
            beam.y_axis.transpose(),
            x.cross(&beam.y_axis).transpose(),
        ]);
        let mut turn = SMatrix::<f64, 12, 12>::zeros();
        (0..4).for_each(|block| turn.fixed_view_mut::<3, 3>(3 * block, 3 * block).copy_from(&axes));
        let stiffnesses = [
            beam.axial_stiffness,
            beam.torsional_stiffness,
            beam.bending_stiffness_y,
            beam.bending_stiffness_z,
        ];
        let element = turn.transpose() * textbook((to - from).norm(), stiffnesses) * turn;
        let unknown = |local: usize| number[6 * beam.nodes[local / 6] + local % 6];
        for (i, j) in (0..12).flat_map(|i| (0..12).map(move |j| (i, j))) {
            stiffness[(unknown(i), unknown(j))] += element[(i, j)];
        }
    }
    // O is clamped; numbers that are another's are held.
    for unknown in (0..size).filter(|&unknown| unknown < 6 || number[unknown] != unknown) {
        stiffness[(unknown, unknown)] = 1.0;
        (0..size).filter(|&other| other != unknown).for_each(|other| {
            stiffness[(unknown, other)] = 0.0;
            stiffness[(other, unknown)] = 0.0;
        });
    }
    let (right, left) = (node(&aircraft, "wing_right", 8), node(&aircraft, "wing_left", 6));
    let forces = [(right, Vector3::new(300.0, 50.0, -2000.0)), (left, Vector3::new(-100.0, 20.0, -900.0))];
    let mut load = DVector::zeros(size);
    for (node, force) in forces {
        load.fixed_rows_mut::<3>(6 * node).copy_from(&force);
    }
    let expected = Cholesky::new(stiffness).unwrap().solve(&load);
    let found = deflected(&structure, &forces);
    let largest = found.amax();
    for unknown in 6..size {
        let difference = (found[unknown - 6] - expected[number[unknown]]).abs();
        assert!(difference < 1e-9 * largest, "{unknown}: {difference}, of {largest}");
    }
    // The strut carries: without it the wing bends much further.
    let alone = parsed(&BRACED.replace("[[joint]]\ncomponent = \"strut_right\"\nat = 1\njoined_to = { component = \"wing_right\", at = 0.5 }\nrotations = \"free\"\n", ""));
    let alone = Structure::new(&alone).unwrap();
    assert!(at(&deflected(&alone, &forces), right).z < 2.0 * at(&found, right).z);
}

/// Frequencies with springs in place of joints, lowest first, rad/s, of a structure with axially rigid members beside loops.
fn with_springs(aircraft: &Aircraft, spring: f64, count: usize) -> Vec<f64> {
    let structure = Structure::new(aircraft).unwrap();
    let mut stiffness = structure.stiffness(aircraft.mode_basis == ModeBasis::BendingTorsion);
    for joint in &aircraft.joints {
        let [one, other] = joint.nodes().map(|node| 6 * (node - 1));
        let axes = (0..3).chain((3..6).filter(|axis| joint.rotations[axis - 3]));
        for axis in axes {
            let (one, other) = (one + axis, other + axis);
            stiffness[(one, one)] += spring;
            stiffness[(other, other)] += spring;
            stiffness[(one, other)] -= spring;
            stiffness[(other, one)] -= spring;
        }
    }
    let lower = Cholesky::new(stiffness).unwrap().l();
    let half = lower.solve_lower_triangular(&structure.mass()).unwrap();
    let flexibility = lower.solve_lower_triangular(&half.transpose()).unwrap();
    let mut squares: Vec<f64> = SymmetricEigen::new((&flexibility + flexibility.transpose()) * 0.5)
        .eigenvalues
        .iter()
        .copied()
        .collect();
    squares.sort_by(|a, b| b.total_cmp(a));
    squares.iter().take(count).map(|square| 1.0 / square.sqrt()).collect()
}

#[test]
fn joined_aircraft_swing_as_with_stiff_springs_in_their_joints_and_keep_their_families() {
    for text in [BRACED.to_owned(), joined_twin_boom()] {
        let aircraft = parsed(&text);
        let structure = Structure::new(&aircraft).unwrap();
        let basis = ModalBasis::new(&structure, 16).unwrap();
        let expected = with_springs(&aircraft, 1e12, 16);
        for (mode, expected) in basis.modes.iter().zip(&expected) {
            assert!((mode.angular_frequency / expected - 1.0).abs() < 1e-5, "{mode:?} {expected}");
        }
        let families = [ModeFamily::Symmetric, ModeFamily::Antisymmetric];
        assert!(basis.modes.iter().all(|mode| families.contains(&mode.family)), "{}", aircraft.name);
        for (mode, shape) in basis.modes.iter().zip(basis.shapes.column_iter()) {
            let sign = if mode.family == ModeFamily::Symmetric { 1.0 } else { -1.0 };
            for component in &aircraft.components {
                let Some(image) = component.image else { continue };
                for (&node, &image) in component.nodes.iter().zip(&aircraft.components[image].nodes).skip(1) {
                    for (axis, reflected) in [1.0, -1.0, 1.0, -1.0, 1.0, -1.0].into_iter().enumerate() {
                        let (one, other) = (shape[6 * (node - 1) + axis], shape[6 * (image - 1) + axis]);
                        assert!((one - sign * reflected * other).abs() < 1e-12 * shape.amax());
                    }
                }
            }
            for joint in &aircraft.joints {
                let [one, other] = joint.nodes().map(|node| 6 * (node - 1));
                for axis in (0..3).chain((3..6).filter(|axis| joint.rotations[axis - 3])) {
                    assert_eq!(shape[one + axis], shape[other + axis]);
                }
            }
        }
    }
}

#[test]
fn joined_halves_of_a_tail_meet_in_the_plane_and_swing_higher() {
    let lowest = |text: &str| {
        let aircraft = parsed(text);
        let basis = ModalBasis::new(&Structure::new(&aircraft).unwrap(), 24).unwrap();
        let across = |family| {
            let modes = basis.modes.iter().zip(basis.shapes.column_iter());
            let of_family = modes.filter(move |(mode, _)| mode.family == family);
            let end = 6 * (node(&aircraft, "tail_right", 4) - 1);
            of_family.map(|(_, shape)| (shape.rows(end, 6).clone_owned(), shape.amax())).collect::<Vec<_>>()
        };
        let frequencies: Vec<f64> = basis.modes.iter().map(|mode| mode.angular_frequency).collect();
        (frequencies, across(ModeFamily::Symmetric), across(ModeFamily::Antisymmetric))
    };
    let (apart, ..) = lowest(TWIN_BOOM);
    let (joined, symmetric, antisymmetric) = lowest(&joined_twin_boom());
    // Rayleigh: a constraint lowers no frequency. (Elements of the loop have their own EA, which hardly counts here.)
    assert!(
        apart.iter().zip(&joined).all(|(apart, joined)| *joined > apart * (1.0 - 1e-3)),
        "{apart:?} {joined:?}"
    );
    for (ends, still) in [(symmetric, [1, 3, 5]), (antisymmetric, [0, 2, 4])] {
        for (end, largest) in ends {
            assert!(still.iter().all(|&axis| end[axis].abs() < 1e-12 * largest), "{end}");
        }
    }
}

#[test]
fn a_loop_bends_as_far_as_its_members_stretch_in_a_basis_of_bending_and_torsion_too() {
    let [own, full] = ["bending_torsion", "full"].map(|basis| {
        let aircraft =
            parsed(&BRACED.replace("mode_basis = \"bending_torsion\"", &format!("mode_basis = \"{basis}\"")));
        let basis = ModalBasis::new(&Structure::new(&aircraft).unwrap(), 6).unwrap();
        basis.modes.iter().map(|mode| mode.angular_frequency).collect::<Vec<_>>()
    });
    // Beside the loops nothing stretches that counts in the lowest modes.
    for (own, full) in own.iter().zip(&full) {
        assert!((own / full - 1.0).abs() < 5e-3, "{own} {full}");
    }
}

#[test]
fn a_hinged_member_of_a_loop_is_the_same_in_every_basis() {
    // A strut on a spring, whose tension axis is apart: the balance of its hinge depends on its EA, which it keeps in a loop.
    let [own, full] = [ModeBasis::BendingTorsion, ModeBasis::Full].map(|basis| {
        let mut aircraft = parsed(BRACED);
        aircraft.mode_basis = basis;
        for side in ["strut_right", "strut_left"] {
            let root = aircraft.beams.iter_mut().find(|beam| beam.component == side).unwrap();
            root.coupling.tension_axis = [0.05, 0.1];
            root.hinge = Some(Hinge { springs: vec![Spring { axis: Vector3::x(), stiffness: 3e4 }] });
        }
        Structure::new(&aircraft).unwrap().stiffness(false)
    });
    assert!((&own - &full).amax() < 1e-12 * full.amax(), "{}", (&own - &full).amax() / full.amax());
}

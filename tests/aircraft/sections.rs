//! What a file may say of sections beyond four stiffnesses: boxes, matrices, coupling, hinges, and what of it is refused.

use flexible_aircraft::aircraft::{Aircraft, Beam, Coupling, Problem};
use nalgebra::{Matrix3, Vector3};

/// A wing of 4 m on each side, whose sections are to be said, and a tip on it.
fn file(section: &str) -> String {
    format!(
        "format = 1\nname = \"Wing\"\nsupport = \"clamped\"\nmode_basis = \"full\"\nsymmetric = true\n\n\
         [[component]]\nname = \"right\"\nmirror = \"left\"\nattached_to = \"origin\"\naxis_m = [[0, 0, 0], [0, 4, 0]]\n\
         elements = 2\ny_axis = [1, 0, 0]\n{section}\n\n[[component.point_masses]]\nat = 1\nmass_kg = 1\n"
    )
}

const STIFFNESSES: &str = "EA_N = 1e7\nGJ_N_m2 = 2e4\nEI_y_N_m2 = 5e4\nEI_z_N_m2 = 8e5\n";

fn read(section: &str) -> Aircraft {
    Aircraft::parse(&file(section), "wing.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn stiffnesses(beam: &Beam) -> [f64; 4] {
    [beam.axial_stiffness, beam.torsional_stiffness, beam.bending_stiffness_y, beam.bending_stiffness_z]
}

/// The only complaint about a file: what kind of mistake, and its text from the field on.
fn complaint(section: &str) -> (Problem, String) {
    let error = Aircraft::parse(&file(section), "wing.toml").unwrap_err();
    let [one] = error.diagnostics() else { panic!("{error}") };
    (one.problem, format!("{}: {}; {}", one.field, one.found, one.allowed))
}

/// A matrix as a file writes it, of some entries above its diagonal and their images.
fn matrix(diagonal: [f64; 6], above: &[(usize, usize, f64)]) -> String {
    let mut matrix = [[0.0; 6]; 6];
    for (i, entry) in diagonal.into_iter().enumerate() {
        matrix[i][i] = entry;
    }
    for &(i, j, entry) in above {
        (matrix[i - 1][j - 1], matrix[j - 1][i - 1]) = (entry, entry);
    }
    format!("{matrix:?}")
}

#[test]
fn couplings_are_mirrored_such_that_both_wings_do_the_same() {
    let beside = "EI_yz_N_m2 = 1e5\nbend_twist_y_N_m2 = { multiple_of = \"EI_y_N_m2\", factor = 0.2 }\nbend_twist_z_N_m2 = 2e4\n\
                  tension_axis_y_m = { polynomial = [0, 0.04] }\ntension_axis_z_m = 0.02\nshear_centre_y_m = -0.03\nshear_centre_z_m = 0.01\n";
    let wings = read(&format!("{STIFFNESSES}{beside}"));
    let expected = Coupling {
        bending: 1e5,
        bend_twist: [1e4, 2e4],
        stretch_by_twist: 0.0,
        tension_axis: [0.03, 0.02],
        shear_centre: [-0.03, 0.01],
    };
    assert_eq!(wings.beams[1].coupling, expected);
    let image = wings.beams[3].coupling;
    assert_eq!((image.bending, image.bend_twist), (-1e5, [1e4, -2e4]));
    assert_eq!((image.tension_axis, image.shear_centre), ([0.03, -0.02], [-0.03, -0.01]));
    // `symmetric = true` has compared both sides; a left wing that is written like the right one is no image.
    let other = file(&format!("{STIFFNESSES}{beside}")).replace("mirror = \"left\"\n", "");
    let left = other
        .split("\n\n")
        .nth(1)
        .unwrap()
        .replace("\"right\"", "\"left\"")
        .replace("[0, 4, 0]", "[0, -4, 0]");
    let masses = "[[component.point_masses]]\nat = 1\nmass_kg = 1\n";
    let error = Aircraft::parse(&format!("{other}\n{left}\n{masses}"), "wing.toml").unwrap_err();
    assert!(error.diagnostics().iter().all(|one| one.problem == Problem::NotSymmetric), "{error}");
    // It is with the local axes turned about, and the signs that this asks for.
    let mut turned = left.replace("y_axis = [1, 0, 0]", "y_axis = [-1, 0, 0]");
    for (name, from, to) in [
        ("EI_yz_N_m2", "1e5", "-1e5"),
        ("tension_axis_y_m", "{ polynomial = [0, 0.04] }", "{ polynomial = [0, -0.04] }"),
        ("shear_centre_y_m", "-0.03", "0.03"),
        ("bend_twist_y_N_m2", "{ multiple_of = \"EI_y_N_m2\", factor = 0.2 }", "-1e4"),
    ] {
        let (from, to) = (format!("{name} = {from}"), format!("{name} = {to}"));
        assert!(turned.contains(&from), "{from}");
        turned = turned.replace(&from, &to);
    }
    Aircraft::parse(&format!("{other}\n{turned}\n{masses}"), "wing.toml")
        .unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn a_matrix_without_coupling_is_four_stiffnesses_and_places_are_linear_between() {
    let at = |at: f64, gj: f64| {
        let diagonal = [1e7, 3e6, 2e6, gj, 5e4, 8e5];
        format!("{{ at = {at}, matrix = {} }}", matrix(diagonal, &[]))
    };
    let wings = read(&format!("section_stiffness = [{}, {}]", at(0.25, 2e4), at(1.0, 5e4)));
    for (element, gj) in [(0, 2e4), (1, 4e4)] {
        let found = stiffnesses(&wings.beams[element]);
        for (found, expected) in found.into_iter().zip([1e7, gj, 5e4, 8e5]) {
            assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        }
        let Coupling { bending, bend_twist, stretch_by_twist, tension_axis, shear_centre } =
            wings.beams[element].coupling;
        let all = [bending, bend_twist[0], bend_twist[1], stretch_by_twist];
        assert!(all.into_iter().chain(tension_axis).chain(shear_centre).all(|number| number.abs() < 1e-9));
    }
}

#[test]
fn a_matrix_about_an_axis_is_that_of_places_and_couplings() {
    // Tension axis at (0.1, 0): F1 = EA (ε − y κ3), so that S16 = −EA y and S66 = EI_z + EA y²; S45 = −K_y.
    let (ea, y, k) = (1e7, 0.1, 1e4);
    let diagonal = [ea, 3e6, 2e6, 2e4, 5e4, 8e5 + ea * y * y];
    let text =
        format!("section_stiffness = [{{ matrix = {} }}]", matrix(diagonal, &[(1, 6, -ea * y), (4, 5, -k)]));
    let wings = read(&text);
    let fields = read(&format!("{STIFFNESSES}bend_twist_y_N_m2 = {k}\ntension_axis_y_m = {y}"));
    for (one, other) in wings.beams.iter().zip(&fields.beams) {
        for (one, other) in stiffnesses(one).into_iter().zip(stiffnesses(other)) {
            assert!((one / other - 1.0).abs() < 1e-12, "{one} {other}");
        }
        assert!((one.coupling.bend_twist[0] - other.coupling.bend_twist[0]).abs() < 1e-9 * k);
        assert!((one.coupling.tension_axis[0] - y).abs() < 1e-12);
    }
}

#[test]
fn a_box_has_the_stiffness_of_its_walls_and_weighs_something_where_its_density_is_said() {
    let sizes = "height_m = 0.1\nwidth_m = { at = [0, 1], values = [0.4, 0.2] }\nskin_m = 0.002\nE_Pa = 7e10\nG_Pa = 2.6e10\n";
    let text = |density: &str| format!("[component.box]\n{sizes}{density}");
    let wings = read(&text(""));
    let (w, h, t): (f64, f64, f64) = (0.35, 0.1, 0.002);
    let (wi, hi) = (w - 2.0 * t, h - 2.0 * t);
    let expected = [
        7e10 * (w * h - wi * hi),
        4.0 * 2.6e10 * ((w - t) * (h - t)).powi(2) * t / (2.0 * (w - t) + 2.0 * (h - t)),
        7e10 * (w * h * h * h - wi * hi * hi * hi) / 12.0,
        7e10 * (h * w * w * w - hi * wi * wi * wi) / 12.0,
    ];
    for (found, expected) in stiffnesses(&wings.beams[0]).into_iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
    assert_eq!(wings.bays.len(), 2);
    let heavy = read(&text("density_kg_m3 = 2700"));
    let box_bays = &heavy.written[0].groups.iter().find(|group| group.name == "box").unwrap().bays;
    assert_eq!((heavy.bays.len(), box_bays.len()), (6, 4));
    let bay = &heavy.bays[box_bays[0]];
    // Of 2 m; local z is −z, local y is x.
    let mass = 2700.0 * 2.0 * (w * h - wi * hi);
    assert!((bay.mass / mass - 1.0).abs() < 1e-12);
    let (about_y, about_z) = (2700.0 * 2.0 * expected[2] / 7e10, 2700.0 * 2.0 * expected[3] / 7e10);
    let rod = mass * 4.0 / 12.0;
    let expected = Matrix3::from_diagonal(&Vector3::new(about_y + rod, about_y + about_z, about_z + rod));
    assert!((bay.inertia - expected).norm() < 1e-12 * expected.norm(), "{} {expected}", bay.inertia);
    // With its centre on the tension axis.
    let beside = read(&format!("tension_axis_y_m = 0.05\n{}", text("density_kg_m3 = 2700")));
    assert!((beside.bays[box_bays[0]].offset - Vector3::new(0.05, 0.0, 0.0)).norm() < 1e-15);
}

#[test]
fn a_section_mass_is_a_bay_with_offset_and_inertia() {
    // μ = 4 kg/m, c = (0, −0.1, 0): M15 … by −μ c×; J about the axis.
    let (mu, c) = (4.0, -0.1);
    let inertia = [0.09 + mu * c * c, 0.03, 0.06 + mu * c * c];
    let diagonal = [mu, mu, mu, inertia[0], inertia[1], inertia[2]];
    let entries = [(1, 6, -mu * c), (3, 4, mu * c), (5, 6, 0.005)];
    let wings = read(&format!("{STIFFNESSES}section_mass = [{{ matrix = {} }}]", matrix(diagonal, &entries)));
    let bay = &wings.bays
        [wings.written[0].groups.iter().find(|group| group.name == "section_mass").unwrap().bays[0]];
    assert!(
        (bay.mass - 8.0).abs() < 1e-12 && (bay.offset - Vector3::new(-0.1, 0.0, 0.0)).norm() < 1e-15,
        "{bay:?}"
    );
    // Local x, y, z are y, x, −z of the body.
    let rod = 8.0 * 4.0 / 12.0;
    let expected = Matrix3::new(0.06 + rod, 0.0, -0.01, 0.0, 0.18, 0.0, -0.01, 0.0, 0.12 + rod);
    assert!((bay.inertia - expected).norm() < 1e-12, "{}", bay.inertia);
}

#[test]
fn what_no_section_is_like_is_refused() {
    let (problem, text) = complaint(&format!("{STIFFNESSES}bend_twist_y_N_m2 = 3.2e4"));
    assert_eq!(problem, Problem::NotPositiveDefinite);
    assert_eq!(
        text,
        "component.right.bend_twist_y_N_m2.element[1]: found EI_yz = 0, bend–twist 32000 and 0 N m² with GJ = 20000, EI_y = 50000, \
         EI_z = 800000 N m²; a positive definite stiffness is allowed: by which every strain has energy"
    );
    let stiffness = |diagonal: [f64; 6], above: &[(usize, usize, f64)]| {
        complaint(&format!("section_stiffness = [{{ matrix = {} }}]", matrix(diagonal, above)))
    };
    let usual = [1e7, 3e6, 2e6, 2e4, 5e4, 8e5];
    let (problem, text) = stiffness(usual, &[(2, 4, 3e5)]);
    assert_eq!(problem, Problem::NotPositiveDefinite);
    assert!(
        text.starts_with("component.right.section_stiffness[1].matrix: found a matrix by which some strain"),
        "{text}"
    );
    let (problem, _) = stiffness([-1e7, 3e6, 2e6, 2e4, 5e4, 8e5], &[]);
    assert_eq!(problem, Problem::NotPositiveDefinite);
    let skew = matrix(usual, &[]).replacen("[0.0, 3000000.0", "[7.0, 3000000.0", 1);
    let (problem, text) = complaint(&format!("section_stiffness = [{{ matrix = {skew} }}]"));
    assert_eq!(problem, Problem::Contradiction);
    assert!(text.contains("found 0 in row 1 and 7 in row 2"), "{text}");
    let mass = matrix([4.0, 4.0, 3.0, 1.0, 1.0, 1.0], &[]);
    let (problem, text) = complaint(&format!("{STIFFNESSES}section_mass = [{{ matrix = {mass} }}]"));
    assert_eq!(problem, Problem::UnphysicalInertia);
    assert!(text.contains("found masses that are not alike in all directions"), "{text}");
    let mass = matrix([4.0, 4.0, 4.0, 0.5, 0.1, 0.1], &[(3, 4, 4.0 * 0.6)]);
    let (problem, _) = complaint(&format!("{STIFFNESSES}section_mass = [{{ matrix = {mass} }}]"));
    assert_eq!(problem, Problem::UnphysicalInertia);
    // However long the elements: what an element is as a rod has no part in it.
    let mass = matrix([4.0, 4.0, 4.0, 1.0, 0.01, 0.01], &[]);
    let (problem, text) = complaint(&format!("{STIFFNESSES}section_mass = [{{ matrix = {mass} }}]"));
    assert_eq!(problem, Problem::UnphysicalInertia);
    assert_eq!(
        text,
        "component.right.section_mass[1].matrix: found the principal moments of inertia 0.01000, 0.01000, 1.00000 kg m about its centre; \
         moments are allowed of which none is negative or greater than the sum of the others"
    );
}

#[test]
fn each_matrix_has_to_be_one_of_a_section_wherever_elements_have_their_middles() {
    let at = |at: f64, torsion: f64| {
        format!("{{ at = {at}, matrix = {} }}", matrix([1e7, 3e6, 2e6, 2e4, 5e4, 8e5], &[(4, 5, torsion)]))
    };
    let (problem, text) = complaint(&format!("section_stiffness = [{}, {}]", at(0.0, 0.0), at(1.0, 3.3e4)));
    assert_eq!(problem, Problem::NotPositiveDefinite);
    assert!(
        text.starts_with("component.right.section_stiffness[2].matrix: found a matrix by which"),
        "{text}"
    );
}

#[test]
fn two_ways_to_say_it_a_wall_too_thick_and_places_out_of_order_are_refused() {
    let tube = "box = { height_m = 0.1, width_m = 0.2, skin_m = 0.002, E_Pa = 7e10, G_Pa = 2.6e10 }\n";
    let (problem, text) = complaint(&format!("{tube}GJ_N_m2 = 1e4"));
    assert_eq!(problem, Problem::Contradiction);
    assert!(text.starts_with("component.right.GJ_N_m2: found \"box\" and \"GJ_N_m2\""), "{text}");
    let (problem, text) = complaint(&tube.replace("0.002", "0.026"));
    assert_eq!(problem, Problem::OutOfRange);
    assert_eq!(
        text,
        "component.right.box.skin_m.element[1]: found 0.026 m; a wall of at most 0.025 m, a quarter of the box, is allowed"
    );
    let at = |at: f64| format!("{{ at = {at}, matrix = {} }}", matrix([1e7, 3e6, 2e6, 2e4, 5e4, 8e5], &[]));
    let matrices = format!("section_stiffness = [{}, {}]\n", at(0.5), at(0.5));
    let (problem, text) = complaint(&matrices);
    assert_eq!(problem, Problem::OutOfRange);
    assert!(text.contains("increasing places are allowed"), "{text}");
    let (problem, _) = complaint(&format!("section_stiffness = [{}]\ntension_axis_y_m = 0.1\n", at(0.0)));
    assert_eq!(problem, Problem::Contradiction);
    let (problem, text) = complaint("GJ_N_m2 = 2e4\nEI_y_N_m2 = 5e4\nEI_z_N_m2 = 8e5\n");
    assert_eq!(problem, Problem::MissingField);
    assert!(text.contains("EA_N"), "{text}");
    let (problem, text) = complaint("");
    assert_eq!(problem, Problem::MissingField);
    assert!(text.ends_with("exactly one of EA_N, section_stiffness, box is allowed"), "{text}");
}

#[test]
fn a_factor_on_stiffness_scales_what_couples_and_hinges_and_leaves_places() {
    let hinge = "hinge = { axis = [0, 1, 0], stiffness_N_m_per_rad = 3e3 }\n";
    let mut wings = read(&format!(
        "{STIFFNESSES}EI_yz_N_m2 = 1e5\nbend_twist_y_N_m2 = 1e4\ntension_axis_y_m = 0.1\n{hinge}"
    ));
    let before = wings.beams.clone();
    let factor =
        wings.factors().into_iter().find(|factor| factor.name == "component.right.stiffness").unwrap();
    wings.multiply(&factor, 0.5).unwrap();
    for (after, before) in wings.beams.iter().zip(&before) {
        let (coupling, other) = (after.coupling, before.coupling);
        assert_eq!(coupling.bending, 0.5 * other.bending);
        assert_eq!(coupling.bend_twist, other.bend_twist.map(|number| 0.5 * number));
        assert_eq!(coupling.tension_axis, other.tension_axis);
        let spring = |beam: &Beam| beam.hinge.as_ref().map(|hinge| hinge.springs[0].stiffness);
        assert_eq!(spring(after), spring(before).map(|stiffness| 0.5 * stiffness));
    }
}

#[test]
fn a_hinge_is_on_both_sides_and_nothing_else_hangs_on_its_root() {
    let wings = read(&format!("{STIFFNESSES}hinge = {{ axis = [0.1, 1, 0], stiffness_N_m_per_rad = 3e3 }}"));
    let hinges: Vec<_> = wings.beams.iter().map(|beam| beam.hinge.clone()).collect();
    assert!(hinges[1].is_none() && hinges[3].is_none());
    let (right, left) = (hinges[0].as_ref().unwrap().springs[0], hinges[2].as_ref().unwrap().springs[0]);
    assert_eq!((right.stiffness, left.stiffness), (3e3, 3e3));
    assert_eq!((left.axis.x, left.axis.y, left.axis.z), (right.axis.x, -right.axis.y, 0.0));
    let local = read(&format!("{STIFFNESSES}hinge = {{ stiffnesses_N_m_per_rad = [1e3, 2e3, 3e3] }}"));
    let springs = &local.beams[0].hinge.as_ref().unwrap().springs;
    assert_eq!(springs.iter().map(|spring| spring.stiffness).collect::<Vec<_>>(), [1e3, 2e3, 3e3]);
    assert!((springs[2].axis - Vector3::new(0.0, 0.0, -1.0)).norm() < 1e-15, "{springs:?}");
    let tip = "\n[[component]]\nname = \"tip\"\nattached_to = { component = \"right\", at = 0 }\naxis_m = [[0, 0, 0], [0, 1, 0]]\n\
               elements = 1\ny_axis = [1, 0, 0]\nEA_N = 1e7\nGJ_N_m2 = 1e5\nEI_y_N_m2 = 1e5\nEI_z_N_m2 = 1e5\n";
    let text = file(&format!("{STIFFNESSES}hinge = {{ axis = [0, 1, 0], stiffness_N_m_per_rad = 3e3 }}"));
    let text = format!("{text}{tip}").replace("symmetric = true\n", "");
    let error = Aircraft::parse(&text, "wing.toml").unwrap_err().to_string();
    assert!(error.contains("found the root of \"right\", where a hinge is"), "{error}");
    Aircraft::parse(&text.replace("at = 0 }", "at = 1 }"), "wing.toml").unwrap();
}

//! Load modes: a few shapes of static loads beside natural modes [theory: load-modes.loads, load-modes.shapes].

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{ModeSelection, PlantSettings};
use flexible_aircraft::structure::{
    ModalBasis, ModeCount, ModeFamily, ModeKind, ReducedModel, Structure, StructureError,
};

use super::record::Record;
use crate::support::{AILERON_SYMMETRIC, up};

/// The jet with load modes and without the ailerons' deflection together, which the reference does not have.
pub(super) fn jet() -> Aircraft {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
    let mut jet = Aircraft::read(path).unwrap();
    jet.load_modes = true;
    jet.controls.remove(AILERON_SYMMETRIC);
    for flap in jet.strips.iter_mut().filter_map(|strip| strip.flap.as_mut()) {
        flap.gains.remove(AILERON_SYMMETRIC);
    }
    jet
}

/// Nominal frequencies of the load modes of one family, Hz.
fn frequencies(count: usize, kind: ModeKind, family: ModeFamily) -> Result<Vec<f64>, StructureError> {
    let model = ReducedModel::with(&jet(), ModeCount::Asked(count), kind)?;
    let of_family = model.modes.iter().filter(|mode| mode.of_loads && mode.family == family);
    Ok(of_family.map(|mode| mode.angular_frequency / std::f64::consts::TAU).collect())
}

#[test]
fn load_modes_of_the_jet_have_the_frequencies_of_an_independent_computation() {
    let mut record = Record::new(
        "load-modes",
        "Load modes of the jet without `aileron_symmetric`: nominal frequencies, Hz",
        "an independent implementation of [theory: load-modes.shapes]; half a unit of its last digit",
    );
    let rows = [
        (4, ModeKind::Symmetric, ModeFamily::Symmetric, [8.86, 9.94, 15.03, 29.52]),
        (8, ModeKind::Symmetric, ModeFamily::Symmetric, [15.95, 17.72, 28.18, 33.14]),
        (12, ModeKind::All, ModeFamily::Antisymmetric, [14.10, 15.77, 21.31, 25.07]),
    ];
    for (count, kind, family, expected) in rows {
        let found = frequencies(count, kind, family).unwrap();
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (place, (expected, found)) in expected.into_iter().zip(found).enumerate() {
            let name = format!("beside {count} {kind}, {family:?} {}", place + 1);
            record.absolute(&name, expected, 5e-3, found);
        }
    }
    record.finish();
}

#[test]
fn natural_and_load_modes_are_orthonormal_in_mass_and_orthogonal_in_stiffness() {
    let jet = jet();
    let structure = Structure::new(&jet).unwrap();
    let basis = ModalBasis::new(&structure, 12).unwrap();
    let product = |matrix: nalgebra::DMatrix<f64>| basis.shapes.transpose() * matrix * &basis.shapes;
    let (mass, stiffness) = (product(structure.mass()), product(structure.stiffness(true)));
    let (mut off_mass, mut off_stiffness) = (0.0_f64, 0.0_f64);
    for (i, one) in basis.modes.iter().enumerate() {
        for (j, other) in basis.modes.iter().enumerate() {
            let (one, other) = (one.angular_frequency, other.angular_frequency);
            let own = f64::from(u8::from(i == j));
            off_mass = off_mass.max((mass[(i, j)] - own).abs());
            off_stiffness = off_stiffness.max((stiffness[(i, j)] / (one * other) - own).abs());
        }
    }
    // In the stiffness the axial one of 1e12 N rounds.
    assert!(off_mass < 2e-13 && off_stiffness < 1e-8, "{off_mass:e} {off_stiffness:e}");
}

#[test]
fn load_modes_change_no_natural_mode_and_lie_above_those_in_use() {
    let mut without = jet();
    without.load_modes = false;
    let natural = ReducedModel::new(&without, 12).unwrap();
    let both = ReducedModel::new(&jet(), 12).unwrap();
    assert_eq!(both.modes[..12], natural.modes);
    for family in [ModeFamily::Symmetric, ModeFamily::Antisymmetric] {
        let frequencies = |of_loads| {
            let of = both.modes.iter().filter(move |mode| mode.family == family && mode.of_loads == of_loads);
            of.map(|mode| mode.angular_frequency).collect::<Vec<_>>()
        };
        assert!(frequencies(false).last() < frequencies(true).first());
        assert!(frequencies(true).is_sorted());
    }
}

/// A trim at 127 m/s, 7620 m: how many symmetric natural modes, stiffness scale; pitch, elevator, wing tip (m).
type TrimCase = (usize, f64, [f64; 3]);

const TRIMS: [(Fidelity, [TrimCase; 4]); 2] = [
    (
        Fidelity::Exact,
        [
            (4, 1.0, [0.13757, -0.23702, 0.5670]),
            (8, 1.0, [0.13745, -0.23612, 0.5663]),
            (4, 0.1, [0.13788, -0.26562, 2.8886]),
            (8, 0.1, [0.13158, -0.20772, 2.9050]),
        ],
    ),
    (
        Fidelity::GeometricallyExact,
        [
            (4, 1.0, [0.13752, -0.23661, 0.5979]),
            (8, 1.0, [0.13750, -0.23647, 0.5977]),
            (4, 0.1, [0.16802, -0.41950, 5.7293]),
            (8, 0.1, [0.16704, -0.40953, 5.7457]),
        ],
    ),
];

fn trim(model: &Arc<ReducedModel>, fidelity: Fidelity, mode_count: usize, stiffness_scale: f64) -> [f64; 3] {
    let settings = PlantSettings {
        fidelity,
        mode_selection: ModeSelection::Symmetric,
        mode_count,
        stiffness_scale,
        ..PlantSettings::of(model)
    };
    let mut flight = Simulation::new(Arc::clone(model), &Settings::from(settings), 0.0).unwrap();
    let trim = *flight.trim();
    [trim.pitch, trim.pitch_control, up(flight.outputs(), "wing_tip_right")]
}

#[test]
fn trims_with_load_modes_are_those_of_an_independent_computation() {
    let mut record = Record::new(
        "load-modes-trim",
        "Natural + load modes: pitch and elevator (rad), wing tip (m)",
        "an independent implementation of [theory: load-modes.shapes]; a unit of its last digit",
    );
    let cases = TRIMS.iter().flat_map(|(level, cases)| cases.iter().map(move |case| (*level, *case)));
    for (fidelity, (count, stiffness_scale, expected)) in cases {
        let count_of = ModeCount::Asked(count);
        let model = Arc::new(ReducedModel::with(&jet(), count_of, ModeKind::Symmetric).unwrap());
        let found = trim(&model, fidelity, count, stiffness_scale);
        let quantities = [("pitch", 1e-5), ("elevator", 1e-5), ("wing tip", 1e-4)];
        for (((quantity, digit), expected), found) in quantities.into_iter().zip(expected).zip(found) {
            let case = format!("{}, {count} + 4 × {stiffness_scale}: {quantity}", fidelity.symbol());
            record.absolute(&case, expected, digit, found);
        }
    }
    record.finish();
}

/// With forty natural modes, GE: stiffness scale; pitch, elevator (rad), wing tip (m), by the same computation.
const FORTY: [(f64, [f64; 3]); 2] = [(1.0, [0.13749, -0.23633, 0.5978]), (0.1, [0.16686, -0.40814, 5.7344])];

#[test]
fn a_few_modes_with_load_modes_trim_the_aircraft_as_forty_modes_do() {
    let mut record = Record::new(
        "load-modes-few",
        "GE, natural + load modes against 40 natural modes: pitch and elevator (rad), wing tip (m)",
        "an independent computation with 40 natural modes",
    );
    // Eight modes alone are off by 8e-4, 1.3e-3 and 1.2e-2 at nominal stiffness, 2e-3, 6e-2 and 0.31 at one tenth.
    for (count, (stiffness_scale, expected), bounds) in
        [(4, FORTY[0], [1e-4, 5e-4, 5e-4]), (8, FORTY[1], [5e-4, 3e-3, 2e-2])]
    {
        let count_of = ModeCount::Asked(count);
        let model = Arc::new(ReducedModel::with(&jet(), count_of, ModeKind::Symmetric).unwrap());
        let found = trim(&model, Fidelity::GeometricallyExact, count, stiffness_scale);
        let names = ["pitch", "elevator", "wing tip"];
        for (((name, bound), expected), found) in names.into_iter().zip(bounds).zip(expected).zip(found) {
            record.absolute(&format!("{count} + 4 × {stiffness_scale}: {name}"), expected, bound, found);
        }
    }
    record.finish();
}

#[test]
fn load_modes_of_fewer_natural_modes_than_packaged_are_those_of_the_same_number_packaged() {
    let reduced =
        |count| Arc::new(ReducedModel::with(&jet(), ModeCount::Asked(count), ModeKind::Symmetric).unwrap());
    let (many, few) = (reduced(12), reduced(4));
    let settings = |model| PlantSettings {
        mode_selection: ModeSelection::Symmetric,
        mode_count: 4,
        ..PlantSettings::of(model)
    };
    let [contracted, packaged] =
        [&many, &few].map(|model| model.in_use(&settings(model).choose_modes(model).unwrap()));
    assert_eq!(contracted.modes.len(), 8);
    for (one, other) in contracted.modes.iter().zip(&packaged.modes) {
        assert_eq!((one.family, one.of_loads), (other.family, other.of_loads));
        let apart = one.angular_frequency / other.angular_frequency - 1.0;
        assert!(apart.abs() < 2.5e-9, "{apart:e}");
    }
    for stiffness_scale in [1.0, 0.1] {
        let [one, other] = [&many, &few].map(|model| trim(model, Fidelity::Exact, 4, stiffness_scale));
        one.iter().zip(other).for_each(|(one, other)| assert!((one - other).abs() < 5e-12, "{one} {other}"));
    }
}

#[test]
fn load_modes_switched_off_leave_the_bits_of_a_model_without() {
    let both = Arc::new(ReducedModel::new(&jet(), 12).unwrap());
    let without = Arc::new(ReducedModel::new(&Aircraft { load_modes: false, ..jet() }, 12).unwrap());
    let off = PlantSettings { load_modes: false, ..PlantSettings::of(&both) };
    let fly = |model: &Arc<ReducedModel>, settings: PlantSettings| {
        let mut flight = Simulation::new(Arc::clone(model), &Settings::from(settings), 0.0).unwrap();
        for step in 0..5 {
            flight.step(0.1 * f64::from(step), 0.1).unwrap();
        }
        let outputs = flight.outputs();
        (outputs.attitude, outputs.position, outputs.modal_q[..12].to_vec())
    };
    assert_eq!(fly(&both, off), fly(&without, PlantSettings::of(&without)));
}

#[test]
fn static_loads_of_one_family_do_nothing_to_modes_of_the_other_and_stay_with_the_load_modes_in_use() {
    let model = ReducedModel::new(&jet(), 6).unwrap();
    assert_eq!(model.static_loads.len(), 8);
    for load in &model.static_loads {
        for (mode, force) in model.modes.iter().zip(&load.forces) {
            assert!(mode.family == load.family || *force == 0.0, "{:?} {force:e}", load.family);
        }
    }
    // What is chosen of a choice is as if chosen at once.
    let settings = PlantSettings { mode_count: 6, ..PlantSettings::of(&model) };
    let in_use = |model: &ReducedModel, mode_count| {
        model.in_use(&PlantSettings { mode_count, ..settings }.choose_modes(model).unwrap())
    };
    let (at_once, in_turn) = (in_use(&model, 2), in_use(&in_use(&model, 4), 2));
    assert_eq!(in_turn.static_loads.len(), 8);
    for (one, other) in at_once.modes.iter().zip(&in_turn.modes) {
        assert_eq!((one.family, one.of_loads), (other.family, other.of_loads));
        assert!((one.angular_frequency / other.angular_frequency - 1.0).abs() < 1e-9, "{one:?} {other:?}");
    }
    let natural = model.select(&[0, 1, 2]);
    assert!(natural.static_loads.is_empty() && !natural.has_load_modes());
}

//! Nodes may share a place without being joined: struts that touch a wing, halves of a tailplane that meet.

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::{ModeSelection, Outputs, PlantSettings};
use flexible_aircraft::structure::{ModeFamily, ReducedModel};
use flexible_aircraft::symmetry::{Counterpart, SymmetricHalf};

use crate::support::angles;

const BIPLANE: &str = include_str!("../data/braced-biplane.toml");
const TWIN_BOOM: &str = include_str!("../data/twin-boom.toml");

/// Where rotations are linear, and where they are finite along the tree of sections.
const LEVELS: [Fidelity; 2] = [Fidelity::Exact, Fidelity::GeometricallyExact];

/// Each aircraft, and what moves its touching nodes 1 mm apart.
const TOUCHING: [(&str, [&str; 2]); 2] = [
    (BIPLANE, ["[[0, 0, 0], [0, 0, -1.5]]", "[[0, 0, 0], [0, 0, -1.499]]"]),
    (TWIN_BOOM, ["[[0, 0, 0], [0, -1.4, 0]]", "[[0, 0, 0], [0, -1.399, 0]]"]),
];

fn reduced(text: &str) -> Arc<ReducedModel> {
    let aircraft = Aircraft::parse(text, "touching.toml").unwrap_or_else(|error| panic!("{error}"));
    Arc::new(ReducedModel::new(&aircraft, 20).unwrap())
}

#[test]
fn coincident_nodes_leave_the_mirror_plane() {
    for (text, [touching, apart]) in TOUCHING {
        assert!(text.contains(touching));
        let (model, apart) = (reduced(text), reduced(&text.replace(touching, apart)));
        for (mode, other) in model.modes.iter().zip(&apart.modes) {
            assert_ne!(mode.family, ModeFamily::Unsymmetric);
            let ratio = mode.angular_frequency / other.angular_frequency;
            // A millimetre of a strut of 1.5 m or a tail of 1.4 m: three halves of its share, the mass stays.
            assert!((ratio - 1.0).abs() < 2e-3, "{}: {ratio}", model.name);
        }
        assert!(SymmetricHalf::find(&model).is_some(), "{}", model.name);
    }
}

fn settings(
    model: &ReducedModel,
    fidelity: Fidelity,
    mode_selection: ModeSelection,
    mode_count: usize,
) -> Settings {
    Settings {
        tolerance: 1e-8,
        ..PlantSettings { fidelity, mode_selection, mode_count, ..PlantSettings::of(model) }.into()
    }
}

#[test]
fn aircraft_whose_parts_touch_trim_with_symmetric_modes_as_with_all() {
    for ((text, _), fidelity) in TOUCHING.into_iter().flat_map(|of| LEVELS.map(|level| (of, level))) {
        let model = reduced(text);
        let symmetric = model.modes.iter().filter(|mode| mode.family == ModeFamily::Symmetric).count();
        assert!((5..=15).contains(&symmetric), "{}: {symmetric}", model.name);
        let trim = |selection, count| {
            let settings = settings(&model, fidelity, selection, count);
            let flight = Simulation::new(Arc::clone(&model), &settings, 0.0).unwrap();
            [flight.trim().pitch, flight.trim().pitch_control]
        };
        let (half, whole) =
            (trim(ModeSelection::Symmetric, symmetric), trim(ModeSelection::All, model.modes.len()));
        assert!(
            half.iter().zip(&whole).all(|(half, whole)| (half - whole).abs() < 1e-9),
            "{fidelity:?}: {half:?} {whole:?}"
        );
    }
}

/// Flies for a second under elevator; an aileron of 1e-14 rad moves nothing that counts, but lets the whole aircraft fly.
fn flight(model: &Arc<ReducedModel>, fidelity: Fidelity, aileron: f64) -> Outputs {
    let settings = settings(model, fidelity, ModeSelection::All, 12);
    let mut flight = Simulation::new(Arc::clone(model), &settings, 0.0).unwrap();
    let [elevator, roll] = ["elevator", "aileron"].map(|name| model.control(name).unwrap());
    flight.set_inputs(&angles(model, &[(elevator, 0.03), (roll, aileron)]), &Inputs::zero(model));
    flight.advance_to(1.0).unwrap();
    assert_eq!(flight.is_symmetric(), aileron == 0.0);
    flight.outputs().clone()
}

#[test]
fn half_an_aircraft_with_strips_that_meet_in_the_plane_flies_as_the_whole_one_does() {
    let model = reduced(TWIN_BOOM);
    let half = SymmetricHalf::find(&model).unwrap();
    // The wing's strips, two of which are cut by the aileron's ends, and the tail's: one of each pair is kept.
    let pairs = model.strips.len() / 2;
    assert_eq!((half.model.strips.len(), half.edge_on.len()), (pairs, 0));
    let kept = half.strips.iter().map(|counterpart| match counterpart {
        Counterpart::Lifting { index, .. } => *index,
        Counterpart::EdgeOn(_) => unreachable!("no strip is edge-on"),
    });
    let mut uses = vec![0; pairs];
    kept.for_each(|index| uses[index] += 1);
    assert!(uses.iter().all(|&uses| uses == 2), "{uses:?}");

    for fidelity in LEVELS {
        let (half, whole) = (flight(&model, fidelity, 0.0), flight(&model, fidelity, 1e-14));
        for (half, whole) in half.deflections.iter().zip(&whole.deflections) {
            assert!((half.displacement - whole.displacement).norm() < 1e-8, "{half:?} {whole:?}");
            assert!(half.displacement.norm() > 1e-4);
        }
        assert!((half.load_factor - whole.load_factor).norm() < 1e-7, "{fidelity:?}");
        assert!((half.attitude - whole.attitude).norm() < 1e-8, "{fidelity:?}");
    }
}

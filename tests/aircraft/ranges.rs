//! `from` and `to`: ranges that meet neither overlap nor leave a gap, whatever the elements.

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Strip};
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::ReducedModel;

use super::{AILERON, assert_messages, edited};

/// The small aircraft with five elements, at none of whose nodes the ranges end.
const FIVE: (&str, &str) = ("elements = 4", "elements = 5");

const SURFACE: &str = "[[component.surface]]\nelastic_axis = 0.35\nlift_slope_per_rad = 5.5\nprofile_drag = 0.01\n\
                       flap = { lift_slope_per_rad = 3, hinge = 0.75 }\n\
                       [[component.surface.control]]\ninput = \"aileron\"\ngain = -1\nfrom = 0.5\n";

/// Somewhere else for the ailerons to be, where the wing has none.
const TAILERONS: (&str, &str) = (
    "{ input = \"rudder\", gain = 1 }",
    "{ input = \"rudder\", gain = 1 }, { input = \"aileron\", gain = 1 }",
);

/// The small aircraft with these surfaces on its wing of 5 m.
fn with_surfaces(surfaces: &str) -> Aircraft {
    edited(&[FIVE, TAILERONS, (SURFACE, surfaces)]).unwrap_or_else(|error| panic!("{error}"))
}

fn surface(more: &str) -> String {
    format!(
        "[[component.surface]]\nelastic_axis = 0.35\nlift_slope_per_rad = 5.5\nprofile_drag = 0.01\n\
         flap = {{ lift_slope_per_rad = 3, hinge = 0.75 }}\n{more}\n"
    )
}

/// The right wing's strips with their places along it, m.
fn strips(aircraft: &Aircraft) -> Vec<(f64, &Strip)> {
    let on_it = |strip: &&Strip| aircraft.beams[strip.attachment.beam].component == "wing_right";
    let at = |strip: &Strip| strip.attachment.beam as f64 + strip.attachment.fraction;
    aircraft.strips.iter().filter(on_it).map(|strip| (at(strip), strip)).collect()
}

/// Width and first moment of width about the root.
fn area<'s>(strips: impl Iterator<Item = (f64, &'s Strip)>) -> [f64; 2] {
    strips.fold([0.0; 2], |[sum, moment], (at, strip)| [sum + strip.width, moment + strip.width * at])
}

fn near(one: f64, other: f64) {
    assert!((one - other).abs() < 1e-6, "{one} instead of {other}");
}

#[test]
fn adjacent_surfaces_share_no_strip_and_leave_none_out() {
    // In the middle of an element, at a node, a hair beside one, a third with seven digits on one side.
    for (end, begin) in
        [("0.5", "0.5"), ("0.4", "0.4"), ("0.6000001", "0.5999999"), ("0.3333333", "0.33333333")]
    {
        let surfaces = [surface(&format!("to = {end}")), surface(&format!("from = {begin}"))].concat();
        let aircraft = with_surfaces(&surfaces);
        let [width, moment] = area(strips(&aircraft).into_iter());
        near(width, 5.0);
        near(moment, 12.5);
        let end: f64 = end.parse().unwrap();
        let [inner, _] = area(strips(&aircraft).into_iter().filter(|(at, _)| *at < 5.0 * end));
        near(inner, 5.0 * end);
    }
}

#[test]
fn a_wing_of_two_surfaces_bends_as_a_wing_of_one() {
    let bent = |surfaces: &str| {
        let clamped = [FIVE, TAILERONS, (SURFACE, surfaces), ("\"free\"", "\"clamped\"")];
        let model = ReducedModel::new(&edited(&clamped).unwrap(), 8).unwrap();
        let settings = Settings::from(PlantSettings {
            airspeed: 60.0,
            altitude: 0.0,
            mode_count: 8,
            ..PlantSettings::of(&model)
        });
        let mut flight = Simulation::new(Arc::new(model), &settings, 0.0).unwrap();
        flight.outputs().deflections[0].displacement.z
    };
    let one = bent(&surface("incidence_deg = 3"));
    let two =
        bent(&[surface("incidence_deg = 3\nto = 0.5"), surface("incidence_deg = 3\nfrom = 0.5")].concat());
    // Loads at the quarter points of the cut element instead of its middle.
    assert!(one < -1e-3 && (two / one - 1.0).abs() < 0.01, "{two} instead of {one}");
}

#[test]
fn mass_parts_that_meet_within_an_element_keep_their_mass_and_its_centre() {
    let bays = |parts: &str| {
        let edits = [FIVE, ("parts = [{ total_kg = 100, chord_power = 2 }]", parts)];
        let aircraft = edited(&edits).unwrap_or_else(|error| panic!("{error}"));
        let right = aircraft.bays.iter().filter(|bay| bay.attachment.beam < 5);
        right.fold([0.0; 2], |[mass, moment], bay| {
            let at = bay.attachment.beam as f64 + bay.attachment.fraction;
            [mass + bay.mass, moment + bay.mass * at]
        })
    };
    let [mass, moment] = bays("parts = [{ total_kg = 100, to = 0.5 }]");
    near(mass, 100.0);
    near(moment / mass, 1.25);
    let [mass, moment] = bays("parts = [{ total_kg = 60, to = 0.5 }, { total_kg = 40, from = 0.5 }]");
    near(mass, 100.0);
    near(moment, 60.0 * 1.25 + 40.0 * 3.75);
    let [mass, moment] = bays("parts = [{ total_kg = 30, from = 0.23, to = 0.29 }]");
    near(mass, 30.0);
    near(moment / mass, 1.3);
}

#[test]
fn lumps_of_a_cut_element_have_its_inertia_together() {
    let inertia = |parts: &str| {
        let added = "gyration_chords = [0, 0.25, 0.25]\ngyration_lengths = [0.28867513459481287, 0, 0.28867513459481287]\n\
                     added_inertia_kg_m2 = [3, 4, 5]";
        let edits = [
            FIVE,
            ("parts = [{ total_kg = 100, chord_power = 2 }]", parts),
            ("gyration_chords = [0, 0.25, 0.25]", added),
        ];
        let aircraft = edited(&edits).unwrap_or_else(|error| panic!("{error}"));
        let third = aircraft.bays.iter().filter(|bay| bay.attachment.beam == 2);
        third.fold(nalgebra::Vector3::zeros(), |sum: nalgebra::Vector3<f64>, bay| {
            let arm = bay.attachment.fraction - 0.5;
            let steiner = bay.mass * arm * arm;
            sum + bay.inertia.diagonal() + nalgebra::Vector3::new(steiner, 0.0, steiner)
        })
    };
    let whole = inertia("parts = [{ total_kg = 100 }]");
    let cut = inertia("parts = [{ total_kg = 50, to = 0.5 }, { total_kg = 50, from = 0.5 }]");
    assert!((whole - cut).norm() < 1e-12 * whole.norm(), "{whole} {cut}");
}

#[test]
fn a_flap_that_ends_within_an_element_moves_its_part_of_it() {
    let control = |from: f64, to: f64| {
        format!("[[component.surface.control]]\ninput = \"aileron\"\ngain = -1\nfrom = {from}\nto = {to}\n")
    };
    let moved = |controls: &str| {
        let aircraft = with_surfaces(&surface(controls));
        let gain = |strip: &Strip| strip.flap.as_ref().unwrap().gains[AILERON];
        let strips = strips(&aircraft);
        near(area(strips.iter().copied())[0], 5.0);
        assert!(strips.iter().all(|(_, strip)| [0.0, -1.0].contains(&gain(strip))), "{strips:?}");
        area(strips.into_iter().filter(|(_, strip)| gain(strip) != 0.0))
    };
    for (from, to) in [(0.5, 1.0), (0.62, 0.95), (0.2, 0.4), (0.71, 0.74)] {
        let [width, moment] = moved(&control(from, to));
        near(width, 5.0 * (to - from));
        near(moment / width, 2.5 * (from + to));
    }
    // Two that meet.
    near(moved(&[control(0.3, 0.5), control(0.5, 0.9)].concat())[0], 3.0);
}

#[test]
fn a_part_of_a_strip_keeps_its_position_within_the_part() {
    let aircraft = with_surfaces(&surface("position_in_element = 1\nfrom = 0.1\nto = 0.5"));
    let at: Vec<f64> = strips(&aircraft).iter().map(|(at, _)| *at).collect();
    assert_eq!(at, [1.0, 2.0, 2.5]);
    let aircraft = with_surfaces(&surface("position_in_element = 0.25\nfrom = 0.1\nto = 0.5"));
    let at: Vec<f64> = strips(&aircraft).iter().map(|(at, _)| *at).collect();
    assert_eq!(at, [0.625, 1.25, 2.125]);
}

#[test]
fn overlapping_surfaces_are_refused() {
    let second = "\n[[component.surface]]\nfrom = 0.45\nelastic_axis = 0.35\nlift_slope_per_rad = 5\nprofile_drag = 0\n";
    let edits = [
        ("elastic_axis = 0.35\nlift", "to = 0.5\nelastic_axis = 0.35\nlift"),
        ("from = 0.5\n\n[[component]]", &format!("from = 0.25\n{second}\n[[component]]")),
    ];
    assert_messages(
        &edits,
        &["small.toml:37:1: component.wing_right.surface[2]: found a surface from 0.45 to 1 over \
             component.wing_right.surface[1], which runs from 0 to 0.5; surfaces of one component are allowed that meet, \
             leave a gap, or whose span axes are at least 45 degrees apart"],
    );
}

#[test]
fn surfaces_that_cross_may_share_a_stretch() {
    let body = |axis: &str| {
        format!(
            "[[component.surface]]\nspan_axis = {axis}\nwidth_m = 1\nchord_m = 2\nelastic_axis = 0.5\nlift_slope_per_rad = 0.5\nprofile_drag = 0\n\n"
        )
    };
    let with = |surfaces: &str| {
        let fin = "[[component]]\nname = \"fin\"";
        edited(&[(fin, &format!("{surfaces}{fin}"))])
    };
    assert!(with(&[body("[0, 1, 0]"), body("[0, 0, -1]")].concat()).is_ok());
    assert!(with(&[body("[0, 1, -1]"), body("[0, -1, -1]")].concat()).is_ok());
    assert!(with(&[body("[0, 1, 0]"), body("[0, -1, 0.1]")].concat()).is_err());
}

#[test]
fn a_stretch_too_thin_to_hold_anything_is_refused() {
    let error =
        edited(&[TAILERONS, (SURFACE, &surface("from = 0.4\nto = 0.4000001"))]).unwrap_err().to_string();
    assert!(error.contains("found no strip from 0.4 to 0.4000001"), "{error}");
    let parts = "parts = [{ total_kg = 100, from = 0.4, to = 0.4000001 }]";
    let error = edited(&[("parts = [{ total_kg = 100, chord_power = 2 }]", parts)]).unwrap_err().to_string();
    assert!(error.contains("found from = 0.4 and to = 0.4000001; a stretch longer than"), "{error}");
}

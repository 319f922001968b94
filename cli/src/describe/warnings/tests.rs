use flexible_aircraft::ReducedModel;
use flexible_aircraft::aircraft::{Component, GivenReference};

use super::*;

fn read(file: &str) -> Aircraft {
    Aircraft::read(format!("{}/../aircraft/{file}.toml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// The jet, changed.
fn jet(change: impl FnOnce(&mut Aircraft)) -> Aircraft {
    let mut jet = read("generic-business-jet");
    change(&mut jet);
    jet
}

fn facts(aircraft: &Aircraft) -> Facts {
    Facts::new(aircraft, &ReducedModel::new(aircraft, 1).unwrap())
}

fn wing(aircraft: &Aircraft) -> usize {
    aircraft.wing().unwrap()
}

#[test]
fn a_static_margin_is_between_0_and_a_half() {
    assert_eq!(static_margin(0.1), None);
    assert!(
        static_margin(-0.02)
            .unwrap()
            .starts_with("the static margin is -0.02, usual is 0 to 0.5 of the chord")
    );
    assert!(static_margin(0.61).unwrap().contains("is 0.61, usual"));
}

#[test]
fn the_lowest_frequency_goes_with_the_span() {
    assert_eq!(lowest_frequency(2.4, 25.0, Support::Free), None);
    assert!(
        lowest_frequency(0.1, 25.0, Support::Free)
            .unwrap()
            .contains("0.1 Hz, usual is 0.12 to 20 Hz at a span of 25 m")
    );
    // A model of half a metre, and what flies by the sun.
    assert!(
        lowest_frequency(150.0, 0.5, Support::Free).is_none()
            && lowest_frequency(0.13, 75.0, Support::Free).is_none()
    );
    // A typical section.
    assert!(lowest_frequency(1.27, 1.0, Support::Clamped).is_none());
    // Masses in grams make a thousandth of the stiffness by mass of it.
    assert!(lowest_frequency(70.0 / 11.0 / 1000_f64.sqrt(), 11.0, Support::Free).is_some());
}

/// What warnings say of an aircraft, all of them.
fn all(aircraft: &Aircraft) -> Vec<String> {
    let options = crate::flown::FlownOptions::default();
    super::super::Description::new(aircraft, &options).unwrap().warnings
}

#[test]
fn a_control_does_what_is_said_of_it() {
    assert_eq!(all(&read("light-single")), Vec::<String>::new());
    let turned = |name: &str| {
        let mut aircraft = read("light-single");
        let control = aircraft.controls.iter().position(|control| control.name == name).unwrap();
        aircraft.strips.iter_mut().filter_map(|strip| strip.flap.as_mut()).for_each(|flap| {
            flap.gains[control] *= -1.0;
        });
        all(&aircraft)
    };
    for (name, opposite) in [("elevator", "nose-up"), ("aileron", "rolls left"), ("rudder", "nose left")] {
        let warnings = turned(name);
        let begins = format!("{name} says positive = ");
        assert_eq!(warnings.len(), 1, "{warnings:?}");
        assert!(warnings[0].starts_with(&begins) && warnings[0].contains(opposite), "{warnings:?}");
    }
    // Words of other languages, and what says nothing of a turn.
    let mut quiet = read("light-single");
    quiet.controls.iter_mut().for_each(|control| control.positive = "Hinterkante unten".to_owned());
    assert_eq!(all(&quiet), Vec::<String>::new());
}

#[test]
fn words_of_turns_are_read_with_and_without_hyphens() {
    let said = |positive: &str| {
        let control = flexible_aircraft::aircraft::Control {
            positive: positive.to_owned(),
            ..read("generic-business-jet").controls[0].clone()
        };
        controls::contradiction(&control, &Vector3::new(1.0, 2.0, 3.0)).is_some()
    };
    for odd in
        ["nose-down", "Nose down", "trailing edge down (nose-down)", "rolls left", "yaws left", "nose-left"]
    {
        assert!(said(odd), "{odd}");
    }
    for right in ["nose-up", "rolls right", "Nose-Right", "trailing edge down", "", "out (less lift)"] {
        assert!(!said(right), "{right}");
    }
}

#[test]
fn moments_are_those_of_aerofoils() {
    let usual = read("generic-business-jet");
    assert!((0..usual.components.len()).all(|component| sections::moments(&usual, component).is_empty()));
    let odd = jet(|jet| {
        for strip in &mut jet.strips {
            strip.moment_slope = -0.3 * strip.lift_slope;
            strip.flap.iter_mut().for_each(|flap| flap.moment_slope = Some(3.0));
        }
    });
    let [far, upward] = sections::moments(&odd, wing(&odd)).try_into().unwrap();
    assert!(far.contains("usual is up to 0.25 of it"), "{far}");
    assert!(upward.contains("moment_slope of its flap is 3 per rad, usual is below 0"), "{upward}");
}

#[test]
fn engines_turn_as_much_as_their_aircraft_can_carry() {
    // A Cessna 172's propeller: 18 kg, 1.9 m, 250 rad/s; J = 0.7, η = 0.8.
    let mut single = read("light-single");
    let (inertia, torque) = (18.0 * 1.9 * 1.9 / 12.0, 0.7 / (TAU * 0.8) * 1.9);
    single.engines[0].angular_momentum = inertia * 250.0;
    single.engines[0].torque = -torque;
    let facts = facts(&single);
    assert_eq!(engines::turning(&single.engines[0], &facts), Vec::<String>::new());
    (single.engines[0].angular_momentum, single.engines[0].torque) = (1e6, 50.0);
    let [torque, momentum] = engines::turning(&single.engines[0], &facts).try_into().unwrap();
    assert!(
        torque.contains("torque_m is 50, usual is up to 1.")
            && momentum.contains("is 1000000, usual is up to"),
        "{torque} {momentum}"
    );
}

#[test]
fn what_meets_is_joined() {
    let braced = read("strut-braced");
    assert!(!braced.joints.is_empty() && meetings::unjoined(&braced).is_empty());
    let mut loose = braced;
    loose.joints.clear();
    let warnings = meetings::unjoined(&loose);
    // Of both sides one is told.
    let [warning] = warnings.try_into().unwrap();
    for said in [
        "wing_right at 0.6 and strut_right at 1 of their lengths",
        "do not touch, usual is a [[joint]] there",
    ] {
        assert!(warning.contains(said), "{warning}");
    }
    for file in ["twin-boom", "generic-business-jet", "t-tail", "v-tail-uav", "flying-wing"] {
        assert!(meetings::unjoined(&read(file)).is_empty(), "{file}");
    }
}

#[test]
fn a_wing_carries_half_a_kilogram_to_1000_a_square_metre() {
    assert_eq!(wing_loading(&facts(&read("generic-business-jet"))), None);
    let heavy = jet(|jet| jet.bays.iter_mut().for_each(|bay| bay.mass *= 10.0));
    assert!(wing_loading(&facts(&heavy)).unwrap().contains("kg/m², usual is 0.5 to 1000 kg/m²"));
}

#[test]
fn the_centre_of_mass_is_within_the_aircraft() {
    let usual = read("generic-business-jet");
    assert_eq!(centre_of_mass(&usual, &facts(&usual)), None);
    let ahead = jet(|jet| jet.bays.iter_mut().for_each(|bay| bay.offset.x += 30.0));
    assert!(centre_of_mass(&ahead, &facts(&ahead)).unwrap().contains("usual is between them"));
}

#[test]
fn a_tail_and_a_fin_are_neither_small_nor_large() {
    let usual = read("generic-business-jet");
    assert!(tails::volumes(&usual, &facts(&usual)).is_empty());
    // Strips of all but the wing a fifth as wide.
    let small = jet(|jet| {
        let wing = wing(jet);
        let sides = [Some(wing), jet.components[wing].image];
        let owner: Vec<_> = jet.strips.iter().map(|strip| jet.component_of(strip.attachment.beam)).collect();
        let others = jet.strips.iter_mut().zip(owner).filter(|(_, owner)| !sides.contains(owner));
        others.for_each(|(strip, _)| strip.width *= 0.2);
    });
    let found = tails::volumes(&small, &facts(&small));
    assert!(found[0].starts_with("the volume coefficient of the tailplanes is 0.1"), "{found:?}");
    assert!(found[0].contains("usual is 0.2 to 1.5: area by lever"), "{found:?}");
    let far = jet(|jet| jet.bays.iter_mut().for_each(|bay| bay.offset.x += 100.0));
    let found = tails::volumes(&far, &facts(&far));
    assert!(found.iter().any(|text| text.starts_with("the volume coefficient of the fins is")), "{found:?}");
}

#[test]
fn what_continues_a_wing_is_no_tail() {
    // The outer half of the jet's wing as a component of its own.
    let usual = read("generic-business-jet");
    let wing = wing(&usual);
    let mut split = usual.clone();
    let half = split.components[wing].nodes.len() / 2;
    let outer = split.components[wing].nodes.split_off(half);
    let nodes = [vec![*split.components[wing].nodes.last().unwrap()], outer].concat();
    let first_beam = split.components[wing].first_beam + half - 1;
    for beam in first_beam..first_beam + nodes.len() - 1 {
        split.beams[beam].component = "outer".into();
    }
    let (name, image, parent) = ("outer".into(), None, Some((wing, half - 1)));
    split.components.push(Component { name, nodes, first_beam, image, parent });
    assert!(tails::continues(&split, split.components.len() - 1, wing));
    let tail = usual.components.iter().position(|component| component.name.contains("tail")).unwrap();
    assert!(!tails::continues(&usual, tail, wing));
}

#[test]
fn radii_of_gyration_are_a_part_of_the_size() {
    let usual = read("generic-business-jet");
    assert!(gyration::inertia(&usual, &facts(&usual)).is_empty());
    let odd = jet(|jet| jet.bays.iter_mut().for_each(|bay| bay.inertia *= 1e4));
    let found = gyration::inertia(&odd, &facts(&odd));
    assert!(found[0].starts_with("the radius of gyration in roll is ") && found.len() == 3, "{found:?}");
    let far = jet(|jet| jet.bays[3].offset = Vector3::y() * 40.0);
    let found = gyration::inertia(&far, &facts(&far));
    assert!(found.iter().any(|text| text.contains("lie 40 m from the beam that carries them")), "{found:?}");
}

#[test]
fn given_reference_lengths_are_about_those_of_the_wing() {
    assert!(reference_lengths(&jet(|jet| jet.reference.chord = Some(3.5))).is_empty());
    let odd = reference_lengths(&jet(|jet| jet.reference.chord = Some(37.0)));
    assert_eq!(odd, ["[reference] chord_m is 37, the wing has 3.73073: usual is about that"]);
    // A component for each side: what has an image is the tail alone.
    let by_sides = jet(|jet| {
        let wing = wing(jet);
        let image = jet.components[wing].image.unwrap();
        [wing, image].into_iter().for_each(|side| jet.components[side].image = None);
        jet.reference.area = Some(80.0);
    });
    assert!(by_sides.components[by_sides.wing().unwrap()].name.contains("tail"));
    assert!(reference_lengths(&by_sides).is_empty());
    // And no tail either.
    let halves = Aircraft {
        components: by_sides
            .components
            .iter()
            .cloned()
            .map(|component| Component { image: None, ..component })
            .collect(),
        ..by_sides
    };
    assert!(reference_lengths(&halves).is_empty());
    let odd = Aircraft {
        reference: GivenReference { chord: Some(37.0), area: Some(400.0), ..halves.reference },
        ..halves
    };
    let odd = reference_lengths(&odd);
    assert!(
        odd.len() == 2
            && odd[0].starts_with("[reference] chord_m is 37")
            && odd[1].starts_with("[reference] area_m2 is 400"),
        "{odd:?}"
    );
}

#[test]
fn what_lifts_weighs_something() {
    let usual = read("generic-business-jet");
    assert_eq!(massless(&usual, wing(&usual)), None);
    let light = jet(|jet| {
        let wing = wing(jet);
        let beams = elements(jet, wing);
        jet.bays.retain(|bay| !beams.contains(&bay.attachment.beam));
    });
    assert!(
        massless(&light, wing(&light)).unwrap().starts_with("wing_right has strips and its mass is 0 kg")
    );
}

#[test]
fn a_wing_is_stiffer_in_its_plane() {
    let usual = read("generic-business-jet");
    for component in 0..usual.components.len() {
        assert_eq!(stiffness_ratio(&usual, component), None);
    }
    let exchanged = jet(|jet| {
        for beam in &mut jet.beams {
            (beam.bending_stiffness_y, beam.bending_stiffness_z) =
                (beam.bending_stiffness_z, beam.bending_stiffness_y);
        }
    });
    let warning = stiffness_ratio(&exchanged, wing(&exchanged)).unwrap();
    assert!(warning.contains("is 0.285714 of that out of it, usual is 0.5 or more"), "{warning}");
}

#[test]
fn chords_of_neighbours_are_alike() {
    let usual = read("generic-business-jet");
    assert_eq!(chord_step(&usual, wing(&usual)), None);
    let step = jet(|jet| jet.strips[5].semichord *= 10.0);
    let component = step.component_of(step.strips[5].attachment.beam).unwrap();
    assert!(chord_step(&step, component).unwrap().contains("usual is a factor of 3 at most"));
}

#[test]
fn a_section_lifts_no_more_than_a_thin_aerofoil() {
    let usual = read("goland-wing");
    assert_eq!(lift_slope(&usual, 0), None);
    let steep = jet(|jet| jet.strips.iter_mut().for_each(|strip| strip.lift_slope = 10.0));
    assert!(lift_slope(&steep, wing(&steep)).unwrap().contains("is 10, usual is up to 2π, 6.28319 per rad"));
}

#[test]
fn a_wing_has_strips_up_to_its_end() {
    let usual = read("generic-business-jet");
    for component in 0..usual.components.len() {
        assert_eq!(gap(&usual, component), None);
    }
    let bare = jet(|jet| {
        let wing = wing(jet);
        let last = elements(jet, wing).end - 1;
        jet.strips.retain(|strip| strip.attachment.beam != last);
    });
    let warning = gap(&bare, wing(&bare)).unwrap();
    assert!(
        warning.contains("1 of the 24 elements from the first strip to the end have no strip"),
        "{warning}"
    );
}

#[test]
fn a_control_moves_something() {
    let usual = read("generic-business-jet");
    assert!((0..usual.controls.len()).all(|control| idle_control(&usual, control).is_none()));
    let idle = jet(|jet| {
        jet.strips.iter_mut().filter_map(|strip| strip.flap.as_mut()).for_each(|flap| flap.gains[0] = 0.0);
    });
    assert!(idle_control(&idle, 0).unwrap().starts_with("elevator moves no flap"));
}

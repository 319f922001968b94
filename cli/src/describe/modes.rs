//! Natural modes with names for people: what strains most, how, which one of its kind it is [theory: structure.motions].

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use flexible_aircraft::Aircraft;
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::{Mode, ModeFamily, ModeMotion, StrainShares};

use super::surfaces::is_lifting;

/// Part of the strain energy of a component from which on one kind of strain names a mode alone.
const ALONE: f64 = 0.7;

/// Part of the strain energy of a component and its image from which on one of the two names a mode alone.
const ONE_SIDE: f64 = 0.75;

/// A smaller part of the kinetic energy is not told.
const TOLD: f64 = 0.02;

/// A natural mode.
pub struct NaturalMode {
    /// Its place among the coordinates, from 1.
    pub number: usize,
    /// rad/s.
    pub angular_frequency: f64,
    pub family: ModeFamily,
    /// The component with the most strain energy, left and right together: a place in the aircraft's components.
    pub component: usize,
    /// "wing bending, first, symmetric".
    pub motion: String,
    /// Of components, left and right together, that have a notable part of the kinetic energy, the largest first.
    pub kinetic: Vec<(String, f64)>,
    /// Shares of the component's strain energy, by kind.
    pub strain: StrainShares,
}

impl NaturalMode {
    /// Hz.
    pub fn frequency(&self) -> f64 {
        self.angular_frequency / TAU
    }
}

/// The lowest natural modes, as many as some settings have fly, at their stiffness.
pub fn name(
    aircraft: &Aircraft,
    modes: &[Mode],
    motions: &[ModeMotion],
    settings: &PlantSettings,
) -> Vec<NaturalMode> {
    let groups = groups(aircraft);
    let mut counted = BTreeMap::new();
    let natural = modes.iter().zip(motions).enumerate().filter(|(_, (mode, _))| !mode.of_loads);
    let in_use = natural.enumerate().take_while(|(count, (_, (mode, _)))| {
        *count < settings.mode_count || mode.completes_a_pair && settings.mode_count > 0
    });
    let named = in_use.filter_map(|(_, (place, (mode, motion)))| {
        let strains = |group: &&Group| group.strain(motion).sum();
        let group = groups.iter().max_by(|one, other| strains(one).total_cmp(&strains(other)))?;
        let strain = group.strain(motion);
        let what = format!("{} {}", group.name_in(aircraft, motion), kinds(&strain, group.is_lifting));
        let family = family_name(mode.family);
        let count = counted.entry((what.clone(), family)).or_insert(0);
        *count += 1;
        let family = family.map_or(String::new(), |family| format!(", {family}"));
        Some(NaturalMode {
            number: place + 1,
            angular_frequency: mode.angular_frequency * settings.stiffness_scale.sqrt(),
            family: mode.family,
            component: group.members[0],
            motion: format!("{what}, {}{family}", ordinal(*count)),
            kinetic: kinetic(&groups, motion),
            strain: strain.of_whole(),
        })
    });
    named.collect()
}

/// Components and their mirror images.
struct Group {
    name: String,
    members: Vec<usize>,
    is_lifting: bool,
}

impl Group {
    fn strain(&self, motion: &ModeMotion) -> StrainShares {
        self.members.iter().fold(StrainShares::default(), |sum, &member| sum.plus(&motion.strain[member]))
    }

    fn kinetic(&self, motion: &ModeMotion) -> f64 {
        self.members.iter().map(|&member| motion.kinetic[member]).sum()
    }

    /// That of the one side which strains alone, if there is one, else of both.
    fn name_in<'n>(&'n self, aircraft: &'n Aircraft, motion: &ModeMotion) -> &'n str {
        let most = ONE_SIDE * self.strain(motion).sum();
        let alone = self.members.iter().find(|&&member| motion.strain[member].sum() > most);
        alone.map_or(&self.name, |&member| match self.members.len() {
            1 => &self.name,
            _ => &aircraft.components[member].name,
        })
    }
}

fn groups(aircraft: &Aircraft) -> Vec<Group> {
    let mut groups = Vec::new();
    for (place, component) in aircraft.components.iter().enumerate() {
        let members: Vec<usize> = [Some(place), component.image].into_iter().flatten().collect();
        if component.image.is_some_and(|image| image < place) {
            continue;
        }
        let names: Vec<&str> =
            members.iter().map(|&member| aircraft.components[member].name.as_str()).collect();
        let is_lifting = is_lifting(aircraft, place);
        groups.push(Group { name: common_name(&names), members, is_lifting });
    }
    groups
}

/// What the names of a component and its image have in common, in whole words: `wing` of `wing_right` and `wing_left`.
fn common_name(names: &[&str]) -> String {
    let [one, other] = names else { return names.concat() };
    let words = |name: &'_ str| -> Vec<String> { name.split('_').map(str::to_owned).collect() };
    let (one_words, other_words) = (words(one), words(other));
    let common: Vec<&str> =
        one_words.iter().filter(|word| other_words.contains(word)).map(String::as_str).collect();
    if common.is_empty() { format!("{one} and {other}") } else { common.join("_") }
}

/// What strains, the greatest part first.
fn kinds(strain: &StrainShares, is_lifting: bool) -> String {
    let StrainShares { bending, in_plane, torsion, stretch } = *strain;
    let in_plane_name = if is_lifting { "in-plane bending" } else { "sideways bending" };
    let mut kinds =
        [(bending, "bending"), (in_plane, in_plane_name), (torsion, "torsion"), (stretch, "stretch")];
    kinds.sort_by(|one, other| other.0.total_cmp(&one.0));
    let [(most, first), (_, second), ..] = kinds;
    if most >= ALONE * strain.sum() { first.to_owned() } else { format!("{first} and {second}") }
}

fn kinetic(groups: &[Group], motion: &ModeMotion) -> Vec<(String, f64)> {
    let mut shares: Vec<(String, f64)> =
        groups.iter().map(|group| (group.name.clone(), group.kinetic(motion))).collect();
    shares.retain(|(_, share)| *share >= TOLD);
    shares.sort_by(|one, other| other.1.total_cmp(&one.1));
    shares
}

/// None where there is no mirror plane.
pub fn family_name(family: ModeFamily) -> Option<&'static str> {
    match family {
        ModeFamily::Symmetric => Some("symmetric"),
        ModeFamily::Antisymmetric => Some("antisymmetric"),
        ModeFamily::Unsymmetric => None,
    }
}

fn ordinal(number: usize) -> String {
    const WORDS: [&str; 6] = ["first", "second", "third", "fourth", "fifth", "sixth"];
    WORDS.get(number.wrapping_sub(1)).map_or_else(|| format!("number {number}"), |word| (*word).to_owned())
}

#[cfg(test)]
mod tests {
    use flexible_aircraft::structure::{ModalBasis, Structure};

    use super::*;

    fn named(file: &str, count: usize) -> Vec<NaturalMode> {
        let path = format!("{}/../{file}", env!("CARGO_MANIFEST_DIR"));
        let aircraft = Aircraft::read(path).unwrap();
        let structure = Structure::new(&aircraft).unwrap();
        let basis = ModalBasis::new(&structure, count).unwrap();
        let motions = ModeMotion::of_modes(&structure, &basis.shapes);
        let modes = basis.modes.clone();
        let model = flexible_aircraft::ReducedModel::of_basis(&structure, basis).unwrap();
        let settings = PlantSettings { mode_count: count, ..PlantSettings::of(&model) };
        name(&aircraft, &modes, &motions, &settings)
    }

    #[test]
    fn the_lowest_modes_of_the_jet_bend_its_wing() {
        let modes = named("aircraft/generic-business-jet.toml", 4);
        let motions: Vec<&str> = modes.iter().map(|mode| mode.motion.as_str()).collect();
        assert_eq!(motions[..2], ["wing bending, first, symmetric", "wing bending, first, antisymmetric"]);
        for mode in &modes {
            assert!((mode.strain.sum() - 1.0).abs() < 1e-12, "{}", mode.motion);
            let kinetic: f64 = mode.kinetic.iter().map(|(_, share)| share).sum();
            assert!((0.8..1.0 + 1e-12).contains(&kinetic), "{kinetic}");
        }
        assert!((modes[0].frequency() * TAU - modes[0].angular_frequency).abs() < 1e-12);
    }

    #[test]
    fn the_second_mode_of_golands_wing_twists_it_and_there_is_no_family() {
        let modes = named("aircraft/goland-wing.toml", 2);
        assert_eq!(modes[0].motion, "wing bending, first");
        assert!(modes[1].motion.starts_with("wing torsion"), "{}", modes[1].motion);
        assert_eq!(family_name(modes[0].family), None);
    }

    #[test]
    fn a_side_has_the_name_of_both_and_one_that_strains_alone_its_own() {
        assert_eq!(common_name(&["wing_right", "wing_left"]), "wing");
        assert_eq!(common_name(&["right_outer_wing", "left_outer_wing"]), "outer_wing");
        assert_eq!(common_name(&["star", "port"]), "star and port");
        assert_eq!(common_name(&["fuselage_aft"]), "fuselage_aft");
    }

    #[test]
    fn two_kinds_are_told_where_none_has_seven_tenths() {
        let strain = StrainShares { bending: 0.6, torsion: 0.35, in_plane: 0.05, stretch: 0.0 };
        assert_eq!(kinds(&strain, true), "bending and torsion");
        let strain = StrainShares { bending: 0.1, torsion: 0.1, in_plane: 0.8, stretch: 0.0 };
        assert_eq!(kinds(&strain, true), "in-plane bending");
        assert_eq!(kinds(&strain, false), "sideways bending");
        assert_eq!([1, 6, 7].map(ordinal), ["first", "sixth", "number 7"]);
    }
}

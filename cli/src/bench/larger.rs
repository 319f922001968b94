//! The same aircraft with more of one thing: what it costs is timed, and nothing else is asked of it.

use flexible_aircraft::aircraft::{Aircraft, Attachment, MassBay};
use flexible_aircraft::structure::{ReducedModel, ReducedStrip};

/// The same aircraft with every strip cut into strips of a share of its width, at the same place.
pub fn with_strips_in_parts(model: &ReducedModel, parts: usize) -> ReducedModel {
    let cut = |strip: &ReducedStrip| ReducedStrip { width: strip.width / parts as f64, ..strip.clone() };
    let strips = model.strips.iter().flat_map(|strip| std::iter::repeat_n(cut(strip), parts)).collect();
    ReducedModel { strips, ..model.clone() }
}

/// The same aircraft with the mass of every bay in so many bays on the widest stretch of its element that has the bay in its
/// middle: more sections [theory: geometrically-exact.sections], which carry the same strips and all mass at the same centre.
pub fn with_bays_in_parts(aircraft: &Aircraft, parts: usize) -> Aircraft {
    let share = 1.0 / parts as f64;
    let cut = |bay: &MassBay| {
        let Attachment { beam, fraction } = bay.attachment;
        let reach = fraction.min(1.0 - fraction);
        let bay = bay.clone();
        (0..parts).map(move |part| {
            let place = fraction + reach * ((2 * part + 1) as f64 * share - 1.0);
            MassBay {
                attachment: Attachment { beam, fraction: place },
                mass: bay.mass * share,
                inertia: bay.inertia * share,
                ..bay
            }
        })
    };
    Aircraft { bays: aircraft.bays.iter().flat_map(cut).collect(), ..aircraft.clone() }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use flexible_aircraft::plant::PlantSettings;
    use flexible_aircraft::symmetry::Plants;

    use super::*;

    #[test]
    fn more_bays_are_more_sections_with_the_same_strips_and_the_same_mass() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/generic-business-jet.toml");
        let jet = Aircraft::read(&path).unwrap();
        let [one, two, four] =
            [1, 2, 4].map(|parts| ReducedModel::new(&with_bays_in_parts(&jet, parts), 2).unwrap());
        // Those of `src/structure/sections.rs`.
        assert_eq!(one.sections.len(), 135);
        assert!(two.sections.len() > 180 && four.sections.len() > two.sections.len() + 90);
        for more in [two, four] {
            assert_eq!(more.strips.len(), one.strips.len());
            let places = |model: &ReducedModel| model.strips.iter().map(|s| s.position).collect::<Vec<_>>();
            assert_eq!(places(&more), places(&one));
            assert!((more.integrals.mass / one.integrals.mass - 1.0).abs() < 1e-13);
            let moved = more.integrals.first_moment - one.integrals.first_moment;
            assert!(moved.norm() < 1e-12 * one.integrals.first_moment.norm(), "{moved}");
            assert!(Plants::under(&more, &PlantSettings::of(&more)).unwrap().half().is_some());
        }
    }
}

//! An aircraft with other stiffnesses and masses than its file says: what a study multiplies, by the names of the file
//! [theory: sweeps.factors].

use std::fmt::Display;

use super::model::{Aircraft, MassGroup, WrittenComponent};

/// Something of an aircraft that can be multiplied, on both sides of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// `component.<name>.stiffness`, `mass.<name>` or `mass.<name>.<table>[<number>]`, names being those of the file.
    pub name: String,
    target: Target,
}

/// What is multiplied.
#[derive(Clone, Debug, PartialEq)]
enum Target {
    /// All stiffnesses of the elements of a component and of its mirror image, that of a hinge at its root too.
    Stiffness { component: String, image: Option<String> },
    /// Mass and inertia of bays, so that radii of gyration stay.
    Mass { bays: Vec<usize> },
}

/// A factor that is a slip of the pen.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{name}: found the factor {found}, allowed is {least} to {most}", least = Factor::LEAST, most = Factor::MOST)]
pub struct FactorOutOfRange {
    /// Of what.
    pub name: String,
    /// The factor.
    pub found: f64,
}

impl Factor {
    /// The smallest factor: as good as nothing.
    pub const LEAST: f64 = 1e-6;
    /// The greatest factor: as good as rigid.
    pub const MOST: f64 = 1e6;

    fn stiffness(component: &WrittenComponent) -> Self {
        let WrittenComponent { name, image, .. } = component;
        Factor {
            name: format!("component.{name}.stiffness"),
            target: Target::Stiffness { component: name.clone(), image: image.clone() },
        }
    }

    fn mass(name: impl Display, bays: Vec<usize>) -> Self {
        Factor { name: format!("mass.{name}"), target: Target::Mass { bays } }
    }
}

impl WrittenComponent {
    fn factors(&self) -> Vec<Factor> {
        let mut factors = vec![Factor::stiffness(self)];
        if !self.groups.is_empty() {
            let all = self.groups.iter().flat_map(|group| group.bays.iter().copied());
            factors.push(Factor::mass(&self.name, all.collect()));
        }
        let of_group = |group: &MassGroup| {
            Factor::mass(format_args!("{}.{}", self.name, group.name), group.bays.clone())
        };
        factors.extend(self.groups.iter().map(of_group));
        factors
    }
}

impl Aircraft {
    /// All that can be multiplied, in the order of the file.
    ///
    /// ```
    /// let mut jet = flexible_aircraft::Aircraft::read("aircraft/generic-business-jet.toml")?;
    /// let wings = jet.factors().into_iter().find(|factor| factor.name == "component.wing_right.stiffness");
    /// jet.multiply(&wings.ok_or("no such factor")?, 0.5)?; // both of them
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn factors(&self) -> Vec<Factor> {
        self.written.iter().flat_map(WrittenComponent::factors).collect()
    }

    /// Multiplies what a factor is of, which is one of [`factors`](Self::factors), by a number.
    ///
    /// # Errors
    /// When the number is not from [`Factor::LEAST`] to [`Factor::MOST`].
    pub fn multiply(&mut self, factor: &Factor, by: f64) -> Result<(), FactorOutOfRange> {
        if !(Factor::LEAST..=Factor::MOST).contains(&by) {
            return Err(FactorOutOfRange { name: factor.name.clone(), found: by });
        }
        match &factor.target {
            Target::Stiffness { component, image } => {
                let is_part = |name: &String| name == component || Some(name) == image.as_ref();
                for beam in self.beams.iter_mut().filter(|beam| is_part(&beam.component)) {
                    beam.axial_stiffness *= by;
                    beam.torsional_stiffness *= by;
                    beam.bending_stiffness_y *= by;
                    beam.bending_stiffness_z *= by;
                    beam.coupling = beam.coupling.scaled(by);
                    beam.hinge = beam.hinge.as_ref().map(|hinge| hinge.scaled(by));
                }
            }
            Target::Mass { bays } => {
                for &bay in bays {
                    if let Some(bay) = self.bays.get_mut(bay) {
                        bay.mass *= by;
                        bay.inertia *= by;
                    }
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wing with an image and masses, a body with masses, a fin and tails without.
    const SMALL: &str = include_str!("../../tests/data/small-aircraft.toml");

    fn small() -> Aircraft {
        Aircraft::parse(SMALL, "small-aircraft.toml").unwrap()
    }

    fn multiplied(name: &str, by: f64) -> Aircraft {
        let mut aircraft = small();
        let factor = aircraft.factors().into_iter().find(|factor| factor.name == name).unwrap();
        aircraft.multiply(&factor, by).unwrap();
        aircraft
    }

    #[test]
    fn names_are_those_of_the_file_in_its_order_and_every_bay_is_in_one_group() {
        let aircraft = small();
        let names: Vec<String> = aircraft.factors().into_iter().map(|factor| factor.name).collect();
        let expected = [
            "component.wing_right.stiffness",
            "mass.wing_right",
            "mass.wing_right.distributed_mass[1]",
            "component.fuselage.stiffness",
            "mass.fuselage",
            "mass.fuselage.point_masses[1]",
            "component.fin.stiffness",
            "component.tail_right.stiffness",
        ];
        assert_eq!(names, expected);
        let mut bays: Vec<usize> = aircraft
            .written
            .iter()
            .flat_map(|component| &component.groups)
            .flat_map(|group| group.bays.clone())
            .collect();
        bays.sort_unstable();
        assert_eq!(bays, (0..aircraft.bays.len()).collect::<Vec<_>>());
    }

    #[test]
    fn a_factor_on_stiffness_acts_on_both_sides_and_on_nothing_else() {
        let (before, after) = (small(), multiplied("component.wing_right.stiffness", 0.5));
        assert_eq!(before.bays, after.bays);
        for (before, after) in before.beams.iter().zip(&after.beams) {
            let expected = if before.component.starts_with("wing_") { 0.5 } else { 1.0 };
            let ratios = [
                after.axial_stiffness / before.axial_stiffness,
                after.torsional_stiffness / before.torsional_stiffness,
                after.bending_stiffness_y / before.bending_stiffness_y,
                after.bending_stiffness_z / before.bending_stiffness_z,
            ];
            assert_eq!(ratios, [expected; 4], "{}", before.component);
        }
    }

    #[test]
    fn a_factor_on_mass_keeps_radii_of_gyration_and_acts_on_the_bays_of_its_component() {
        let (before, after) = (small(), multiplied("mass.wing_right", 2.0));
        assert_eq!(before.beams, after.beams);
        for (before, after) in before.bays.iter().zip(&after.bays) {
            let component = &small().beams[before.attachment.beam].component;
            let expected = if component.starts_with("wing_") { 2.0 } else { 1.0 };
            assert_eq!(after.mass, expected * before.mass, "{component}");
            assert_eq!(after.inertia, expected * before.inertia, "{component}");
        }
    }

    #[test]
    fn a_factor_beyond_its_range_is_refused_and_changes_nothing() {
        let mut aircraft = small();
        let factor = aircraft.factors().remove(0);
        for wrong in [0.0, -1.0, f64::NAN, 1e7] {
            let refused = aircraft.multiply(&factor, wrong).unwrap_err().to_string();
            assert!(
                refused.contains("found the factor") && refused.ends_with("allowed is 0.000001 to 1000000"),
                "{refused}"
            );
        }
        assert_eq!(aircraft, small());
    }
}

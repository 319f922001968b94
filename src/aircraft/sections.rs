//! The sections of a component's elements: as stiff as laws, matrices or a box say, with what they weigh, and the hinge at the root.
//!
//! [theory: coupled-sections.energy, coupled-sections.mass, coupled-sections.box, coupled-sections.hinge]

use nalgebra::{Matrix3, Vector3};

use super::box_section::Tube;
use super::coupling::{Coupling, Hinge, Spring};
use super::error::{Place, Problem};
use super::format::section as fields;
use super::geometry::Line;
use super::law::Laws;
use super::masses::{LocatedBay, check_inertia};
use super::model::{Attachment, MassBay};
use super::schema::{BoxSpec, ComponentSpec, HingeSpec, StiffnessSource};
use super::section_matrix::{SectionMass, SectionStiffness, matrix_at};

/// The sections in the middle of each element.
pub(super) fn of_elements(spec: &ComponentSpec, line: &Line, laws: &Laws) -> Option<Vec<SectionStiffness>> {
    let middles = line.points_at(0.5);
    let sections: Option<Vec<SectionStiffness>> = match &spec.section.source {
        StiffnessSource::Laws => {
            let values = spec.stiffness.iter().map(|(_, law)| laws.values(law, &middles));
            let values: Vec<Vec<f64>> = values.collect::<Vec<_>>().into_iter().collect::<Option<_>>()?;
            let section = |i: usize| SectionStiffness {
                axial: values[0][i],
                torsional: values[1][i],
                bending_y: values[2][i],
                bending_z: values[3][i],
                coupling: Coupling::NONE,
            };
            Some((0..middles.len()).map(section).collect())
        }
        StiffnessSource::Box(tube) => {
            let tubes = tubes(tube, line, laws)?;
            Some(tubes.iter().map(|sizes| sizes.stiffness(tube.young, tube.shear)).collect())
        }
        StiffnessSource::Matrices(matrices) => {
            let faulty = matrices.iter().find(|m| SectionStiffness::condensed(&m.matrix.value).is_none());
            let refuse = |place: &Place| {
                let found = "a matrix by which some strain has no energy, or a negative one";
                not_positive_definite(place, found, laws)
            };
            match faulty {
                Some(faulty) => refuse(&faulty.matrix.place),
                // What is between two that are positive definite is so too, but for rounding.
                None => {
                    let section = |s: f64| SectionStiffness::condensed(&matrix_at(matrices, s));
                    let sections = middles.iter().map(|middle| section(middle.s));
                    sections.collect::<Option<_>>().or_else(|| refuse(&matrices[0].matrix.place))
                }
            }
        }
    };
    let mut sections = sections?;
    let couplings = couplings(spec, line, laws)?;
    for (element, (section, coupling)) in sections.iter_mut().zip(couplings).enumerate() {
        if let Some(coupling) = coupling {
            section.coupling = coupling;
        }
        if !section.is_positive_definite() {
            let beside = spec.section.beside.iter().flatten().next();
            let place = beside.map_or(&spec.name.place, |law| &law.place);
            return coupled_too_much(section, &place.within(&format!("element[{}]", element + 1)), laws);
        }
    }
    Some(sections)
}

/// What stands beside the stiffnesses of each element, if anything does.
fn couplings(spec: &ComponentSpec, line: &Line, laws: &Laws) -> Option<Vec<Option<Coupling>>> {
    let middles = line.points_at(0.5);
    if spec.section.beside.iter().all(Option::is_none) {
        return Some(vec![None; middles.len()]);
    }
    let values = spec.section.beside.iter().zip(fields::BESIDE);
    let values = values.map(|(law, field)| laws.values_or_usual(law.as_ref(), field, &middles));
    let values: Vec<Vec<f64>> = values.collect::<Vec<_>>().into_iter().collect::<Option<_>>()?;
    let coupling = |i: usize| {
        Some(Coupling {
            bending: values[0][i],
            bend_twist: [values[1][i], values[2][i]],
            stretch_by_twist: 0.0,
            tension_axis: [values[3][i], values[4][i]],
            shear_centre: [values[5][i], values[6][i]],
        })
    };
    Some((0..middles.len()).map(coupling).collect())
}

/// The sizes of a box in the middle of each element.
fn tubes(spec: &BoxSpec, line: &Line, laws: &Laws) -> Option<Vec<Tube>> {
    let middles = line.points_at(0.5);
    let [height, width, skin] = [&spec.height, &spec.width, &spec.skin].map(|law| laws.values(law, &middles));
    let web = spec.web.as_ref().map(|law| laws.values(law, &middles));
    let (height, width, skin) = (height?, width?, skin?);
    let web = web.unwrap_or_else(|| Some(skin.clone()))?;
    let tube = |i: usize| {
        let tube = Tube { height: height[i], width: width[i], skin: skin[i], web: web[i] };
        let Some((wall, thickness, most)) = tube.too_thick() else { return Some(tube) };
        let place = spec.place.within(wall).within(&format!("element[{}]", i + 1));
        let allowed = format!("a wall of at most {most} m, a quarter of the box, is allowed");
        laws.report.add(Problem::OutOfRange, &place, format!("found {thickness} m"), allowed);
        None
    };
    (0..middles.len()).map(tube).collect()
}

/// What the sections weigh by themselves: one bay in the middle of each element, for each of the names of those that do.
pub(super) fn bays(
    spec: &ComponentSpec,
    line: &Line,
    laws: &Laws,
) -> Vec<(&'static str, Option<Vec<LocatedBay>>)> {
    let mut groups = Vec::new();
    if let StiffnessSource::Box(tube) = &spec.section.source
        && let Some(density) = tube.density
    {
        groups.push((fields::BOX_FIELD.name, box_bays(spec, (tube, density), line, laws)));
    }
    if !spec.section.masses.is_empty() {
        groups.push((fields::SECTION_MASS.name, matrix_bays(spec, line, laws)));
    }
    groups
}

fn box_bays(
    spec: &ComponentSpec,
    (tube, density): (&BoxSpec, f64),
    line: &Line,
    laws: &Laws,
) -> Option<Vec<LocatedBay>> {
    let (tubes, couplings) = (tubes(tube, line, laws)?, couplings(spec, line, laws)?);
    let bay = |(element, (sizes, coupling)): (usize, (&Tube, Option<Coupling>))| {
        let mass = sizes.mass(density, coupling.unwrap_or_default().tension_axis);
        Some((bay(spec, line, element, &mass)?, tube.place.clone()))
    };
    tubes.iter().zip(couplings).enumerate().map(bay).collect()
}

fn matrix_bays(spec: &ComponentSpec, line: &Line, laws: &Laws) -> Option<Vec<LocatedBay>> {
    let masses = &spec.section.masses;
    for mass in masses {
        if let Err([fault, allowed]) = SectionMass::of(&mass.matrix.value) {
            let found = format!("found {fault}");
            laws.report.add(Problem::UnphysicalInertia, &mass.matrix.place, found, allowed);
            return None;
        }
    }
    let place = &masses[0].matrix.place;
    let bays = line.points_at(0.5).into_iter().map(|middle| {
        let mass = SectionMass::of(&matrix_at(masses, middle.s)).ok()?;
        Some((bay(spec, line, middle.element, &mass)?, place.clone()))
    });
    let bays: Vec<LocatedBay> = bays.collect::<Option<_>>()?;
    check_inertia(&bays, laws.report).then_some(bays)
}

/// The mass of an element along which it is spread evenly.
fn bay(spec: &ComponentSpec, line: &Line, element: usize, section: &SectionMass) -> Option<MassBay> {
    let axes = local_axes(spec, line, element)?;
    let length = line.span(element).norm();
    let rod = Matrix3::from_diagonal(&Vector3::new(0.0, 1.0, 1.0)) * (section.mass * length * length / 12.0);
    Some(MassBay {
        attachment: Attachment { beam: element, fraction: 0.5 },
        mass: section.mass * length,
        offset: axes * section.centre,
        inertia: axes * (section.inertia + rod) * axes.transpose() * length,
    })
}

/// Local x, y and z of an element as columns; `None` where the written y runs along it, which whoever makes the beam complains about.
pub(super) fn local_axes(spec: &ComponentSpec, line: &Line, element: usize) -> Option<Matrix3<f64>> {
    let (written, x_axis) = (spec.y_axis.value, line.span(element).normalize());
    let y_axis = (written - x_axis * x_axis.dot(&written)).try_normalize(1e-6)?;
    Some(Matrix3::from_columns(&[x_axis, y_axis, x_axis.cross(&y_axis)]))
}

/// The springs at the root, body axes.
pub(super) fn hinge(spec: &ComponentSpec, line: &Line) -> Option<Hinge> {
    let springs = match spec.section.hinge.as_ref()? {
        HingeSpec::About { axis, stiffness } => vec![Spring { axis: *axis, stiffness: *stiffness }],
        HingeSpec::AboutLocalAxes(stiffnesses) => {
            let axes = local_axes(spec, line, 0)?;
            let spring = |i: usize| Spring { axis: axes.column(i).into_owned(), stiffness: stiffnesses[i] };
            (0..3).map(spring).collect()
        }
    };
    Some(Hinge { springs })
}

fn coupled_too_much<T>(section: &SectionStiffness, place: &Place, laws: &Laws) -> Option<T> {
    let SectionStiffness { torsional, bending_y, bending_z, coupling, .. } = section;
    let [y, z] = coupling.bend_twist;
    let found = format!(
        "EI_yz = {}, bend–twist {y} and {z} N m² with GJ = {torsional}, EI_y = {bending_y}, EI_z = {bending_z} N m²",
        coupling.bending
    );
    not_positive_definite(place, &found, laws)
}

fn not_positive_definite<T>(place: &Place, found: &str, laws: &Laws) -> Option<T> {
    let allowed = "a positive definite stiffness is allowed: by which every strain has energy";
    laws.report.add(Problem::NotPositiveDefinite, place, format!("found {found}"), allowed);
    None
}

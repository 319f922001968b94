//! Mass bays: masses distributed over the elements, and masses at points [3.1].

use nalgebra::{Matrix3, SymmetricEigen, Vector3};

use super::document::Located;
use super::error::{Place, Problem, Report};
use super::geometry::Line;
use super::law::{Laws, Point};
use super::model::{Attachment, MassBay};
use super::schema::{DistributedMassSpec, InertiaSpec, MassPartSpec, PointMassesSpec};

/// A bay with the place of the file that it comes from; its element counted from the component's root.
pub(super) type LocatedBay = (MassBay, Place);

/// One bay at the middle of every element that carries a share of the mass.
pub(super) fn distributed(spec: &DistributedMassSpec, line: &Line, laws: &Laws) -> Option<Vec<LocatedBay>> {
    let middles = line.points_at(0.5);
    let mut masses = vec![0.0; line.elements()];
    for part in &spec.parts {
        for (mass, share) in masses.iter_mut().zip(shares(part, line, &middles, laws)?) {
            *mass += share;
        }
    }
    let in_chords = |vector: &Option<Located<Vector3<f64>>>| match vector {
        None => Some(vec![Vector3::zeros(); middles.len()]),
        Some(v) => Some(laws.chords(&middles, &v.place)?.iter().map(|chord| *chord * v.value).collect()),
    };
    let (offsets, gyrations) = (in_chords(&spec.offset_chords), in_chords(&spec.gyration_chords));
    let (offsets, gyrations) = (offsets?, gyrations?);
    let place = spec.gyration_chords.as_ref().map_or(&spec.place, |gyration| &gyration.place);
    let bay = |element: usize| {
        let lengthwise = spec.gyration_lengths * line.span(element).norm();
        let gyration_squared = squared(gyrations[element]) + squared(lengthwise);
        let moments = masses[element] * gyration_squared + spec.added_inertia;
        let bay = MassBay {
            attachment: Attachment { beam: element, fraction: 0.5 },
            mass: masses[element],
            offset: offsets[element] + spec.offset,
            inertia: Matrix3::from_diagonal(&moments),
        };
        (bay, place.clone())
    };
    let bays: Vec<_> = (0..line.elements()).filter(|&i| masses[i] > 0.0).map(bay).collect();
    check_inertia(&bays, laws.report).then_some(bays)
}

/// The mass of a part in each element: in proportion to c^power times length where the part lies.
fn shares(part: &MassPartSpec, line: &Line, middles: &[Point], laws: &Laws) -> Option<Vec<f64>> {
    let chords = match part.chord_power {
        0.0 => vec![1.0; middles.len()],
        _ => laws.chords(middles, &part.place)?,
    };
    let weight = |(point, chord): (&Point, &f64)| {
        let inside = (part.from..=part.to).contains(&point.s);
        if inside { libm::pow(*chord, part.chord_power) * line.span(point.element).norm() } else { 0.0 }
    };
    let weights: Vec<f64> = middles.iter().zip(&chords).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    if sum > 0.0 && sum.is_finite() {
        return Some(weights.iter().map(|weight| part.total * (weight / sum)).collect());
    }
    let found = format!("found from = {} and to = {}", part.from, part.to);
    let allowed = "a stretch that holds the middle of at least one element is allowed";
    laws.report.add(Problem::OutOfRange, &part.place, found, allowed);
    None
}

/// One bay at each place.
pub(super) fn at_points(spec: &PointMassesSpec, line: &Line, report: &Report) -> Option<Vec<LocatedBay>> {
    let attachments = line.locate(&spec.along, report)?;
    let masses = match spec.masses.value.as_slice() {
        [one] => vec![*one; attachments.len()],
        list => list.to_vec(),
    };
    if masses.len() != attachments.len() {
        let found = format!("found {} masses at {} places", masses.len(), attachments.len());
        report.add(
            Problem::WrongType,
            &spec.masses.place,
            found,
            "one for all, or one for each place, is allowed",
        );
        return None;
    }
    let bay = |(attachment, mass): (&Attachment, &f64)| {
        let moments = match spec.inertia {
            InertiaSpec::Gyration(radii) => *mass * squared(radii),
            InertiaSpec::Moments(moments) => moments,
        };
        let [xy, xz, yz] = spec.products.into();
        let inertia = Matrix3::new(moments.x, xy, xz, xy, moments.y, yz, xz, yz, moments.z);
        let bay = MassBay { attachment: *attachment, mass: *mass, offset: spec.offset, inertia };
        (bay, spec.inertia_place.clone())
    };
    let bays: Vec<_> = attachments.iter().zip(&masses).map(bay).collect();
    check_inertia(&bays, report).then_some(bays)
}

fn squared(v: Vector3<f64>) -> Vector3<f64> {
    v.component_mul(&v)
}

/// Complains about the first inertia that no body has; true when all are in order.
fn check_inertia(bays: &[LocatedBay], report: &Report) -> bool {
    for (bay, place) in bays {
        if let Err(moments) = principal_moments(&bay.inertia) {
            let found = format!("found the principal moments of inertia {moments} kg m²");
            let allowed =
                "moments are allowed of which none is negative or greater than the sum of the others";
            report.add(Problem::UnphysicalInertia, place, found, allowed);
            return false;
        }
    }
    true
}

/// The error is the text of the moments when they break the triangle inequality.
fn principal_moments(inertia: &Matrix3<f64>) -> Result<(), String> {
    let Some(eigen) = SymmetricEigen::try_new(*inertia, f64::EPSILON, 100) else {
        return Err("that cannot be computed,".to_owned());
    };
    let mut moments: [f64; 3] = eigen.eigenvalues.into();
    moments.sort_by(f64::total_cmp);
    let [least, middle, greatest] = moments;
    let slack = 1e-9 * greatest.abs();
    if least >= -slack && greatest <= least + middle + slack {
        return Ok(());
    }
    let digits = (5.0 - libm::log10(greatest.abs())).clamp(0.0, 12.0) as usize;
    Err(format!("{least:.digits$}, {middle:.digits$}, {greatest:.digits$}"))
}

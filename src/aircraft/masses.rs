//! Mass bays: masses distributed over the elements, and masses at points [theory: structure.bay; thesis §3.1].

use nalgebra::{Matrix3, SymmetricEigen, Vector3};

use super::document::Located;
use super::error::{Place, Problem, Report};
use super::geometry::{Line, SAME_PLACE};
use super::law::{AxisPoint, Law, Laws};
use super::model::{Attachment, MassBay};
use super::schema::{DistributedMassSpec, InertiaSpec, MassPartSpec, PointMassesSpec};
use super::stretch::Piece;

/// A bay with the place of the file that it comes from; its element counted from the component's root.
pub(super) type LocatedBay = (MassBay, Place);

/// One bay at the middle of every element that carries a share of the mass, or of every part of it where a part of
/// the mass begins or ends within.
pub(super) fn distributed(spec: &DistributedMassSpec, line: &Line, laws: &Laws) -> Option<Vec<LocatedBay>> {
    let pieces = line.pieces(spec.parts.iter().map(|part| &part.stretch));
    let middles: Vec<AxisPoint> = pieces.iter().map(|piece| line.point(piece.at(0.5))).collect();
    let mut masses = vec![0.0; pieces.len()];
    for part in &spec.parts {
        for (mass, share) in masses.iter_mut().zip(shares(part, line, &pieces, &middles, laws)?) {
            *mass += share;
        }
    }
    let in_chords = |vector: &Option<Located<[Law; 3]>>| match vector {
        None => Some(vec![Vector3::zeros(); middles.len()]),
        Some(v) => {
            let chords = laws.chords(&middles, &v.place)?;
            let [x, y, z] = v.value.each_ref().map(|law| laws.values(law, &middles));
            let (x, y, z) = (x?, y?, z?);
            Some((0..chords.len()).map(|i| chords[i] * Vector3::new(x[i], y[i], z[i])).collect())
        }
    };
    let (offsets, gyrations) = (in_chords(&spec.offset_chords), in_chords(&spec.gyration_chords));
    let (offsets, gyrations) = (offsets?, gyrations?);
    let place = spec.gyration_chords.as_ref().map_or(&spec.place, |gyration| &gyration.place);
    let bay = |i: usize| {
        let lengthwise = spec.gyration_lengths * length(line, &pieces[i]);
        let gyration_squared = squared(gyrations[i]) + squared(lengthwise);
        let moments = masses[i] * gyration_squared + spec.added_inertia * pieces[i].share();
        let bay = MassBay {
            attachment: pieces[i].at(0.5),
            mass: masses[i],
            offset: offsets[i] + spec.offset,
            inertia: Matrix3::from_diagonal(&moments),
        };
        (bay, place.clone())
    };
    let bays: Vec<_> = (0..pieces.len()).filter(|&i| masses[i] > 0.0).map(bay).collect();
    check_inertia(&bays, laws.report).then_some(bays)
}

/// m.
fn length(line: &Line, piece: &Piece) -> f64 {
    line.span(piece.element).norm() * piece.share()
}

/// The mass of a part in each piece: in proportion to c^power times length where the part lies.
fn shares(
    part: &MassPartSpec,
    line: &Line,
    pieces: &[Piece],
    middles: &[AxisPoint],
    laws: &Laws,
) -> Option<Vec<f64>> {
    let chords = match part.chord_power {
        0.0 => vec![1.0; middles.len()],
        _ => laws.chords(middles, &part.place)?,
    };
    let weight = |(piece, chord): (&Piece, &f64)| {
        let inside = part.stretch.holds(piece);
        if inside { libm::pow(*chord, part.chord_power) * length(line, piece) } else { 0.0 }
    };
    let weights: Vec<f64> = pieces.iter().zip(&chords).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    if sum > 0.0 && sum.is_finite() {
        return Some(weights.iter().map(|weight| part.total * (weight / sum)).collect());
    }
    let found = format!("found from = {} and to = {}", part.stretch.from, part.stretch.to);
    let allowed = format!("a stretch longer than {SAME_PLACE} of the component is allowed");
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

/// What the moments of a body are like.
pub(super) const MOMENTS_ALLOWED: &str =
    "moments are allowed of which none is negative or greater than the sum of the others";

/// A share of the greatest moment that is rounding.
const ROUNDED: f64 = 1e-9;

/// Complains about the first inertia that no body has; true when all are in order.
pub(super) fn check_inertia(bays: &[LocatedBay], report: &Report) -> bool {
    for (bay, place) in bays {
        if let Err(moments) = principal_moments(&bay.inertia, 0.0) {
            let found = format!("found the principal moments of inertia {moments} kg m²");
            report.add(Problem::UnphysicalInertia, place, found, MOMENTS_ALLOWED);
            return false;
        }
    }
    true
}

/// The error is the text of the moments when they break the triangle inequality by more than a share of the greatest and what else of
/// them is rounding.
pub(super) fn principal_moments(inertia: &Matrix3<f64>, rounding: f64) -> Result<(), String> {
    let Some(eigen) = SymmetricEigen::try_new(*inertia, f64::EPSILON, 100) else {
        return Err("that cannot be computed,".to_owned());
    };
    let mut moments: [f64; 3] = eigen.eigenvalues.into();
    moments.sort_by(f64::total_cmp);
    let [least, middle, greatest] = moments;
    let slack = ROUNDED * greatest.abs() + rounding;
    if least >= -slack && greatest <= least + middle + slack {
        return Ok(());
    }
    let digits = (5.0 - libm::log10(greatest.abs())).clamp(0.0, 12.0) as usize;
    Err(format!("{least:.digits$}, {middle:.digits$}, {greatest:.digits$}"))
}

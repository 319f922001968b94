//! One component by itself: its elastic axis cut into elements, and places along it.

use nalgebra::{Matrix3, Vector3};

use super::components::at_node;
use super::coupling::Coupling;
use super::document::Located;
use super::error::{Place, Problem, Report};
use super::law::AxisPoint;
use super::model::Attachment;
use super::schema::{Along, ComponentSpec};
use super::stretch::{Piece, Stretch};

/// Lengths below this count as 0, m.
const SHORTEST: f64 = 1e-6;

/// Ends of stretches nearer to a node, or to one another, than this share of the component's length are one place.
pub(super) const SAME_PLACE: f64 = 1e-6;

/// A component as written or its image in y = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    AsWritten,
    Mirrored,
}

impl Side {
    /// Positions, offsets, directions.
    pub(super) fn vector(self, v: Vector3<f64>) -> Vector3<f64> {
        match self {
            Side::AsWritten => v,
            Side::Mirrored => Vector3::new(v.x, -v.y, v.z),
        }
    }

    /// Axes of rotation: span axes, about which nose-up stays positive.
    pub(super) fn axis(self, v: Vector3<f64>) -> Vector3<f64> {
        match self {
            Side::AsWritten => v,
            Side::Mirrored => Vector3::new(-v.x, v.y, -v.z),
        }
    }

    /// Of a section whose local axes are x and y as they come to lie, and z = x × y.
    pub(super) fn coupling(self, coupling: Coupling) -> Coupling {
        match self {
            Side::AsWritten => coupling,
            Side::Mirrored => coupling.mirrored(),
        }
    }

    pub(super) fn inertia(self, inertia: Matrix3<f64>) -> Matrix3<f64> {
        match self {
            Side::AsWritten => inertia,
            Side::Mirrored => {
                let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
                mirror * inertia * mirror
            }
        }
    }
}

/// The nodes of a component, from its attachment point.
#[derive(Clone, Debug)]
pub(super) struct Line {
    /// Positions relative to the attachment point; the first is zero.
    pub(super) points: Vec<Vector3<f64>>,
    /// Distance of each node from the first along the axis, m.
    pub(super) distances: Vec<f64>,
}

impl Line {
    /// Cuts each segment of the axis into equal elements.
    pub(super) fn of(spec: &ComponentSpec, report: &Report) -> Option<Line> {
        let (corners, place) = (&spec.axis.value, &spec.axis.place);
        if corners[0].norm() > SHORTEST {
            let found = format!("found a first point {:?}", corners[0].as_slice());
            let allowed = "the axis begins at its attachment point: [0, 0, 0] is allowed";
            report.add(Problem::Disconnected, &place_of_corner(place, 0), found, allowed);
            return None;
        }
        let mut line = Line { points: vec![Vector3::zeros()], distances: vec![0.0] };
        for (segment, &count) in spec.elements.iter().enumerate() {
            let (start, end) = (corners[segment], corners[segment + 1]);
            let length = (end - start).norm();
            if length / (count as f64) < SHORTEST {
                let found = format!("found elements of length {} m", length / (count as f64));
                let allowed = format!("elements of at least {SHORTEST} m are allowed");
                report.add(Problem::ZeroLength, &place_of_corner(place, segment + 1), found, allowed);
                return None;
            }
            let so_far = line.length();
            for step in 1..=count {
                let fraction = step as f64 / count as f64;
                line.points.push(start + (end - start) * fraction);
                line.distances.push(so_far + length * fraction);
            }
        }
        Some(line)
    }

    /// Number of elements.
    pub(super) fn elements(&self) -> usize {
        self.points.len() - 1
    }

    /// Length along the axis, m.
    pub(super) fn length(&self) -> f64 {
        self.distances[self.distances.len() - 1]
    }

    /// From the first to the second node of an element, m.
    pub(super) fn span(&self, element: usize) -> Vector3<f64> {
        self.points[element + 1] - self.points[element]
    }

    /// The point of each element at a fraction of its length.
    pub(super) fn points_at(&self, fraction: f64) -> Vec<AxisPoint> {
        (0..self.elements()).map(|element| self.point(Attachment { beam: element, fraction })).collect()
    }

    /// The elements, those that the ends of some stretches cut in parts.
    pub(super) fn pieces<'s>(&self, stretches: impl Iterator<Item = &'s Stretch>) -> Vec<Piece> {
        let mut places: Vec<f64> = self.distances.iter().map(|distance| distance / self.length()).collect();
        let mut cuts: Vec<Vec<f64>> = vec![Vec::new(); self.elements()];
        for cut in stretches.flat_map(|stretch| [stretch.from, stretch.to]) {
            if places.iter().all(|place| (place - cut).abs() > SAME_PLACE) {
                // The nodes stand first; a cut that is at none of them is between two.
                let element = places[..self.distances.len()].partition_point(|&node| node < cut) - 1;
                cuts[element].push((cut - places[element]) / (places[element + 1] - places[element]));
                places.push(cut);
            }
        }
        let mut pieces = Vec::with_capacity(places.len() - 1);
        for (element, mut cuts) in cuts.into_iter().enumerate() {
            cuts.extend([0.0, 1.0]);
            cuts.sort_by(f64::total_cmp);
            pieces.extend(cuts.windows(2).map(|ends| {
                let middle = Attachment { beam: element, fraction: 0.5 * (ends[0] + ends[1]) };
                Piece { element, ends: [ends[0], ends[1]], middle: self.point(middle).s }
            }));
        }
        pieces
    }

    /// A place along the axis as a point.
    pub(super) fn point(&self, place: Attachment) -> AxisPoint {
        let [start, end] = [self.distances[place.beam], self.distances[place.beam + 1]];
        AxisPoint { s: (start + place.fraction * (end - start)) / self.length(), element: place.beam }
    }

    /// The node at a fraction of the length, if one is there.
    pub(super) fn node_at(&self, fraction: f64) -> Option<usize> {
        at_node(self.fractions(), fraction)
    }

    /// Of the length at which nodes are, from 0 to 1.
    pub(super) fn fractions(&self) -> impl Iterator<Item = f64> {
        self.distances.iter().map(|node| node / self.length())
    }

    /// Places along the axis, the elements counted from 0 at the root.
    pub(super) fn locate(&self, along: &Along, report: &Report) -> Option<Vec<Attachment>> {
        let (places, unit, scale) = match along {
            Along::Metres(places) => (places, " m", 1.0),
            Along::Fractions(places) => (places, "", self.length()),
        };
        let located = places.iter().map(|place| self.locate_one(place, unit, scale, report));
        located.collect::<Vec<_>>().into_iter().collect()
    }

    fn locate_one(&self, at: &Located<f64>, unit: &str, scale: f64, report: &Report) -> Option<Attachment> {
        let (distance, slack) = (at.value * scale, 1e-9 * self.length());
        if !(-slack..=self.length() + slack).contains(&distance) {
            let (found, end) = (format!("found {}{unit}", at.value), self.length() / scale);
            let allowed = format!("a place on the component is allowed, from 0 to {end}{unit}");
            report.add(Problem::OffTheBeam, &at.place, found, allowed);
            return None;
        }
        let after = self.distances.partition_point(|&node| node < distance - slack);
        let beam = after.saturating_sub(1);
        let (start, end) = (self.distances[beam], self.distances[beam + 1]);
        Some(Attachment { beam, fraction: ((distance - start) / (end - start)).clamp(0.0, 1.0) })
    }
}

fn place_of_corner(place: &Place, corner: usize) -> Place {
    Place { span: place.span.clone(), field: format!("{}[{}]", place.field, corner + 1) }
}

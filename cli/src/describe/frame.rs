//! Where points of the aircraft lie on pictures of it: from above, from behind, from the right.

use nalgebra::Vector3;

/// From where the aircraft is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// The nose points up.
    Above,
    /// The right wing is on the right.
    Behind,
    /// The nose points to the right.
    Right,
}

impl View {
    pub fn name(self) -> &'static str {
        match self {
            View::Above => "from above",
            View::Behind => "from behind",
            View::Right => "from the right",
        }
    }

    /// To the right and down on the picture, m, of a point in body axes.
    pub fn seen(self, point: &Vector3<f64>) -> [f64; 2] {
        match self {
            View::Above => [point.y, -point.x],
            View::Behind => [point.y, point.z],
            View::Right => [point.x, point.z],
        }
    }
}

/// The smallest rectangle around points as seen, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    low: [f64; 2],
    high: [f64; 2],
}

impl Extent {
    /// Around all of some points.
    pub fn around<'p>(view: View, points: impl Iterator<Item = &'p Vector3<f64>>) -> Self {
        let nothing = Extent { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        points.fold(nothing, |extent, point| {
            let seen = view.seen(point);
            Extent {
                low: [0, 1].map(|axis| extent.low[axis].min(seen[axis])),
                high: [0, 1].map(|axis| extent.high[axis].max(seen[axis])),
            }
        })
    }

    /// Width and height, m.
    pub fn size(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.high[axis] - self.low[axis])
    }
}

/// A view at a scale, px per metre, with O at (0, 0).
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub view: View,
    pub scale: f64,
}

impl Frame {
    /// px.
    pub fn place(&self, point: &Vector3<f64>) -> [f64; 2] {
        self.view.seen(point).map(|metres| metres * self.scale)
    }

    /// Where O lies on the picture so that the middle of what is seen is in the middle of its place, px.
    pub fn origin(&self, seen: &Extent, middle: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| middle[axis] - 0.5 * (seen.low[axis] + seen.high[axis]) * self.scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ahead_is_up_from_above_and_up_is_up_from_the_side() {
        let nose_up_right = Vector3::new(3.0, 2.0, -1.0);
        assert_eq!(View::Above.seen(&nose_up_right), [2.0, -3.0]);
        assert_eq!(View::Behind.seen(&nose_up_right), [2.0, -1.0]);
        assert_eq!(View::Right.seen(&nose_up_right), [3.0, -1.0]);
    }

    #[test]
    fn the_middle_of_what_is_seen_is_in_the_middle_of_its_frame() {
        let points = [Vector3::new(0.0, -4.0, 0.0), Vector3::new(-2.0, 8.0, 0.0)];
        let extent = Extent::around(View::Above, points.iter());
        assert_eq!(extent.size(), [12.0, 2.0]);
        let frame = Frame { view: View::Above, scale: 10.0 };
        let [x, y] = frame.origin(&extent, [100.0, 50.0]);
        let places = points.map(|point| frame.place(&point));
        assert_eq!(places.map(|[right, down]| [x + right, y + down]), [[40.0, 40.0], [160.0, 60.0]]);
    }
}

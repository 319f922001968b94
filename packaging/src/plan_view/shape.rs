//! What a picture is made of, whatever it is written as.

/// Of letters, px.
pub(super) const FONT: f64 = 13.0;

/// Radius of a point, px.
pub(super) const DOT: f64 = 4.0;

/// Shapes, those behind first.
pub(super) struct Drawing<'a> {
    /// Width and height, px.
    pub size: [f64; 2],
    pub shapes: Vec<Shape<'a>>,
}

/// A shape; places are px to the right and downwards, and the class says what it shows.
pub(super) enum Shape<'a> {
    Polygon {
        class: &'static str,
        corners: Vec<[f64; 2]>,
    },
    Line {
        class: &'static str,
        from: [f64; 2],
        to: [f64; 2],
    },
    /// A point and what is there.
    Dot {
        class: &'static str,
        place: [f64; 2],
        name: &'a str,
    },
    /// The name of a point, about the middle.
    Name {
        place: [f64; 2],
        text: &'a str,
    },
    /// The name of an axis.
    Letter {
        place: [f64; 2],
        text: &'static str,
    },
    /// That of the scale.
    Length {
        place: [f64; 2],
        text: String,
    },
}

//! A drawing as PNG on white, for importers that show no SVG. Without its letters: a font that is the same on all machines
//! would be larger than the picture, and equal inputs give equal bytes.

use tiny_skia::{Color, FillRule, Paint, Path, PathBuilder, Pixmap, Stroke, Transform};

use super::shape::{DOT, Drawing, Shape};

/// px of the picture per px of the drawing.
const SCALE: f32 = 2.0;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// It has no pixels, or too many.
    #[error("a picture of {width} by {height} pixels cannot be")]
    Size {
        /// px.
        width: f32,
        /// px.
        height: f32,
    },
    /// It cannot be written as PNG.
    #[error("{0}")]
    Encoding(String),
}

/// The bytes of the file.
pub(super) fn bytes(Drawing { size, shapes }: &Drawing<'_>) -> Result<Vec<u8>, PictureError> {
    let [width, height] = size.map(|length| (length as f32 * SCALE).ceil());
    // Casts saturate, and a picture of such a size cannot be.
    let pixmap = Pixmap::new(width as u32, height as u32);
    let mut pixmap = pixmap.ok_or(PictureError::Size { width, height })?;
    pixmap.fill(Color::WHITE);
    shapes.iter().for_each(|shape| draw(&mut pixmap, shape));
    pixmap.encode_png().map_err(|error| PictureError::Encoding(error.to_string()))
}

fn draw(pixmap: &mut Pixmap, shape: &Shape<'_>) {
    let scaled = Transform::from_scale(SCALE, SCALE);
    let (class, path, is_filled) = match shape {
        Shape::Polygon { class, corners } => (*class, polygon(corners), true),
        Shape::Dot { class, place: [x, y], .. } => {
            (*class, PathBuilder::from_circle(*x as f32, *y as f32, DOT as f32), true)
        }
        // The bar of the scale would have no length.
        Shape::Line { class: "scale", .. } => return,
        Shape::Line { class, from, to } => (*class, polygon(&[*from, *to]), false),
        Shape::Name { .. } | Shape::Letter { .. } | Shape::Length { .. } => return,
    };
    // Nothing is drawn of what has no size.
    let Some(path) = path else { return };
    let Colours { fill, stroke } = colours(class);
    if is_filled {
        pixmap.fill_path(&path, &paint(fill), FillRule::Winding, scaled, None);
    }
    if let Some((colour, width)) = stroke {
        pixmap.stroke_path(&path, &paint(colour), &Stroke { width, ..Stroke::default() }, scaled, None);
    }
}

/// A closed line through some points.
fn polygon(corners: &[[f64; 2]]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (index, [x, y]) in corners.iter().enumerate() {
        let (x, y) = (*x as f32, *y as f32);
        if index == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
    path.close();
    path.finish()
}

/// Red, green, blue.
type Colour = [u8; 3];

struct Colours {
    fill: Colour,
    /// And its width, px of the drawing.
    stroke: Option<(Colour, f32)>,
}

/// Those that the documentation page gives a class.
fn colours(class: &str) -> Colours {
    let (fill, stroke) = match class {
        "surface" => ([0xdb, 0xe7, 0xf3], Some(([0x8a, 0xa5, 0xc0], 0.6))),
        "flap" => ([0xf2, 0xb5, 0x6b], Some(([0x8a, 0xa5, 0xc0], 0.6))),
        "axis" => ([0; 3], Some(([0x27, 0x44, 0x5f], 2.0))),
        "body" => ([0; 3], Some(([0x7a, 0x1f, 0xa2], 1.5))),
        "engine" => ([0xb3, 0x41, 0x2e], None),
        "station" => ([0x2e, 0x7d, 0x4f], None),
        _ => ([0x1a, 0x1f, 0x26], None),
    };
    Colours { fill, stroke }
}

fn paint<'a>([red, green, blue]: Colour) -> Paint<'a> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, 255);
    paint
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_have_their_colours_on_white_where_they_are() {
        let corners = vec![[2.0, 2.0], [8.0, 2.0], [8.0, 8.0], [2.0, 8.0]];
        let shapes = vec![
            Shape::Polygon { class: "flap", corners },
            Shape::Dot { class: "engine", place: [16.0, 5.0], name: "left" },
            Shape::Name { place: [16.0, 5.0], text: "left" },
        ];
        let png = bytes(&Drawing { size: [20.0, 10.0], shapes }).unwrap();
        let picture = Pixmap::decode_png(&png).unwrap();
        assert_eq!((picture.width(), picture.height()), (40, 20));
        let colour = |x, y| {
            let colour = picture.pixel(x, y).unwrap();
            [colour.red(), colour.green(), colour.blue(), colour.alpha()]
        };
        assert_eq!(colour(0, 0), [255; 4]);
        assert_eq!(colour(10, 10), [0xf2, 0xb5, 0x6b, 255]);
        assert_eq!(colour(32, 10), [0xb3, 0x41, 0x2e, 255]);
    }

    #[test]
    fn a_picture_without_pixels_is_refused() {
        let refused = bytes(&Drawing { size: [0.0, 10.0], shapes: Vec::new() }).unwrap_err();
        assert_eq!(refused.to_string(), "a picture of 0 by 20 pixels cannot be");
    }
}

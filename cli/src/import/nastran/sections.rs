//! Cross-sections by their shape: area, second moments of area, torsion constant.
//!
//! Axes as Nastran has them: y up in plane 1, z across. I1 is ∫y² dA, I2 is ∫z² dA, both about the centroid. J of closed sections
//! is Bredt's, of open ones Σ b t³/3, of solid ones Saint-Venant's [Roark's Formulas for Stress and Strain, table 10.7].

use std::f64::consts::PI;

/// Properties of a section in the unit of its dimensions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    pub area: f64,
    /// About z: bending in plane 1.
    pub i1: f64,
    /// About y: bending in plane 2.
    pub i2: f64,
    pub i12: f64,
    pub torsion: f64,
}

/// Shapes that are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    Rod,
    Tube,
    Bar,
    Box,
    I,
    T,
    Chan,
}

/// What is wrong with dimensions: which of them, counted from 0, and what is allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct BadDimension {
    pub index: usize,
    pub allowed: String,
}

/// A rectangle of the section: width along z, height along y, place of its middle.
struct Rectangle {
    width: f64,
    height: f64,
    y: f64,
    z: f64,
}

impl Shape {
    pub const NAMES: &str = "ROD, TUBE, BAR, BOX, I, T or CHAN";

    pub fn named(name: &str) -> Option<Shape> {
        Some(match name {
            "ROD" => Shape::Rod,
            "TUBE" => Shape::Tube,
            "BAR" => Shape::Bar,
            "BOX" => Shape::Box,
            "I" => Shape::I,
            "T" => Shape::T,
            "CHAN" => Shape::Chan,
            _ => return None,
        })
    }

    /// How many dimensions it has.
    pub fn dimensions(self) -> usize {
        match self {
            Shape::Rod => 1,
            Shape::Tube | Shape::Bar => 2,
            Shape::Box | Shape::T | Shape::Chan => 4,
            Shape::I => 6,
        }
    }

    /// Whether its shear centre is its centroid, whatever the dimensions.
    pub fn is_doubly_symmetric(self) -> bool {
        matches!(self, Shape::Rod | Shape::Tube | Shape::Bar | Shape::Box)
    }

    /// Its properties.
    ///
    /// # Errors
    /// At the first dimension that no such shape has.
    pub fn section(self, dimensions: &[f64]) -> Result<Section, BadDimension> {
        let d = |index: usize| dimensions.get(index).copied().unwrap_or(0.0);
        let hollow = usize::from(self == Shape::Tube);
        if let Some(index) = (0..self.dimensions() - hollow).find(|&index| d(index) <= 0.0) {
            return Err(BadDimension { index, allowed: "a length above 0 is allowed".to_owned() });
        }
        let less = |index: usize, most: f64, than: &str| {
            let allowed = || format!("less than {than}, {most}, is allowed");
            if d(index) < most { Ok(()) } else { Err(BadDimension { index, allowed: allowed() }) }
        };
        Ok(match self {
            Shape::Rod => round(d(0), 0.0),
            Shape::Tube => {
                less(1, d(0), "the outer radius")?;
                round(d(0), d(1).max(0.0))
            }
            Shape::Bar => solid(d(0), d(1)),
            Shape::Box => {
                less(3, 0.5 * d(0), "half of the width")?;
                less(2, 0.5 * d(1), "half of the height")?;
                closed([d(0), d(1)], [d(2), d(3)])
            }
            Shape::I => {
                less(4, d(0) - d(5), "the height without the upper flange")?;
                less(3, d(1).min(d(2)), "the widths of the flanges")?;
                i_shape(&[d(0), d(1), d(2), d(3), d(4), d(5)])
            }
            Shape::T => {
                less(2, d(1), "the height")?;
                less(3, d(0), "the width")?;
                t_shape([d(0), d(1)], [d(2), d(3)])
            }
            Shape::Chan => {
                less(2, d(0), "the width")?;
                less(3, 0.5 * d(1), "half of the height")?;
                channel([d(0), d(1)], [d(2), d(3)])
            }
        })
    }
}

fn round(outer: f64, inner: f64) -> Section {
    let [outer2, inner2] = [outer * outer, inner * inner];
    let second = 0.25 * PI * (outer2 * outer2 - inner2 * inner2);
    Section { area: PI * (outer2 - inner2), i1: second, i2: second, i12: 0.0, torsion: 2.0 * second }
}

/// Width along z, height along y.
fn solid(width: f64, height: f64) -> Section {
    let [long, short] = [width.max(height), width.min(height)];
    let ratio = short / long;
    let torsion = long * short.powi(3) * (1.0 / 3.0 - 0.21 * ratio * (1.0 - ratio.powi(4) / 12.0));
    let whole = of_rectangles(&[Rectangle { width, height, y: 0.0, z: 0.0 }]);
    Section { torsion, ..whole }
}

/// Thickness of the walls above and below, of those at the sides.
fn closed([width, height]: [f64; 2], [level, upright]: [f64; 2]) -> Section {
    let [inner_width, inner_height] = [width - 2.0 * upright, height - 2.0 * level];
    let [middle_width, middle_height] = [width - upright, height - level];
    let around = 2.0 * (middle_width / level + middle_height / upright);
    Section {
        area: width * height - inner_width * inner_height,
        i1: (width * height.powi(3) - inner_width * inner_height.powi(3)) / 12.0,
        i2: (height * width.powi(3) - inner_height * inner_width.powi(3)) / 12.0,
        i12: 0.0,
        torsion: 4.0 * (middle_width * middle_height).powi(2) / around,
    }
}

/// Height, widths below and above, web, thickness below and above.
fn i_shape(&[height, below, above, web, thick_below, thick_above]: &[f64; 6]) -> Section {
    let web_height = height - thick_below - thick_above;
    let whole = of_rectangles(&[
        Rectangle { width: below, height: thick_below, y: 0.5 * thick_below, z: 0.0 },
        Rectangle { width: web, height: web_height, y: thick_below + 0.5 * web_height, z: 0.0 },
        Rectangle { width: above, height: thick_above, y: height - 0.5 * thick_above, z: 0.0 },
    ]);
    let between = height - 0.5 * (thick_below + thick_above);
    Section { torsion: thin(&[[below, thick_below], [above, thick_above], [between, web]]), ..whole }
}

/// Flange above; thickness of flange and web.
fn t_shape([width, height]: [f64; 2], [flange, web]: [f64; 2]) -> Section {
    let web_height = height - flange;
    let whole = of_rectangles(&[
        Rectangle { width, height: flange, y: height - 0.5 * flange, z: 0.0 },
        Rectangle { width: web, height: web_height, y: 0.5 * web_height, z: 0.0 },
    ]);
    Section { torsion: thin(&[[width, flange], [height - 0.5 * flange, web]]), ..whole }
}

/// Thickness of web and flanges.
fn channel([width, height]: [f64; 2], [web, flange]: [f64; 2]) -> Section {
    let between = height - 2.0 * flange;
    let whole = of_rectangles(&[
        Rectangle { width: web, height: between, y: 0.5 * height, z: 0.5 * web },
        Rectangle { width, height: flange, y: 0.5 * flange, z: 0.5 * width },
        Rectangle { width, height: flange, y: height - 0.5 * flange, z: 0.5 * width },
    ]);
    let arm = width - 0.5 * web;
    Section { torsion: thin(&[[arm, flange], [arm, flange], [height - flange, web]]), ..whole }
}

fn thin(walls: &[[f64; 2]]) -> f64 {
    walls.iter().map(|[length, thickness]| length * thickness.powi(3) / 3.0).sum()
}

/// Area and second moments about the common centroid; none of torsion.
fn of_rectangles(parts: &[Rectangle]) -> Section {
    let area: f64 = parts.iter().map(Rectangle::area).sum();
    let mean =
        |of: fn(&Rectangle) -> f64| parts.iter().map(|part| part.area() * of(part)).sum::<f64>() / area;
    let [y, z] = [mean(|part| part.y), mean(|part| part.z)];
    let mut whole = Section { area, ..Section::default() };
    for part in parts {
        let [up, across] = [part.y - y, part.z - z];
        whole.i1 += part.width * part.height.powi(3) / 12.0 + part.area() * up * up;
        whole.i2 += part.height * part.width.powi(3) / 12.0 + part.area() * across * across;
        whole.i12 += part.area() * up * across;
    }
    whole
}

impl Rectangle {
    fn area(&self) -> f64 {
        self.width * self.height
    }
}

impl Section {
    /// A mean of some, each with its weight.
    pub fn mean(parts: &[(Section, f64)]) -> Section {
        let whole: f64 = parts.iter().map(|(_, weight)| weight).sum();
        let mean = |of: fn(&Section) -> f64| {
            parts.iter().map(|(part, weight)| weight * of(part)).sum::<f64>() / whole
        };
        Section {
            area: mean(|part| part.area),
            i1: mean(|part| part.i1),
            i2: mean(|part| part.i2),
            i12: mean(|part| part.i12),
            torsion: mean(|part| part.torsion),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn section(name: &str, dimensions: &[f64]) -> Section {
        Shape::named(name).unwrap().section(dimensions).unwrap()
    }

    /// Sums over a fine grid of squares, whether a place is inside: area, ∫y², ∫z², ∫yz about the centroid.
    fn summed(width: f64, height: f64, is_inside: impl Fn(f64, f64) -> bool) -> [f64; 4] {
        const CELLS: usize = 800;
        let [dy, dz] = [height / CELLS as f64, width / CELLS as f64];
        let mut sums = [0.0; 6];
        for i in 0..CELLS {
            for j in 0..CELLS {
                let [y, z] = [(i as f64 + 0.5) * dy, (j as f64 + 0.5) * dz];
                if is_inside(y, z) {
                    for (sum, term) in sums.iter_mut().zip([1.0, y, z, y * y, z * z, y * z]) {
                        *sum += term * dy * dz;
                    }
                }
            }
        }
        let [a, y, z, yy, zz, yz] = sums;
        [a, yy - y * y / a, zz - z * z / a, yz - y * z / a]
    }

    #[track_caller]
    fn check(found: Section, expected: [f64; 4]) {
        let found = [found.area, found.i1, found.i2, found.i12];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-4 * expected.abs() + 1e-6 * found.abs() + 1e-9,
                "{found} {expected}"
            );
        }
    }

    /// Dimensions are multiples of the cell, so that the sums have the error of the squares alone, (1/800)².
    #[test]
    fn open_shapes_have_the_moments_of_what_is_summed_over_their_area() {
        check(
            section("I", &[8.0, 4.0, 6.0, 0.5, 1.0, 0.75]),
            summed(8.0, 8.0, |y, z| {
                let z = (z - 4.0).abs();
                if y < 1.0 {
                    z < 2.0
                } else if y > 7.25 {
                    z < 3.0
                } else {
                    z < 0.25
                }
            }),
        );
        check(
            section("T", &[6.0, 8.0, 1.0, 0.5]),
            summed(8.0, 8.0, |y, z| {
                let z = (z - 4.0).abs();
                if y > 7.0 { z < 3.0 } else { z < 0.25 }
            }),
        );
        check(
            section("CHAN", &[4.0, 8.0, 0.5, 1.0]),
            summed(8.0, 8.0, |y, z| z < 4.0 && (z < 0.5 || !(1.0..7.0).contains(&y))),
        );
        check(
            section("BOX", &[6.0, 4.0, 0.5, 1.0]),
            summed(8.0, 4.0, |y, z| z < 6.0 && !((0.5..3.5).contains(&y) && (1.0..5.0).contains(&z))),
        );
        check(section("BAR", &[6.0, 4.0]), [24.0, 32.0, 72.0, 0.0]);
    }

    #[test]
    fn torsion_constants_are_those_of_the_books() {
        assert!((section("ROD", &[2.0]).torsion - 8.0 * PI).abs() < 1e-12);
        assert!((section("TUBE", &[2.0, 1.0]).torsion - 7.5 * PI).abs() < 1e-12);
        // Timoshenko and Goodier, Theory of Elasticity, §109: 0.1406 of a square, 0.229 of 2:1, 0.312 of 10:1, times b t³.
        for (ratio, factor) in [(1.0, 0.1406), (2.0, 0.229), (10.0, 0.312)] {
            let torsion = section("BAR", &[ratio, 1.0]).torsion / ratio;
            assert!((torsion / factor - 1.0).abs() < 3e-3, "{ratio}: {torsion}");
            assert_eq!(section("BAR", &[1.0, ratio]).torsion / ratio, torsion);
        }
        // Of a thin square tube, side a between the middles of its walls: J = a³ t.
        let tube = section("BOX", &[1.01, 1.01, 0.01, 0.01]).torsion;
        assert!((tube / 0.01 - 1.0).abs() < 1e-12, "{tube}");
        assert!((section("I", &[1.02, 1.0, 1.0, 0.02, 0.02, 0.02]).torsion - 8e-6).abs() < 1e-12);
    }

    #[test]
    fn dimensions_that_leave_no_shape_are_told_by_their_number() {
        for (name, dimensions, index) in [
            ("TUBE", vec![1.0, 1.0], 1),
            ("BOX", vec![1.0, 1.0, 0.5, 0.1], 2),
            ("I", vec![1.0, 1.0, 1.0, 0.1, 0.5, 0.5], 4),
            ("ROD", vec![-1.0], 0),
            ("T", vec![1.0, 1.0, 0.1], 3),
            ("CHAN", vec![1.0, 1.0, 0.1, 0.6], 3),
        ] {
            let shape = Shape::named(name).unwrap();
            assert_eq!(shape.section(&dimensions).unwrap_err().index, index, "{name}");
        }
        assert_eq!(Shape::named("HAT"), None);
    }
}

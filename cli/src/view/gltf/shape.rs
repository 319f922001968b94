//! Surfaces as they are built: vertices that hang on joints, and triangles that look outwards.

use nalgebra::Vector3;

/// What a surface is painted as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paint {
    Skin,
    Flap,
    Body,
    Engine,
    Inlet,
}

/// A vertex on the undeformed aircraft, body axes.
#[derive(Clone, Copy, Debug)]
pub struct Vertex {
    /// m.
    pub place: Vector3<f64>,
    pub normal: Vector3<f64>,
    pub joint: usize,
}

/// A surface of one paint.
#[derive(Clone, Debug)]
pub struct Surface {
    pub paint: Paint,
    pub vertices: Vec<Vertex>,
    /// Counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// All surfaces.
#[derive(Clone, Debug)]
pub struct Shape([Surface; 5]);

impl Paint {
    pub const ALL: [Paint; 5] = [Paint::Skin, Paint::Flap, Paint::Body, Paint::Engine, Paint::Inlet];

    pub fn name(self) -> &'static str {
        match self {
            Paint::Skin => "skin",
            Paint::Flap => "flap",
            Paint::Body => "body",
            Paint::Engine => "engine",
            Paint::Inlet => "inlet",
        }
    }

    /// Red, green, blue, linear.
    pub fn colour(self) -> [f32; 3] {
        match self {
            Paint::Skin => [0.79, 0.82, 0.85],
            Paint::Flap => [0.29, 0.45, 0.62],
            Paint::Body => [0.90, 0.91, 0.92],
            Paint::Engine => [0.40, 0.46, 0.52],
            Paint::Inlet => [0.04, 0.05, 0.07],
        }
    }
}

impl Shape {
    pub fn new() -> Self {
        Shape(Paint::ALL.map(|paint| Surface { paint, vertices: Vec::new(), triangles: Vec::new() }))
    }

    /// That of a paint.
    pub fn of(&mut self, paint: Paint) -> &mut Surface {
        &mut self.0[paint as usize]
    }

    /// Those that have something.
    pub fn surfaces(&self) -> impl Iterator<Item = &Surface> {
        self.0.iter().filter(|surface| !surface.triangles.is_empty())
    }
}

impl Surface {
    pub fn vertex(&mut self, joint: usize, place: Vector3<f64>, normal: Vector3<f64>) -> u32 {
        self.vertices.push(Vertex { place, normal, joint });
        self.vertices.len() as u32 - 1
    }

    /// A triangle whose front is where the normal of its first vertex points; none where it has no area.
    pub fn triangle(&mut self, [a, b, c]: [u32; 3]) {
        let [first, second, third] = [a, b, c].map(|vertex| self.vertices[vertex as usize]);
        let front = (second.place - first.place).cross(&(third.place - first.place));
        let size = (second.place - first.place).norm() * (third.place - first.place).norm();
        if front.norm() <= f64::EPSILON * size {
            return;
        }
        let is_front = front.dot(&first.normal) >= 0.0;
        self.triangles.push(if is_front { [a, b, c] } else { [a, c, b] });
    }

    pub fn quad(&mut self, [a, b, c, d]: [u32; 4]) {
        self.triangle([a, b, c]);
        self.triangle([a, c, d]);
    }

    /// A flat face with corners in order around it.
    pub fn face(&mut self, joint: usize, normal: Vector3<f64>, corners: &[Vector3<f64>]) {
        let vertices: Vec<u32> = corners.iter().map(|corner| self.vertex(joint, *corner, normal)).collect();
        for pair in vertices[1..].windows(2) {
            self.triangle([vertices[0], pair[0], pair[1]]);
        }
    }

    /// Strips of quadrilaterals between rows that are closed around.
    pub fn rings(&mut self, rows: &[Vec<u32>]) {
        for pair in rows.windows(2) {
            for (place, (&inner, &outer)) in pair[0].iter().zip(&pair[1]).enumerate() {
                let next = (place + 1) % pair[0].len();
                self.quad([inner, pair[0][next], pair[1][next], outer]);
            }
        }
    }
}

/// The unit vector; another one where there is none.
pub fn unit(v: Vector3<f64>, otherwise: Vector3<f64>) -> Vector3<f64> {
    v.try_normalize(1e-12).unwrap_or(otherwise)
}

/// Two unit vectors at right angles to a unit vector, the first as near to straight down as it can be.
pub fn across(axis: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let beside = |wish: Vector3<f64>| wish - axis * axis.dot(&wish);
    let down = beside(Vector3::z()).try_normalize(1e-3);
    // PROOF: no axis is along z and along x.
    let first = down.unwrap_or_else(|| beside(Vector3::x()).normalize());
    [first, axis.cross(&first)]
}

/// Unit vectors around an axis.
pub fn around(axis: &Vector3<f64>, count: usize) -> Vec<Vector3<f64>> {
    let [first, second] = across(axis);
    let angle = |place: usize| std::f64::consts::TAU * place as f64 / count as f64;
    (0..count).map(|place| first * angle(place).cos() + second * angle(place).sin()).collect()
}

//! Thin rectangular tubes: stiffness and mass from their sizes [theory: coupled-sections.box].

use nalgebra::{Matrix3, Vector3};

use super::coupling::Coupling;
use super::section_matrix::{SectionMass, SectionStiffness};

/// Walls are not thicker than this share of the tube.
pub(super) const THICKEST: f64 = 0.25;

/// Sizes of a tube, m.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tube {
    /// Outer, along local z.
    pub(super) height: f64,
    /// Outer, along local y.
    pub(super) width: f64,
    /// Of the walls above and below.
    pub(super) skin: f64,
    /// Of the walls before and behind.
    pub(super) web: f64,
}

impl Tube {
    /// What of its walls is too thick: which wall, how thick it is, and the most that it may be.
    pub(super) fn too_thick(&self) -> Option<(&'static str, f64, f64)> {
        let walls = [("skin_m", self.skin, self.height), ("web_m", self.web, self.width)];
        let mut most = walls.into_iter().map(|(name, wall, size)| (name, wall, THICKEST * size));
        most.find(|(_, wall, most)| wall > most)
    }

    /// Of walls of one material, Pa, without coupling.
    pub(super) fn stiffness(&self, young: f64, shear: f64) -> SectionStiffness {
        let Tube { height, width, skin, web } = *self;
        let [about_y, about_z] = self.second_moments();
        let enclosed = (width - web) * (height - skin);
        let around = 2.0 * ((width - web) / skin + (height - skin) / web);
        SectionStiffness {
            axial: young * self.area(),
            torsional: 4.0 * shear * enclosed * enclosed / around,
            bending_y: young * about_y,
            bending_z: young * about_z,
            coupling: Coupling::NONE,
        }
    }

    /// Of walls of a density, kg/m³, with their centre at a place.
    pub(super) fn mass(&self, density: f64, [y, z]: [f64; 2]) -> SectionMass {
        let [about_y, about_z] = self.second_moments();
        let moments = Vector3::new(about_y + about_z, about_y, about_z) * density;
        SectionMass {
            mass: density * self.area(),
            centre: Vector3::new(0.0, y, z),
            inertia: Matrix3::from_diagonal(&moments),
        }
    }

    fn inside(&self) -> [f64; 2] {
        [self.height - 2.0 * self.skin, self.width - 2.0 * self.web]
    }

    fn area(&self) -> f64 {
        let [height, width] = self.inside();
        self.width * self.height - width * height
    }

    /// ∫z² dA and ∫y² dA.
    fn second_moments(&self) -> [f64; 2] {
        let cube = |x: f64| x * x * x;
        let [height, width] = self.inside();
        let about_y = self.width * cube(self.height) - width * cube(height);
        let about_z = self.height * cube(self.width) - height * cube(width);
        [about_y / 12.0, about_z / 12.0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_tube_is_that_of_the_tables_and_of_a_thin_wall() {
        // Square hollow section 100 × 100 × 4 with sharp corners: A = 15.36 cm², I = 236.3 cm⁴ (b⁴ − bᵢ⁴)/12.
        let tube = Tube { height: 0.1, width: 0.1, skin: 0.004, web: 0.004 };
        let section = tube.stiffness(2.1e11, 8.1e10);
        assert!((section.axial / (2.1e11 * 15.36e-4) - 1.0).abs() < 1e-12);
        assert!(
            (section.bending_y / (2.1e11 * (0.1_f64.powi(4) - 0.092_f64.powi(4)) / 12.0) - 1.0).abs() < 1e-12
        );
        assert_eq!(section.bending_y, section.bending_z);
        // Bredt's J = t b³ of a thin square tube, b the middle line.
        assert!((section.torsional / (8.1e10 * 0.004 * 0.096_f64.powi(3)) - 1.0).abs() < 1e-12);
        let mass = tube.mass(7850.0, [0.01, -0.02]);
        assert!((mass.mass - 7850.0 * 15.36e-4).abs() < 1e-12);
        assert!((mass.inertia[(0, 0)] - 2.0 * mass.inertia[(1, 1)]).abs() < 1e-15);
        assert_eq!(mass.centre, Vector3::new(0.0, 0.01, -0.02));
    }

    #[test]
    fn height_is_across_bending_in_z_and_each_wall_is_held_against_its_own_side() {
        let tube = Tube { height: 0.1, width: 0.4, skin: 0.002, web: 0.004 };
        let section = tube.stiffness(7e10, 2.6e10);
        assert!(section.bending_z > 9.0 * section.bending_y);
        // Thin walls: skins at ± h/2, webs over the height.
        let thin = 7e10 * (2.0 * 0.4 * 0.002 * 0.049_f64.powi(2) + 2.0 * 0.004 * 0.096_f64.powi(3) / 12.0);
        assert!((section.bending_y / thin - 1.0).abs() < 1e-3, "{} {thin}", section.bending_y);
        assert_eq!(tube.too_thick(), None);
        assert_eq!(Tube { skin: 0.03, ..tube }.too_thick(), Some(("skin_m", 0.03, 0.025)));
        assert_eq!(Tube { web: 0.2, ..tube }.too_thick(), Some(("web_m", 0.2, 0.1)));
    }
}

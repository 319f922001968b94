//! How stiff a section is, and the same in other axes [theory: coupled-sections.energy].

/// A product of second moments below this share of them is rounding.
const ROUNDED: f64 = 1e-9;

/// Sine of 0.01°: axes that are nearer are one.
pub const ALIGNED: f64 = 1.75e-4;

/// Stiffness of a section in axes across it; names as in aircraft files. The axis of twist is the element's own.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stiffness {
    /// N.
    pub ea: f64,
    /// N m².
    pub gj: f64,
    /// Bending in z.
    pub ei_y: f64,
    /// Bending in y.
    pub ei_z: f64,
    /// ∫E y z dA: PBAR and PBEAM have I12 = ∫y z dA, which couples bending in y and in z with this sign in the stiffness of a CBAR
    /// [MYSTRAN, BAR1: KE(2,3) = 12 E I12/L³].
    pub ei_yz: f64,
    /// Where an axial force bends nothing, along y and z, m.
    pub tension_axis: [f64; 2],
}

impl Stiffness {
    /// Whether it is the same in all axes.
    pub fn is_round(&self) -> bool {
        (self.ei_y - self.ei_z).abs() <= 1e-9 * self.ei_y.max(self.ei_z)
            && self.ei_yz == 0.0
            && self.tension_axis == [0.0; 2]
    }

    /// The least stiffness against bending.
    pub fn softest(&self) -> f64 {
        let [half, difference] = [0.5 * (self.ei_y + self.ei_z), 0.5 * (self.ei_y - self.ei_z)];
        half - libm::hypot(difference, self.ei_yz)
    }

    /// Without what rounding has left of a product of second moments.
    pub fn without_rounding(self) -> Self {
        let is_rounding = self.ei_yz.abs() <= ROUNDED * libm::sqrt(self.ei_y * self.ei_z);
        Stiffness { ei_yz: if is_rounding { 0.0 } else { self.ei_yz }, ..self }
    }

    /// In axes whose y is at these shares of the old y and z, and whose x points as before or, `is_reversed`, back.
    pub fn in_axes(&self, [along_y, along_z]: [f64; 2], is_reversed: bool) -> Self {
        let snapped = |share: f64, other: f64| match () {
            () if other.abs() < ALIGNED => share.signum(),
            () if share.abs() < ALIGNED => 0.0,
            () => share,
        };
        let (cos, sin) = (snapped(along_y, along_z), snapped(along_z, along_y));
        let side = if is_reversed { -1.0 } else { 1.0 };
        let Stiffness { ei_y, ei_z, ei_yz, tension_axis: [y, z], .. } = *self;
        let both = 2.0 * cos * sin * ei_yz;
        Stiffness {
            ei_z: cos * cos * ei_z + sin * sin * ei_y + both,
            ei_y: sin * sin * ei_z + cos * cos * ei_y - both,
            // What is 0 is without sign.
            ei_yz: 0.0 + side * (cos * sin * (ei_y - ei_z) + (cos * cos - sin * sin) * ei_yz),
            tension_axis: [0.0 + cos * y + sin * z, 0.0 + side * (cos * z - sin * y)],
            ..*self
        }
        .without_rounding()
    }

    /// Of the mirror image, whose x and y are mirrored [theory: coupled-sections.mirrored].
    pub fn mirrored(&self) -> Self {
        let [y, z] = self.tension_axis;
        Stiffness { ei_yz: 0.0 - self.ei_yz, tension_axis: [y, 0.0 - z], ..*self }
    }

    /// Of the same section in axes whose y and z both point the other way.
    pub fn turned_about(&self) -> Self {
        Stiffness { tension_axis: self.tension_axis.map(|place| 0.0 - place), ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of an area with ∫y², ∫z², ∫yz of 5, 3, 1 and its tension axis at (0.2, 0.1): in axes that are turned by 30° each is what the places are there.
    #[test]
    fn second_moments_in_other_axes_are_those_of_the_places_there() {
        let places: [([f64; 2], f64); 3] = [([1.0, 0.0], 4.0), ([1.0, 1.0], 1.0), ([0.0, 1.0], 2.0)];
        let moments = |axes: [[f64; 2]; 2]| {
            let mut sums = [0.0; 3];
            for ([y, z], weight) in places {
                let [other_y, other_z] = axes.map(|[along_y, along_z]| along_y * y + along_z * z);
                let terms = [other_y * other_y, other_z * other_z, other_y * other_z];
                sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += weight * term);
            }
            sums
        };
        let [ei_z, ei_y, ei_yz] = moments([[1.0, 0.0], [0.0, 1.0]]);
        let section = Stiffness { ea: 1.0, gj: 1.0, ei_y, ei_z, ei_yz, tension_axis: [0.2, 0.1] };
        let (sin, cos) = 30f64.to_radians().sin_cos();
        for (y, z, is_reversed) in [
            ([cos, sin], [-sin, cos], false),
            ([cos, sin], [sin, -cos], true),
            ([0.0, -1.0], [1.0, 0.0], false),
        ] {
            let found = section.in_axes(y, is_reversed);
            let expected = moments([y, z]);
            for (found, expected) in [found.ei_z, found.ei_y, found.ei_yz].into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-12, "{found} {expected}");
            }
            let place = [y, z].map(|[along_y, along_z]| 0.2 * along_y + 0.1 * along_z);
            for (found, expected) in found.tension_axis.into_iter().zip(place) {
                assert!((found - expected).abs() < 1e-12, "{found} {expected}");
            }
        }
    }
}

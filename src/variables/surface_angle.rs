//! Angles of control surfaces as people give them, at times in degrees.

/// The largest that is taken for one in rad.
const LARGEST: f64 = 1.6;

/// What is allowed in place of an angle, if it is too large for one in rad.
pub fn instead_of_degrees(angle: f64) -> Option<String> {
    let looks_like_degrees = angle.abs() > LARGEST;
    looks_like_degrees
        .then(|| format!("-{LARGEST} to {LARGEST} rad: inputs are rad; {angle} looks like degrees"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_in_degrees_is_told_from_one_in_rad() {
        assert_eq!([0.0, 1.6, -1.6].map(instead_of_degrees), [None, None, None]);
        let expected = "-1.6 to 1.6 rad: inputs are rad; -5 looks like degrees";
        assert_eq!(instead_of_degrees(-5.0).as_deref(), Some(expected));
    }
}

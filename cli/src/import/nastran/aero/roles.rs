//! What controls hold where an aircraft is trimmed: the one that pitches most, rolls most, yaws most.

use nalgebra::Vector3;

use super::super::structure::Structure;
use super::controls::is_rightwards;
use super::strip::Surface;

/// What a control holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    Pitch,
    Roll,
    Yaw,
}

impl Role {
    /// By the axis of its moment.
    const OF_AXES: [Role; 3] = [Role::Roll, Role::Pitch, Role::Yaw];

    /// That of its moment: x, y, z.
    pub fn axis(self) -> usize {
        match self {
            Role::Roll => 0,
            Role::Pitch => 1,
            Role::Yaw => 2,
        }
    }

    pub fn name(self) -> &'static str {
        match self {
            Role::Pitch => "pitch",
            Role::Roll => "roll",
            Role::Yaw => "yaw",
        }
    }
}

/// A rudder rolls too, but does not pitch: a moment is across the plane of symmetry if the pitching one is less than this share of it.
const ASIDE: f64 = 0.2;

/// What holds pitch does nothing else: one elevator of two rolls.
const IN_PLANE: f64 = 0.02;

/// Moments by which flaps of 1 rad turn the aircraft, of each control, as areas times arms, m³.
pub fn moments(structure: &Structure, surfaces: &[Surface], controls: usize) -> Vec<Vector3<f64>> {
    let centre = structure.centre();
    let mut moments = vec![Vector3::zeros(); controls];
    for surface in surfaces {
        let Some(flap) = &surface.flap else { continue };
        let (at, width) = middle(structure, surface);
        let chord = surface.chords.iter().sum::<f64>() / surface.chords.len() as f64;
        let span = if is_rightwards(&width) { width.normalize() } else { -width.normalize() };
        let normal = Vector3::x().cross(&span);
        for &(control, gain) in &flap.moves {
            // Lift is against n, and a positive flap adds to it.
            moments[control] -=
                (at - centre).cross(&normal) * (gain * flap.effectiveness * chord * width.norm());
        }
    }
    moments
}

/// The middle of a surface's stretch, and the stretch across x.
pub fn middle(structure: &Structure, surface: &Surface) -> (Vector3<f64>, Vector3<f64>) {
    let component = &structure.components[surface.component];
    let distances = component.distances();
    let length = distances[distances.len() - 1];
    let place = |fraction: f64| {
        let distance = fraction * length;
        let element =
            distances.windows(2).position(|ends| distance <= ends[1]).unwrap_or(distances.len() - 2);
        let share = (distance - distances[element]) / (distances[element + 1] - distances[element]);
        component.points[element].lerp(&component.points[element + 1], share)
    };
    let [from, to] = [place(surface.from), place(surface.to)];
    let along = to - from;
    (0.5 * (from + to), Vector3::new(0.0, along.y, along.z))
}

/// One control for each role, of those that turn about one axis alone; none of what turns nothing.
pub fn roles(moments: &[Vector3<f64>]) -> Vec<Option<Role>> {
    let axis = |moment: &Vector3<f64>| {
        let axis = moment.iamax();
        let others =
            (0..3).filter(|other| *other != axis).map(|other| moment[other].abs()).fold(0.0, f64::max);
        let is_alone = match Role::OF_AXES[axis] {
            Role::Pitch => others < IN_PLANE * moment[axis].abs(),
            Role::Roll | Role::Yaw => moment.y.abs() < ASIDE * moment[axis].abs(),
        };
        (moment[axis].abs() > 0.0 && is_alone).then_some(axis)
    };
    let mut roles = vec![None; moments.len()];
    for (place, role) in Role::OF_AXES.into_iter().enumerate() {
        let of_axis = (0..moments.len()).filter(|&control| axis(&moments[control]) == Some(place));
        let most = of_axis.max_by(|&one, &other| {
            // The first of equals.
            moments[one][place].abs().total_cmp(&moments[other][place].abs()).then(other.cmp(&one))
        });
        if let Some(control) = most {
            roles[control] = Some(role);
        }
    }
    roles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_greatest_moment_about_one_axis_alone_has_the_role() {
        let elevator = Vector3::new(0.0, -12.0, 0.0);
        let flaps = Vector3::new(0.0, 1.0, 0.0);
        let ailerons = Vector3::new(9.0, 0.0, 0.1);
        let rudder = Vector3::new(0.4, 0.0, 6.0);
        let one_elevator = Vector3::new(6.0, -20.0, 0.0);
        let one_aileron = Vector3::new(8.0, 4.0, 0.0);
        let idle = Vector3::zeros();
        let found = roles(&[flaps, elevator, ailerons, rudder, one_elevator, one_aileron, idle]);
        let [pitch, roll, yaw] = [Role::Pitch, Role::Roll, Role::Yaw].map(Some);
        assert_eq!(found, [None, pitch, roll, yaw, None, None, None]);
    }
}

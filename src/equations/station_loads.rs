//! Loads on stations: forces that keep their direction in earth axes, moments that turn with their sections.
//!
//! [theory: gravity-and-thrust.point-loads, kinematics.rows]

use nalgebra::{Matrix3, Vector3};

use crate::kinematics::{GeneralisedVectorMut, Section, Sections};
use crate::strips::Resultant;

/// What acts on the stations; nothing at first.
#[derive(Clone, Debug, Default)]
pub struct StationLoads {
    /// On each station in their order, or none at all.
    loads: Vec<StationLoad>,
}

/// What acts on one station.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StationLoad {
    /// North-east-down, N.
    pub force: Vector3<f64>,
    /// In the axes that its section has undeformed and takes along, N m.
    pub moment: Vector3<f64>,
}

impl StationLoad {
    /// Nothing.
    pub const NONE: StationLoad =
        StationLoad { force: Vector3::new(0.0, 0.0, 0.0), moment: Vector3::new(0.0, 0.0, 0.0) };
}

impl StationLoads {
    /// Loads on each station, in their order.
    pub fn new(loads: Vec<StationLoad>) -> Self {
        StationLoads { loads }
    }

    /// Whether nothing acts.
    pub fn are_none(&self) -> bool {
        self.loads.iter().all(|load| *load == StationLoad::NONE)
    }

    /// What acts on each station that bears anything, at its deformed place, in body axes.
    pub fn resultants(
        &self,
        sections: &impl Sections,
        body_from_inertial: &Matrix3<f64>,
    ) -> impl Iterator<Item = Resultant> {
        let loads = self.loads.iter().zip(sections.stations());
        loads.map(move |(StationLoad { force, moment }, section)| Resultant {
            position: section.at_rest() + section.displacement(),
            force: body_from_inertial * force,
            moment: section.turned(moment),
        })
    }

    /// Adds their generalised forces on ν; with `deformed_arms` they act about O from the deformed place.
    pub fn add(
        &self,
        sections: &impl Sections,
        body_from_inertial: &Matrix3<f64>,
        deformed_arms: bool,
        forces: &mut [f64],
    ) {
        let mut forces = GeneralisedVectorMut::of(forces);
        for (StationLoad { force, moment }, section) in self.loads.iter().zip(sections.stations()) {
            let (force, moment) = (body_from_inertial * force, section.turned(moment));
            let displacement = if deformed_arms { section.displacement() } else { Vector3::zeros() };
            let arm = section.at_rest() + displacement;
            forces.add_rigid(&force, &(arm.cross(&force) + moment));
            section.add_generalised_load(&force, &moment, forces.modal);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Scalar;

    use crate::kinematics::test_kind::Curved;
    use crate::kinematics::{Coordinates, GeometricallyExact, Kinematics, Superposition};
    use crate::structure::test_jet::jet;

    #[test]
    fn loads_do_the_work_of_their_stations_whatever_the_kinematics() {
        do_the_work::<Superposition>();
        do_the_work::<GeometricallyExact>();
        do_the_work::<Curved>();
    }

    /// Whether loads on ν have the power that they have on the stations of the moving jet.
    fn do_the_work<K: Kinematics>() {
        let model = jet().select(&[0, 1, 2, 3, 4]);
        let kinematics = K::new(&model, &[]);
        let [q, q_dot] = [[20.0, -15.0, 30.0, 10.0, -25.0], [4.0, 3.0, -2.0, 1.0, 5.0]];
        let at = Coordinates { q: &q, q_dot: &q_dot };
        let mut memory = kinematics.memory();
        kinematics.evaluate(Scalar::new(), at, &mut memory);
        let sections = kinematics.sections(at, &memory);

        let vector = |seed: f64| Vector3::new(libm::sin(seed), libm::sin(2.3 * seed), libm::cos(3.1 * seed));
        let load = |station: usize| {
            let seed = station as f64 + 0.4;
            StationLoad { force: vector(seed) * 100.0, moment: vector(-seed) * 300.0 }
        };
        let loads: Vec<StationLoad> = (0..model.stations.len()).map(load).collect();
        let to_body = nalgebra::Rotation3::from_euler_angles(0.3, -0.5, 1.1).into_inner();
        let (velocity, rate) = (vector(0.2), vector(0.9));
        let powers = loads.iter().zip(sections.stations()).map(|(load, section)| {
            let arm = section.at_rest() + section.displacement();
            let motion = velocity + rate.cross(&arm) + section.velocity();
            let moment = section.turned(&load.moment);
            [(to_body * load.force).dot(&motion), moment.dot(&section.angular_velocity(&rate))]
        });
        let powers: Vec<[f64; 2]> = powers.collect();
        let expected: f64 = powers.iter().flatten().sum();
        let size: f64 = powers.iter().flatten().map(|power| power.abs()).sum();

        let mut forces = vec![0.0; 6 + q.len()];
        StationLoads::new(loads).add(&sections, &to_body, true, &mut forces);
        let velocities = velocity.iter().chain(rate.iter()).chain(&q_dot);
        let found: f64 = forces.iter().zip(velocities).map(|(force, velocity)| force * velocity).sum();
        assert!(size > 1e3 && (found - expected).abs() < 1e-14 * size, "{found} {expected} of {size}");
    }
}

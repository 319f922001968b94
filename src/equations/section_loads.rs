//! Section loads: force and moment at cuts through the airframe, by summation of all that acts outboard.
//!
//! [theory: section-loads.summation, section-loads.pieces, section-loads.axes]
//!
//! Accelerations are the true ones and arms the deformed ones at every level of fidelity.

use nalgebra::{Matrix3, Vector3};

use crate::kinematics::{
    Carried, CarriesMass, GeneralisedVector, Kinematics, OfKind, RigidMotion, Sections, by_kind,
};
use crate::math::Attitude;
use crate::strips::{Accelerated, Resultant, Surroundings};
use crate::structure::RigidBody;

use super::controls::Controls;
use super::cuts::SectionLoads;
use super::of_motion::EquationsOfMotion;
use super::workspace::Workspace;

/// What acts on an aircraft at an instant.
#[derive(Clone, Copy)]
struct Instant<'a> {
    controls: &'a Controls,
    motion: RigidMotion,
    accelerations: GeneralisedVector<'a>,
    /// C_bI.
    to_body: &'a Matrix3<f64>,
    /// Body axes, m/s².
    gravity: Vector3<f64>,
}

impl EquationsOfMotion {
    /// Number of cuts.
    pub(crate) fn cut_count(&self) -> usize {
        self.cuts.len()
    }

    /// Writes the loads at all cuts in the state and under the controls of the last evaluation.
    pub(crate) fn write_section_loads(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &Workspace,
        loads: &mut [SectionLoads],
    ) {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        let instant = Instant {
            controls,
            motion: self.motion(state),
            accelerations: GeneralisedVector::of(workspace.accelerations()),
            to_body: &attitude.body_from_inertial,
            gravity: attitude.body_from_inertial * Vector3::new(0.0, 0.0, self.gravity),
        };
        loads.fill(SectionLoads::default());
        self.tell_strip_loads(state, controls, workspace, |strip, resultant| {
            self.cuts.add(loads, |outboard| &outboard.strips, strip, &resultant);
        });
        let at = self.coordinates(state);
        by_kind!(self.kinematics.as_ref().with(workspace.kinematics().as_ref()), |(kinematics, memory)| {
            let sections = kinematics.sections(at, memory);
            self.add_masses(&sections, &instant, loads);
            self.add_thrusts_and_station_loads(&sections, &instant, loads);
            self.cuts.resolve(sections.cuts(at.q), loads);
        });
    }

    /// Tells what the air does to each strip in the state and under the controls of the last evaluation, in their order, those edge-on
    /// left out.
    pub(crate) fn tell_strip_loads(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &Workspace,
        mut tell: impl FnMut(usize, Resultant),
    ) {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        let gust = self.gust_seen(state, &attitude, controls).map(|_| &workspace.gust);
        let around = Surroundings { gust, ..self.surroundings(state, &attitude, controls) };
        let accelerated = Accelerated {
            state,
            layout: self.layout.inflow_layout(),
            accelerations: GeneralisedVector::of(workspace.accelerations()),
            angles: &controls.angles,
        };
        let at = self.coordinates(state);
        by_kind!(self.kinematics.as_ref().with(workspace.kinematics().as_ref()), |(kinematics, memory)| {
            let sections = kinematics.sections(at, memory);
            self.strips.tell_resultants(&sections, &around, &accelerated, &mut tell);
        });
    }

    fn add_masses(&self, sections: &impl Sections, instant: &Instant, loads: &mut [SectionLoads]) {
        for (mass, (body, section)) in self.cuts.bodies().iter().zip(sections.masses()).enumerate() {
            let resultant = instant.on_mass(body, &section);
            self.cuts.add(loads, |outboard| &outboard.masses, mass, &resultant);
        }
    }

    fn add_thrusts_and_station_loads(
        &self,
        sections: &impl Sections,
        instant: &Instant,
        loads: &mut [SectionLoads],
    ) {
        let gyroscopic = self.engines.gyroscopic_moments(sections, &instant.motion.rate);
        let acting = self.engines.per_newton(sections).zip(&instant.controls.thrust).zip(gyroscopic);
        for (engine, ((Resultant { position, force, moment }, thrust), gyroscopic)) in acting.enumerate() {
            let (force, moment) = (force * *thrust, moment * *thrust + gyroscopic);
            let resultant = Resultant { position, force, moment };
            self.cuts.add(loads, |outboard| &outboard.engines, engine, &resultant);
        }
        for (station, resultant) in self.station_loads.resultants(sections, instant.to_body).enumerate() {
            self.cuts.add(loads, |outboard| &outboard.stations, station, &resultant);
        }
    }
}

impl Instant<'_> {
    /// Weight less inertia of a body, m(g − a) of all its parts, at its centre [theory: section-loads.pieces].
    fn on_mass(&self, body: &RigidBody, section: &impl CarriesMass) -> Resultant {
        let Instant { motion: RigidMotion { velocity, rate }, .. } = *self;
        let GeneralisedVector { translation, rotation, modal } = self.accelerations;
        let Carried { now, rate: rising, acceleration: curving } = section.carried(modal);
        let (spin, spinning_up) = (rate.cross_matrix(), rotation.cross_matrix());
        let turning = spinning_up + spin * spin;
        let position = section.at_rest() + section.displacement() + now * body.offset;
        let relative_velocity = section.velocity() + rising * body.offset;
        let acceleration = translation
            + rate.cross(&velocity)
            + turning * position
            + spin * relative_velocity * 2.0
            + section.acceleration(modal)
            + curving * body.offset;
        // What lies o beside the centre is at B o from there, and accelerated by N o more.
        let around = turning * now + spin * rising * 2.0 + curving;
        let second_moment = Matrix3::identity() * (0.5 * body.inertia.trace()) - body.inertia;
        Resultant {
            position,
            force: (self.gravity - acceleration) * body.mass,
            moment: -twist(&(now * second_moment * around.transpose())),
        }
    }
}

/// Of a sum of products a bᵀ the sum of a × b.
fn twist(m: &Matrix3<f64>) -> Vector3<f64> {
    Vector3::new(m[(1, 2)] - m[(2, 1)], m[(2, 0)] - m[(0, 2)], m[(0, 1)] - m[(1, 0)])
}

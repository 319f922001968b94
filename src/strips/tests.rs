//! Strips on sections of a kind of kinematics that is not the thesis'.

use nalgebra::Vector3;
use pulp::Scalar;

use crate::air::UniformFlow;
use crate::kinematics::{
    Bias, RigidFreedom, SectionMotion, Sections, SectionsInPlane, SectionsInSpace, Superposition,
};
use crate::math::{Arithmetic, Arrow, Attitude, Eight, LANES, LaneVector, Lanes, PlaneVector, Window};
use crate::structure::ReducedStrip;
use crate::structure::test_jet::jet_in_plane;

use super::inflow::PetersInflow;
use super::{Strips, Surroundings};

/// Sections that accelerate by themselves, at a and α, however the others beneath them move.
struct Accelerating<T> {
    sections: T,
    a: Vector3<f64>,
    alpha: Vector3<f64>,
}

impl<T: SectionsInSpace> SectionsInSpace for Accelerating<T> {
    type Turn<S: Arithmetic> = T::Turn<S>;

    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> LaneVector<S> {
        self.sections.at_rest(window)
    }

    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<LaneVector<S>, LaneVector<S>, T::Turn<S>> {
        let bias = Bias {
            acceleration: LaneVector::splat(window, &self.a),
            angular_acceleration: LaneVector::splat(window, &self.alpha),
        };
        SectionMotion { bias: Some(bias), ..self.sections.motion(window) }
    }

    fn rows(&self) -> impl Iterator<Item = &[Eight; 6]> {
        self.sections.rows()
    }
}

/// The same in the mirror plane.
struct AcceleratingInPlane<T>(Accelerating<T>);

impl<T: SectionsInPlane> SectionsInPlane for AcceleratingInPlane<T> {
    type Turn<S: Arithmetic> = T::Turn<S>;

    fn at_rest<S: Arithmetic>(&self, window: Window<S>) -> PlaneVector<S> {
        self.0.sections.at_rest(window)
    }

    fn motion<S: Arithmetic>(
        &self,
        window: Window<S>,
    ) -> SectionMotion<PlaneVector<S>, Lanes<S>, T::Turn<S>> {
        let bias = Bias {
            acceleration: PlaneVector::splat(window, &self.0.a),
            angular_acceleration: window.splat(self.0.alpha.y),
        };
        SectionMotion { bias: Some(bias), ..self.0.sections.motion(window) }
    }

    fn rows(&self) -> impl Iterator<Item = [&Eight; 3]> {
        self.0.sections.rows()
    }
}

/// By how much a and α of the section change ẇ = … + m·a and Ω̇ = … + s·α of an undeformed strip.
fn expected(strip: &ReducedStrip, [a, alpha]: [Vector3<f64>; 2]) -> [f64; 2] {
    let zero_lift_normal = strip.forward.cross(&strip.span) + strip.forward * strip.zero_lift_offset;
    [zero_lift_normal.dot(&a), strip.span.dot(&alpha)]
}

#[test]
fn upwash_and_pitch_rate_change_by_the_biases_of_sections_in_space_and_in_the_mirror_plane() {
    let (mut model, _) = jet_in_plane();
    model.strips.iter_mut().for_each(|strip| strip.zero_lift_offset = 0.03);
    let (strips, sections) =
        (Strips::new(&model, &[], RigidFreedom::InPlane), Superposition::new(&model, &[]));
    let at_rest = vec![0.0; model.modes.len()];
    let sections = sections.at(&at_rest, &at_rest);
    let (inflow, velocity, rate) =
        (PetersInflow::new(0), Vector3::new(120.0, 0.0, 9.0), Vector3::new(0.0, 0.3, 0.0));
    let still = UniformFlow { velocity: Vector3::zeros(), rate: Vector3::zeros() };
    let level = Attitude::from_quaternion(&[1.0, 0.0, 0.0, 0.0]);
    let around = Surroundings {
        air: still.met_by(&level, [&velocity, &rate]),
        rate,
        density: 1.0,
        inflow: &inflow,
        deformed_arms: true,
        freedom: RigidFreedom::InPlane,
    };
    let bias @ [a, alpha] = [Vector3::new(3.0, 0.0, -5.0), Vector3::new(0.0, 0.7, 0.0)];
    let mut in_plane = 0;
    for (index, strips_here) in model.strips.chunks(LANES).enumerate() {
        let group = &strips.groups[index];
        for (window, strip) in Window::all(Scalar::new()).zip(strips_here) {
            let accelerating = Accelerating { sections: sections.of_strips(index), a, alpha };
            let flow = group.deform::<Scalar, false>(window, &accelerating, &around).flow;
            let unbiased = group.deform::<Scalar, false>(window, &accelerating.sections, &around).flow;
            let mut changes = vec![(flow, unbiased)];
            if group.in_plane {
                in_plane += 1;
                let accelerating = AcceleratingInPlane(accelerating);
                let flow = group.deform_in_plane::<Scalar, false>(window, &accelerating, &around).flow;
                let unbiased =
                    group.deform_in_plane::<Scalar, false>(window, &accelerating.0.sections, &around).flow;
                changes.push((flow, unbiased));
            }
            for (flow, unbiased) in changes {
                let found =
                    [flow.upwash_drift - unbiased.upwash_drift, flow.pitch_drift - unbiased.pitch_drift];
                for (found, expected) in found.into_iter().zip(expected(strip, bias)) {
                    assert!((found.numbers()[0] - expected).abs() < 1e-12, "{index}: {found:?} {expected}");
                }
            }
        }
    }
    assert!(in_plane > LANES);
}

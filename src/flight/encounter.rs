//! What a flight flies into: gust and turbulence along the track on which it begins [theory: gusts.field].

use std::sync::Arc;

use nalgebra::Vector3;

use crate::air::{Extent, FrozenGust, Track};
use crate::aircraft::Support;
use crate::math::Attitude;
use crate::plant::{Plant, Trim};
use crate::structure::{ReducedModel, ReducedStrip};

use super::settings::Settings;

/// What is frozen in the air under some settings before an aircraft that is trimmed so, along its course; `None` where nothing is.
pub(super) fn encounter(
    model: &ReducedModel,
    settings: &Settings,
    plant: &Plant,
    trim: &Trim,
) -> Option<Arc<FrozenGust>> {
    let Way { track, .. } = way(model, settings, plant, trim);
    let density = plant.air(&trim.state).density;
    FrozenGust::new(track, (&settings.gust, &settings.turbulence), settings.plant.altitude, density)
        .map(Arc::new)
}

/// The way of an aircraft through what is frozen in the air.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Way {
    /// On which it begins.
    pub track: Track,
    /// Between which distances ahead of O all strips are, m, the foremost first: the undeformed aircraft, whether its first axis
    /// is along the track or as trimmed.
    pub ends: [f64; 2],
}

/// That of an aircraft which is trimmed under some settings, along its course.
pub(crate) fn way(model: &ReducedModel, settings: &Settings, plant: &Plant, trim: &Trim) -> Way {
    let layout = plant.layout();
    let position = Vector3::from_column_slice(&trim.state[layout.position()]);
    let attitude = Attitude::from_quaternion(&trim.state[layout.attitude()]);
    let (velocity, ahead) = match model.support {
        Support::Free => {
            let velocity = Vector3::from_column_slice(&trim.state[layout.velocity()]);
            (attitude.body_from_inertial.tr_mul(&velocity), Vector3::x())
        }
        // Along the first axis of the earth; the mount may hold the aircraft in any attitude.
        Support::Clamped => (
            -settings.plant.along_course().configuration(model.support).tunnel_flow,
            attitude.body_from_inertial * Vector3::x(),
        ),
    };
    let track = Track::new(&position, &velocity, extent(model, &ahead));
    let [[nose, tail], [foremost, last]] =
        [ahead, attitude.body_from_inertial * track.along()].map(|ahead| edges(model, &ahead));
    Way { track, ends: [nose.max(foremost), tail.min(last)] }
}

/// By how much the foremost leading and the last trailing edge of any strip are ahead of O, in a direction of body axes, on the
/// undeformed aircraft, m.
fn edges(model: &ReducedModel, ahead: &Vector3<f64>) -> [f64; 2] {
    let edge = |strip: &ReducedStrip, semichords: f64| {
        let chordwise = strip.forward * (strip.elastic_axis_aft_of_midchord + semichords * strip.semichord);
        ahead.dot(&(strip.position + chordwise))
    };
    let all = |semichords: f64| model.strips.iter().map(move |strip| edge(strip, semichords));
    [all(1.0).reduce(f64::max).unwrap_or(0.0), all(-1.0).reduce(f64::min).unwrap_or(0.0)]
}

/// How far an aircraft reaches, `ahead` in a direction of body axes; no strip is ever twice as far from O as on the undeformed
/// aircraft.
fn extent(model: &ReducedModel, ahead: &Vector3<f64>) -> Extent {
    let reach = |strip: &ReducedStrip| {
        2.0 * strip.position.norm() + strip.elastic_axis_aft_of_midchord.abs() + strip.semichord
    };
    Extent { nose: edges(model, ahead)[0], reach: model.strips.iter().map(reach).fold(0.0, f64::max) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::test_jet::jet;

    #[test]
    fn the_jet_meets_a_gust_with_the_leading_edge_of_its_nose() {
        // From an independent computation: 10.4143 m before O.
        let Extent { nose, reach } = extent(jet(), &Vector3::x());
        assert!((nose - 10.4143).abs() < 5e-5 && reach > nose, "{nose} {reach}");
        // Its last trailing edge is that of the fin's tip, which goes back as the nose goes up.
        let [level, pitched] = [0.0, 0.15].map(|pitch: f64| {
            let (sin, cos) = libm::sincos(pitch);
            edges(jet(), &Vector3::new(cos, 0.0, sin))[1]
        });
        assert!(pitched < level - 0.2 && level < -10.0, "{level} {pitched}");
    }
}

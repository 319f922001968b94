//! The shipped jet, for unit tests of all rooms from here on.

use std::sync::OnceLock;

use crate::aircraft::Aircraft;

use super::{ModeFamily, ReducedModel, ReducedStrip};

/// Places of the jet's controls among its inputs.
pub const ELEVATOR: usize = 0;
pub const AILERON: usize = 1;
pub const AILERON_SYMMETRIC: usize = 2;
pub const RUDDER: usize = 3;

/// The shipped jet.
pub fn jet() -> &'static ReducedModel {
    static JET: OnceLock<ReducedModel> = OnceLock::new();
    JET.get_or_init(|| {
        let text = include_str!("../../aircraft/generic-business-jet.toml");
        ReducedModel::new(
            &Aircraft::parse(text, "generic-business-jet.toml").unwrap(),
            ReducedModel::USUAL_MODES,
        )
        .unwrap()
    })
}

/// What of the jet can move in its mirror plane: of its lowest five modes those that are symmetric, the strips on the right
/// and, last, those in the plane; and by themselves the strips that meet such motion edge-on.
pub fn jet_in_plane() -> (ReducedModel, Vec<ReducedStrip>) {
    let symmetric = |&mode: &usize| jet().modes[mode].family == ModeFamily::Symmetric;
    let mut model = jet().select(&(0..5).filter(symmetric).collect::<Vec<_>>());
    let centred = |strip: &ReducedStrip| strip.position.y.abs() < 1e-9;
    let (mut in_plane, aside): (Vec<_>, Vec<_>) = model.strips.into_iter().partition(centred);
    let edge_on = in_plane.extract_if(.., |strip| strip.span.y.abs() < 0.5).collect();
    in_plane.iter_mut().for_each(ReducedStrip::lay_in_plane);
    model.strips = aside.into_iter().filter(|strip| strip.position.y > 0.0).chain(in_plane).collect();
    (model, edge_on)
}

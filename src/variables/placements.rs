//! Where the aircraft and its stations are as outputs: attitudes by quaternions, places in space, the path over the ground.
//!
//! [theory: outputs.placement, outputs.path, outputs.centre-of-mass]

use crate::structure::ReducedModel;

use super::axis::Axis;
use super::output_slot::{OutputSlot, PathQuantity, PlacementComponent};
use super::row::output;
use super::table::NORTH_EAST_DOWN;
use super::unit::Unit;
use super::variable::Variable;

/// Those of the whole aircraft.
pub(super) fn of_aircraft() -> Vec<Variable> {
    let mut rows = Vec::new();
    for (part, name) in QUATERNION.into_iter().enumerate() {
        let text = format!(
            "{name} part of the quaternion that turns body into north-east-down components, continuous"
        );
        let name = format!("attitude.quaternion[{}]", part + 1);
        rows.push(output(name, Unit::One, OutputSlot::Quaternion(part), text));
    }
    for (axis, component) in Axis::ALL.into_iter().zip(["x", "y", "z"]) {
        rows.push(output(
            format!("angular_acceleration.{component}"),
            Unit::RadianPerSecondSquared,
            OutputSlot::AngularAcceleration(axis),
            format!("Rate of change of the angular velocity along body axis {component}"),
        ));
    }
    for (axis, component) in Axis::ALL.into_iter().zip(["x", "y", "z"]) {
        let text = format!(
            "(Inertial acceleration - gravity)/g at the momentary centre of mass, z counted upwards: component {component}"
        );
        let slot = OutputSlot::LoadFactorAtCentre(axis);
        rows.push(output(format!("load_factor_cg.{component}"), Unit::One, slot, text));
    }
    let text = "Load factor at O across the flow there: 1 in level flight";
    rows.push(output("load_factor.lift".to_owned(), Unit::One, OutputSlot::LiftLoadFactor, text.to_owned()));
    let path = [
        (
            "climb_angle",
            Unit::Radian,
            PathQuantity::ClimbAngle,
            "Angle of the velocity of O above the horizon",
        ),
        (
            "track",
            Unit::Radian,
            PathQuantity::Track,
            "Direction of the velocity of O over the ground, from north to east",
        ),
        ("vertical_speed", Unit::MetrePerSecond, PathQuantity::VerticalSpeed, "Upward velocity of O"),
    ];
    for (name, unit, quantity, text) in path {
        rows.push(output(format!("path.{name}"), unit, OutputSlot::Path(quantity), text.to_owned()));
    }
    rows
}

/// Those of the stations.
pub(super) fn of_stations(model: &ReducedModel) -> Vec<Variable> {
    let mut rows = Vec::new();
    for (station, point) in model.stations.iter().enumerate() {
        let name = &point.name;
        for (axis, direction) in Axis::ALL.into_iter().zip(NORTH_EAST_DOWN) {
            let component = PlacementComponent::Position(axis);
            rows.push(output(
                format!("station.{name}.position.{direction}"),
                Unit::Metre,
                OutputSlot::Placement { station, component },
                format!("Position of the deformed section at {name} towards {direction}"),
            ));
        }
        for (part, which) in QUATERNION.into_iter().enumerate() {
            let component = PlacementComponent::Quaternion(part);
            rows.push(output(
                format!("station.{name}.quaternion[{}]", part + 1),
                Unit::One,
                OutputSlot::Placement { station, component },
                format!(
                    "{which} part of the quaternion that turns components in the axes of the deformed section at {name} \
                     into north-east-down ones"
                ),
            ));
        }
    }
    rows
}

/// The parts of a quaternion.
const QUATERNION: [&str; 4] = ["Scalar", "First", "Second", "Third"];

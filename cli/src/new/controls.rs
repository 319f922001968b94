//! What a pilot has in hand.

use super::design::Control;
use super::kind::Kind;

pub fn of(kind: Kind) -> Vec<Control> {
    let pitch = |description| Control {
        name: "elevator",
        description,
        positive: "nose-down",
        mirror: "same",
        trim: Some("pitch"),
        limit: 25.0,
    };
    let roll = |description| Control {
        name: "aileron",
        description,
        positive: "rolls right",
        mirror: "opposite",
        trim: Some("roll"),
        limit: 20.0,
    };
    let yaw = |description| Control {
        name: "rudder",
        description,
        positive: "nose right",
        mirror: "opposite",
        trim: Some("yaw"),
        limit: 25.0,
    };
    let ailerons = "Aileron deflection";
    match kind {
        Kind::VTail => {
            vec![pitch("Ruddervators together"), roll(ailerons), yaw("Ruddervators against each other")]
        }
        Kind::FlyingWing => vec![pitch("Elevons together"), roll("Elevons against each other")],
        Kind::WingOnWall => vec![Control {
            name: "flap",
            description: "Flap deflection",
            positive: "trailing edge down",
            mirror: "none",
            trim: None,
            limit: 20.0,
        }],
        _ => vec![pitch("Elevator deflection"), roll(ailerons), yaw("Rudder deflection")],
    }
}

//! The aircraft as engineers describe it, expanded to elements, bays, strips and engines [3.1, 4.1].
//!
//! [`Aircraft`] is what the rest of the program sees. Body axes, origin O at node 0, which is clamped in
//! the body frame. Nothing here knows of modes or of flight.

mod model;

pub use model::{
    Aircraft, Attachment, Beam, ControlGains, Engine, Flap, MassBay, ModeBasis, Station, Strip, Support,
};

//! Panels, splines and control surfaces as strips on components.

mod attach;
mod carriers;
mod chordwise;
mod controls;
mod joined;
mod line;
mod links;
mod panel;
mod panels;
mod roles;
mod runs;
mod strip;
mod trapezium;

pub use attach::surfaces;
pub use carriers::carry;
pub use controls::{Control, controls};
pub use joined::join;
pub use line::SurfaceLine;
pub use links::link;
pub use panels::panels;
pub use roles::{Role, middle, moments, roles};
pub use strip::{Flap, Surface};

//! Panels, splines and control surfaces as strips on components.

mod attach;
mod controls;
mod joined;
mod line;
mod panel;
mod roles;
mod strip;

pub use attach::surfaces;
pub use controls::{Control, controls};
pub use joined::join_for_pitch;
pub use line::SurfaceLine;
pub use panel::panels;
pub use roles::{Role, moments, roles};
pub use strip::{Flap, Surface};

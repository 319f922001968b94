//! What a user chooses before the flight.

use crate::dynamics::Fidelity;

/// Which families of modes take part, lowest frequencies first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ModeSelection {
    /// Symmetric and antisymmetric modes together.
    All,
    /// Symmetric modes only.
    Symmetric,
}

/// What the surface and thrust inputs mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum InputReference {
    /// They add to the trim values.
    Trim,
    /// They are the values themselves.
    Absolute,
}

/// The parameters of a flight; the defaults are those of the FMU.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Fidelity level.
    pub fidelity: Fidelity,
    /// Trimmed airspeed, m/s, > 0.
    pub airspeed: f64,
    /// Trimmed altitude, m.
    pub altitude: f64,
    /// Initial yaw angle, rad.
    pub heading: f64,
    /// Factor on all elastic properties, > 0.
    pub stiffness_scale: f64,
    /// Modal damping ratio ζ of every mode, ≥ 0.
    pub structural_damping: f64,
    /// Families of modes.
    pub mode_selection: ModeSelection,
    /// Number of modes, 0…those packaged of the selection. `Rigid` ignores it.
    pub mode_count: usize,
    /// Peters inflow states per strip, 0…8; 0 is steady aerodynamics.
    pub inflow_states: usize,
    /// Relative tolerance of the integrator, > 0.
    pub tolerance: f64,
    /// Meaning of the inputs.
    pub input_reference: InputReference,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            fidelity: Fidelity::Exact,
            airspeed: 127.0,
            altitude: 7620.0,
            heading: 0.0,
            stiffness_scale: 1.0,
            structural_damping: 0.0,
            mode_selection: ModeSelection::All,
            mode_count: 12,
            inflow_states: 5,
            tolerance: 1e-6,
            input_reference: InputReference::Trim,
        }
    }
}

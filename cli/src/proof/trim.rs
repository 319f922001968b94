//! What a packaged aircraft says of its trim.

use std::fmt;

use flexible_aircraft::aircraft::{Control, TrimRole};
use flexible_aircraft_packaging::FmuError;
use flexible_aircraft_packaging::c_abi::{Fmu, Instance};

/// A trim, for people.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Trim {
    pub(super) angles: Vec<TrimAngle>,
    pub(super) along: Along,
}

/// An angle of a trim.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TrimAngle {
    /// For people.
    pub(super) name: String,
    /// rad.
    pub(super) angle: f64,
    /// Whether it is told though it is 0.
    pub(super) is_in_plane: bool,
}

/// Smaller angles, rad, would be told as 0.
const NO_ANGLE: f64 = 5e-6;

/// What balances an aircraft along its path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Along {
    /// N per engine.
    Thrust(f64),
    /// The path of a glider, rad above the horizon.
    ClimbAngle(f64),
}

impl Trim {
    pub(super) fn read(
        fmu: &Fmu,
        aircraft: &mut Instance<'_>,
        controls: &[Control],
    ) -> Result<Self, FmuError> {
        let has = |wanted: &str| fmu.variable_names().any(|name| name == wanted);
        let value = |name: &str| {
            let mut value = [0.0];
            aircraft.get_real(&[fmu.variable(name)?], &mut value).map(|()| value[0])
        };
        let with_role = |role| with_role(controls, role).map(|name| (name, name, role == TrimRole::Pitch));
        let outputs = [
            Some(("pitch", "pitch", true)),
            with_role(TrimRole::Pitch),
            Some(("roll", "bank angle", false)),
            Some(("beta", "sideslip", false)),
            with_role(TrimRole::Roll),
            with_role(TrimRole::Yaw),
        ];
        let angles = outputs.into_iter().flatten().map(|(output, name, is_in_plane)| {
            let angle = value(&format!("trim.{output}"))?;
            Ok(TrimAngle { name: name.to_owned(), angle, is_in_plane })
        });
        let angles = angles.collect::<Result<_, FmuError>>()?;
        let along = if has("trim.climb_angle") {
            Along::ClimbAngle(value("trim.climb_angle")?)
        } else {
            Along::Thrust(value("trim.thrust")?)
        };
        Ok(Trim { angles, along })
    }
}

impl fmt::Display for Trim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let angle = |f: &mut fmt::Formatter<'_>, name: &str, angle: f64| {
            writeln!(f, "  {name:<15} {:8.3}° ({angle:.5} rad)", angle.to_degrees())
        };
        for told in self.angles.iter().filter(|told| told.is_in_plane || told.angle.abs() >= NO_ANGLE) {
            angle(f, &told.name, told.angle)?;
        }
        match self.along {
            Along::Thrust(thrust) => writeln!(f, "  thrust          {thrust:8.0} N per engine"),
            Along::ClimbAngle(climb) => angle(f, "climb angle", climb),
        }
    }
}

/// The control with a role, by its name.
pub(super) fn with_role(controls: &[Control], role: TrimRole) -> Option<&str> {
    controls.iter().find(|control| control.role == Some(role)).map(|control| control.name.as_str())
}

//! Which flight a trim is of: straight, a turn, a pull-up; and how a user asks for it [theory: trim.manoeuvres].

use crate::aircraft::Support;

use super::setting_error::SettingError;

/// The flight that is to be trimmed, beside airspeed, altitude and heading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manoeuvre {
    /// Straight, turning, pulling up.
    pub flight: SteadyFlight,
    /// γ of the path, rad, positive upwards; an aircraft without engines finds its own.
    pub climb_angle: f64,
    /// Index of the engine that gives no thrust.
    pub failed_engine: Option<usize>,
}

/// How the path bends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SteadyFlight {
    /// Not at all, at this sideslip, rad: bank angle and the controls for roll and yaw hold it.
    Straight {
        /// β.
        sideslip: f64,
    },
    /// Not at all, at this bank angle, rad: sideslip and the controls for roll and yaw hold it.
    Banked {
        /// φ.
        bank_angle: f64,
    },
    /// To the right or left, at this bank angle, rad, without a lateral load factor.
    Turn {
        /// φ, positive to the right.
        bank_angle: f64,
    },
    /// The same, at this load factor across the flow; negative for a turn to the left.
    TurnAtLoadFactor {
        /// n.
        load_factor: f64,
    },
    /// Upwards or downwards, at this load factor across the flow, for a moment: gravity turns away as the flight goes on.
    PullUp {
        /// n.
        load_factor: f64,
    },
}

/// The manoeuvres among which a user chooses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ManoeuvreChoice {
    /// A straight path.
    Straight,
    /// A coordinated turn.
    Turn,
    /// A pull-up, or a push-over.
    PullUp,
}

/// What is given of a straight flight that is not symmetric.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lateral {
    /// The sideslip.
    Sideslip,
    /// The bank angle.
    Bank,
}

/// The manoeuvre as a user sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConditionSettings {
    /// Which manoeuvre.
    pub manoeuvre: ManoeuvreChoice,
    /// γ, rad.
    pub climb_angle: f64,
    /// φ, rad, of a turn or of a straight flight whose bank is given, else 0.
    pub bank_angle: f64,
    /// n, 1, across the flow, of a turn or of a pull-up; 0 where it is not given [theory: outputs.load-factor].
    pub load_factor: f64,
    /// β, rad, of a straight flight whose sideslip is given, else 0.
    pub sideslip: f64,
    /// Which of the two is given.
    pub lateral: Lateral,
    /// Number of the engine that gives no thrust, from 1 in the order of the aircraft; 0 where all do.
    pub failed_engine: usize,
}

/// Angles of a condition, rad: within 84.8°.
pub const STEEPEST: f64 = 1.48;

/// Load factors of a condition.
pub const LARGEST_LOAD_FACTOR: f64 = 20.0;

impl Manoeuvre {
    /// Straight and level, all engines on, without sideslip.
    pub const LEVEL: Manoeuvre =
        Manoeuvre { flight: SteadyFlight::Straight { sideslip: 0.0 }, climb_angle: 0.0, failed_engine: None };

    /// For people, of an aircraft with engines or without.
    pub fn name(&self, has_engines: bool) -> &'static str {
        match self.flight {
            SteadyFlight::Turn { .. } | SteadyFlight::TurnAtLoadFactor { .. } => "turn",
            SteadyFlight::PullUp { .. } => "pull-up",
            _ if !has_engines => "glide",
            _ if self.failed_engine.is_some() => "flight with an engine that has failed",
            SteadyFlight::Banked { .. } => "flight with a bank angle",
            SteadyFlight::Straight { sideslip } if sideslip != 0.0 => "flight with sideslip",
            SteadyFlight::Straight { .. } if self.climb_angle > 0.0 => "climb",
            SteadyFlight::Straight { .. } if self.climb_angle < 0.0 => "descent",
            SteadyFlight::Straight { .. } => "level flight",
        }
    }

    /// Whether sideslip may hold it where one of the controls for roll and yaw is not there.
    pub fn is_held_by_one_control(&self) -> bool {
        match self.flight {
            SteadyFlight::Straight { sideslip } => sideslip == 0.0,
            SteadyFlight::Banked { .. } => false,
            SteadyFlight::Turn { .. }
            | SteadyFlight::TurnAtLoadFactor { .. }
            | SteadyFlight::PullUp { .. } => true,
        }
    }

    /// Whether a symmetric aircraft flies it symmetrically.
    pub fn is_symmetric(&self) -> bool {
        let is_straight = match self.flight {
            SteadyFlight::Straight { sideslip } => sideslip == 0.0,
            SteadyFlight::PullUp { .. } => true,
            SteadyFlight::Banked { .. }
            | SteadyFlight::Turn { .. }
            | SteadyFlight::TurnAtLoadFactor { .. } => false,
        };
        is_straight && self.failed_engine.is_none()
    }
}

impl Default for ConditionSettings {
    /// [`Manoeuvre::LEVEL`].
    fn default() -> Self {
        ConditionSettings {
            manoeuvre: ManoeuvreChoice::Straight,
            climb_angle: 0.0,
            bank_angle: 0.0,
            load_factor: 0.0,
            sideslip: 0.0,
            lateral: Lateral::Sideslip,
            failed_engine: 0,
        }
    }
}

impl ConditionSettings {
    /// The flight that is asked for.
    pub fn manoeuvre(&self) -> Manoeuvre {
        let ConditionSettings { climb_angle, bank_angle, load_factor, sideslip, .. } = *self;
        let flight = match (self.manoeuvre, self.lateral) {
            (ManoeuvreChoice::Straight, Lateral::Sideslip) => SteadyFlight::Straight { sideslip },
            (ManoeuvreChoice::Straight, Lateral::Bank) => SteadyFlight::Banked { bank_angle },
            (ManoeuvreChoice::Turn, _) if load_factor == 0.0 => SteadyFlight::Turn { bank_angle },
            (ManoeuvreChoice::Turn, _) => SteadyFlight::TurnAtLoadFactor { load_factor },
            (ManoeuvreChoice::PullUp, _) => SteadyFlight::PullUp { load_factor },
        };
        Manoeuvre { flight, climb_angle, failed_engine: self.failed_engine.checked_sub(1) }
    }

    /// Checks every setting against its range and against the others, for an aircraft on its support with so many engines.
    ///
    /// # Errors
    /// Names the first that is out of range or does not go with another.
    pub fn check(&self, support: Support, engines: usize) -> Result<(), SettingError> {
        if support == Support::Clamped {
            return self.check_clamped();
        }
        let ConditionSettings { climb_angle, bank_angle, load_factor, sideslip, .. } = *self;
        let allowed = format!("-{STEEPEST} to {STEEPEST} (rad)");
        for (name, angle) in
            [("climb_angle", climb_angle), ("bank_angle", bank_angle), ("sideslip", sideslip)]
        {
            unless(angle.abs() <= STEEPEST, name, angle, &allowed)?;
        }
        let inside = load_factor.abs() <= LARGEST_LOAD_FACTOR;
        unless(inside, "load_factor", load_factor, "-20 to 20, 0 for none given")?;
        let glides = "0 (rad): without engines the climb angle is found";
        unless(engines > 0 || climb_angle == 0.0, "climb_angle", climb_angle, glides)?;
        self.check_flight()?;
        self.check_failed(engines)
    }

    fn check_flight(&self) -> Result<(), SettingError> {
        let ConditionSettings { climb_angle, bank_angle, load_factor, .. } = *self;
        self.check_unused()?;
        match self.manoeuvre {
            ManoeuvreChoice::Straight => Ok(()),
            ManoeuvreChoice::Turn if load_factor == 0.0 => {
                let allowed = "an angle other than 0 (rad) in a turn, or 0 with a load factor";
                unless(bank_angle != 0.0, "bank_angle", bank_angle, allowed)
            }
            ManoeuvreChoice::Turn => {
                let allowed = "0 (rad) in a turn whose load factor is given";
                unless(bank_angle == 0.0, "bank_angle", bank_angle, allowed)?;
                let least = libm::cos(climb_angle);
                let allowed = format!("below -{least:.4} (to the left) or above {least:.4} in a turn");
                unless(load_factor.abs() > least, "load_factor", load_factor, &allowed)
            }
            ManoeuvreChoice::PullUp => {
                unless(load_factor != 0.0, "load_factor", load_factor, "a number other than 0 in a pull-up")
            }
        }
    }

    /// That nothing is given which the flight finds by itself.
    fn check_unused(&self) -> Result<(), SettingError> {
        let (bank, sideslip) = (("bank_angle", self.bank_angle), ("sideslip", self.sideslip));
        let (unused, flight): (&[_], _) = match (self.manoeuvre, self.lateral) {
            (ManoeuvreChoice::Straight, Lateral::Sideslip) => {
                (&[bank], "a straight flight with condition.lateral = sideslip")
            }
            (ManoeuvreChoice::Straight, Lateral::Bank) => {
                (&[sideslip], "a straight flight with condition.lateral = bank")
            }
            (ManoeuvreChoice::Turn, _) => (&[sideslip], "a turn"),
            (ManoeuvreChoice::PullUp, _) => (&[bank, sideslip], "a pull-up"),
        };
        let allowed = format!("0 (rad) in {flight}, which finds it");
        unused.iter().try_for_each(|&(name, value)| unless(value == 0.0, name, value, &allowed))
    }

    fn check_failed(&self, engines: usize) -> Result<(), SettingError> {
        let found = self.failed_engine as f64;
        if self.failed_engine == 0 {
            return Ok(());
        }
        unless(self.failed_engine <= engines, "failed_engine", found, &format!("0 (none) to {engines}"))?;
        unless(engines > 1, "failed_engine", found, "0: the aircraft has no other engine")?;
        let is_straight = self.manoeuvre == ManoeuvreChoice::Straight;
        unless(is_straight, "failed_engine", found, "0 in a turn or a pull-up")
    }

    /// That nothing is asked of an aircraft that is clamped.
    fn check_clamped(&self) -> Result<(), SettingError> {
        let ConditionSettings { climb_angle, bank_angle, load_factor, sideslip, .. } = *self;
        let given = [
            ("climb_angle", climb_angle),
            ("bank_angle", bank_angle),
            ("load_factor", load_factor),
            ("sideslip", sideslip),
            ("manoeuvre", self.manoeuvre as i32 as f64),
            ("lateral", self.lateral as i32 as f64),
            ("failed_engine", self.failed_engine as f64),
        ];
        let allowed = "its start: a clamped aircraft stands as its mount does";
        given.into_iter().try_for_each(|(name, value)| unless(value == 0.0, name, value, allowed))
    }
}

fn unless(inside: bool, name: &str, found: f64, allowed: &str) -> Result<(), SettingError> {
    let error = || SettingError {
        setting: format!("condition.{name}"),
        found: found.to_string(),
        allowed: allowed.to_owned(),
    };
    if inside { Ok(()) } else { Err(error()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(settings: ConditionSettings) -> String {
        settings.check(Support::Free, 2).unwrap_err().to_string()
    }

    #[test]
    fn what_does_not_go_together_is_refused_by_name() {
        let level = ConditionSettings::default();
        assert!(level.manoeuvre() == Manoeuvre::LEVEL && level.check(Support::Free, 0).is_ok());
        let turn = ConditionSettings { manoeuvre: ManoeuvreChoice::Turn, ..level };
        assert!(refused(turn).starts_with("condition.bank_angle: found 0, allowed is an angle other than 0"));
        let both = ConditionSettings { bank_angle: 0.3, load_factor: 1.2, ..turn };
        assert!(refused(both).starts_with("condition.bank_angle: found 0.3, allowed is 0"));
        let weightless = refused(ConditionSettings { load_factor: -0.5, ..turn });
        assert!(weightless.contains("below -1.0000 (to the left) or above 1.0000"), "{weightless}");
        let pull_up = ConditionSettings { manoeuvre: ManoeuvreChoice::PullUp, ..level };
        assert!(refused(pull_up).starts_with("condition.load_factor: found 0"));
        for (failed_engine, engines, said) in [(3, 2, "0 (none) to 2"), (1, 1, "no other engine")] {
            let failed = ConditionSettings { failed_engine, ..level };
            let error = failed.check(Support::Free, engines).unwrap_err().to_string();
            assert!(error.contains(said), "{error}");
        }
        let turning = ConditionSettings { failed_engine: 1, bank_angle: 0.2, ..turn };
        assert!(refused(turning).contains("0 in a turn or a pull-up"));
        for steep in [2.0, f64::NAN] {
            assert!(
                refused(ConditionSettings { climb_angle: steep, ..level }).contains("-1.48 to 1.48 (rad)")
            );
        }
        let climb = ConditionSettings { climb_angle: 0.1, ..level };
        let glider = climb.check(Support::Free, 0).unwrap_err().to_string();
        assert!(glider.contains("the climb angle is found"), "{glider}");
        let clamped = climb.check(Support::Clamped, 2).unwrap_err().to_string();
        assert!(
            clamped.starts_with("condition.climb_angle: found 0.1") && clamped.contains("mount"),
            "{clamped}"
        );
        assert!(level.check(Support::Clamped, 2).is_ok());
    }
}

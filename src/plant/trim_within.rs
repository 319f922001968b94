//! Trims within limits of controls and thrust: one that needs more is none, and says what is left [theory: trim.limits].

use std::fmt;

use crate::aircraft::TrimRole;
use crate::kinematics::GeneralisedVector;

use super::limits::LimitedQuantity;
use super::system::Plant;
use super::trim::{Trim, TrimCondition};
use super::trim_error::TrimError;
use super::trim_problem::TrimUnknown;
use super::trim_search::{Search, SearchEnd};

/// What controls and engines can give at most, infinite where there is no limit.
#[derive(Clone, Debug, PartialEq)]
pub struct TrimLimits {
    /// Least and largest angle of each control, rad.
    pub controls: Vec<[f64; 2]>,
    /// Least and largest thrust of each engine, N.
    pub thrust: [f64; 2],
}

/// Why there is no trim within limits.
#[derive(Clone, Debug, PartialEq)]
pub enum LimitedTrimError {
    /// There is none without limits either.
    NotFound(Box<TrimError>),
    /// It needs more than there is.
    Beyond(Shortfall),
}

/// What a trim would need beyond the limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Shortfall {
    /// In the order in which they went to their limits.
    pub held: Vec<Held>,
    /// Whether a flight was found in which only what they would balance is left.
    pub found: bool,
}

/// What is held at its limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// Which control, or thrust.
    pub quantity: LimitedQuantity,
    /// What the trim would need, rad or N per engine that runs.
    pub needed: f64,
    /// What it can be at most or at least.
    pub limit: f64,
    /// The acceleration that it would balance, rad/s²; of thrust along the path, m/s².
    pub left: f64,
}

impl Plant {
    /// As [`trim`](Self::trim), where controls and engines can give that.
    ///
    /// # Errors
    /// When there is no trim, or what it would need is beyond the limits.
    pub fn trim_within(
        &self,
        condition: &TrimCondition,
        limits: &TrimLimits,
    ) -> Result<Trim, LimitedTrimError> {
        let trim = self.trim(condition).map_err(LimitedTrimError::NotFound)?;
        let steady = self.with_steady_inflow();
        let mut search = Search::resume(&steady, *condition, &trim.unknowns);
        let mut held: Vec<(TrimUnknown, Held)> = Vec::new();
        loop {
            let beyond = search.beyond(limits);
            if beyond.is_empty() {
                break;
            }
            let mut problem = search.problem.clone();
            for (unknown, _, value) in &beyond {
                problem = problem.holding(*unknown, *value);
            }
            held.extend(beyond.into_iter().map(|(unknown, held, _)| (unknown, held)));
            let mut next = Search::new(&steady, *condition, problem);
            next.begin_at(&search);
            let has_ended = matches!(next.iterate(), SearchEnd::Steps(_));
            next.evaluate();
            search = next;
            if !has_ended || !search.is_valid() {
                let held = held.into_iter().map(|(_, held)| held).collect();
                return Err(LimitedTrimError::Beyond(Shortfall { held, found: false }));
            }
        }
        if held.is_empty() {
            return Ok(trim);
        }
        let held = held.into_iter().map(|(unknown, held)| Held { left: search.left_by(unknown), ..held });
        Err(LimitedTrimError::Beyond(Shortfall { held: held.collect(), found: true }))
    }
}

impl Search<'_> {
    /// What the present unknowns need beyond limits, and where they are to be held.
    fn beyond(&self, limits: &TrimLimits) -> Vec<(TrimUnknown, Held, f64)> {
        let mut point = self.point();
        let mut beyond = Vec::new();
        for &unknown in &self.problem.unknowns {
            let (quantity, [least, most]) = match unknown {
                TrimUnknown::Control(role) => {
                    let controls = self.plant.controls().iter().zip(&limits.controls);
                    let mut of_role = controls.filter(|(control, _)| control.role == Some(role));
                    let Some((control, limits)) = of_role.next() else { continue };
                    (LimitedQuantity::Control(control.name.clone()), *limits)
                }
                TrimUnknown::Thrust => {
                    let thrust = self.thrust_beyond(point.thrust, limits.thrust);
                    beyond.extend(thrust.map(|(held, value)| (unknown, held, value)));
                    continue;
                }
                _ => continue,
            };
            let needed = *unknown.of(&mut point);
            let limit = needed.clamp(least.min(most), most);
            if limit != needed {
                beyond.push((unknown, Held { quantity, needed, limit, left: 0.0 }, limit));
            }
        }
        beyond
    }

    /// What of a thrust per unit of share is beyond the limits of an engine, of several the one that is furthest beyond, and the thrust per
    /// unit of share at which that is held.
    fn thrust_beyond(&self, thrust: f64, [least, most]: [f64; 2]) -> Option<(Held, f64)> {
        let shares: Vec<f64> = self.running().map(|(_, share)| share).collect();
        let all_the_same = shares.iter().all(|share| *share == shares[0]);
        let quantity = if all_the_same { LimitedQuantity::Thrust } else { LimitedQuantity::ThrustOfOne };
        let beyond = shares.into_iter().filter(|share| *share > 0.0).map(|share| {
            let needed = share * thrust;
            (needed, needed.clamp(least.min(most), most), share)
        });
        let too_much = |(needed, limit, share): &(f64, f64, f64)| (needed - limit).abs() / share;
        let (needed, limit, share) = beyond
            .filter(|(needed, limit, _)| limit != needed)
            .max_by(|one, other| too_much(one).total_cmp(&too_much(other)))?;
        Some((Held { quantity, needed, limit, left: 0.0 }, limit / share))
    }

    /// The acceleration that an unknown would balance, at the last evaluation.
    fn left_by(&self, held: TrimUnknown) -> f64 {
        let accelerations = GeneralisedVector::of(self.workspace.accelerations());
        match held {
            TrimUnknown::Control(TrimRole::Pitch) => accelerations.rotation.y,
            TrimUnknown::Control(TrimRole::Roll) => accelerations.rotation.x,
            TrimUnknown::Control(TrimRole::Yaw) => accelerations.rotation.z,
            _ => {
                let velocity = self.plant.equations.motion(&self.state).velocity;
                accelerations.translation.dot(&velocity) / velocity.norm()
            }
        }
    }
}

impl std::error::Error for LimitedTrimError {}

impl fmt::Display for LimitedTrimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Shortfall { held, found } = match self {
            LimitedTrimError::NotFound(error) => return error.fmt(f),
            LimitedTrimError::Beyond(shortfall) => shortfall,
        };
        let needs: Vec<String> = held.iter().map(Held::needs).collect();
        write!(f, "{}", needs.join(", "))?;
        if !found {
            return write!(
                f,
                "; held there, no flight is found in which only what they would balance is left"
            );
        }
        let left: Vec<String> = held.iter().map(Held::leaves).collect();
        let verb = if held.len() == 1 { "remains" } else { "remain" };
        write!(f, "; held there, {} {verb}", left.join(" and "))
    }
}

impl Held {
    fn needs(&self) -> String {
        let Held { quantity, needed, limit, .. } = self;
        match quantity {
            LimitedQuantity::Thrust => {
                format!("each engine would need {needed:.0} N, its limit is {limit:.0} N")
            }
            LimitedQuantity::ThrustOfOne => {
                format!("one engine would need {needed:.0} N, its limit is {limit:.0} N")
            }
            _ => format!("{} would need {needed:.4} rad, its limit is {limit:.4} rad", quantity.name()),
        }
    }

    fn leaves(&self) -> String {
        let Held { quantity, left, .. } = self;
        match quantity {
            LimitedQuantity::Thrust | LimitedQuantity::ThrustOfOne => {
                format!("{left:.5} m/s² along the path")
            }
            _ => format!("{left:.5} rad/s² that {} would balance", quantity.name()),
        }
    }
}

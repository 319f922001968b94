//! Where a trim is beyond what the aircraft is flown within. It stands all the same: this is for warnings.
//!
//! [theory: limits-of-validity.unlimited]

use std::fmt;

use crate::aircraft::{Bound, Limits, Support};
use crate::structure::ReducedModel;

use super::settings::PlantSettings;
use super::system::Plant;
use super::trim::Trim;

/// A quantity of a trim that is beyond its limit.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitExceeded {
    /// Which.
    pub quantity: LimitedQuantity,
    /// What the trim needs, in the quantity's unit.
    pub value: f64,
    /// The end of the range that it is beyond.
    pub limit: Bound,
}

/// What limits are for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum LimitedQuantity {
    /// Of the body x axis at O, rad.
    AngleOfAttack,
    /// Mach number.
    Mach,
    /// Of one engine, all having the same, N.
    Thrust,
    /// Of one engine, others having more or less, N.
    ThrustOfOne,
    /// Of the control with this name, rad.
    Control(String),
}

impl LimitExceeded {
    /// Everything in a trim of a plant that is beyond the limits.
    pub fn find(limits: &Limits, plant: &Plant, trim: &Trim) -> Vec<LimitExceeded> {
        let controls = &trim.controls;
        let air = plant.air_data(&trim.state, controls);
        let met = [
            (LimitedQuantity::AngleOfAttack, limits.angle_of_attack, air.angle_of_attack),
            (LimitedQuantity::Mach, limits.mach, air.mach),
        ];
        let used = plant.controls().iter().zip(&controls.angles);
        let used = used
            .map(|(control, &angle)| (LimitedQuantity::Control(control.name.clone()), control.limits, angle));
        let thrust =
            thrusts(plant, trim).into_iter().map(|(quantity, value)| (quantity, limits.thrust, value));
        // What is clamped needs neither controls nor engines.
        let is_free = plant.support() == Support::Free;
        let used = used.chain(thrust).filter(|_| is_free);
        let exceeded = met.into_iter().chain(used).filter_map(|(quantity, bounds, value)| {
            bounds.exceeded_by(value).map(|limit| LimitExceeded { quantity, value, limit })
        });
        exceeded.collect()
    }

    /// A warning of everything that is beyond the limits in the trim under some settings, if anything is.
    pub fn warning(
        exceeded: &[LimitExceeded],
        model: &ReducedModel,
        settings: &PlantSettings,
    ) -> Option<String> {
        let airspeed = settings.airspeed;
        let condition = match model.tunnel_air {
            Some(air) => format!("{airspeed} m/s in air of {} kg/m³", air.density),
            None => format!("{airspeed} m/s and {}", settings.air_in_words()),
        };
        let list: Vec<String> = exceeded.iter().map(ToString::to_string).collect();
        (!list.is_empty()).then(|| format!("the trim at {condition} stands, but {}", list.join("; ")))
    }
}

/// What engines give in a trim: all the same, or the greatest and the least of those that run [theory: trim.shares].
fn thrusts(plant: &Plant, trim: &Trim) -> Vec<(LimitedQuantity, f64)> {
    let thrust = trim.point.thrust;
    let shares = plant.equations.trim_shares();
    match shares.first() {
        None => Vec::new(),
        Some(first) if shares.iter().all(|share| share == first) => {
            vec![(LimitedQuantity::Thrust, first * thrust)]
        }
        Some(_) => {
            let acting = trim.controls.thrust.iter().copied().filter(|acting| *acting != 0.0);
            let [least, greatest] = acting
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, greatest], acting| {
                    [least.min(acting), greatest.max(acting)]
                });
            let ends = [least, greatest].into_iter().filter(|thrust| thrust.is_finite());
            ends.map(|thrust| (LimitedQuantity::ThrustOfOne, thrust)).collect()
        }
    }
}

impl LimitedQuantity {
    /// For people.
    pub fn name(&self) -> &str {
        match self {
            LimitedQuantity::AngleOfAttack => "angle of attack",
            LimitedQuantity::Mach => "Mach number",
            LimitedQuantity::Thrust => "thrust per engine",
            LimitedQuantity::ThrustOfOne => "thrust of one engine",
            LimitedQuantity::Control(name) => name,
        }
    }

    /// A value with its unit.
    pub fn text(&self, value: f64) -> String {
        match self {
            LimitedQuantity::Mach => format!("{value:.3}"),
            LimitedQuantity::Thrust | LimitedQuantity::ThrustOfOne => format!("{value:.0} N"),
            // As many digits as a small angle needs.
            _ if value.abs() < 1e-3 && value != 0.0 => {
                format!("{value:.2e} rad ({:.2e}°)", value.to_degrees())
            }
            _ => format!("{value:.4} rad ({:.1}°)", value.to_degrees()),
        }
    }
}

impl fmt::Display for LimitExceeded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let LimitExceeded { quantity, value, limit } = self;
        let bound = limit.value().unwrap_or(f64::NAN);
        let side = if *value > bound { "above" } else { "below" };
        let source = match limit {
            Bound::Given(_) => "the aircraft file's limit",
            Bound::Usual(_) | Bound::None => "the usual limit, for the aircraft file gives none",
        };
        let [value, bound] = [*value, bound].map(|value| quantity.text(value));
        write!(f, "{} {value} is {side} {bound}, {source}", quantity.name())
    }
}

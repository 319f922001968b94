//! Trims over airspeed that are beyond what an aircraft is flown within [theory: limits-of-validity.unlimited].

use flexible_aircraft::aircraft::Bound;
use flexible_aircraft::plant::{LimitExceeded, LimitedQuantity};

use crate::numbers::short;

/// A warning for each quantity whose trims are beyond a limit, of airspeeds in ascending order, m/s: the farthest trim, and from
/// where to where they are.
pub fn warnings(exceeded: &[(f64, LimitExceeded)]) -> Vec<String> {
    let mut kinds: Vec<(&LimitedQuantity, &Bound)> = Vec::new();
    for (_, LimitExceeded { quantity, limit, .. }) in exceeded {
        if !kinds.contains(&(quantity, limit)) {
            kinds.push((quantity, limit));
        }
    }
    let warning = |(quantity, limit): (&LimitedQuantity, &Bound)| {
        let is_of_kind =
            |(_, other): &&(f64, LimitExceeded)| (&other.quantity, &other.limit) == (quantity, limit);
        let alike: Vec<_> = exceeded.iter().filter(is_of_kind).collect();
        let (airspeed, farthest) = alike.iter().max_by(|a, b| a.1.value.abs().total_cmp(&b.1.value.abs()))?;
        let more = match alike[..] {
            [(first, _), .., (last, _)] => {
                format!(" (so at {} airspeeds, {} to {} m/s)", alike.len(), short(*first), short(*last))
            }
            _ => String::new(),
        };
        Some(format!("the trim at {} m/s stands, but {farthest}{more}", short(*airspeed)))
    };
    kinds.into_iter().filter_map(warning).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_farthest_trim_of_each_quantity_is_told_with_the_airspeeds_of_all() {
        let elevator = |value: f64| LimitExceeded {
            quantity: LimitedQuantity::Control("elevator".to_owned()),
            value,
            limit: Bound::Given(-0.25),
        };
        let mach = LimitExceeded { quantity: LimitedQuantity::Mach, value: 0.9, limit: Bound::Given(0.85) };
        let exceeded = [(60.0, elevator(-0.5)), (70.5, elevator(-0.3)), (270.0, mach)];
        let found = warnings(&exceeded);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found[0].starts_with("the trim at 60 m/s stands, but elevator -0.5000 rad"), "{found:?}");
        assert!(found[0].ends_with(" (so at 2 airspeeds, 60 to 70.5 m/s)"), "{found:?}");
        assert!(
            found[1].starts_with("the trim at 270 m/s stands, but Mach number 0.900 is above"),
            "{found:?}"
        );
        assert!(!found[1].contains("so at") && warnings(&[]).is_empty(), "{found:?}");
    }
}

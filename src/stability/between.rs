//! The linearised motion between two neighbouring airspeeds of a range [theory: stability.between].

use std::sync::Arc;

use super::condensed::Condensed;
use super::points::Motions;

/// Equal parts of the interval at whose ends the motion is computed.
const PARTS: usize = 16;

/// The motion over an interval of airspeeds: computed where parts of it meet and when it is first asked for, linear in the airspeed within
/// the parts. A trim and its linearisation cost as much as many roots.
pub(super) struct Between {
    /// m/s.
    airspeeds: [f64; 2],
    /// At the lower end, where the parts meet, and at the upper end; none where it has not been asked for.
    meets: [Option<Motion>; PARTS + 1],
}

/// None where there is no trim.
type Motion = Option<Arc<Condensed>>;

impl Between {
    /// Of an interval, m/s, with the motions at its ends that are at hand.
    pub fn new(airspeeds: [f64; 2], ends: [Option<Arc<Condensed>>; 2]) -> Self {
        let mut meets = [const { None }; PARTS + 1];
        let [low, high] = ends.map(|end| end.map(Some));
        (meets[0], meets[PARTS]) = (low, high);
        Between { airspeeds, meets }
    }

    /// The motion at a place from 0, the lower end, to 1; none where there is no trim beside it.
    pub fn at(&mut self, place: f64, aircraft: Motions) -> Motion {
        let parts = place * PARTS as f64;
        let (part, share) = (parts.floor(), parts.fract());
        let low = self.meet(part as usize, aircraft)?;
        if share == 0.0 {
            return Some(low);
        }
        let high = self.meet(part as usize + 1, aircraft)?;
        Some(Arc::new(low.towards(&high, share)))
    }

    fn meet(&mut self, index: usize, aircraft: Motions) -> Motion {
        let [low, high] = self.airspeeds;
        let airspeed = if index == PARTS { high } else { low + index as f64 / PARTS as f64 * (high - low) };
        self.meets[index].get_or_insert_with(|| aircraft.problem(airspeed)).clone()
    }
}

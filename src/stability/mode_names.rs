//! What the modes of an aircraft in flight are called, by what takes part in them.
//!
//! [theory: stability.modes]

use std::fmt;

use crate::plant::Unknown;

/// Of a mode that is rigid motion more than half of what moves takes part there.
const RIGID: f64 = 0.5;

/// A root with less of the roll rate is never the roll.
const SOME_ROLL: f64 = 0.05;

/// What a mode is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FlightModeName {
    /// Which motion.
    pub kind: FlightModeKind,
    /// From 1, where several roots have the same motion, as a pair that has become two real roots.
    pub number: Option<usize>,
}

/// A kind of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum FlightModeKind {
    /// Height alone: in denser air the same flight is faster.
    Altitude,
    /// Speed and pitch angle exchange height and airspeed.
    Phugoid,
    /// Angle of attack and pitch rate.
    ShortPeriod,
    /// Sideslip and yaw rate.
    DutchRoll,
    /// Roll rate.
    Roll,
    /// Roll angle or heading, slowly.
    Spiral,
    /// Roll angle and rate as one pair.
    RollSpiral,
    /// Another motion of the structure than of the whole; from 1, lowest frequency first.
    Elastic(usize),
}

impl FlightModeName {
    pub(super) fn is_elastic(&self) -> bool {
        matches!(self.kind, FlightModeKind::Elastic(_))
    }

    /// That of the elastic mode behind all elastic ones among some.
    pub(super) fn elastic_beyond(known: &[FlightModeName]) -> Self {
        let number = |name: &FlightModeName| match name.kind {
            FlightModeKind::Elastic(number) => number,
            _ => 0,
        };
        let kind = FlightModeKind::Elastic(1 + known.iter().map(number).max().unwrap_or(0));
        FlightModeName { kind, number: None }
    }
}

impl fmt::Display for FlightModeName {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let FlightModeName { kind, number } = *self;
        let name = match kind {
            FlightModeKind::Altitude => "altitude",
            FlightModeKind::Phugoid => "phugoid",
            FlightModeKind::ShortPeriod => "short period",
            FlightModeKind::DutchRoll => "Dutch roll",
            FlightModeKind::Roll => "roll",
            FlightModeKind::Spiral => "spiral",
            FlightModeKind::RollSpiral => "roll-spiral",
            FlightModeKind::Elastic(elastic) => return write!(formatter, "elastic {elastic}"),
        };
        match number {
            Some(number) => write!(formatter, "{name} {number}"),
            None => formatter.write_str(name),
        }
    }
}

/// What the naming asks of a root.
#[derive(Clone, Copy)]
pub(super) struct Portrait {
    /// Whether it is a pair.
    pub oscillates: bool,
    /// Of height; of speed and pitch angle; of heave and pitch rate.
    in_plane: [f64; 3],
    /// Of sideslip and yaw rate; of roll rate; of roll angle.
    aside: [f64; 3],
}

impl Portrait {
    pub fn new(oscillates: bool, unknowns: &[Unknown], participations: &[f64]) -> Self {
        let mut portrait = Portrait { oscillates, in_plane: [0.0; 3], aside: [0.0; 3] };
        for (unknown, share) in unknowns.iter().zip(participations) {
            if let Some(place) = portrait.place(*unknown) {
                *place += share;
            }
        }
        portrait
    }

    /// Where an unknown of the rigid motion is counted.
    fn place(&mut self, unknown: Unknown) -> Option<&mut f64> {
        match unknown {
            Unknown::Down => Some(&mut self.in_plane[0]),
            Unknown::Velocity(0) | Unknown::Pitch => Some(&mut self.in_plane[1]),
            Unknown::Velocity(2) | Unknown::Rate(1) => Some(&mut self.in_plane[2]),
            Unknown::Velocity(_) | Unknown::Rate(2) => Some(&mut self.aside[0]),
            Unknown::Rate(_) => Some(&mut self.aside[1]),
            Unknown::Roll => Some(&mut self.aside[2]),
            Unknown::Horizontal(_)
            | Unknown::Yaw
            | Unknown::Coordinate(_)
            | Unknown::CoordinateRate(_)
            | Unknown::Inflow { .. } => None,
        }
    }

    /// Of rigid motion aside, as a share of all rigid motion; none where there is none.
    pub fn share_aside(&self) -> Option<f64> {
        let [in_plane, aside] = [&self.in_plane, &self.aside].map(|parts| parts.iter().sum::<f64>());
        let rigid = in_plane + aside;
        (rigid > 0.0).then(|| aside / rigid)
    }

    fn is_rigid(&self) -> bool {
        self.in_plane.iter().chain(&self.aside).sum::<f64>() > RIGID
    }

    /// The kind of a mode that is rigid; that of an elastic one is none yet.
    pub fn kind(&self) -> Option<FlightModeKind> {
        if !self.is_rigid() {
            return None;
        }
        let ([height, speed, heave], [sideslip, roll_rate, roll]) = (self.in_plane, self.aside);
        let is_aside = self.share_aside().is_some_and(|share| share > 0.5);
        Some(match (is_aside, self.oscillates) {
            (false, false) if height > speed.max(heave) => FlightModeKind::Altitude,
            (false, _) if speed > heave => FlightModeKind::Phugoid,
            (false, _) => FlightModeKind::ShortPeriod,
            (true, true) if sideslip > roll_rate + roll => FlightModeKind::DutchRoll,
            (true, true) => FlightModeKind::RollSpiral,
            (true, false) if roll_rate > roll.max(sideslip) => FlightModeKind::Roll,
            (true, false) => FlightModeKind::Spiral,
        })
    }
}

/// The kinds of all roots; none yet of elastic ones.
pub(super) fn kinds(portraits: &[Portrait]) -> Vec<Option<FlightModeKind>> {
    let mut kinds: Vec<Option<FlightModeKind>> = portraits.iter().map(Portrait::kind).collect();
    only_pair_is_dutch_roll(portraits, &mut kinds);
    softest_roll(portraits, &mut kinds);
    kinds
}

/// Names of modes of some kinds, which are given slowest first.
pub(super) fn names(kinds: impl Iterator<Item = Option<FlightModeKind>>) -> Vec<FlightModeName> {
    let mut elastic = 0;
    let mut or_elastic = |kind: Option<FlightModeKind>| {
        kind.unwrap_or_else(|| {
            elastic += 1;
            FlightModeKind::Elastic(elastic)
        })
    };
    let kinds: Vec<FlightModeKind> = kinds.map(&mut or_elastic).collect();
    numbered(&kinds)
}

/// The only pair aside is the Dutch roll, whatever leads it; of two it is the one with the more sideslip.
pub(super) fn only_pair_is_dutch_roll(portraits: &[Portrait], kinds: &mut [Option<FlightModeKind>]) {
    let pair = |kind: &Option<FlightModeKind>| {
        matches!(kind, Some(FlightModeKind::DutchRoll | FlightModeKind::RollSpiral))
    };
    let pairs: Vec<usize> =
        (0..kinds.len()).filter(|&root| portraits[root].oscillates && pair(&kinds[root])).collect();
    let sideslip = |root: &&usize| portraits[**root].aside[0];
    let most = pairs.iter().max_by(|a, b| sideslip(a).total_cmp(&sideslip(b))).copied();
    for &root in &pairs {
        let is_dutch_roll = Some(root) == most;
        kinds[root] =
            Some(if is_dutch_roll { FlightModeKind::DutchRoll } else { FlightModeKind::RollSpiral });
    }
}

/// Where no mode is rigid enough to be the roll, as where wings twist as much as they roll, it is the real root aside with the most roll rate.
fn softest_roll(portraits: &[Portrait], kinds: &mut [Option<FlightModeKind>]) {
    if kinds.iter().any(|kind| matches!(kind, Some(FlightModeKind::Roll | FlightModeKind::RollSpiral))) {
        return;
    }
    let roll_rate = |root: usize| portraits[root].aside[1];
    let may_be = |root: &usize| {
        let Portrait { oscillates, .. } = portraits[*root];
        let is_aside = portraits[*root].share_aside().is_some_and(|share| share > 0.5);
        kinds[*root].is_none() && !oscillates && is_aside && roll_rate(*root) > SOME_ROLL
    };
    let roll = (0..kinds.len()).filter(may_be).max_by(|&a, &b| roll_rate(a).total_cmp(&roll_rate(b)));
    if let Some(roll) = roll {
        kinds[roll] = Some(FlightModeKind::Roll);
    }
}

/// With numbers where a kind is there more than once.
fn numbered(kinds: &[FlightModeKind]) -> Vec<FlightModeName> {
    let number = |place: usize| {
        let same = |range: &[FlightModeKind]| range.iter().filter(|kind| **kind == kinds[place]).count();
        (same(kinds) > 1).then(|| same(&kinds[..=place]))
    };
    (0..kinds.len()).map(|place| FlightModeName { kind: kinds[place], number: number(place) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNKNOWNS: [Unknown; 10] = [
        Unknown::Down,
        Unknown::Roll,
        Unknown::Pitch,
        Unknown::Velocity(0),
        Unknown::Velocity(1),
        Unknown::Velocity(2),
        Unknown::Rate(0),
        Unknown::Rate(1),
        Unknown::Rate(2),
        Unknown::Coordinate(0),
    ];

    fn portrait(oscillates: bool, shares: &[(Unknown, f64)]) -> Portrait {
        let share =
            |unknown: &Unknown| shares.iter().find(|(other, _)| other == unknown).map_or(0.0, |s| s.1);
        Portrait::new(oscillates, &UNKNOWNS, &UNKNOWNS.each_ref().map(share))
    }

    fn told(portraits: &[Portrait]) -> Vec<String> {
        names(kinds(portraits).into_iter()).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_mode_is_named_by_what_leads_it() {
        let portraits = [
            portrait(false, &[(Unknown::Down, 0.9)]),
            portrait(true, &[(Unknown::Velocity(0), 0.5), (Unknown::Pitch, 0.4)]),
            portrait(false, &[(Unknown::Roll, 0.8), (Unknown::Rate(2), 0.2)]),
            portrait(
                true,
                &[(Unknown::Velocity(2), 0.4), (Unknown::Rate(1), 0.4), (Unknown::Coordinate(0), 0.2)],
            ),
            portrait(true, &[(Unknown::Velocity(1), 0.3), (Unknown::Roll, 0.4), (Unknown::Rate(2), 0.2)]),
            portrait(false, &[(Unknown::Rate(0), 0.9)]),
            portrait(true, &[(Unknown::Coordinate(0), 0.9), (Unknown::Velocity(2), 0.1)]),
        ];
        let expected = ["altitude", "phugoid", "spiral", "short period", "Dutch roll", "roll", "elastic 1"];
        assert_eq!(told(&portraits), expected);
    }

    #[test]
    fn the_roll_of_a_soft_wing_is_the_real_root_aside_with_the_most_roll_rate() {
        let soft = |oscillates, rate| {
            portrait(oscillates, &[(Unknown::Rate(0), rate), (Unknown::Coordinate(0), 1.0 - rate)])
        };
        let portraits = [soft(false, 0.2), soft(false, 0.3), soft(true, 0.4), soft(false, 0.01)];
        assert_eq!(told(&portraits), ["elastic 1", "roll", "elastic 2", "elastic 3"]);
        let rigid = [soft(false, 0.3), portrait(false, &[(Unknown::Rate(0), 0.9)])];
        assert_eq!(told(&rigid), ["elastic 1", "roll"]);
    }

    #[test]
    fn pairs_that_have_parted_or_joined_are_told_apart() {
        let portraits = [
            portrait(false, &[(Unknown::Velocity(0), 0.9)]),
            portrait(false, &[(Unknown::Pitch, 0.9)]),
            portrait(true, &[(Unknown::Roll, 0.5), (Unknown::Rate(0), 0.5)]),
            portrait(true, &[(Unknown::Velocity(1), 0.5), (Unknown::Rate(2), 0.5)]),
        ];
        assert_eq!(told(&portraits), ["phugoid 1", "phugoid 2", "roll-spiral", "Dutch roll"]);
    }
}

//! RBE3 by the grids that several others carry.

use std::collections::BTreeMap;

use super::super::cards::{Cards, Spread};
use super::super::lumps::Lump;

/// What divides a mass on a grid among several others: the first that does.
pub fn spreads_by_grid(cards: &Cards) -> BTreeMap<i64, &Spread> {
    let several = cards.spreads.iter().filter(|spread| spread.carriers.len() > 1);
    several.rev().map(|spread| (spread.grid, spread)).collect()
}

/// Whether masses would be divided into more parts than a stick has.
pub fn too_many_parts<'c>(cards: &'c Cards, lumps: &[Lump], most: usize) -> Option<&'c Spread> {
    let spreads = spreads_by_grid(cards);
    let mut parts = 0;
    lumps.iter().filter_map(|lump| spreads.get(&lump.grid).copied()).find(|spread| {
        parts += spread.carriers.len();
        parts > most
    })
}

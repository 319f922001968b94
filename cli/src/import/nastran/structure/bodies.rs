//! Grids that move as one body: what RBE2, RBAR and rigid springs join; and what of them is held.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cards::{Bush, Cards, Ids};
use super::super::frames::World;
use super::super::mistakes::{Mistakes, Needed, Origin, Remarks};
use super::super::units::Units;

/// Sets that are unions of unions, so deep.
const DEEPEST: usize = 16;

/// A root that gives way.
#[derive(Clone, Debug)]
pub struct Hinge {
    pub origin: Origin,
    /// The grid that it holds, and its body.
    pub grid: i64,
    pub body: usize,
    /// Axes of its springs, as columns.
    pub axes: nalgebra::Matrix3<f64>,
    /// About these axes, N m/rad.
    pub stiffness: [f64; 3],
}

/// Rigid bodies, by the grids that they have.
#[derive(Debug, Default)]
pub struct Bodies {
    /// Body of each grid.
    of_grid: BTreeMap<i64, usize>,
    /// Grids that are held in all six components, by their bodies; with the card.
    pub clamped: Vec<(usize, i64, Origin)>,
    /// The first root that gives way.
    pub hinge: Option<Hinge>,
}

/// Which grids belong together, each led to another one, the first of a body to itself.
#[derive(Default)]
struct Union(BTreeMap<i64, i64>);

impl Union {
    fn head(&mut self, grid: i64) -> i64 {
        let mut head = grid;
        while let Some(&next) = self.0.get(&head).filter(|next| **next != head) {
            head = next;
        }
        // The way is short the next time.
        let mut at = grid;
        while at != head {
            at = self.0.insert(at, head).unwrap_or(head);
        }
        head
    }

    fn join(&mut self, one: i64, other: i64) {
        let [one, other] = [self.head(one), self.head(other)];
        self.0.insert(one.max(other), one.min(other));
        self.0.entry(one.min(other)).or_insert(one.min(other));
    }
}

impl Bodies {
    /// The body of a grid.
    pub fn of(&self, grid: i64) -> Option<usize> {
        self.of_grid.get(&grid).copied()
    }

    /// Bodies are counted from 0 without gaps.
    pub fn count(&self) -> usize {
        self.of_grid.values().max().map_or(0, |last| last + 1)
    }

    /// Joins what links join. `used` are the grids that elements and masses are on.
    pub fn new(
        (cards, world, units): (&Cards, &World, &Units),
        used: &BTreeSet<i64>,
        sets: Option<&[i64]>,
        (mistakes, remarks): (&mut Mistakes, &mut Remarks),
    ) -> Bodies {
        let mut union = Union::default();
        join_links(cards, &mut union, mistakes);
        let held = held(cards, sets, (mistakes, remarks));
        let grounded = |grid: Option<i64>| {
            grid.is_none_or(|grid| {
                is_full(held.get(&grid).map(|(digits, _)| digits)) && !used.contains(&grid)
            })
        };
        let mut roots: Vec<(&Bush, i64)> = Vec::new();
        for bush in &cards.bushes {
            for grid in bush.grids.iter().flatten().filter(|grid| !cards.grids.contains_key(grid)) {
                mistakes.missing(&bush.origin, "GA, GB", *grid, Needed::Grid);
            }
            match bush.grids {
                [Some(grid), ground] | [ground, Some(grid)] if grounded(ground) => roots.push((bush, grid)),
                [Some(one), Some(other)] => {
                    union.join(one, other);
                    remarks.card(
                        &bush.origin,
                        "springs that are not at a clamped root are not held: both grids are one rigid body",
                    );
                }
                _ => {}
            }
        }
        let mut bodies = Bodies::numbered(cards, &mut union);
        bodies.find_clamped((cards, used), &held, remarks);
        for (bush, grid) in roots {
            bodies.add_hinge((bush, grid), (cards, world, units), (mistakes, remarks));
        }
        bodies
    }

    fn numbered(cards: &Cards, union: &mut Union) -> Bodies {
        let mut numbers = BTreeMap::new();
        let mut of_grid = BTreeMap::new();
        for &grid in cards.grids.keys() {
            let next = numbers.len();
            of_grid.insert(grid, *numbers.entry(union.head(grid)).or_insert(next));
        }
        Bodies { of_grid, ..Bodies::default() }
    }

    fn find_clamped(
        &mut self,
        (cards, used): (&Cards, &BTreeSet<i64>),
        held: &BTreeMap<i64, (String, Origin)>,
        remarks: &mut Remarks,
    ) {
        let of_structure: BTreeSet<usize> = used.iter().filter_map(|grid| self.of(*grid)).collect();
        for (&grid, (digits, origin)) in held {
            let Some(body) = self.of(grid).filter(|body| of_structure.contains(body)) else { continue };
            if is_full(Some(digits)) {
                self.clamped.push((body, grid, origin.clone()));
            } else if cards.grids.contains_key(&grid) {
                let said = format!(
                    "components {digits} of GRID {grid} are held, the others not: they are free here"
                );
                remarks.card(origin, said);
            }
        }
    }

    fn add_hinge(
        &mut self,
        (bush, grid): (&Bush, i64),
        (cards, world, units): (&Cards, &World, &Units),
        (mistakes, remarks): (&mut Mistakes, &mut Remarks),
    ) {
        let Some(body) = self.of(grid) else { return };
        let Some(property) = cards.bush_properties.get(&bush.property) else {
            mistakes.missing(&bush.origin, "PID", bush.property, Needed::Card("a PBUSH"));
            return;
        };
        let Some(axes) = world.axes_at(bush.frame.unwrap_or(0), grid) else {
            mistakes.missing(&bush.origin, "CID", bush.frame.unwrap_or(0), Needed::Frame);
            return;
        };
        let [k1, k2, k3, about @ ..] = property.stiffness;
        let lacking = ["K4", "K5", "K6"].into_iter().zip(about).filter(|(_, about)| *about <= 0.0);
        let lacking: Vec<&str> = lacking.map(|(name, _)| name).collect();
        if !lacking.is_empty() {
            let said =
                format!("found no {}: held as if rigid about it, else nothing holds it", lacking.join(", "));
            remarks.card(&bush.origin, said);
        }
        if [k1, k2, k3].iter().any(|along| along.is_finite()) {
            let said =
                "the springs K1, K2, K3 along its axes are held as if rigid, those about them as they are";
            remarks.card(&bush.origin, said);
        }
        if self.hinge.is_some() {
            remarks.card(
                &bush.origin,
                "a second spring at a root is not held: the first one holds the aircraft",
            );
            return;
        }
        let stiffness = about.map(|about| about * units.moment());
        self.hinge = Some(Hinge { origin: bush.origin.clone(), grid, body, axes, stiffness });
    }
}

fn is_full(digits: Option<&String>) -> bool {
    digits.is_some_and(|digits| "123456".chars().all(|digit| digits.contains(digit)))
}

fn join_links(cards: &Cards, union: &mut Union, mistakes: &mut Mistakes) {
    for rigid in &cards.rigids {
        cards.missing_grids((&rigid.origin, "GN"), &Ids::of(rigid.grid), mistakes);
        cards.missing_grids((&rigid.origin, "GM"), &rigid.others, mistakes);
        for other in cards.grids_in(&rigid.others) {
            union.join(rigid.grid, other);
        }
    }
    for spread in &cards.spreads {
        let grids = std::iter::once(spread.grid).chain(spread.carriers.iter().map(|(grid, _)| *grid));
        for missing in grids.filter(|grid| !cards.grids.contains_key(grid)) {
            mistakes.missing(&spread.origin, "REFGRID, G", missing, Needed::Grid);
        }
        if let [(carrier, _)] = spread.carriers[..] {
            union.join(carrier, spread.grid);
        }
    }
}

/// Components that are held of each grid, and the card that holds the last of them.
fn held(
    cards: &Cards,
    asked: Option<&[i64]>,
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> BTreeMap<i64, (String, Origin)> {
    let sets = asked.map(|asked| all_sets(cards, asked));
    if let Some(several) = asked.map(BTreeSet::from_iter).filter(|asked: &BTreeSet<&i64>| asked.len() > 1) {
        let several = several.iter().map(ToString::to_string).collect::<Vec<_>>().join(" and ");
        remarks.note(format!("SPC = {several} of several subcases hold together here"));
    }
    let mut held: BTreeMap<i64, (String, Origin)> = BTreeMap::new();
    let mut hold = |grid: i64, digits: &str, origin: &Origin| {
        if !digits.is_empty() {
            let entry = held.entry(grid).or_insert_with(|| (String::new(), origin.clone()));
            let more: String = digits.chars().filter(|digit| !entry.0.contains(*digit)).collect();
            entry.0 += &more;
        }
    };
    for constraint in &cards.constraints {
        cards.missing_grids((&constraint.origin, "G"), &constraint.grids, mistakes);
        if sets.as_ref().is_none_or(|sets| sets.contains(&constraint.set)) {
            for grid in cards.grids_in(&constraint.grids) {
                hold(grid, &constraint.components, &constraint.origin);
            }
        } else {
            let set = constraint.set;
            remarks.note(format!(
                "{}: no SPC = {set} of the case control asks for it: it holds nothing",
                constraint.origin
            ));
        }
    }
    for (&id, grid) in &cards.grids {
        hold(id, &grid.held, &grid.origin);
    }
    held
}

/// Sets with those that they are unions of.
fn all_sets(cards: &Cards, asked: &[i64]) -> BTreeSet<i64> {
    let mut sets: BTreeSet<i64> = asked.iter().copied().collect();
    for _ in 0..DEEPEST {
        let unions = sets.iter().filter_map(|set| cards.constraint_unions.get(set));
        let more: Vec<i64> = unions.flat_map(|union| union.ids.singles()).collect();
        sets.extend(more);
    }
    sets
}

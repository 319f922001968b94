//! One card: its fields asked for by place and name, each with what it may hold.

use std::cell::RefCell;
use std::collections::BTreeSet;

use super::super::deck::{self, Card, Deck};
use super::super::mistakes::{Mistakes, Origin};

/// Whole numbers, some of them from one to another, as lists with THRU have them; each once.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ids {
    /// In their own order.
    singles: Vec<i64>,
    /// Ascending, without overlap.
    runs: Vec<(i64, i64)>,
}

impl Ids {
    /// One alone.
    pub fn of(id: i64) -> Self {
        Ids { singles: vec![id], runs: Vec::new() }
    }

    /// Of numbers and runs as they are listed: what is in a run is not told again.
    fn listed(singles: &[i64], mut listed: Vec<(i64, i64)>) -> Self {
        listed.sort_unstable();
        let mut runs: Vec<(i64, i64)> = Vec::new();
        for (from, to) in listed {
            match runs.last_mut().filter(|(_, last)| from <= *last) {
                Some((_, last)) => *last = to.max(*last),
                None => runs.push((from, to)),
            }
        }
        let is_in_run = |id: i64| {
            let behind = runs.partition_point(|(from, _)| *from <= id);
            behind > 0 && runs[behind - 1].1 >= id
        };
        let mut seen = BTreeSet::new();
        let alone = singles.iter().copied().filter(|id| !is_in_run(*id) && seen.insert(*id)).collect();
        Ids { singles: alone, runs }
    }

    /// The runs of it that lie in a range.
    pub fn within(&self, range: std::ops::Range<i64>) -> impl Iterator<Item = (i64, i64)> + '_ {
        let all = self.singles.iter().map(|id| (*id, *id)).chain(self.runs.iter().copied());
        let clipped = all.map(move |(from, to)| (from.max(range.start), to.min(range.end - 1)));
        clipped.filter(|(from, to)| from <= to)
    }

    /// Those of some numbers that are in it.
    pub fn among<'i>(&'i self, known: impl Fn(i64, i64) -> Vec<i64> + 'i) -> impl Iterator<Item = i64> + 'i {
        let all = self.singles.iter().map(|id| (*id, *id)).chain(self.runs.iter().copied());
        all.flat_map(move |(from, to)| known(from, to))
    }

    /// How many there are.
    pub fn size(&self) -> usize {
        let in_runs = self
            .runs
            .iter()
            .map(|(from, to)| to.saturating_sub(*from).saturating_add(1).unsigned_abs() as usize);
        self.singles.len() + in_runs.fold(0, usize::saturating_add)
    }

    /// How many of some ascending numbers are in it, or listed by themselves.
    pub fn count(&self, known: &[i64]) -> usize {
        let below = |id: i64| known.partition_point(|other| *other < id);
        let in_runs = self.runs.iter().map(|&(from, to)| below(to.saturating_add(1)) - below(from));
        self.singles.len() + in_runs.sum::<usize>()
    }

    /// What is listed by itself.
    pub fn singles(&self) -> impl Iterator<Item = i64> + '_ {
        self.singles.iter().copied()
    }
}

/// Of a field that is wrong so many letters are shown.
const LONGEST_FOUND: usize = 40;

/// A card that is being read; what is wrong with it is said once for each field.
pub struct Reader<'a> {
    pub deck: &'a Deck,
    pub card: &'a Card,
    mistakes: &'a RefCell<Mistakes>,
}

impl<'a> Reader<'a> {
    pub fn new(deck: &'a Deck, card: &'a Card, mistakes: &'a RefCell<Mistakes>) -> Self {
        Reader { deck, card, mistakes }
    }

    pub fn text(&self, index: usize) -> &'a str {
        self.deck.text(self.card, index)
    }

    pub fn is_blank(&self, index: usize) -> bool {
        self.text(index).is_empty()
    }

    /// Says what is wrong with a field.
    pub fn wrong<T>(
        &self,
        index: usize,
        name: &str,
        found: impl Into<String>,
        allowed: impl Into<String>,
    ) -> Option<T> {
        let texts = (found.into(), allowed.into());
        self.mistakes.borrow_mut().of_card((self.card, self.text(0)), (index, name), texts);
        None
    }

    fn found(&self, index: usize) -> String {
        match self.text(index) {
            "" => "found nothing".to_owned(),
            text => format!("found {}", text.chars().take(LONGEST_FOUND).collect::<String>()),
        }
    }

    pub fn integer(&self, index: usize, name: &str) -> Option<i64> {
        deck::integer(self.text(index))
            .or_else(|| self.wrong(index, name, self.found(index), "a whole number is allowed"))
    }

    pub fn integer_or(&self, index: usize, name: &str, otherwise: i64) -> Option<i64> {
        if self.is_blank(index) { Some(otherwise) } else { self.integer(index, name) }
    }

    pub fn real(&self, index: usize, name: &str) -> Option<f64> {
        deck::real(self.text(index)).or_else(|| {
            self.wrong(index, name, self.found(index), "a number is allowed, as 1.5, 1.5E3 or 1.5+3")
        })
    }

    pub fn real_or(&self, index: usize, name: &str, otherwise: f64) -> Option<f64> {
        if self.is_blank(index) { Some(otherwise) } else { self.real(index, name) }
    }

    /// A number, none where nothing stands.
    pub fn optional(&self, index: usize, name: &str) -> Option<Option<f64>> {
        if self.is_blank(index) { Some(None) } else { self.real(index, name).map(Some) }
    }

    pub fn positive(&self, index: usize, name: &str) -> Option<f64> {
        let number = self.real(index, name)?;
        if number > 0.0 {
            return Some(number);
        }
        self.wrong(index, name, self.found(index), "a number above 0 is allowed")
    }

    pub fn not_negative(&self, index: usize, name: &str, otherwise: f64) -> Option<f64> {
        let number = self.real_or(index, name, otherwise)?;
        if number >= 0.0 {
            return Some(number);
        }
        self.wrong(index, name, self.found(index), "a number from 0 on is allowed")
    }

    pub fn vector(&self, index: usize, names: [&str; 3]) -> Option<[f64; 3]> {
        let [x, y, z] = [0, 1, 2].map(|axis| self.real_or(index + axis, names[axis], 0.0));
        Some([x?, y?, z?])
    }

    /// A whole number above 0 that is the card's own.
    pub fn id(&self) -> Option<i64> {
        let id = self.integer(0, "ID")?;
        if id > 0 {
            Some(id)
        } else {
            self.wrong(0, "ID", self.found(0), "a whole number above 0 is allowed")
        }
    }

    /// Whole numbers from a field to the end, with THRU between two of them.
    pub fn ids(&self, first: usize, name: &str) -> Option<Ids> {
        let (mut singles, mut runs) = (Vec::new(), Vec::new());
        let mut index = first;
        while index < self.card.len() {
            if self.is_blank(index) {
                index += 1;
                continue;
            }
            // What RBE2 ends with, a coefficient of thermal expansion, is no id.
            if index > first && self.text(index).contains('.') {
                break;
            }
            let from = self.integer(index, name)?;
            if self.text(index + 1).eq_ignore_ascii_case("THRU") {
                let to = self.integer(index + 2, name)?;
                if to < from {
                    return self.wrong(
                        index + 2,
                        name,
                        self.found(index + 2),
                        format!("{from} or more is allowed"),
                    );
                }
                runs.push((from, to));
                index += 3;
            } else {
                singles.push(from);
                index += 1;
            }
        }
        Some(Ids::listed(&singles, runs))
    }

    pub fn origin(&self, card: &'static str, id: i64) -> Origin {
        Origin { card, id, place: self.card.place }
    }
}

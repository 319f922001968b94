//! One card: its fields asked for by place and name, each with what it may hold.

use std::cell::RefCell;

use super::super::deck::{self, Card, Deck};
use super::super::mistakes::{Mistakes, Origin};

/// Whole numbers from some to others, as lists with THRU have them; each once, however often it is listed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ids {
    /// Ascending and apart.
    runs: Vec<(i64, i64)>,
    /// What is listed by itself, ascending.
    singles: Vec<i64>,
}

impl Ids {
    /// One alone.
    pub fn of(id: i64) -> Self {
        Ids::new(Vec::new(), vec![id])
    }

    fn new(mut runs: Vec<(i64, i64)>, mut singles: Vec<i64>) -> Self {
        singles.sort_unstable();
        singles.dedup();
        runs.extend(singles.iter().map(|&id| (id, id)));
        runs.sort_unstable();
        runs.dedup_by(|next, before| {
            let is_joined = next.0 <= before.1.saturating_add(1);
            if is_joined {
                before.1 = before.1.max(next.1);
            }
            is_joined
        });
        Ids { runs, singles }
    }

    /// All of them, as runs.
    pub fn runs(&self) -> impl Iterator<Item = (i64, i64)> + '_ {
        self.runs.iter().copied()
    }

    /// The runs of it that lie in a range.
    pub fn within(&self, range: std::ops::Range<i64>) -> impl Iterator<Item = (i64, i64)> + '_ {
        let first = self.runs.partition_point(|(_, to)| *to < range.start);
        let inside = self.runs[first..].iter().take_while(move |(from, _)| *from < range.end);
        inside.map(move |(from, to)| ((*from).max(range.start), (*to).min(range.end - 1)))
    }

    /// What is listed by itself.
    pub fn singles(&self) -> impl Iterator<Item = i64> + '_ {
        self.singles.iter().copied()
    }
}

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
        self.mistakes.borrow_mut().of_card((self.card, &deck::cut_short(self.text(0))), (index, name), texts);
        None
    }

    fn found(&self, index: usize) -> String {
        match self.text(index) {
            "" => "found nothing".to_owned(),
            text => format!("found {}", deck::cut_short(text)),
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
        let (mut runs, mut singles) = (Vec::new(), Vec::new());
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
        Some(Ids::new(runs, singles))
    }

    pub fn origin(&self, card: &'static str, id: i64) -> Origin {
        Origin { card, id, place: self.card.place }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_have_each_number_once_in_runs_that_are_apart() {
        let ids = Ids::new(vec![(10, 20), (1, 4), (15, 30), (1, 4)], vec![5, 40, 40, 12]);
        assert_eq!(ids.runs().collect::<Vec<_>>(), [(1, 5), (10, 30), (40, 40)]);
        assert_eq!(ids.singles().collect::<Vec<_>>(), [5, 12, 40]);
        assert_eq!(ids.within(3..13).collect::<Vec<_>>(), [(3, 5), (10, 12)]);
        assert_eq!(ids.within(31..40).count() + ids.within(41..99).count(), 0);
        let all = Ids::new(vec![(i64::MIN, i64::MAX)], vec![i64::MAX]);
        assert_eq!(all.within(7..9).collect::<Vec<_>>(), [(7, 8)]);
    }
}

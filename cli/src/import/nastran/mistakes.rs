//! What is wrong with a deck, file by file; and what is not held of it, line by line.

use std::collections::BTreeSet;
use std::ops::Range;

use super::deck::{Card, Deck, Place, cut_short, field_number};
use crate::marked::{Mistake, Rejected, RejectedFiles};

/// A deck that is told about at most so many times: one slip in a table may be found on each of its lines.
const MOST_TOLD: usize = 50;

/// Where a mistake is.
#[derive(Debug)]
enum Whereabouts {
    /// Bytes of a file.
    Bytes(usize, Range<usize>),
    /// All of a line.
    Line(Place),
}

/// What cards name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needed {
    Grid,
    Frame,
    /// By the names of its cards.
    Card(&'static str),
}

impl Needed {
    pub fn text(self) -> String {
        match self {
            Needed::Grid => "a GRID of the deck is needed".to_owned(),
            Needed::Frame => "a CORD1R, CORD2R or CORD2C of the deck is needed".to_owned(),
            Needed::Card(name) => format!("{name} of the deck is needed"),
        }
    }
}

/// A mistake: where, what field, what was found, what is allowed.
type Told = (Whereabouts, String, String, String);

/// Mistakes with the files that they are in.
#[derive(Debug, Default)]
pub struct Mistakes {
    told: Vec<Told>,
    whole: Vec<String>,
    /// Beyond those that are told.
    more: usize,
}

impl Mistakes {
    pub fn add(&mut self, file: usize, span: Range<usize>, field: String, found: String, allowed: String) {
        self.tell((Whereabouts::Bytes(file, span), field, found, allowed));
    }

    fn tell(&mut self, told: Told) {
        if self.told.len() < MOST_TOLD {
            self.told.push(told);
        } else {
            self.more += 1;
        }
    }

    /// One that is in no line.
    pub fn of_whole(&mut self, text: String) {
        self.whole.push(text);
    }

    /// In a field of a card, counted from 0 behind its name.
    pub fn of_card(
        &mut self,
        (card, id): (&Card, &str),
        (index, name): (usize, &str),
        (found, allowed): (String, String),
    ) {
        let (_, span) = card.field_place(index);
        let card_name = cut_short(&card.name);
        let field = format!("{card_name} {id}, field {} ({name})", field_number(index)).replace(" ,", ",");
        self.add(card.place.file, span, field, found, allowed);
    }

    /// In a card of which only its line is known.
    pub fn of_origin(
        &mut self,
        origin: &Origin,
        name: &str,
        found: impl Into<String>,
        allowed: impl Into<String>,
    ) {
        let field = format!("{origin} ({name})");
        self.tell((Whereabouts::Line(origin.place), field, found.into(), allowed.into()));
    }

    /// Of a card that names what the deck has not.
    pub fn missing(&mut self, origin: &Origin, name: &str, id: i64, needed: Needed) {
        self.of_origin(origin, name, format!("found {id}"), needed.text());
    }

    /// Goes on where there is no mistake, with none.
    ///
    /// # Errors
    /// When there is any.
    pub fn checked(&mut self, deck: &Deck) -> Result<(), RejectedFiles> {
        std::mem::take(self).conclude(deck)
    }

    pub fn is_empty(&self) -> bool {
        self.told.is_empty() && self.whole.is_empty()
    }

    /// As they are shown, each file with its own.
    ///
    /// # Errors
    /// When there is any.
    pub fn conclude(self, deck: &Deck) -> Result<(), RejectedFiles> {
        if self.is_empty() {
            return Ok(());
        }
        let mut files: Vec<(usize, Rejected)> = Vec::new();
        for (whereabouts, field, found, allowed) in self.told {
            let (file, span) = match whereabouts {
                Whereabouts::Bytes(file, span) => (file, span),
                Whereabouts::Line(place) => (place.file, deck.bytes_of(place)),
            };
            let place = files.iter().position(|(other, _)| *other == file).unwrap_or_else(|| {
                let named = deck.files.get(file);
                let (file_name, text) =
                    named.map_or_else(Default::default, |f| (f.name.clone(), f.text.clone()));
                files.push((file, Rejected { file_name, text, mistakes: Vec::new() }));
                files.len() - 1
            });
            files[place].1.mistakes.push(Mistake { span, field, found, allowed });
        }
        let mut files: Vec<Rejected> = files.into_iter().map(|(_, rejected)| rejected).collect();
        files.iter_mut().for_each(|rejected| rejected.mistakes.sort_by_key(|mistake| mistake.span.start));
        Err(RejectedFiles { files, whole: self.whole, more: self.more, beside: Vec::new() })
    }
}

/// What of the deck does not come into the aircraft as it is: a card, where, and what became of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Remark {
    pub place: Place,
    /// `PBAR 101, field 2 (K1)`.
    pub what: String,
    pub said: String,
    /// What is said instead of many cards of one kind that differ in numbers alone.
    pub of_many: Option<&'static str>,
}

/// What the importer has to say, in the order of the deck.
#[derive(Debug, Default)]
pub struct Remarks {
    /// Not held, or held differently.
    pub reports: Vec<Remark>,
    /// How something was understood that is held.
    pub notes: Vec<String>,
    /// Not held, and in no line.
    pub general: Vec<String>,
    /// The same notes, each there once.
    noted: BTreeSet<String>,
    /// What was told once of which card.
    told: BTreeSet<(&'static str, i64, String)>,
}

impl Remarks {
    /// Of a field of a card.
    pub fn field(&mut self, (card, id): (&Card, i64), (index, name): (usize, &str), said: impl Into<String>) {
        self.of_field(&Field::of((card, id), (index, name), String::new()), said);
    }

    /// Of a field that was kept.
    pub fn of_field(&mut self, field: &Field, said: impl Into<String>) {
        self.report((field.place, field.what.clone()), said);
    }

    /// Of a whole card.
    pub fn card(&mut self, source: &Origin, said: impl Into<String>) {
        self.report((source.place, source.to_string()), said);
    }

    /// Of what there may be many cards, with numbers of their own.
    pub fn card_of_many(&mut self, source: &Origin, said: String, of_many: &'static str) {
        let of_many = Some(of_many);
        self.reports.push(Remark { place: source.place, what: source.to_string(), said, of_many });
    }

    /// Of anything, by where it is and what it is called.
    pub fn report(&mut self, (place, what): (Place, String), said: impl Into<String>) {
        self.reports.push(Remark { place, what, said: said.into(), of_many: None });
    }

    /// Of a whole card, if it was not told of this yet.
    pub fn card_once(&mut self, source: &Origin, about: impl Into<String>, said: impl Into<String>) {
        if self.told.insert((source.card, source.id, about.into())) {
            self.card(source, said);
        }
    }

    pub fn note(&mut self, said: impl Into<String>) {
        let said = said.into();
        if self.noted.insert(said.clone()) {
            self.notes.push(said);
        }
    }
}

/// A field that something comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    place: Place,
    what: String,
    /// What stands there.
    pub found: String,
}

impl Field {
    pub fn of((card, id): (&Card, i64), (index, name): (usize, &str), found: String) -> Field {
        let (place, _) = card.field_place(index);
        Field { place, what: format!("{} {id}, field {} ({name})", card.name, field_number(index)), found }
    }
}

/// The card that something comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    pub card: &'static str,
    pub id: i64,
    pub place: Place,
}

impl std::fmt::Display for Origin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.card, self.id)
    }
}

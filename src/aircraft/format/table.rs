//! What the description of a format is made of: tables, their fields, what these may hold.

use super::allowed::{ANY, Allowed};

/// What the largest component of a direction has at least.
pub const LEAST_COMPONENT: f64 = 1e-9;

/// A table of an aircraft file, or the file itself.
#[derive(Debug)]
pub struct Table {
    /// Dotted path of the fields that lead to it, `component.surface`; empty for the file. Forms of a law have their first
    /// field's name.
    pub path: &'static str,
    /// What it describes, for people.
    pub sentence: &'static str,
    /// In the order in which messages list them.
    pub fields: &'static [&'static Field],
    /// What holds between fields.
    pub rules: &'static [Rule],
    /// Fields of former days, which are refused with what stands in their place.
    pub former: &'static [&'static Field],
}

/// A field of a table.
#[derive(Debug)]
pub struct Field {
    /// As files write it.
    pub name: &'static str,
    /// What it may hold.
    pub kind: Kind,
    /// Of its numbers; empty where they have none.
    pub unit: &'static str,
    /// What holds where it is left out.
    pub absent: Absent,
    /// What it is, for people, in Markdown on one line.
    pub sentence: &'static str,
}

/// What a field may hold.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Kind {
    /// A number.
    Number(&'static Allowed),
    /// A whole number from the first to the second.
    Whole(usize, usize),
    /// A whole number from the first to the second, or a list of at least one.
    WholeOrMore(usize, usize),
    /// `true` or `false`.
    Flag,
    /// A text on one line.
    Text,
    /// A text that becomes part of a sentence: not empty; a full stop at its end is left out.
    Phrase,
    /// Letters, digits and underscores, not a digit first.
    Name,
    /// One of some words.
    OneOf(&'static [Word]),
    /// One of some words, or a list of at least one of others, each once.
    WordOrWords(&'static [Word], &'static [Word]),
    /// A number or a list of at least one.
    NumberOrMore(&'static Allowed),
    /// A list of at least one number.
    Numbers(&'static Allowed),
    /// Three numbers.
    Vector(&'static Allowed),
    /// Three numbers, of which at least one is not 0: [`LEAST_COMPONENT`] or more.
    Direction,
    /// Roll, pitch and yaw; the second for the pitch.
    Attitude(&'static Allowed, &'static Allowed),
    /// At least two points of three numbers.
    Corners(&'static Allowed),
    /// Six rows of six numbers.
    Matrix(&'static Allowed),
    /// A number, or a table of one of some forms.
    Law(&'static Allowed, &'static [&'static Table]),
    /// Three laws, one for each axis.
    Laws(&'static Allowed, &'static [&'static Table]),
    /// In a form of a law: a number that the law's quantity may be.
    LawNumber,
    /// In a form of a law: a list of at least one such number.
    LawNumbers,
    /// A table.
    Table(&'static Table),
    /// A list of at least so many tables.
    Tables(&'static Table, usize),
    /// A word or a table.
    WordOrTable(&'static Word, &'static Table),
}

/// A word that a field may hold.
#[derive(Clone, Copy, Debug)]
pub struct Word {
    /// As files write it.
    pub word: &'static str,
    /// What it means, for people.
    pub sentence: &'static str,
}

/// What holds where a field is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Absent {
    /// It may not be left out.
    Needed,
    /// Nothing: what it describes is not there.
    Nothing,
    /// This number; everywhere, where it is a law.
    Number(f64),
    /// This whole number.
    Whole(usize),
    /// This flag.
    Flag(bool),
    /// This word.
    Word(&'static str),
    /// Three times 0.
    Zeros,
    /// What is found elsewhere, for people.
    Found(&'static str),
}

/// What holds between fields of a table.
#[derive(Debug)]
#[non_exhaustive]
pub enum Rule {
    /// Exactly one of these is there.
    ExactlyOne(&'static [&'static Field]),
    /// One of these at most is there.
    AtMostOne(&'static [&'static Field]),
    /// Where the first is there, the second must be; a list of tables is there if it has any.
    Needs(&'static Field, &'static Field),
    /// The first is allowed where the second is this word.
    OnlyWhere(&'static Field, &'static Field, &'static str),
    /// Where the second field is this word, the numbers of the first are narrower.
    Narrower(&'static Field, &'static Allowed, &'static Field, &'static str),
}

impl Table {
    /// The fields of which exactly one is needed, if a field is one of them: "`at_m` or `at`".
    pub fn alternatives(&self, field: &Field) -> Option<String> {
        self.rules.iter().find_map(|rule| match rule {
            Rule::ExactlyOne(fields) if fields.iter().any(|other| other.name == field.name) => {
                let names = fields.iter().map(|field| format!("`{}`", field.name));
                Some(names.collect::<Vec<_>>().join(" or "))
            }
            _ => None,
        })
    }
}

impl Field {
    /// What it may hold, for people: `law, 1e-6 to 1e15 N`.
    pub fn allowed_in_words(&self) -> String {
        let range = self.range_in_words();
        let with = |kind: &str| match &range {
            Some(range) => format!("{kind}, {range}"),
            None => kind.to_owned(),
        };
        match self.kind {
            Kind::Number(_) | Kind::Whole(..) | Kind::LawNumber => range.unwrap_or("a number".to_owned()),
            Kind::WholeOrMore(..) => with("whole number or list"),
            Kind::Flag => "`true` or `false`".to_owned(),
            Kind::Text | Kind::Phrase => "a text".to_owned(),
            Kind::Name => "a name".to_owned(),
            Kind::OneOf(words) => words.iter().map(Word::in_quotes).collect::<Vec<_>>().join(", "),
            Kind::WordOrWords(words, others) => {
                let quoted =
                    |words: &[Word]| words.iter().map(Word::in_quotes).collect::<Vec<_>>().join(", ");
                format!("{}, or list of {}", quoted(words), quoted(others))
            }
            Kind::NumberOrMore(_) => with("number or list"),
            Kind::Numbers(_) | Kind::LawNumbers => with("list of numbers"),
            Kind::Vector(_) | Kind::Attitude(..) => with("three numbers"),
            Kind::Direction => "three numbers, not all 0".to_owned(),
            Kind::Corners(_) => with("list of points"),
            Kind::Matrix(_) => with("six rows of six numbers"),
            Kind::Law(..) => with("law"),
            Kind::Laws(..) => with("three laws"),
            Kind::Table(_) => "a table".to_owned(),
            Kind::Tables(..) => "tables".to_owned(),
            Kind::WordOrTable(word, _) => format!("{} or a table", word.in_quotes()),
        }
    }

    /// Its numbers, with their unit: `0 to 1000 m/s²`. `None` where it holds none, or any.
    fn range_in_words(&self) -> Option<String> {
        let numbers = match self.kind {
            Kind::Whole(least, most) if least == most => least.to_string(),
            Kind::Whole(least, most) | Kind::WholeOrMore(least, most) => format!("{least} to {most}"),
            Kind::Attitude(turn, pitch) => {
                format!("{}, the second {}", turn.range.in_words()?, pitch.range.in_words()?)
            }
            kind => kind.allowed().range.in_words()?,
        };
        Some(if self.unit.is_empty() { numbers } else { format!("{numbers} {}", self.unit) })
    }
}

impl Word {
    /// In Markdown, as files write it.
    pub fn in_quotes(&self) -> String {
        format!("`\"{}\"`", self.word)
    }
}

impl Absent {
    /// For people: `needed`, `9.80665`.
    pub fn in_words(&self) -> String {
        match self {
            Absent::Needed => "needed".to_owned(),
            Absent::Nothing => "none".to_owned(),
            Absent::Number(number) => number.to_string(),
            Absent::Whole(number) => number.to_string(),
            Absent::Flag(flag) => format!("`{flag}`"),
            Absent::Word(word) => format!("`\"{word}\"`"),
            Absent::Zeros => "`[0, 0, 0]`".to_owned(),
            Absent::Found(what) => (*what).to_owned(),
        }
    }
}

impl Kind {
    /// What its numbers may be: any, where nothing is said.
    pub fn allowed(&self) -> &'static Allowed {
        match self {
            Kind::Number(allowed)
            | Kind::NumberOrMore(allowed)
            | Kind::Numbers(allowed)
            | Kind::Vector(allowed)
            | Kind::Attitude(allowed, _)
            | Kind::Corners(allowed)
            | Kind::Matrix(allowed)
            | Kind::Law(allowed, _)
            | Kind::Laws(allowed, _) => allowed,
            _ => &ANY,
        }
    }

    /// The table that it holds, each time if there are several.
    pub fn table(&self) -> Option<&'static Table> {
        match self {
            Kind::Table(table) | Kind::Tables(table, _) | Kind::WordOrTable(_, table) => Some(table),
            _ => None,
        }
    }

    /// The forms besides a number, where it is a law.
    pub fn forms(&self) -> &'static [&'static Table] {
        match self {
            Kind::Law(_, forms) | Kind::Laws(_, forms) => forms,
            _ => &[],
        }
    }

    /// The words that it may hold.
    pub fn words(&self) -> &'static [Word] {
        match self {
            Kind::OneOf(words) | Kind::WordOrWords(words, _) => words,
            Kind::WordOrTable(word, _) => std::slice::from_ref(word),
            _ => &[],
        }
    }
}

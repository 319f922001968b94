//! Cards with types: numbers and names as the deck has them, in its units and frames. What no reader takes is reported.

mod aero;
mod beams;
mod bounds;
mod geometry;
mod links;
mod masses;
mod other;
mod properties;
mod reader;

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

pub use aero::{AeroCards, Division, LinkCard, List, PanelCard, Spline, SplineBoxes, SurfaceCard};
pub use beams::{Element, ElementKind, Offset, Orientation, Pin};
pub use bounds::boxes;
pub use geometry::{FrameBy, FrameCard, FrameShape, Grid};
pub use links::{Bush, BushProperty, Constraint, Rigid, Spread};
pub use masses::{LumpCard, LumpContent};
pub use properties::{Material, Property};
pub use reader::Ids;
use reader::Reader;

use super::deck::{self, Deck, Place};
use super::mistakes::{Mistakes, Needed, Origin, Remarks};

/// All that the deck says of the aircraft.
#[derive(Debug, Default)]
pub struct Cards {
    pub grids: BTreeMap<i64, Grid>,
    pub frames: BTreeMap<i64, FrameCard>,
    pub elements: Vec<Element>,
    pub properties: BTreeMap<i64, Property>,
    pub materials: BTreeMap<i64, Material>,
    pub lumps: Vec<LumpCard>,
    pub rigids: Vec<Rigid>,
    pub spreads: Vec<Spread>,
    pub constraints: Vec<Constraint>,
    /// Sets that are unions of others.
    pub constraint_unions: BTreeMap<i64, List>,
    /// The grid that a free aircraft is supported at while it is analysed.
    pub reference_grid: Option<i64>,
    pub bushes: Vec<Bush>,
    pub bush_properties: BTreeMap<i64, BushProperty>,
    pub aero: AeroCards,
    /// What masses are multiplied by.
    pub mass_factor: Option<f64>,
    /// Lines of cards that say what is computed, by their names.
    pub of_analyses: BTreeMap<String, Vec<Place>>,
}

/// What has been read, and what was said of it.
struct Reading<'a> {
    cards: Cards,
    remarks: &'a mut Remarks,
    defaults: Defaults,
    /// Numbers of cards that are in no map, each with its kind.
    numbers: BTreeSet<(&'static str, i64)>,
}

/// What cards say of fields that others leave blank.
#[derive(Default)]
struct Defaults {
    grid: geometry::GridDefaults,
    bar: beams::BeamDefaults,
    beam: beams::BeamDefaults,
}

impl Defaults {
    fn read(deck: &Deck, shared: &RefCell<Mistakes>) -> Self {
        let mut defaults = Defaults::default();
        for card in &deck.cards {
            let reader = Reader::new(deck, card, shared);
            match card.name.as_str() {
                "GRDSET" => defaults.grid = geometry::defaults(&reader).unwrap_or_default(),
                "BAROR" => defaults.bar = beams::defaults(&reader).unwrap_or_default(),
                "BEAMOR" => defaults.beam = beams::defaults(&reader).unwrap_or_default(),
                _ => {}
            }
        }
        defaults
    }
}

impl Cards {
    /// Reads all cards of a deck.
    pub fn read(deck: &Deck, mistakes: &mut Mistakes, remarks: &mut Remarks) -> Cards {
        let shared = RefCell::new(std::mem::take(mistakes));
        let defaults = Defaults::read(deck, &shared);
        let mut reading = Reading { cards: Cards::default(), remarks, defaults, numbers: BTreeSet::new() };
        for card in &deck.cards {
            let reader = Reader::new(deck, card, &shared);
            // What is wrong with a card has been said where it was found.
            let _ = reading
                .structure(&reader)
                .or_else(|| reading.air(&reader))
                .or_else(|| reading.other(&reader));
        }
        let cards = reading.cards;
        *mistakes = shared.into_inner();
        bounds::check(&cards, mistakes);
        cards
    }

    /// The grids of a list that are there.
    pub fn grids_in<'c>(&'c self, ids: &'c Ids) -> impl Iterator<Item = i64> + 'c {
        ids.runs().flat_map(|(from, to)| self.grids.range(from..=to).map(|(id, _)| *id))
    }

    /// Says of grids that a list names by themselves that they are not there: a list of THRU may have gaps.
    pub fn missing_grids(&self, (origin, name): (&Origin, &str), ids: &Ids, mistakes: &mut Mistakes) {
        for grid in ids.singles().filter(|grid| !self.grids.contains_key(grid)) {
            mistakes.missing(origin, name, grid, Needed::Grid);
        }
    }
}

impl Reading<'_> {
    /// Takes a card of the structure, if it is one.
    fn structure(&mut self, card: &Reader) -> Option<()> {
        self.number(card);
        let (cards, remarks) = (&mut self.cards, &mut *self.remarks);
        match card.card.name.as_str() {
            "GRDSET" | "BAROR" | "BEAMOR" => {}
            "GRID" => {
                let grid = geometry::grid(card, &self.defaults.grid);
                self.keep(card, grid.map(|grid| (grid.origin.id, grid)), |cards| &mut cards.grids);
            }
            "CORD1R" => {
                let mut found = Vec::new();
                let _ = geometry::by_grids(card, &mut found);
                found.into_iter().for_each(|frame| self.keep(card, Some(frame), |cards| &mut cards.frames));
            }
            "CORD2R" => {
                let frame = geometry::by_points(card, ("CORD2R", FrameShape::Rectangular));
                self.keep(card, frame, |cards| &mut cards.frames);
            }
            "CORD2C" => {
                let frame = geometry::by_points(card, ("CORD2C", FrameShape::Cylindrical));
                self.keep(card, frame, |cards| &mut cards.frames);
            }
            "CBAR" => {
                let kind = ("CBAR", ElementKind::Bar);
                cards.elements.extend(beams::bar_or_beam(card, kind, &self.defaults.bar, remarks));
            }
            "CBEAM" => {
                let kind = ("CBEAM", ElementKind::Beam);
                cards.elements.extend(beams::bar_or_beam(card, kind, &self.defaults.beam, remarks));
            }
            "CROD" => cards.elements.extend(beams::rod(card)),
            "CONM1" => cards.lumps.extend(masses::conm1(card)),
            "CONM2" => cards.lumps.extend(masses::conm2(card)),
            "RBE2" => cards.rigids.extend(links::rbe2(card, remarks)),
            "RBAR" => cards.rigids.extend(links::rbar(card, remarks)),
            "RBE3" => cards.spreads.extend(links::rbe3(card, remarks)),
            "SPC1" => cards.constraints.extend(links::spc1(card)),
            "SPC" => drop(links::spc(card, &mut cards.constraints)),
            "SPCADD" => {
                let union = aero::list(card, ("SPCADD", "S"));
                self.keep(card, union, |cards| &mut cards.constraint_unions);
            }
            "SUPORT" => self.supported(card, 0),
            "SUPORT1" => self.supported(card, 1),
            "CBUSH" => cards.bushes.extend(links::cbush(card)),
            "PBUSH" => {
                let property = links::pbush(card);
                self.keep(card, property, |cards| &mut cards.bush_properties);
            }
            "MAT1" => {
                let material = properties::mat1(card, remarks);
                self.keep(card, material, |cards| &mut cards.materials);
            }
            name => {
                let property = match name {
                    "PBAR" => properties::pbar(card, remarks),
                    "PBARL" => properties::pbarl(card, remarks),
                    "PBEAM" => properties::pbeam(card, remarks),
                    "PBEAML" => properties::pbeaml(card, remarks),
                    "PROD" => properties::prod(card),
                    _ => return None,
                };
                self.keep(card, property.map(|property| (property.origin.id, property)), |cards| {
                    &mut cards.properties
                });
            }
        }
        Some(())
    }

    /// Takes a card of the air, if it is one.
    fn air(&mut self, card: &Reader) -> Option<()> {
        let (aero, remarks) = (&mut self.cards.aero, &mut *self.remarks);
        match card.card.name.as_str() {
            "AERO" => drop(aero::aero(card, &mut aero.reference, remarks)),
            "AEROS" => drop(aero::aeros(card, &mut aero.reference, remarks)),
            "CAERO1" => aero.panels.extend(aero::panel(card)),
            "PAERO1" => aero::bodies(card, remarks),
            "AEFACT" => {
                let list = aero::fractions(card);
                self.keep(card, list, |cards| &mut cards.aero.fractions);
            }
            "SPLINE1" => aero.splines.extend(aero::spline(card, "SPLINE1")),
            "SPLINE2" => aero.splines.extend(aero::spline(card, "SPLINE2")),
            "SPLINE4" => aero.splines.extend(aero::spline(card, "SPLINE4")),
            "SPLINE5" => aero.splines.extend(aero::spline(card, "SPLINE5")),
            "SET1" => {
                let set = aero::list(card, ("SET1", "G"));
                self.keep(card, set, |cards| &mut cards.aero.sets);
            }
            "AESURF" => aero.surfaces.extend(aero::surface(card, remarks)),
            "AELINK" => aero.links.extend(aero::link(card)),
            "AELIST" => {
                let list = aero::list(card, ("AELIST", "E"));
                self.keep(card, list, |cards| &mut cards.aero.boxes);
            }
            _ => return None,
        }
        Some(())
    }

    /// Takes a parameter; says of all other cards that they are not held.
    fn other(&mut self, card: &Reader) -> Option<()> {
        let name = card.card.name.as_str();
        if name == "PARAM" {
            return self.parameter(card);
        }
        if other::is_of_analyses(name) {
            self.cards.of_analyses.entry(name.to_owned()).or_default().push(card.card.place);
            return Some(());
        }
        let what = format!("{} {}", deck::cut_short(&card.card.name), deck::cut_short(card.text(0)));
        let said = "this card is not read: what it says is not in the aircraft";
        self.remarks.report((card.card.place, what.trim_end().to_owned()), said);
        Some(())
    }

    fn parameter(&mut self, card: &Reader) -> Option<()> {
        let name = card.text(0).to_uppercase();
        if name == "WTMASS" {
            let factor = card.positive(1, "V1")?;
            if let Some(other) = self.cards.mass_factor.replace(factor).filter(|other| *other != factor) {
                self.remarks.note(format!("PARAM WTMASS = {other}: it does not count, {factor} does, which stands in the case control or farther below"));
            }
            return Some(());
        }
        if matches!(name.as_str(), "G" | "W3" | "W4") && card.real_or(1, "V1", 0.0)? != 0.0 {
            let said = "damping of the structure is not in the deck's beams here; the parameter structural_damping is one ratio for all modes";
            self.remarks.note(format!("PARAM {name} = {}: {said}", deck::cut_short(card.text(1))));
            return Some(());
        }
        if name == "COUPMASS" {
            self.remarks.note("PARAM COUPMASS: masses of elements are at two places in each, which have its mass, centre and inertia");
            return Some(());
        }
        self.cards.of_analyses.entry("PARAM".to_owned()).or_default().push(card.card.place);
        Some(())
    }

    /// Puts something under its number, which nothing else of its kind has.
    fn keep<T>(
        &mut self,
        card: &Reader,
        found: Option<(i64, T)>,
        map: fn(&mut Cards) -> &mut BTreeMap<i64, T>,
    ) {
        let Some((id, value)) = found else { return };
        if map(&mut self.cards).insert(id, value).is_some() {
            self.second(card, id);
        }
    }

    /// The first grid that a card names is supported; others are told of.
    fn supported(&mut self, card: &Reader, first: usize) {
        // Each grid with its components.
        let fields =
            (first..card.card.len()).step_by(2).filter(|&index| index == first || !card.is_blank(index));
        for (number, index) in fields.enumerate() {
            let Some(grid) = card.integer(index, &format!("ID{}", number + 1)) else { return };
            match self.cards.reference_grid {
                Some(first) if first != grid => self.remarks.note(format!(
                    "{}: GRID {grid} is supported too; of all, GRID {first} is O",
                    card.card.name
                )),
                _ => self.cards.reference_grid = Some(grid),
            }
        }
    }

    /// Elements have numbers of their own, and so have masses, links, panels, splines; of some cards there is one.
    fn number(&mut self, card: &Reader) {
        let kind = match card.card.name.as_str() {
            "CBAR" | "CBEAM" | "CROD" | "CBUSH" => "element",
            "CONM1" | "CONM2" => "mass",
            "RBE2" | "RBAR" | "RBE3" => "link",
            "CAERO1" => "panel",
            "SPLINE1" | "SPLINE2" | "SPLINE4" | "SPLINE5" => "spline",
            "AESURF" => "surface",
            "AERO" => return self.only(card, ("AERO", "ACSID")),
            "AEROS" => return self.only(card, ("AEROS", "ACSID")),
            "GRDSET" => return self.only(card, ("GRDSET", "blank")),
            "BAROR" => return self.only(card, ("BAROR", "blank")),
            "BEAMOR" => return self.only(card, ("BEAMOR", "blank")),
            _ => return,
        };
        if let Some(id) = deck::integer(card.text(0)).filter(|id| !self.numbers.insert((kind, *id))) {
            self.second(card, id);
        }
    }

    /// Of a card that a deck has once.
    fn only(&mut self, card: &Reader, (name, field): (&'static str, &str)) {
        if !self.numbers.insert((name, 0)) {
            let _: Option<()> = card.wrong(0, field, format!("found a second {name}"), "one is allowed");
        }
    }

    fn second(&mut self, card: &Reader, id: i64) {
        let _: Option<()> =
            card.wrong(0, "ID", format!("found {id} a second time"), "a number that no other has is allowed");
    }
}

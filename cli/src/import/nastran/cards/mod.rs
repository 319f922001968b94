//! Cards with types: numbers and names as the deck has them, in its units and frames. What no reader takes is reported.

mod aero;
mod beams;
mod geometry;
mod links;
mod masses;
mod other;
mod properties;
mod reader;

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

pub use aero::{AeroCards, Division, PanelCard, SurfaceCard};
pub use beams::{Element, ElementKind, Offset, Orientation, Pin};
pub use geometry::{FrameBy, FrameCard, FrameShape, Grid};
pub use links::{Bush, BushProperty, Constraint, Rigid, Spread};
pub use masses::{LumpCard, LumpContent};
pub use properties::{Material, Property};
pub use reader::Ids;
use reader::Reader;

use super::deck::{self, Deck, Place};
use super::mistakes::{Mistakes, Remarks};

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
    pub constraint_unions: BTreeMap<i64, Ids>,
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
    /// Numbers of elements, masses, panels, splines and control surfaces, of which each has one.
    numbers: BTreeSet<(&'static str, i64)>,
}

impl Cards {
    /// Reads all cards of a deck.
    pub fn read(deck: &Deck, mistakes: &mut Mistakes, remarks: &mut Remarks) -> Cards {
        let shared = RefCell::new(std::mem::take(mistakes));
        let mut reading = Reading { cards: Cards::default(), remarks, numbers: BTreeSet::new() };
        let defaults = deck.cards.iter().find(|card| card.name == "GRDSET");
        let defaults = defaults.and_then(|card| geometry::defaults(&Reader::new(deck, card, &shared)));
        let defaults = defaults.unwrap_or_default();
        for card in &deck.cards {
            let reader = Reader::new(deck, card, &shared);
            // What is wrong with a card has been said where it was found.
            let _ = reading
                .structure(&reader, &defaults)
                .or_else(|| reading.air(&reader))
                .or_else(|| reading.other(&reader));
        }
        let cards = reading.cards;
        *mistakes = shared.into_inner();
        cards
    }
}

impl Cards {
    /// How many grids are named by all lists together, by those of splines for each of them.
    pub fn listed(&self) -> usize {
        let grids: Vec<i64> = self.grids.keys().copied().collect();
        let of_sets = self.aero.splines.iter().filter_map(|spline| self.aero.sets.get(&spline.set));
        let of_links = self.rigids.iter().map(|rigid| &rigid.others);
        let of_constraints = self.constraints.iter().map(|constraint| &constraint.grids);
        of_links.chain(of_constraints).chain(of_sets).map(|ids| ids.count(&grids)).sum()
    }
}

impl Reading<'_> {
    /// Takes a card of the structure, if it is one.
    fn structure(&mut self, card: &Reader, defaults: &geometry::GridDefaults) -> Option<()> {
        self.number(card);
        let (cards, remarks) = (&mut self.cards, &mut *self.remarks);
        match card.card.name.as_str() {
            "GRDSET" => {}
            "GRID" => {
                let grid = geometry::grid(card, defaults);
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
            "CBAR" => cards.elements.extend(beams::bar_or_beam(card, ("CBAR", ElementKind::Bar), remarks)),
            "CBEAM" => cards.elements.extend(beams::bar_or_beam(card, ("CBEAM", ElementKind::Beam), remarks)),
            "CROD" => cards.elements.extend(beams::rod(card)),
            "CONM1" => cards.lumps.extend(masses::conm1(card)),
            "CONM2" => cards.lumps.extend(masses::conm2(card)),
            "RBE2" => cards.rigids.extend(links::rbe2(card, remarks)),
            "RBAR" => cards.rigids.extend(links::rbar(card, remarks)),
            "RBE3" => cards.spreads.extend(links::rbe3(card, remarks)),
            "SPC1" => cards.constraints.extend(links::spc1(card)),
            "SPC" => drop(links::spc(card, &mut cards.constraints)),
            "SPCADD" => {
                let union = aero::set(card, "S");
                self.keep(card, union, |cards| &mut cards.constraint_unions);
            }
            "SUPORT" => supported(card, &mut cards.reference_grid, remarks),
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
                    "PBARL" => properties::pbarl(card),
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
            "AERO" => drop(aero::aero(card, &mut aero.reference)),
            "AEROS" => drop(aero::aeros(card, &mut aero.reference)),
            "CAERO1" => aero.panels.extend(aero::panel(card)),
            "PAERO1" => aero::bodies(card, remarks),
            "AEFACT" => {
                let list = aero::fractions(card);
                self.keep(card, list, |cards| &mut cards.aero.fractions);
            }
            "SPLINE1" => aero.splines.extend(aero::spline(card, "SPLINE1")),
            "SPLINE2" => aero.splines.extend(aero::spline(card, "SPLINE2")),
            "SET1" => {
                let set = aero::set(card, "G");
                self.keep(card, set, |cards| &mut cards.aero.sets);
            }
            "AESURF" => aero.surfaces.extend(aero::surface(card, remarks)),
            "AELIST" => {
                let list = aero::set(card, "E");
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
        let what = format!("{} {}", card.card.name, card.text(0));
        let said = "this card is not read: what it says is not in the aircraft".to_owned();
        let (place, what) = (card.card.place, what.trim_end().to_owned());
        self.remarks.reports.push(super::mistakes::Remark { place, what, said });
        Some(())
    }

    fn parameter(&mut self, card: &Reader) -> Option<()> {
        let name = card.text(0).to_uppercase();
        if name == "WTMASS" {
            self.cards.mass_factor = Some(card.positive(1, "V1")?);
            return Some(());
        }
        if matches!(name.as_str(), "G" | "W3" | "W4") {
            let said = "damping of the structure is not in the deck's beams here; the parameter structural_damping is one ratio for all modes";
            self.remarks.note(format!("PARAM {name} = {}: {said}", card.text(1)));
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

    /// Elements have numbers of their own, and so have rigid ones, masses, panels, splines and control surfaces.
    fn number(&mut self, card: &Reader) {
        let kind = match card.card.name.as_str() {
            "CBAR" | "CBEAM" | "CROD" | "CBUSH" => "element",
            "RBE2" | "RBE3" | "RBAR" => "rigid element",
            "CONM1" | "CONM2" => "mass",
            "SPLINE1" | "SPLINE2" => "spline",
            "CAERO1" => "panel",
            "AESURF" => "control surface",
            "AERO" => return self.only(card, "AERO"),
            "AEROS" => return self.only(card, "AEROS"),
            _ => return,
        };
        let id = deck::integer(card.text(0));
        if let Some(id) = id.filter(|id| !self.numbers.insert((kind, *id))) {
            self.second(card, id);
        }
    }

    /// Of some cards a deck has one.
    fn only(&mut self, card: &Reader, name: &'static str) {
        if !self.numbers.insert((name, 0)) {
            let _: Option<()> = card.wrong(0, "ACSID", format!("found a second {name}"), "one is allowed");
        }
    }

    fn second(&mut self, card: &Reader, id: i64) {
        let _: Option<()> =
            card.wrong(0, "ID", format!("found {id} a second time"), "a number that no other has is allowed");
    }
}

/// The first grid that a deck supports is O; others are told.
fn supported(card: &Reader, reference: &mut Option<i64>, remarks: &mut Remarks) {
    let Some(grid) = card.integer(0, "ID1") else { return };
    let first = *reference.get_or_insert(grid);
    if first != grid {
        remarks.note(format!("SUPORT: GRID {grid} is supported too; of all, GRID {first} is O"));
    }
}

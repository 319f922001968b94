//! A deck from its files to the text of an aircraft file: all rooms, one after the other.

use flexible_aircraft::Aircraft;

use super::Error;
use super::aero::{self, Control, Role, Surface};
use super::axes::DeckAxes;
use super::cards::Cards;
use super::choices::{self, Support};
use super::deck::Deck;
use super::frames::World;
use super::mistakes::{Mistakes, Needed, Origin, Remark, Remarks};
use super::pairs::{self, Side};
use super::request::{OneText, Request};
use super::structure::{Component, Parts, Structure};
use super::write::{self, Engine, Written};
use super::{joints, layout, lumps, members};
use crate::marked::RejectedFiles;

/// How many reports are told beside mistakes.
const MOST_REPORTS: usize = 10;

/// Nothing that is read is farther from O, m.
const FARTHEST: f64 = 1000.0;

/// What came of a deck.
#[derive(Debug)]
pub struct Imported {
    pub(super) deck: Deck,
    pub(super) cards: Cards,
    pub(super) text: String,
    pub(super) aircraft: Aircraft,
    pub(super) remarks: Remarks,
    /// What was taken where the deck leaves it open.
    pub(super) taken: Vec<String>,
    /// Of CONM1 and CONM2, of elements, kg, as the deck has them.
    pub(super) masses: [f64; 2],
}

impl Imported {
    /// The aircraft file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether something of the deck is not in it as it is there.
    pub fn has_reports(&self) -> bool {
        !self.remarks.reports.is_empty() || !self.remarks.general.is_empty()
    }

    /// The files of the deck.
    pub(super) fn files(&self) -> impl Iterator<Item = &str> {
        self.deck.files.iter().map(|file| file.name.as_str())
    }
}

/// The aircraft file of a deck that is one text, in metres, with what is usual: for programs that have no file. INCLUDE finds nothing.
///
/// # Errors
/// With every mistake in the deck that can be told without guessing.
pub fn of_text(deck: &str) -> Result<Imported, Error> {
    import(&Request::of_text(&OneText(deck)))
}

/// Reads, finds the tree, writes, and reads what it wrote.
///
/// # Errors
/// With every mistake that can be told without guessing, room by room.
pub fn import(request: &Request) -> Result<Imported, Error> {
    let mut mistakes = Mistakes::default();
    let deck = Deck::read(request.deck, request.source, &mut mistakes);
    mistakes.checked(&deck)?;
    let mut remarks = Remarks::default();
    let cards = Cards::read(&deck, &mut mistakes, &mut remarks);
    let found = mistakes
        .checked(&deck)
        .map_err(Error::from)
        .and_then(|()| found(request, (&deck, &cards), &mut remarks))
        .map_err(|error| with_reports(error, &deck, &remarks))?;
    let (text, aircraft) = found.written(request, &deck, &mut remarks)?;
    let Found { taken, masses, .. } = found;
    Ok(Imported { deck, cards, text, aircraft, remarks, taken, masses })
}

/// Mistakes with what was reported before, for a card that is not read may be why another one lacks something.
fn with_reports(error: Error, deck: &Deck, remarks: &Remarks) -> Error {
    let Error::Rejected(mut rejected) = error else { return error };
    let shown = |remark: &Remark| format!("{}: {}: {}", deck.shown(remark.place), remark.what, remark.said);
    rejected.beside = remarks.reports.iter().take(MOST_REPORTS).map(shown).collect();
    let more = remarks.reports.len().saturating_sub(MOST_REPORTS);
    if more > 0 {
        rejected.beside.push(format!("and {more} reports more"));
    }
    if !rejected.beside.is_empty() {
        rejected.beside.insert(0, "reported beside the mistakes:".to_owned());
    }
    Error::Rejected(rejected)
}

/// All of the aircraft, before it is written.
struct Found {
    structure: Structure,
    surfaces: Vec<Surface>,
    controls: Vec<Control>,
    roles: Vec<Option<Role>>,
    sides: Vec<Side>,
    names: Vec<String>,
    engines: Vec<Engine>,
    taken: Vec<String>,
    masses: [f64; 2],
    support: Support,
    airspeed: (f64, String),
    altitude: (f64, String),
    reference: [Option<f64>; 3],
}

fn found(request: &Request, (deck, cards): (&Deck, &Cards), remarks: &mut Remarks) -> Result<Found, Error> {
    let built = built(request, (deck, cards), remarks)?;
    let Built { mut structure, world, mut taken, masses } = built;
    let mut mistakes = Mistakes::default();
    let flown = Flown::new(request, (cards, &world), &mut structure, (&mut mistakes, remarks));
    mistakes.checked(deck)?;
    let Flown { surfaces, controls, roles, engines, area } = flown;
    let sides = joints::agreed(&structure, pairs::sides(&structure, &surfaces));
    let support = choices::support(request.support, &structure, &roles, remarks);
    if let Some(half) = &cards.aero.reference.half {
        remarks.card(half, "SYMXZ says that half of an aircraft is meant: it is not mirrored");
    }
    let names = layout::names(&structure);
    let length = world.length();
    let airspeed = choices::airspeed(
        (request.airspeed, request.altitude),
        cards,
        (support, masses[0] + masses[1], area, length),
        remarks,
    );
    let altitude =
        (request.altitude, if request.altitude == 0.0 { "assumed".to_owned() } else { String::new() });
    let given = &cards.aero.reference;
    let reference = [
        given.chord.map(|chord| chord * length),
        given.area.map(|area| area * length * length),
        given.span.map(|span| span * length),
    ];
    taken.push(
        "modes: those of bending and torsion alone, which leave beams as long as they are (mode_basis)"
            .to_owned(),
    );
    Ok(Found {
        structure,
        surfaces,
        controls,
        roles,
        sides,
        names,
        engines,
        taken,
        masses,
        support,
        airspeed,
        altitude,
        reference,
    })
}

/// What carries, with what was taken to find it.
struct Built {
    structure: Structure,
    world: World,
    taken: Vec<String>,
    masses: [f64; 2],
}

fn built(request: &Request, (deck, cards): (&Deck, &Cards), remarks: &mut Remarks) -> Result<Built, Error> {
    let mut mistakes = Mistakes::default();
    let units = request.units.units(cards.mass_factor.unwrap_or(1.0));
    let world = World::resolve(cards, &mut mistakes);
    mistakes.checked(deck)?;
    let mut taken = vec![format!("units: {}{}", request.units.name(), wtmass(cards))];
    let Some(world) = turned(request, (cards, world), (units.length, &mut taken), &mut mistakes) else {
        mistakes.checked(deck)?;
        return Err(Error::Rejected(RejectedFiles::default()));
    };
    let members = members::members((cards, &world, &units), (&mut mistakes, remarks));
    let of_elements = sum(members.iter().map(members::Member::mass));
    let lumps = lumps::lumps((cards, &world, &units), of_elements, (&mut mistakes, remarks));
    let masses = [sum(lumps.iter().map(|lump| lump.mass)), of_elements];
    mistakes.checked(deck)?;
    let parts = Parts {
        cards,
        world: &world,
        units: &units,
        members,
        lumps,
        sets: deck.constraint_sets.as_deref(),
        root: request.root,
    };
    let structure = Structure::new(parts, (&mut mistakes, remarks));
    let Some(structure) = structure.filter(|_| mistakes.is_empty()) else {
        mistakes.checked(deck)?;
        return Err(Error::Rejected(RejectedFiles::default()));
    };
    check_size(&structure, &mut mistakes);
    if !structure.has_mass() {
        mistakes.of_whole(format!(
            "found a structure of {:.6} kg; a CONM1 or CONM2 with a mass, a RHO of MAT1 or an NSM above 0 is needed",
            masses[0] + masses[1]
        ));
    }
    mistakes.checked(deck)?;
    taken.push(choices::held(&structure));
    Ok(Built { structure, world, taken, masses })
}

/// Of none 0, not −0.
fn sum(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, |sum, number| sum + number)
}

/// What the air does to it.
struct Flown {
    surfaces: Vec<Surface>,
    controls: Vec<Control>,
    roles: Vec<Option<Role>>,
    engines: Vec<Engine>,
    /// Of panels across z, m².
    area: f64,
}

impl Flown {
    fn new(
        request: &Request,
        (cards, world): (&Cards, &World),
        structure: &mut Structure,
        (mistakes, remarks): (&mut Mistakes, &mut Remarks),
    ) -> Flown {
        let panels = aero::panels((cards, world), structure, request.surfaces, (mistakes, remarks));
        aero::carry(structure, &panels, remarks);
        let mut controls = aero::controls((cards, world), structure, &panels, (mistakes, remarks));
        aero::link(&cards.aero, &mut controls, remarks);
        let surfaces = aero::surfaces(structure, &panels, &controls, (mistakes, remarks));
        let engines = choices::engines(request.engines, (world, structure), mistakes);
        let (mut surfaces, mut controls) = choices::used(surfaces, controls, remarks);
        let moments = |surfaces: &[Surface], controls: usize| aero::moments(structure, surfaces, controls);
        let said = aero::join((&mut controls, &mut surfaces), moments);
        said.into_iter().for_each(|said| remarks.note(said));
        let roles = aero::roles(&moments(&surfaces, controls.len()));
        let area = sum(panels
            .iter()
            .map(|panel| panel.outline.area(0.0, 1.0) * panel.outline.span().normalize().y.powi(2)));
        Flown { surfaces, controls, roles, engines, area }
    }
}

fn wtmass(cards: &Cards) -> String {
    cards.mass_factor.map_or(String::new(), |factor| format!("; masses times {factor} (PARAM,WTMASS)"))
}

/// Everything in body axes: those that are asked for, else those of the flow, else the usual ones.
fn turned(
    request: &Request,
    (cards, world): (&Cards, World),
    (length, taken): (f64, &mut Vec<String>),
    mistakes: &mut Mistakes,
) -> Option<World> {
    let flow = cards.aero.reference.frame.as_ref().filter(|_| request.axes.is_none());
    let axes = request.axes.unwrap_or(DeckAxes::AftRightUp);
    taken.push(match (flow, request.axes) {
        (Some((frame, _)), _) => format!("axes: {} (ACSID {frame})", axes.name()),
        (None, Some(_)) => format!("axes: {} (--axes)", axes.name()),
        (None, None) => format!("axes: {} (assumed: there is neither AEROS nor --axes)", axes.name()),
    });
    let turned = world.turned(flow.map_or(0, |(frame, _)| *frame), axes.to_body(), length);
    if let (None, Some((frame, origin))) = (&turned, flow) {
        mistakes.missing(origin, "ACSID", *frame, Needed::Frame);
    }
    turned
}

fn check_size(structure: &Structure, mistakes: &mut Mistakes) {
    // The format has the axes of components from their beginnings.
    let along = |component: &Component| {
        let reach = component.points.iter().map(|point| (point - component.points[0]).norm());
        reach.fold(0.0, f64::max)
    };
    let size = structure.components.iter().map(along).fold(layout::size(structure), f64::max);
    let offsets = structure.lumps.iter().map(|lump| lump.offset.norm()).fold(0.0, f64::max);
    if size.max(offsets) > FARTHEST {
        mistakes.of_whole(format!(
            "found an aircraft that reaches {:.1} m from O; up to {FARTHEST} m is allowed; --units says what the deck's units are",
            size.max(offsets)
        ));
    }
}

impl Found {
    /// The file and what the library reads from it; as a mirrored aircraft, if it is one.
    fn written(
        &self,
        request: &Request,
        deck: &Deck,
        remarks: &mut Remarks,
    ) -> Result<(String, Aircraft), Error> {
        let file = request.deck.file_name().unwrap_or_default().to_string_lossy();
        let name: String = request
            .deck
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .chars()
            .filter(|c| !c.is_control())
            .collect();
        let mut heading = vec![
            format!(
                "Written by `flexair import nastran` from {file}. What was taken where the deck leaves it open:"
            ),
            String::new(),
        ];
        heading.extend(self.taken.iter().map(|line| format!("  {line}")));
        heading.push(String::new());
        heading.push("SI units. Body axes: x forward, y right, z down from O. What decks do not say is marked \"assumed\".".to_owned());
        let heading: Vec<String> =
            heading.iter().map(|line| line.chars().filter(|c| !c.is_control()).collect()).collect();
        let shown = |origin: &Origin| match origin.card {
            "--surface" => "command line".to_owned(),
            _ => deck.shown_briefly(origin.place).chars().filter(|c| !c.is_control()).collect(),
        };
        let text = |is_symmetric: bool| {
            write::file(&Written {
                name: &name,
                heading: &heading,
                is_clamped: self.support == Support::Clamped,
                is_symmetric,
                airspeed: self.airspeed.clone(),
                altitude: self.altitude.clone(),
                reference: self.reference,
                structure: &self.structure,
                names: &self.names,
                sides: &self.sides,
                surfaces: &self.surfaces,
                controls: &self.controls,
                roles: &self.roles,
                engines: &self.engines,
                shown: &shown,
            })
        };
        if pairs::is_mirrored(&self.structure, &self.sides) {
            let symmetric = text(true);
            if let Ok(aircraft) = Aircraft::parse(&symmetric, &file) {
                return Ok((symmetric, aircraft));
            }
            remarks.note("masses or engines have no mirror image in y = 0: symmetric = true is not written");
        }
        let text = text(false);
        let aircraft = Aircraft::parse(&text, "the file that was to be written")
            .map_err(|error| Error::NotRead(Box::new(error)))?;
        Ok((text, aircraft))
    }
}

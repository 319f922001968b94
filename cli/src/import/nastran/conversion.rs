//! A deck from its files to the text of an aircraft file: all rooms, one after the other.

use std::path::Path;

use flexible_aircraft::Aircraft;

use super::Error;
use super::aero::{self, Control, Role, Surface, SurfaceLine};
use super::axes::DeckAxes;
use super::cards::Cards;
use super::choices::{self, Support};
use super::deck::{Deck, Source};
use super::frames::World;
use super::mistakes::{Mistakes, Origin, Remarks};
use super::pairs::{self, Side};
use super::structure::{Parts, Structure};
use super::units::UnitSystem;
use super::write::{self, Engine, Written};
use super::{joints, layout, lumps, members};
use crate::marked::RejectedFiles;

/// Nothing that is read is farther from O, m.
const FARTHEST: f64 = 1000.0;

/// What is asked for.
pub struct Request<'a> {
    pub deck: &'a Path,
    pub source: &'a dyn Source,
    pub units: UnitSystem,
    pub axes: Option<DeckAxes>,
    pub root: Option<i64>,
    pub support: Option<Support>,
    pub airspeed: Option<f64>,
    pub altitude: f64,
    pub surfaces: &'a [SurfaceLine],
    pub engines: &'a [(String, i64)],
}

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
    struct OneText<'t>(&'t str);
    impl Source for OneText<'_> {
        fn read(&self, path: &Path) -> Result<(std::path::PathBuf, String), String> {
            let is_deck = path == Path::new("deck.bdf");
            if is_deck {
                Ok((path.to_owned(), self.0.to_owned()))
            } else {
                Err("there are no other files".to_owned())
            }
        }
    }
    import(&Request {
        deck: Path::new("deck.bdf"),
        source: &OneText(deck),
        units: UnitSystem::M,
        axes: None,
        root: None,
        support: None,
        airspeed: None,
        altitude: 0.0,
        surfaces: &[],
        engines: &[],
    })
}

/// Reads, finds the tree, writes, and reads what it wrote.
///
/// # Errors
/// With every mistake that can be told without guessing, room by room.
pub fn import(request: &Request) -> Result<Imported, Error> {
    let mut mistakes = Mistakes::default();
    let deck = Deck::read(request.deck, request.source, &mut mistakes);
    conclude(mistakes, &deck)?;
    let (mut mistakes, mut remarks) = (Mistakes::default(), Remarks::default());
    let cards = Cards::read(&deck, &mut mistakes, &mut remarks);
    conclude(mistakes, &deck)?;
    let found = found(request, (&deck, &cards), &mut remarks)?;
    let (text, aircraft) = found.written(request, &deck, &mut remarks)?;
    let Found { taken, masses, .. } = found;
    Ok(Imported { deck, cards, text, aircraft, remarks, taken, masses })
}

fn conclude(mistakes: Mistakes, deck: &Deck) -> Result<(), RejectedFiles> {
    mistakes.conclude(deck)
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
    let mut mistakes = Mistakes::default();
    let units = request.units.units(cards.mass_factor.unwrap_or(1.0));
    let world = World::resolve(cards, &mut mistakes);
    conclude(mistakes, deck)?;
    let mut taken = vec![format!("units: {}{}", request.units.name(), wtmass(cards))];
    let mut mistakes = Mistakes::default();
    let Some(world) = turned(request, (cards, world), (units.length, &mut taken), &mut mistakes) else {
        conclude(mistakes, deck)?;
        return Err(Error::Rejected(RejectedFiles::default()));
    };
    let members = members::members((cards, &world, &units), (&mut mistakes, remarks));
    let lumps = lumps::lumps((cards, &world, &units), (&mut mistakes, remarks));
    // A sum of nothing is -0.
    let masses: [f64; 2] = [
        0.0 + lumps.iter().map(|lump| lump.mass).sum::<f64>(),
        0.0 + members.iter().map(members::Member::mass).sum::<f64>(),
    ];
    conclude(mistakes, deck)?;
    let mut mistakes = Mistakes::default();
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
        conclude(mistakes, deck)?;
        return Err(Error::Rejected(RejectedFiles::default()));
    };
    check_size(&structure, &mut mistakes);
    taken.push(choices::held(&structure));
    let panels = aero::panels((cards, &world), &structure, request.surfaces, (&mut mistakes, remarks));
    let controls = aero::controls((cards, &world), &structure, &panels, (&mut mistakes, remarks));
    let surfaces = aero::surfaces(&structure, &panels, &controls, remarks);
    let engines = choices::engines(request.engines, (&world, &structure), &mut mistakes);
    conclude(mistakes, deck)?;
    let (mut surfaces, mut controls) = choices::used(surfaces, controls, remarks);
    let moments = aero::moments(&structure, &surfaces, controls.len());
    let mut roles = aero::roles(&moments);
    if !roles.contains(&Some(Role::Pitch))
        && let Some(said) = aero::join_for_pitch(&mut controls, &mut surfaces, &moments)
    {
        remarks.note(said);
        roles = aero::roles(&aero::moments(&structure, &surfaces, controls.len()));
    }
    let sides = joints::agreed(&structure, pairs::sides(&structure, &surfaces));
    let support = choices::support(request.support, &structure, &roles, remarks);
    if let Some(half) = &cards.aero.reference.half {
        remarks.card(half, "SYMXZ or SYMXY says that half of an aircraft is meant: it is not mirrored");
    }
    let names = layout::names(&structure);
    let area = panels
        .iter()
        .filter(|panel| panel.behind.is_none())
        .map(|panel| panel.area(0.0, 1.0) * panel.span().normalize().y.powi(2))
        .sum();
    let airspeed = choices::airspeed(
        (request.airspeed, request.altitude),
        cards,
        (support, masses[0] + masses[1], area, units.length),
    );
    let altitude =
        (request.altitude, if request.altitude == 0.0 { "assumed".to_owned() } else { String::new() });
    let given = &cards.aero.reference;
    let reference = [
        given.chord.map(|chord| chord * units.length),
        given.area.map(|area| area * units.length * units.length),
        given.span.map(|span| span * units.length),
    ];
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
    let flow = cards.aero.reference.frame.filter(|_| request.axes.is_none());
    let axes = request.axes.unwrap_or(DeckAxes::AftRightUp);
    taken.push(match (flow, request.axes) {
        (Some(frame), _) => format!("axes: {} (ACSID {frame})", axes.name()),
        (None, Some(_)) => format!("axes: {} (--axes)", axes.name()),
        (None, None) => format!("axes: {} (assumed: there is neither AEROS nor --axes)", axes.name()),
    });
    let frame = flow.unwrap_or(0);
    let turned = world.turned(frame, axes.to_body(), length);
    if turned.is_none() {
        let allowed = "a CORD1R, CORD2R or CORD2C of the deck is needed";
        mistakes.of_whole(format!("AEROS or AERO, ACSID: found {frame}; {allowed}"));
    }
    turned
}

fn check_size(structure: &Structure, mistakes: &mut Mistakes) {
    let size = layout::size(structure);
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

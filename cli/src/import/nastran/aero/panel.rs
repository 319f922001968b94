//! Panels in body axes from O: CAERO1 with its boxes and the grids that carry it, or a `--surface`.

use nalgebra::Vector3;

use super::super::cards::{AeroCards, Cards, Division, PanelCard};
use super::super::frames::World;
use super::super::mistakes::{Mistakes, Origin, Remarks};
use super::super::structure::Structure;
use super::line::SurfaceLine;

/// CAERO1, splines and AESURF, of each.
const MOST_PANELS: usize = 1000;

/// Edges of panels that are nearer than this share of the chord are one.
const MEETING: f64 = 1e-3;

/// A trapezium whose chords run along x.
#[derive(Clone, Debug)]
pub struct Panel {
    pub origin: Origin,
    /// Of the leading edge, inboard and outboard, m from O.
    pub corners: [Vector3<f64>; 2],
    pub chords: [f64; 2],
    /// Edges of boxes, as fractions of the span and of the chord.
    pub spanwise: Vec<f64>,
    pub chordwise: Vec<f64>,
    pub carried_by: CarriedBy,
    /// A flap over all of the span: control and hinge.
    pub flap: Option<(String, f64)>,
    /// The panel before it along the chord that has its chord too, and the share of the whole that is before it.
    pub behind: Option<(usize, f64)>,
}

/// What a panel hangs on.
#[derive(Clone, Debug, PartialEq)]
pub enum CarriedBy {
    /// Those of its splines.
    Grids(Vec<i64>),
    /// The beams from one grid to another.
    Between([i64; 2]),
    /// The beam beside it.
    Nearest,
}

impl Panel {
    /// Across x, from the inboard to the outboard edge, m.
    pub fn span(&self) -> Vector3<f64> {
        let along = self.corners[1] - self.corners[0];
        Vector3::new(0.0, along.y, along.z)
    }

    /// How far out a place is: 0 at the inboard edge, 1 at the outboard one.
    pub fn fraction(&self, place: &Vector3<f64>) -> f64 {
        let span = self.span();
        (place - self.corners[0]).dot(&span) / span.norm_squared()
    }

    pub fn chord(&self, fraction: f64) -> f64 {
        self.chords[0] + fraction * (self.chords[1] - self.chords[0])
    }

    pub fn leading_edge(&self, fraction: f64) -> Vector3<f64> {
        self.corners[0] + (self.corners[1] - self.corners[0]) * fraction
    }

    /// How far behind the leading edge a place is, in chords.
    pub fn chord_fraction(&self, place: &Vector3<f64>, fraction: f64) -> f64 {
        (self.leading_edge(fraction).x - place.x) / self.chord(fraction)
    }

    /// Its area between two fractions of the span, m².
    pub fn area(&self, from: f64, to: f64) -> f64 {
        self.span().norm() * (to - from) * self.chord(0.5 * (from + to))
    }

    /// The strip and the row of a box.
    pub fn box_at(&self, id: i64) -> Option<(usize, usize)> {
        let rows = self.chordwise.len() as i64 - 1;
        let place = id - self.origin.id;
        let inside = (0..rows * (self.spanwise.len() as i64 - 1)).contains(&place);
        inside.then(|| ((place / rows) as usize, (place % rows) as usize))
    }

    /// The numbers of its boxes.
    pub fn boxes(&self) -> std::ops::Range<i64> {
        let count = (self.chordwise.len() as i64 - 1) * (self.spanwise.len() as i64 - 1);
        self.origin.id..self.origin.id.saturating_add(count)
    }
}

/// All panels, of the deck and of the command line.
pub fn panels(
    (cards, world): (&Cards, &World),
    structure: &Structure,
    lines: &[SurfaceLine],
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Vec<Panel> {
    let aero = &cards.aero;
    for (name, count) in [
        ("CAERO1", aero.panels.len()),
        ("AESURF", aero.surfaces.len()),
        ("SPLINE1 and SPLINE2", aero.splines.len()),
    ] {
        if count > MOST_PANELS {
            mistakes
                .of_whole(format!("found {count} {name}; up to {MOST_PANELS} are allowed of a stick model"));
            return Vec::new();
        }
    }
    let mut panels: Vec<Panel> = aero
        .panels
        .iter()
        .filter_map(|card| of_card(card, (cards, world), structure, (mistakes, remarks)))
        .collect();
    for (place, line) in lines.iter().enumerate() {
        panels.extend(of_line((place, line), world, structure, mistakes));
    }
    join_along_chord(&mut panels, remarks);
    for spline in &aero.splines {
        if !aero.panels.iter().any(|panel| panel.origin.id == spline.panel) {
            mistakes.of_origin(
                &spline.origin,
                "CAERO",
                format!("found {}", spline.panel),
                "a CAERO1 of the deck is needed",
            );
        }
    }
    panels
}

/// A control surface is often a panel of its own: where the leading edge of one is the trailing edge of another, the one before has both.
fn join_along_chord(panels: &mut [Panel], remarks: &mut Remarks) {
    for rear in 0..panels.len() {
        let follows = |front: &Panel| {
            let gap = |end: usize| {
                let trailing = front.corners[end] - Vector3::x() * front.chords[end];
                (trailing - panels[rear].corners[end]).norm()
            };
            gap(0).max(gap(1)) <= MEETING * front.chords[0].max(front.chords[1])
        };
        let is_front =
            |(place, front): &(usize, &Panel)| *place != rear && front.behind.is_none() && follows(front);
        let Some(front) = panels.iter().enumerate().find(is_front).map(|(place, _)| place) else { continue };
        let (own, more) = (panels[front].chords, panels[rear].chords);
        let share = (own[0] + own[1]) / (own[0] + own[1] + more[0] + more[1]);
        remarks.note(format!(
            "{} goes on behind {} along the chord: they are one surface",
            panels[rear].origin, panels[front].origin
        ));
        panels[front].chords = [own[0] + more[0], own[1] + more[1]];
        panels[front].chordwise.iter_mut().for_each(|edge| *edge *= share);
        panels[rear].behind = Some((front, share));
    }
}

fn of_card(
    card: &PanelCard,
    (cards, world): (&Cards, &World),
    structure: &Structure,
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Option<Panel> {
    let corners =
        card.corners.map(|corner| world.point(card.frame, corner).map(|place| place - structure.origin));
    let [Some(inboard), Some(outboard)] = corners else {
        let allowed = "a CORD1R, CORD2R or CORD2C of the deck is needed";
        mistakes.of_origin(&card.origin, "CP", format!("found {}", card.frame), allowed);
        return None;
    };
    let spanwise = edges(&cards.aero, card, (card.spanwise, "LSPAN"), mistakes)?;
    let chordwise = edges(&cards.aero, card, (card.chordwise, "LCHORD"), mistakes)?;
    let chords = card.chords.map(|chord| chord * world.length());
    let carried_by = carried_by(cards, card, mistakes)?;
    if carried_by == CarriedBy::Nearest {
        remarks.note(format!(
            "{}: no SPLINE1 or SPLINE2 names it, it is carried by the beam beside it",
            card.origin
        ));
    }
    let panel = Panel {
        origin: card.origin.clone(),
        corners: [inboard, outboard],
        chords,
        spanwise,
        chordwise,
        carried_by,
        flap: None,
        behind: None,
    };
    if panel.span().norm() < 1e-6 {
        let found = "found no span across the flow";
        mistakes.of_origin(
            &card.origin,
            "X1, X4",
            found,
            "corners are needed that are apart across x of the aerodynamic frame",
        );
        return None;
    }
    tell_boxes_without_splines(cards, &panel, remarks);
    Some(panel)
}

fn edges(
    aero: &AeroCards,
    card: &PanelCard,
    (division, name): (Division, &str),
    mistakes: &mut Mistakes,
) -> Option<Vec<f64>> {
    match division {
        Division::Equal(count) => Some((0..=count).map(|edge| edge as f64 / count as f64).collect()),
        Division::List(id) => {
            let fractions = aero.fractions.get(&id);
            let found = fractions
                .map_or_else(|| format!("found {id}"), |list| format!("found {list:?} in AEFACT {id}"));
            let is_good = |list: &&Vec<f64>| {
                list.len() > 1
                    && list.windows(2).all(|pair| pair[0] < pair[1])
                    && list.iter().all(|edge| (-1e-9..=1.0 + 1e-9).contains(edge))
            };
            let good = fractions.filter(is_good);
            if good.is_none() {
                mistakes.of_origin(
                    &card.origin,
                    name,
                    found,
                    "an AEFACT of the deck is needed with ascending fractions from 0 to 1",
                );
            }
            good.cloned()
        }
    }
}

/// Says that boxes which no spline moves are carried as the others are.
fn tell_boxes_without_splines(cards: &Cards, panel: &Panel, remarks: &mut Remarks) {
    let splines = || cards.aero.splines.iter().filter(|spline| spline.panel == panel.origin.id);
    if splines().next().is_none() || splines().any(|spline| spline.boxes.is_none()) {
        return;
    }
    let rectangles: Vec<[(usize, usize); 2]> = splines()
        .filter_map(|spline| {
            let [first, last] = spline.boxes?.map(|id| panel.box_at(id));
            Some([first?, last?])
        })
        .collect();
    let is_moved = |(strip, row): (usize, usize)| {
        let is_within = |[first, last]: &[(usize, usize); 2]| {
            (first.0..=last.0).contains(&strip) && (first.1..=last.1).contains(&row)
        };
        rectangles.iter().any(is_within)
    };
    let still = panel.boxes().filter_map(|id| panel.box_at(id)).filter(|place| !is_moved(*place)).count();
    if still > 0 {
        let count = panel.boxes().count();
        remarks.note(format!(
            "{}: no spline moves {still} of its {count} boxes (BOX1, BOX2); all are carried by the grids of its splines",
            panel.origin
        ));
    }
}

fn carried_by(cards: &Cards, card: &PanelCard, mistakes: &mut Mistakes) -> Option<CarriedBy> {
    let aero = &cards.aero;
    let mut sets = Vec::new();
    for spline in aero.splines.iter().filter(|spline| spline.panel == card.origin.id) {
        let Some(set) = aero.sets.get(&spline.set) else {
            mistakes.of_origin(
                &spline.origin,
                "SETG",
                format!("found {}", spline.set),
                "a SET1 of the deck is needed",
            );
            return None;
        };
        if let Some(missing) = set.singles().find(|grid| !cards.grids.contains_key(grid)) {
            let found = format!("found {missing} in SET1 {}", spline.set);
            mistakes.of_origin(&spline.origin, "SETG", found, "GRIDs of the deck are needed");
            return None;
        }
        sets.push(set);
    }
    if sets.is_empty() {
        return Some(CarriedBy::Nearest);
    }
    // A list of THRU names grids that need not be there.
    let known = |from: i64, to: i64| cards.grids.range(from..=to).map(|(id, _)| *id).collect();
    let listed = sets.iter().flat_map(|set| set.among(known));
    Some(CarriedBy::Grids(listed.collect()))
}

fn of_line(
    (place, line): (usize, &SurfaceLine),
    world: &World,
    structure: &Structure,
    mistakes: &mut Mistakes,
) -> Option<Panel> {
    let places = line.grids.map(|grid| world.grid(grid).map(|at| at - structure.origin));
    let [Some(one), Some(other)] = places else {
        mistakes.of_whole(format!(
            "--surface: found {} and {}, two GRIDs of the deck are needed",
            line.grids[0], line.grids[1]
        ));
        return None;
    };
    let ahead = |at: Vector3<f64>, chord: f64| at + Vector3::x() * (line.axis * chord);
    let panel = Panel {
        origin: Origin { card: "--surface", id: place as i64 + 1, place: Default::default() },
        corners: [ahead(one, line.chords[0]), ahead(other, line.chords[1])],
        chords: line.chords,
        spanwise: vec![0.0, 1.0],
        chordwise: vec![0.0, 1.0],
        carried_by: CarriedBy::Between(line.grids),
        flap: line.flap.clone(),
        behind: None,
    };
    if panel.span().norm() < 1e-6 {
        mistakes.of_whole(format!(
            "--surface {}:{}: found no span, two grids apart across x are needed",
            line.grids[0], line.grids[1]
        ));
        return None;
    }
    Some(panel)
}

//! How much of the air and of lists a deck may have: more is no stick model, and would take minutes to be told so.

use super::super::mistakes::{Mistakes, Origin};
use super::{Cards, Division, Ids, PanelCard};

/// Panels, splines, control surfaces.
const MOST_PANELS: usize = 1000;
const MOST_SPLINES: usize = 2000;
const MOST_SURFACES: usize = 1000;

/// Strips of all panels together.
const MOST_STRIPS: usize = 10_000;

/// Grids, and boxes of panels, that lists name, all lists together.
const MOST_LISTED: u64 = 1_000_000;

/// Says of what is more than that where it begins.
pub fn check(cards: &Cards, mistakes: &mut Mistakes) {
    let aero = &cards.aero;
    let mut count = |origin: Option<&Origin>, (found, most): (usize, usize)| {
        if let Some(origin) = origin {
            let found = format!("found {found} cards of its kind");
            mistakes.of_origin(origin, "ID", found, format!("up to {most} are allowed"));
        }
    };
    count(aero.panels.get(MOST_PANELS).map(|card| &card.origin), (aero.panels.len(), MOST_PANELS));
    count(aero.splines.get(MOST_SPLINES).map(|card| &card.origin), (aero.splines.len(), MOST_SPLINES));
    count(aero.surfaces.get(MOST_SURFACES).map(|card| &card.origin), (aero.surfaces.len(), MOST_SURFACES));
    if mistakes.is_empty() {
        strips(cards, mistakes);
        listed_grids(cards, mistakes);
        listed_boxes(cards, mistakes);
    }
}

/// How many boxes a panel has along its span and along its chord; none where its list is missing.
fn divided(cards: &Cards, panel: &PanelCard) -> [usize; 2] {
    [panel.spanwise, panel.chordwise].map(|division| match division {
        Division::Equal(count) => count,
        Division::List(id) => cards.aero.fractions.get(&id).map_or(0, |list| list.len().saturating_sub(1)),
    })
}

/// The numbers of the boxes of a panel.
pub fn boxes(cards: &Cards, panel: &PanelCard) -> std::ops::Range<i64> {
    let [spanwise, chordwise] = divided(cards, panel);
    panel.origin.id..panel.origin.id.saturating_add((spanwise * chordwise) as i64)
}

/// Not too many, and each box with a number of its own.
fn strips(cards: &Cards, mistakes: &mut Mistakes) {
    let mut panels: Vec<&PanelCard> = cards.aero.panels.iter().collect();
    let mut strips = 0;
    for panel in &panels {
        strips += divided(cards, panel)[0];
        if strips > MOST_STRIPS {
            let found = format!("found {strips} boxes along the spans of all panels up to here");
            mistakes.of_origin(&panel.origin, "NSPAN", found, format!("up to {MOST_STRIPS} are allowed"));
            return;
        }
    }
    panels.sort_by_key(|panel| panel.origin.id);
    for pair in panels.windows(2) {
        let id = pair[1].origin.id;
        if boxes(cards, pair[0]).contains(&id) && id != pair[0].origin.id {
            let found = format!("found {id}, which is the number of a box of {}", pair[0].origin);
            mistakes.of_origin(
                &pair[1].origin,
                "EID",
                found,
                "a number is allowed whose boxes no other panel has",
            );
        }
    }
}

/// What lists have named so far.
struct Sum<'a> {
    what: &'static str,
    listed: u64,
    mistakes: &'a mut Mistakes,
}

impl Sum<'_> {
    /// Whether it is still allowed.
    fn add(&mut self, origin: &Origin, more: u64) -> bool {
        self.listed += more;
        let fits = self.listed <= MOST_LISTED;
        if !fits {
            let found = format!("found lists that name {} {} up to here", self.listed, self.what);
            self.mistakes.of_origin(
                origin,
                "list",
                found,
                format!("up to {MOST_LISTED} are allowed of all together"),
            );
        }
        fits
    }
}

fn listed_grids(cards: &Cards, mistakes: &mut Mistakes) {
    let grids: Vec<i64> = cards.grids.keys().copied().collect();
    let below = |id: i64| grids.partition_point(|grid| *grid < id) as u64;
    let count = |ids: &Ids| ids.runs().map(|(from, to)| below(to.saturating_add(1)) - below(from)).sum();
    let mut sum = Sum { what: "grids", listed: 0, mistakes };
    let rigids = cards.rigids.iter().map(|rigid| (&rigid.origin, &rigid.others));
    let constraints = cards.constraints.iter().map(|constraint| (&constraint.origin, &constraint.grids));
    let splines = cards.aero.splines.iter().filter_map(|spline| {
        let set = cards.aero.sets.get(&spline.set)?;
        Some((&spline.origin, &set.ids))
    });
    for (origin, ids) in rigids.chain(constraints).chain(splines) {
        if !sum.add(origin, count(ids)) {
            return;
        }
    }
}

/// Boxes of control surfaces.
fn listed_boxes(cards: &Cards, mistakes: &mut Mistakes) {
    let mut sum = Sum { what: "boxes", listed: 0, mistakes };
    for surface in &cards.aero.surfaces {
        for list in surface.parts.iter().filter_map(|(_, list)| cards.aero.boxes.get(list)) {
            let of_panel = |panel: &PanelCard| {
                list.ids.within(boxes(cards, panel)).map(|(from, to)| to.abs_diff(from) + 1).sum::<u64>()
            };
            let panels = cards.aero.panels.iter().map(of_panel);
            if !sum.add(&surface.origin, panels.sum()) {
                return;
            }
        }
    }
}

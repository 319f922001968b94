//! From panels to surfaces of components: which stretch of which beam carries which part of a panel.
//!
//! Along the span of a panel its fraction runs from 0 to 1; so it does along the elements that carry it. What of the panel lies beyond the last
//! of them widens the strip there, if it is less than half of the element.

use nalgebra::Vector3;

use super::super::mistakes::{Mistakes, Remarks};
use super::super::structure::{Component, Structure};
use super::controls::{Control, ControlPart};
use super::panel::{Panel, SAME};
use super::runs::{Run, beside};
use super::strip::{Surface, of_stretch};

/// Panels whose spans have a smaller cosine than this, 45° apart and a little more, may both have strips on a stretch, as the format has it.
const CROSSING: f64 = 0.70;

/// More stretches with strips are no stick model.
const MOST_STRETCHES: usize = 20_000;

/// Stretches that lie over one another by less than this fraction of their component only meet: decks have few digits.
const SLACK: f64 = 1e-3;

/// All surfaces, panel by panel, the largest first: where panels lie over one another, that one stays.
pub fn surfaces(
    structure: &Structure,
    panels: &[Panel],
    controls: &[Control],
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Vec<Surface> {
    let mut parts: Vec<Vec<(usize, &ControlPart)>> = vec![Vec::new(); panels.len()];
    for (control, found) in controls.iter().enumerate() {
        found.parts.iter().for_each(|part| parts[part.panel].push((control, part)));
    }
    let area = |place: &usize| panels[*place].outline.area(0.0, 1.0);
    let mut order: Vec<usize> = (0..panels.len()).collect();
    order.sort_by(|one, other| area(other).total_cmp(&area(one)));
    let mut taken = Taken(vec![Vec::new(); structure.components.len()]);
    let mut surfaces = Vec::new();
    for place in order {
        let panel = &panels[place];
        surfaces.extend(of_panel((structure, place, panel), &parts[place], &mut taken, remarks));
        if surfaces.len() > MOST_STRETCHES {
            let found = format!("found {} stretches of beams with strips up to here", surfaces.len());
            mistakes.of_origin(&panel.origin, "EID", found, format!("up to {MOST_STRETCHES} are allowed"));
            return Vec::new();
        }
    }
    surfaces.sort_by(|one, other| one.component.cmp(&other.component).then(one.from.total_cmp(&other.from)));
    surfaces
}

/// What of each component has strips already, as fractions of its length, each with its panel.
struct Taken<'p>(Vec<Vec<Stretch<'p>>>);

/// A stretch with strips, the span of its panel, and this.
type Stretch<'p> = ([f64; 2], Vector3<f64>, &'p Panel);

impl<'p> Taken<'p> {
    /// The part of a stretch, as fractions of its panel, that may have strips: none lie there but of panels whose spans cross its own.
    /// What else of it is left out is told.
    fn take(
        &mut self,
        (component, run, panel): (&Component, &Run, &'p Panel),
        stretch: [f64; 2],
        remarks: &mut Remarks,
    ) -> Option<[f64; 2]> {
        let [one, other] = stretch.map(run.along(component));
        let [from, to] = [one.min(other), one.max(other)];
        let span = panel.outline.span().normalize();
        let taken = &mut self.0[run.component];
        let is_over = |(ends, other, _): &&Stretch| {
            to.min(ends[1]) - from.max(ends[0]) > SAME && other.dot(&span).abs() >= CROSSING
        };
        let over: Vec<&Stretch> = taken.iter().filter(is_over).collect();
        let Some((.., other)) = over.first() else {
            taken.push(([from, to], span, panel));
            return Some(stretch);
        };
        let slack = SLACK.min(0.5 * (to - from));
        let intervals: Vec<[f64; 2]> = over.iter().map(|(ends, ..)| *ends).collect();
        let kept = free([from, to], &intervals).filter(|kept| kept[1] - kept[0] > slack);
        let across = kept.map(|kept| run.across(component, kept));
        if to - from - kept.map_or(0.0, |kept| kept[1] - kept[0]) > slack {
            let area = panel.outline.area(stretch[0], stretch[1])
                - across.map_or(0.0, |[from, to]| panel.outline.area(from, to));
            let said = format!(
                "{area:.4} m² of what is from {from:.4} to {to:.4} of a beam lie where {} has strips: they are left out",
                other.origin
            );
            remarks.card(&panel.origin, said);
        }
        taken.extend(kept.map(|kept| (kept, span, panel)));
        across
    }
}

fn of_panel<'p>(
    (structure, place, panel): (&Structure, usize, &'p Panel),
    parts: &[(usize, &ControlPart)],
    all: &mut Taken<'p>,
    remarks: &mut Remarks,
) -> Vec<Surface> {
    let mut runs = beside(structure, (place, panel));
    // The longest first: what it covers is its own, and of others only what lies beside that is carried by them.
    let covered = |run: &Run| run.to().min(1.0) - run.from().max(0.0);
    runs.sort_by(|one, other| covered(other).total_cmp(&covered(one)));
    let mut taken: Vec<[f64; 2]> = Vec::new();
    let mut surfaces = Vec::new();
    let mut carried = Vec::new();
    for run in &runs {
        let Some([from, to]) = free([run.from().max(0.0), run.to().min(1.0)], &taken) else { continue };
        taken.push([from, to]);
        carried.push((run, [from, to]));
    }
    if carried.is_empty() {
        let said = format!("no beam runs along it: its {:.4} m² are left out", panel.outline.area(0.0, 1.0));
        remarks.card(&panel.origin, said);
        return surfaces;
    }
    carried.sort_by(|one, other| one.1[0].total_cmp(&other.1[0]));
    let last = carried.len() - 1;
    for (place, (run, ends)) in carried.iter().enumerate() {
        let gap = |from: f64, to: f64| if to - from > SAME { Some([from, to]) } else { None };
        let before = if place == 0 { gap(0.0, ends[0]) } else { gap(carried[place - 1].1[1], ends[0]) };
        let after = if place == last { gap(ends[1], 1.0) } else { None };
        let component = &structure.components[run.component];
        let beyond = [before, after].map(|gap| gap.filter(|gap| run.is_near(gap, ends)));
        for left_out in
            [before, after].into_iter().zip(beyond).filter(|(gap, kept)| kept.is_none() && gap.is_some())
        {
            let [from, to] = left_out.0.unwrap_or_default();
            let said = format!(
                "{:.4} m² of it, from {from:.4} to {to:.4} of its span, are beside no beam and are left out",
                panel.outline.area(from, to)
            );
            remarks.card(&panel.origin, said);
        }
        for [from, to] in beyond.into_iter().flatten() {
            let said = format!(
                "{}: {:.4} m² beyond the end of the beam widen the last strip",
                panel.origin,
                panel.outline.area(from, to)
            );
            remarks.note(said);
        }
        let stretches = stretches(*ends, parts);
        for (place, stretch) in stretches.iter().enumerate() {
            let Some(kept) = all.take((component, run, panel), *stretch, remarks) else { continue };
            let widened = [
                beyond[0].filter(|_| place == 0 && kept[0] <= stretch[0] + SAME),
                beyond[1].filter(|_| place + 1 == stretches.len() && kept[1] >= stretch[1] - SAME),
            ];
            let widened = widened.map(|gap| gap.map(|gap| gap[1] - gap[0]));
            surfaces.extend(of_stretch((component, run, panel), (kept, widened), parts, remarks));
        }
    }
    surfaces
}

/// The part of an interval that is not taken; of two the longer one.
fn free([from, to]: [f64; 2], taken: &[[f64; 2]]) -> Option<[f64; 2]> {
    let mut parts = vec![[from, to]];
    for other in taken {
        parts = parts
            .iter()
            .flat_map(|part| [[part[0], part[1].min(other[0])], [part[0].max(other[1]), part[1]]])
            .collect();
        parts.retain(|part| part[1] - part[0] > SAME);
    }
    parts
        .into_iter()
        .filter(|part| part[1] - part[0] > SAME)
        .max_by(|one, other| (one[1] - one[0]).total_cmp(&(other[1] - other[0])))
}

/// An interval cut where flaps begin and end.
fn stretches([from, to]: [f64; 2], parts: &[(usize, &ControlPart)]) -> Vec<[f64; 2]> {
    let inside = parts
        .iter()
        .flat_map(|(_, part)| [part.from, part.to])
        .filter(|cut| (from + SAME..to - SAME).contains(cut));
    let mut cuts: Vec<f64> = inside.chain([from, to]).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|one, other| (*one - *other).abs() <= SAME);
    cuts.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

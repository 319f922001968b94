//! AELINK: control surfaces that are no inputs of their own, for others turn them: u_D + Σ C u = 0 [Nastran's sign].

use super::super::cards::{AeroCards, LinkCard};
use super::super::mistakes::Remarks;
use super::controls::{Control, ControlPart, both};

/// Gives the flaps of linked controls to those that turn them; what cannot be held stays an input, and is told of.
pub fn link(cards: &AeroCards, controls: &mut Vec<Control>, remarks: &mut Remarks) {
    let is_linked = |label: &str| cards.links.iter().any(|link| link.dependent.eq_ignore_ascii_case(label));
    let mut done: Vec<&LinkCard> = Vec::new();
    for link in &cards.links {
        let same = done.iter().find(|other| other.dependent.eq_ignore_ascii_case(&link.dependent));
        if let Some(first) = same {
            if first.others != link.others {
                let said = format!(
                    "{} is linked otherwise than by the one before it, which is held",
                    link.dependent
                );
                remarks.card(&link.origin, said);
            }
            continue;
        }
        done.push(link);
        let place =
            |label: &str| controls.iter().position(|control| control.label.eq_ignore_ascii_case(label));
        let Some(dependent) = place(&link.dependent) else {
            remarks
                .card(&link.origin, format!("{} is no AESURF with a flap: it is not linked", link.dependent));
            continue;
        };
        let others: Option<Vec<(usize, f64)>> = link
            .others
            .iter()
            .map(|(label, factor)| place(label).filter(|_| !is_linked(label)).map(|other| (other, -factor)))
            .collect();
        let Some(others) = others else {
            let said =
                "not every LABL of it is an AESURF with a flap that is linked to none: it stays an input";
            remarks.card(&link.origin, format!("{}: {said}", link.dependent));
            continue;
        };
        give(dependent, &others, (controls, link), remarks);
    }
}

fn give(
    dependent: usize,
    others: &[(usize, f64)],
    (controls, link): (&mut Vec<Control>, &LinkCard),
    remarks: &mut Remarks,
) {
    let Control { parts, limits, label, .. } = controls[dependent].clone();
    let turning: Vec<(usize, f64)> = others.iter().copied().filter(|(_, gain)| *gain != 0.0).collect();
    if turning.is_empty() {
        remarks.note(format!("{label} is no input, and nothing turns it ({})", link.origin));
    }
    for &(other, gain) in &turning {
        let turned = parts.iter().cloned().map(|part| ControlPart { gain: part.gain * gain, ..part });
        controls[other].parts.extend(turned);
        let name = &controls[other].label;
        remarks.note(format!("{label} is no input: it turns by {gain} × {name} ({})", link.origin));
    }
    match (limits, turning.as_slice()) {
        (None, _) | (_, []) => {}
        (Some(limits), &[(other, gain)]) => {
            let [one, end] = limits.map(|angle| angle / gain);
            controls[other].limits = both(controls[other].limits, Some([one.min(end), one.max(end)]));
        }
        (Some(_), _) => {
            remarks.card(&link.origin, format!("the limits of {label} are not held, for several turn it"));
        }
    }
    controls.remove(dependent);
}

//! Which stations lead a joint where an engine knows the poses of stations alone: its own, or those before and behind it along the
//! component. Before the first one it follows what the component hangs on too, in the end O.

use nalgebra::Vector3;
use serde_json::{Value, json};

use super::super::airframe::{Airframe, Section};
use super::joints::{digits, triple};

/// A station that leads a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Leader {
    /// Of the file.
    pub station: usize,
    /// What is left of 1 by all of a joint is that of O.
    pub share: f64,
    /// From the station to the joint on the undeformed aircraft, body axes, m.
    pub offset: Vector3<f64>,
}

/// Of each section; none where it moves with O alone.
pub fn of_sections(airframe: &Airframe) -> Vec<Vec<Leader>> {
    let of_section = |section: &Section| {
        let leader = |(station, share): (usize, f64)| {
            let from = airframe.sections[airframe.stations[station]].position;
            Leader { station, share, offset: section.position - from }
        };
        around(airframe, section.component, section.along).into_iter().map(leader).collect()
    };
    airframe.sections.iter().map(of_section).collect()
}

/// Stations around a place of a component, and their shares.
fn around(airframe: &Airframe, component: usize, along: f64) -> Vec<(usize, f64)> {
    let here = distance(airframe, component, along);
    let mut on_it: Vec<(usize, f64)> = (airframe.stations.iter().enumerate())
        .map(|(station, &section)| (station, airframe.sections[section]))
        .filter(|(_, section)| section.component == component)
        .map(|(station, section)| (station, distance(airframe, component, section.along)))
        .collect();
    on_it.sort_by(|one, other| one.1.total_cmp(&other.1));
    let Some(behind) = on_it.iter().position(|(_, at)| *at >= here) else {
        return on_it.last().map_or_else(|| of_root(airframe, component), |(last, _)| vec![(*last, 1.0)]);
    };
    let (next, to) = on_it[behind];
    let (before, from) = match behind.checked_sub(1).map(|before| on_it[before]) {
        Some((station, at)) => (vec![(station, 1.0)], at),
        None => (of_root(airframe, component), 0.0),
    };
    let share = if to > from { (here - from) / (to - from) } else { 1.0 };
    let before = before.into_iter().map(|(station, of_it)| (station, of_it * (1.0 - share)));
    before.chain([(next, share)]).filter(|(_, share)| *share > f64::EPSILON).collect()
}

/// Of what a component hangs on.
fn of_root(airframe: &Airframe, component: usize) -> Vec<(usize, f64)> {
    let parent = airframe.aircraft.components[component].parent;
    parent.map_or(Vec::new(), |(parent, node)| around(airframe, parent, node as f64))
}

/// Of a place on a component from its root, m.
fn distance(airframe: &Airframe, component: usize, along: f64) -> f64 {
    let nodes = &airframe.nodes[component];
    let lengths = nodes.windows(2).map(|ends| {
        let [from, to] = [ends[0], ends[1]].map(|node| airframe.sections[node].position);
        (to - from).norm()
    });
    lengths.enumerate().map(|(element, length)| length * (along - element as f64).clamp(0.0, 1.0)).sum()
}

/// As engines read them.
pub fn extras(airframe: &Airframe, leaders: &[Leader]) -> Value {
    let leader = |leader: &Leader| {
        json!({
            "name": airframe.aircraft.stations[leader.station].name,
            "share": digits(leader.share),
            "offset": triple(&leader.offset),
        })
    };
    leaders.iter().map(leader).collect()
}

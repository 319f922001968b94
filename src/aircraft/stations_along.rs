//! Stations at equal distances along a component, which no file need list.

use nalgebra::Vector3;
use thiserror::Error;

use super::model::{Aircraft, Attachment, Component, Station};
use super::surfaces;

/// Why a component cannot have stations along it.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum StationsAlongError {
    /// There is no such component.
    #[error("found component \"{component}\", allowed are {}", components.join(", "))]
    NoSuchComponent {
        /// What was asked for.
        component: String,
        /// Those that there are.
        components: Vec<String>,
    },
    /// Too few or too many.
    #[error("found {found} stations along {component}, allowed are 1 to {}", Aircraft::MOST_STATIONS_ALONG)]
    Count {
        /// The component.
        component: String,
        /// How many were asked for.
        found: usize,
    },
    /// A station has the name already.
    #[error("found the name \"{0}\" of a station that there is, allowed are names that no other station has")]
    NameTaken(String),
}

impl Aircraft {
    /// The most stations along a component.
    pub const MOST_STATIONS_ALONG: usize = 999;

    /// Adds stations along a component, at (i − ½)/n of its length, named after it: `wing_right_01` and on.
    ///
    /// ```
    /// # use flexible_aircraft::Aircraft;
    /// let mut wing = Aircraft::read("aircraft/goland-wing.toml")?;
    /// wing.add_stations_along("wing", 20)?;
    /// assert_eq!((wing.stations.len(), wing.stations[20].name.as_str()), (1 + 20, "wing_20"));
    /// assert!(wing.add_stations_along("wing", 20).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When there is no such component, too many are asked for, or a name is taken; nothing changes then.
    pub fn add_stations_along(&mut self, component: &str, count: usize) -> Result<(), StationsAlongError> {
        let Some(found) = self.components.iter().find(|other| other.name == component) else {
            let components = self.components.iter().map(|other| other.name.clone()).collect();
            return Err(StationsAlongError::NoSuchComponent { component: component.to_owned(), components });
        };
        if !(1..=Self::MOST_STATIONS_ALONG).contains(&count) {
            return Err(StationsAlongError::Count { component: component.to_owned(), found: count });
        }
        let digits = count.to_string().len().max(2);
        let station = |number: usize| {
            let attachment = self.place_along(found, (number as f64 - 0.5) / count as f64);
            self.station_at(format!("{component}_{number:0digits$}"), attachment)
        };
        let added: Vec<Station> = (1..=count).map(station).collect();
        let is_taken = |one: &&Station| self.stations.iter().any(|other| other.name == one.name);
        if let Some(station) = added.iter().find(is_taken) {
            return Err(StationsAlongError::NameTaken(station.name.clone()));
        }
        self.stations.extend(added);
        Ok(())
    }

    /// A station with a name at a place, with the axis about which twist counts there; it is not added.
    ///
    /// ```
    /// # use flexible_aircraft::Aircraft;
    /// # use flexible_aircraft::aircraft::Attachment;
    /// let mut wing = Aircraft::read("aircraft/goland-wing.toml")?;
    /// wing.stations.push(wing.station_at("first_strip", wing.strips[0].attachment));
    /// assert_eq!(wing.stations[1].twist_axis, wing.strips[0].span);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn station_at(&self, name: impl Into<String>, attachment: Attachment) -> Station {
        Station { name: name.into(), attachment, twist_axis: twist_axis(attachment, self) }
    }

    /// The place at a fraction of a component's length.
    fn place_along(&self, component: &Component, fraction: f64) -> Attachment {
        let distances = self.distances(component);
        let elements = distances.len() - 1;
        let distance = fraction * distances[elements];
        let element = distances[1..elements].partition_point(|node| *node < distance);
        let (start, end) = (distances[element], distances[element + 1]);
        Attachment {
            beam: component.first_beam + element,
            fraction: ((distance - start) / (end - start)).clamp(0.0, 1.0),
        }
    }
}

/// The axis about which a station's twist counts.
pub(super) fn twist_axis(place: Attachment, aircraft: &Aircraft) -> Vector3<f64> {
    let strip = aircraft.strips.iter().find(|strip| strip.attachment.beam == place.beam);
    let [from, to] = aircraft.beams[place.beam].nodes.map(|node| aircraft.nodes[node]);
    let span = strip.map(|strip| strip.span).or_else(|| surfaces::span_axis(to - from));
    // A fuselage has no nose-up twist: forward, it rolls to the right.
    span.unwrap_or(Vector3::x())
}

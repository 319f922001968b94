//! Point loads: forces and moments that an experiment or a test adds at stations [theory: gravity-and-thrust.point-loads].

use std::fmt;

use nalgebra::Vector3;

use crate::equations::{StationLoad, StationLoads};
use crate::structure::ReducedStation;

use super::system::Plant;

/// A force and a moment on a station.
///
/// ```
/// use flexible_aircraft::plant::{Plant, PlantSettings, PointLoad};
/// use flexible_aircraft::{Aircraft, ReducedModel};
/// use nalgebra::Vector3;
///
/// let wing = ReducedModel::new(&Aircraft::read("aircraft/goland-wing.toml")?, 4)?;
/// let settings = PlantSettings::of(&wing);
/// let pull = PointLoad {
///     station: "tip".to_owned(),
///     force: Vector3::new(0.0, 0.0, -1000.0), // N: up
///     moment: Vector3::zeros(),
/// };
/// let plant = Plant::under(&wing, &settings)?;
/// let pulled = plant.clone().under_loads(&[pull])?;
/// let up = |plant: &Plant| -> Result<f64, Box<dyn std::error::Error>> {
///     let trim = plant.trim(&settings.trim_condition())?;
///     let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
///     Ok(-outputs.deflections[0].displacement.z) // m
/// };
/// assert!(up(&pulled)? > up(&plant)? + 0.005);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PointLoad {
    /// Name of the station on whose section it acts.
    pub station: String,
    /// North-east-down, N: a dead load, which keeps its direction however the aircraft flies and deforms.
    pub force: Vector3<f64>,
    /// N m, about axes fixed to the section, which are the body axes while nothing deforms: a moment that follows the section.
    pub moment: Vector3<f64>,
}

/// A point load that cannot act.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PointLoadError {
    /// There is no such station.
    NoSuchStation {
        /// What was asked for.
        station: String,
        /// The stations that there are.
        stations: Vec<String>,
    },
    /// It is infinite or not a number.
    NotFinite(PointLoad),
}

impl std::error::Error for PointLoadError {}

impl fmt::Display for PointLoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PointLoadError::NoSuchStation { station, stations } if stations.is_empty() => {
                write!(f, "point load: found station \"{station}\", but the aircraft has no stations")
            }
            PointLoadError::NoSuchStation { station, stations } => {
                write!(f, "point load: found station \"{station}\", allowed are {}", stations.join(", "))
            }
            PointLoadError::NotFinite(PointLoad { station, force, moment }) => {
                let list = |vector: &Vector3<f64>| format!("({}, {}, {})", vector.x, vector.y, vector.z);
                let (force, moment) = (list(force), list(moment));
                write!(
                    f,
                    "point load on {station}: found force {force} N and moment {moment} N m, allowed are finite numbers"
                )
            }
        }
    }
}

impl PointLoad {
    /// What several loads together do on stations.
    ///
    /// # Errors
    /// When one of them has no station or is not finite.
    pub(crate) fn on_stations(
        loads: &[PointLoad],
        stations: &[ReducedStation],
    ) -> Result<StationLoads, PointLoadError> {
        if loads.is_empty() {
            return Ok(StationLoads::default());
        }
        let mut sums = vec![StationLoad::NONE; stations.len()];
        for load in loads {
            let named = stations.iter().position(|station| station.name == load.station);
            let Some(sum) = named.map(|station| &mut sums[station]) else {
                let stations = stations.iter().map(|station| station.name.clone()).collect();
                return Err(PointLoadError::NoSuchStation { station: load.station.clone(), stations });
            };
            if !load.force.iter().chain(load.moment.iter()).all(|component| component.is_finite()) {
                return Err(PointLoadError::NotFinite(load.clone()));
            }
            sum.force += load.force;
            sum.moment += load.moment;
        }
        Ok(StationLoads::new(sums))
    }
}

impl Plant {
    /// The same plant with these loads on its stations in place of any others: in its rates, outputs, trims and linear motion.
    /// Half an aircraft moves as under that part of the loads that is alike on both sides.
    ///
    /// # Errors
    /// When one of them has no station or is not finite.
    pub fn under_loads(self, loads: &[PointLoad]) -> Result<Self, PointLoadError> {
        let loads = PointLoad::on_stations(loads, &self.stations)?;
        Ok(self.carrying(loads))
    }

    /// The same plant with these loads on its stations.
    pub(crate) fn carrying(mut self, loads: StationLoads) -> Self {
        self.equations.take_loads(loads);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plant::PlantSettings;
    use crate::structure::test_jet::jet;

    fn refusal(station: &str, force: f64) -> String {
        let load = PointLoad {
            station: station.to_owned(),
            force: Vector3::new(0.0, force, 0.0),
            moment: Vector3::zeros(),
        };
        Plant::under(jet(), &PlantSettings::of(jet())).unwrap().under_loads(&[load]).unwrap_err().to_string()
    }

    #[test]
    fn a_load_that_cannot_act_is_refused_with_what_is_allowed() {
        let expected = "point load: found station \"wing_tip\", allowed are wing_tip_right, ";
        assert!(refusal("wing_tip", 1.0).starts_with(expected), "{}", refusal("wing_tip", 1.0));
        assert_eq!(
            refusal("wing_tip_right", f64::NAN),
            "point load on wing_tip_right: found force (0, NaN, 0) N and moment (0, 0, 0) N m, allowed are finite numbers"
        );
    }
}

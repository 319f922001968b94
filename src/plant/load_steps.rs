//! The trim of a plant, for clamped aircraft under point loads in steps of the load.
//!
//! [theory: trim.load-steps]

use crate::aircraft::Support;

use super::system::Plant;
use super::trim::{Trim, TrimCondition};
use super::trim_error::{TrimError, TrimFailure};
use super::trim_search::Search;

/// Shares of the load that are added at first, and at least.
const FIRST_STEP: f64 = 1.0 / 8.0;
const SMALLEST_STEP: f64 = 1.0 / 1024.0;

impl Plant {
    /// Finds the flight of the condition, straight and level without sideslip unless it says otherwise, and q at which all
    /// accelerations vanish, thrust by the shares of the engines that run. A clamped aircraft keeps its attitude; only q is found, under point
    /// loads the one to which a growing load leads.
    ///
    /// # Errors
    /// When Newton's method finds no such state.
    pub fn trim(&self, condition: &TrimCondition) -> Result<Trim, Box<TrimError>> {
        let steady = self.with_steady_inflow();
        // In a flow alone an equilibrium that Newton's method does not find is lost, which sweeps tell.
        let in_steps = self.support() == Support::Clamped && self.equations.has_point_loads();
        let found =
            if in_steps { find_in_steps(&steady, *condition) } else { Search::find(&steady, *condition) };
        Ok(found?.trim_of(self))
    }
}

/// Where a clamped aircraft rests to which its load comes little by little, each part searched for from where the one before
/// has led: at once Newton's method may find another rest, bent the other way. A structure 1/share times as stiff bends as
/// under that share of all loads.
fn find_in_steps(plant: &Plant, condition: TrimCondition) -> Result<Search<'_>, Box<TrimError>> {
    let (mut share, mut step) = (0.0, FIRST_STEP);
    let mut unknowns = vec![0.0; plant.layout().modes()];
    while share < 1.0 {
        let next = f64::min(share + step, 1.0);
        let stiffer = plant.varied(plant.equations.tunnel_flow, 1.0 / next);
        let mut search = Search::resume(&stiffer, condition, &unknowns);
        match search.run() {
            Ok(()) => {
                share = next;
                unknowns.copy_from_slice(search.unknowns());
            }
            Err(_) if step > SMALLEST_STEP => step *= 0.5,
            Err(error) => {
                return Err(Box::new(TrimError {
                    failure: TrimFailure::NoRestUnderLoad { share },
                    ..*error
                }));
            }
        }
    }
    let mut search = Search::resume(plant, condition, &unknowns);
    search.run().map(|()| search)
}

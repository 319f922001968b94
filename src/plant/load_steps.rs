//! The trim of a plant, for clamped aircraft under point loads in steps of the load where one step is too far.
//!
//! [theory: trim.load-steps]

use crate::aircraft::Support;

use super::system::Plant;
use super::trim::{Trim, TrimCondition};
use super::trim_error::TrimError;
use super::trim_search::Search;

/// Shares of the load that are added at first, and at least.
const FIRST_STEP: f64 = 1.0 / 8.0;
const SMALLEST_STEP: f64 = 1.0 / 1024.0;

impl Plant {
    /// Finds steady straight flight, without sideslip where the controls for roll and yaw can hold it, and q at which all
    /// accelerations vanish, thrust equal on all engines. A clamped aircraft keeps its attitude; only q is found.
    ///
    /// # Errors
    /// When Newton's method finds no such state, that of a clamped aircraft under point loads not in steps of the load either.
    pub fn trim(&self, condition: &TrimCondition) -> Result<Trim, Box<TrimError>> {
        let steady = self.with_steady_inflow();
        // In a flow alone an equilibrium that Newton's method does not find is lost, which sweeps tell.
        let may_step = self.support() == Support::Clamped && self.equations.has_point_loads();
        let found = match Search::find(&steady, *condition) {
            Err(error) if may_step => find_in_steps(&steady, *condition).ok_or(error),
            found => found,
        };
        Ok(found?.trim_of(self))
    }
}

/// Where a clamped aircraft rests to which its load comes little by little, each part searched for from where the one before
/// has led. A structure 1/share times as stiff bends as under that share of all loads.
fn find_in_steps(plant: &Plant, condition: TrimCondition) -> Option<Search<'_>> {
    let (mut share, mut step) = (0.0, FIRST_STEP);
    let mut unknowns = vec![0.0; plant.layout().modes()];
    while share < 1.0 {
        let next = f64::min(share + step, 1.0);
        let stiffer = plant.varied(plant.equations.tunnel_flow, 1.0 / next);
        let mut search = Search::resume(&stiffer, condition, &unknowns);
        if search.run().is_ok() {
            share = next;
            unknowns.copy_from_slice(search.unknowns());
        } else if step > SMALLEST_STEP {
            step *= 0.5;
        } else {
            return None;
        }
    }
    let mut search = Search::resume(plant, condition, &unknowns);
    search.run().ok().map(|()| search)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::aircraft::Aircraft;
    use crate::plant::{PlantSettings, PointLoad};
    use crate::structure::ReducedModel;

    /// Of unit length, stiffness and mass, so stiff in its other plane and in torsion that its modes bend it in x and z.
    const CANTILEVER: &str = r#"
        format = 1
        name = "Cantilever"
        gravity_m_s2 = 0
        support = "clamped"
        mode_basis = "bending_torsion"
        model = "geometrically_exact"
        airspeed_m_s = 0
        altitude_m = 0

        [[component]]
        name = "beam"
        attached_to = "origin"
        axis_m = [[0, 0, 0], [1, 0, 0]]
        elements = 40
        y_axis = [0, 1, 0]
        chord_m = 1
        EA_N = 1e6
        GJ_N_m2 = 1e6
        EI_y_N_m2 = 1
        EI_z_N_m2 = 1e6

        [[component.distributed_mass]]
        parts = [{ total_kg = 1 }]
        gyration_chords = [0.001, 0.00075, 0.00075]

        [[station]]
        name = "tip"
        component = "beam"
        at = 1.0
    "#;

    /// PL²/EI, and x/L and z/L of the tip: elliptic integrals, K. Mattiasson, Int. J. Numer. Methods Eng. 17 (1981) 145–153.
    const DEAD_LOADS: [(f64, [f64; 2]); 3] =
        [(2.0, [0.839_358, 0.493_457]), (5.0, [0.612_372, 0.713_792]), (10.0, [0.445_004, 0.810_609])];

    #[test]
    fn a_load_that_is_too_much_at_once_is_carried_in_steps_and_any_other_is_not() {
        let model = ReducedModel::new(&Aircraft::parse(CANTILEVER, "cantilever.toml").unwrap(), 8).unwrap();
        let settings = PlantSettings { inflow_states: 0, ..PlantSettings::of(&model) };
        let (unloaded, condition) = (Plant::under(&model, &settings).unwrap(), settings.trim_condition());
        let mut at_once = Vec::new();
        for (load, [x, z]) in DEAD_LOADS {
            let force = Vector3::z() * load;
            let pull = PointLoad { station: "tip".to_owned(), force, moment: Vector3::zeros() };
            let plant = unloaded.clone().under_loads(&[pull]).unwrap();
            let trim = plant.trim(&condition).unwrap();
            let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
            let tip = Vector3::x() + outputs.deflections[0].displacement;
            assert!((tip - Vector3::new(x, 0.0, z)).norm() < 1e-4, "{load}: {tip}");
            let found = Search::find(&plant, condition).map(|search| search.trim_of(&plant));
            assert!(found.as_ref().is_ok_and(|found| *found == trim) || found.is_err(), "{load}");
            at_once.push(found.is_ok());
        }
        assert_eq!(at_once, [true, true, false]);
    }
}

//! Section loads of a plant, for who asks for them [theory: section-loads.summation].

use crate::equations::{Controls, SectionLoads, Workspace};
use crate::strips::Resultant;

use super::outputs::Outputs;
use super::system::Plant;

impl Plant {
    /// The loads at all cuts in a state under some controls; none at those of half an aircraft. Allocates.
    ///
    /// ```
    /// # use flexible_aircraft::{Aircraft, plant::{Plant, PlantSettings}};
    /// # let jet = Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
    /// # let settings = PlantSettings::of(&jet);
    /// let plant = Plant::under(&jet, &settings)?;
    /// let trim = plant.trim(&settings.trim_condition())?;
    /// let loads = plant.loads_at(&trim.state, &trim.controls, &mut plant.workspace());
    /// let root = jet.cuts.iter().position(|cut| cut.name == "wing_root_right").ok_or("no such cut")?;
    /// assert!((loads[root].bending / 532_649.0 - 1.0).abs() < 1e-2); // N·m
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn loads_at(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &mut Workspace,
    ) -> Vec<SectionLoads> {
        let mut loads = vec![SectionLoads::default(); self.equations.cut_count()];
        self.rates(state, controls, &mut vec![0.0; state.len()], workspace);
        self.equations.write_section_loads(state, controls, workspace, &mut loads);
        loads
    }

    /// What the air does to each strip of a whole aircraft in a state under some controls: force and moment where the elastic axis
    /// passes through it, apparent mass included, in the order of the strips. Allocates.
    ///
    /// [theory: section-loads.pieces]
    ///
    /// ```
    /// # use flexible_aircraft::{Aircraft, plant::{Plant, PlantSettings}};
    /// let wing = Aircraft::read("aircraft/goland-wing.toml")?.reduce()?;
    /// let settings = PlantSettings { airspeed: 80.0, ..PlantSettings::of(&wing) }; // m/s
    /// let plant = Plant::under(&wing, &settings)?;
    /// let trim = plant.trim(&settings.trim_condition())?;
    /// let loads = plant.strip_loads_at(&trim.state, &trim.controls, &mut plant.workspace());
    /// assert_eq!(loads.len(), wing.strips.len());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn strip_loads_at(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &mut Workspace,
    ) -> Vec<Resultant> {
        self.rates(state, controls, &mut vec![0.0; state.len()], workspace);
        let mut loads = Vec::with_capacity(self.equations.strip_count());
        self.equations.tell_strip_loads(state, controls, workspace, |_, resultant| loads.push(resultant));
        loads
    }

    /// Adds the loads in the state and under the controls of the last evaluation to the outputs there. Does not allocate.
    pub(crate) fn write_loads(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &Workspace,
        outputs: &mut Outputs,
    ) {
        outputs.loads.take(|loads| self.equations.write_section_loads(state, controls, workspace, loads));
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::*;
    use crate::aircraft::Fidelity;
    use crate::math::Attitude;
    use crate::plant::PlantSettings;
    use crate::structure::test_jet::jet;

    /// In steady level flight nothing is accelerated.
    #[test]
    fn what_acts_on_all_strips_holds_weight_and_thrust_in_the_trim() {
        let settings = PlantSettings { fidelity: Fidelity::Rigid, ..PlantSettings::of(jet()) };
        let plant = Plant::under(jet(), &settings).unwrap();
        let trim = plant.trim(&settings.trim_condition()).unwrap();
        let to_body: Matrix3<f64> =
            Attitude::from_quaternion(&trim.state[plant.layout().attitude()]).body_from_inertial;
        let weight = to_body * Vector3::new(0.0, 0.0, jet().integrals.mass * jet().gravity);
        let thrusts = jet().engines.iter().zip(&trim.controls.thrust);
        let thrust: Vector3<f64> = thrusts.map(|(engine, thrust)| engine.direction * *thrust).sum();
        let loads = plant.strip_loads_at(&trim.state, &trim.controls, &mut plant.workspace());
        let air: Vector3<f64> = loads.iter().map(|load| load.force).sum();
        assert_eq!(loads.len(), jet().strips.len());
        assert!((air + weight + thrust).norm() < 1e-8 * weight.norm(), "{air} {weight} {thrust}");
        for (strip, load) in jet().strips.iter().zip(&loads) {
            assert!((load.position - strip.position).norm() < 1e-12);
        }
    }
}

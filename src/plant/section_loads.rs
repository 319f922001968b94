//! Section loads of a plant, for who asks for them [theory: section-loads.summation].

use crate::equations::{Controls, SectionLoads, Workspace};

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

//! The plant, as control engineers call it: states x and inputs u in, rates ẋ, outputs y and the linear part of ẋ out.
//!
//! [theory: frames.state, equations-of-motion.rows, integration.linear-part]
//!
//! Nobody above asks which strips, modes or fidelity level there are. Time enters by the inputs alone, of which the motion
//! of the air is one.

use nalgebra::Vector3;

use crate::air::Air;
use crate::aircraft::{Control, Support};
use crate::equations::{Configuration, Controls, EquationsOfMotion, StateLayout, Workspace};
use crate::structure::{ReducedModel, ReducedStation};

use super::course::Course;
use super::free_modes::FreeModes;
use super::outputs::{AirData, Outputs};
use super::trim::Trim;

/// One aircraft under one set of equations, with the places at which it is watched.
///
/// ```
/// # use flexible_aircraft::{aircraft::Aircraft, flight::Settings, structure::ReducedModel};
/// # let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
/// # let model = ReducedModel::new(&Aircraft::read(&path)?, 4)?;
/// let settings = Settings::of(&model);
/// let plant = settings.plant(&model)?;
/// let trim = plant.trim(&settings.trim_condition())?;
/// let (mut rates, mut workspace) = (vec![0.0; trim.state.len()], plant.workspace());
/// plant.rates(&trim.state, &trim.controls, &mut rates, &mut workspace);
/// assert!(rates[plant.layout().velocity()].iter().all(|acceleration| acceleration.abs() < 1e-7)); // m/s²
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plant {
    pub(super) equations: EquationsOfMotion,
    /// Which of the packaged modes take part.
    modes: Vec<usize>,
    /// With the shapes of those modes.
    stations: Vec<ReducedStation>,
    /// The packaged number of each strip.
    strips: Vec<usize>,
}

impl Plant {
    /// Of a whole aircraft, all of whose modes take part unless it is to be rigid.
    pub fn new(model: &ReducedModel, configuration: &Configuration) -> Self {
        Plant::of_selected(model, configuration, (0..model.modes.len()).collect())
    }

    /// Of a whole aircraft with a selection of the packaged modes.
    pub(crate) fn of_selected(
        model: &ReducedModel,
        configuration: &Configuration,
        modes: Vec<usize>,
    ) -> Self {
        let strips = (0..model.strips.len()).collect();
        Plant::of_equations(EquationsOfMotion::new(model, configuration), model, modes, strips)
    }

    /// Of equations of a model whose modes and strips are these among the packaged ones.
    pub(crate) fn of_equations(
        equations: EquationsOfMotion,
        model: &ReducedModel,
        modes: Vec<usize>,
        strips: Vec<usize>,
    ) -> Self {
        Plant { equations, modes, stations: model.stations.clone(), strips }
    }

    /// The equations of motion.
    pub fn equations(&self) -> &EquationsOfMotion {
        &self.equations
    }

    /// Where each part of the state stands.
    pub fn layout(&self) -> &StateLayout {
        self.equations.layout()
    }

    /// Scratch memory for evaluations.
    pub fn workspace(&self) -> Workspace {
        Workspace::new(&self.equations)
    }

    /// Free flight or wind tunnel.
    pub fn support(&self) -> Support {
        self.equations.support()
    }

    /// What moves the flaps, in the order of [`Controls::angles`].
    pub fn controls(&self) -> &[Control] {
        self.equations.controls()
    }

    /// All controls neutral, no thrust, in still air.
    pub fn neutral_controls(&self) -> Controls {
        self.equations.neutral_controls()
    }

    /// Number of engines.
    pub fn engine_count(&self) -> usize {
        self.equations.engine_count()
    }

    /// The packaged number of a strip.
    pub fn packaged_strip(&self, strip: usize) -> usize {
        self.strips.get(strip).copied().unwrap_or(strip)
    }

    /// The coordinate (√kg m) by which the most moving strip is displaced by a metre.
    pub fn metre_of_displacement(&self) -> f64 {
        self.equations.metre_of_displacement()
    }

    /// ẋ: rates of all states, per second; what else the evaluation has found stays in the workspace. States beyond the
    /// model's validity give NaN.
    #[inline]
    pub fn rates(&self, state: &[f64], controls: &Controls, rates: &mut [f64], workspace: &mut Workspace) {
        self.equations.rates(state, controls, rates, workspace);
    }

    /// ẋ at the state and in the wind of the last evaluation under other angles of the controls and thrusts: the same bits as a
    /// new evaluation, for next to nothing.
    pub fn steer(&self, controls: &Controls, rates: &mut [f64], workspace: &mut Workspace) {
        self.equations.steer(controls, rates, workspace);
    }

    /// y: the outputs at the state and under the controls of the last evaluation, in axes along a course.
    pub fn write_outputs(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &Workspace,
        course: Course,
        outputs: &mut Outputs,
    ) {
        outputs.write_motion(&self.equations, state, workspace, course);
        outputs.write_modes(&self.modes, self.layout(), state);
        outputs.write_stations(&self.stations, &self.equations, state, workspace);
        outputs.write_controls(controls);
        outputs.air = self.air_data(state, controls);
    }

    /// The linear part of ẋ that belongs to the wake, at a constant airspeed (m/s): a diagonal in the layout of the state,
    /// 1/s; of complex states its real and imaginary part.
    pub fn write_wake_decay(&self, airspeed: f64, linear: &mut [f64]) {
        self.equations.inflow_linear_part(airspeed, linear);
    }

    /// The linear part of ẋ that belongs to the structure: the modes in which it swings freely about a trim.
    ///
    /// [theory: linearisation.free-modes]
    pub(crate) fn free_modes(&self, trim: &Trim) -> Option<FreeModes> {
        FreeModes::new(&self.equations, &trim.state, &trim.controls)
    }

    /// Speed of O relative to the air, m/s.
    pub fn airspeed(&self, state: &[f64], controls: &Controls) -> f64 {
        self.equations.airspeed(state, controls)
    }

    /// The flow at O.
    pub fn air_data(&self, state: &[f64], controls: &Controls) -> AirData {
        AirData::new(&self.equations.air_velocity(state, controls), &self.equations.air(state))
    }

    /// The packaged number of the first lifting strip that met the air from behind at the last evaluation.
    pub fn reversed_strip(&self, state: &[f64], controls: &Controls, workspace: &Workspace) -> Option<usize> {
        let reversed = self.equations.reversed_strip(state, controls, workspace);
        reversed.map(|strip| self.packaged_strip(strip))
    }

    /// The same plant with steady aerodynamics: the same trim, fewer states.
    pub fn with_steady_inflow(&self) -> Self {
        Plant { equations: self.equations.with_steady_inflow(), ..self.clone() }
    }

    /// The same plant without wide vectors: slower, with the same bits. For comparisons.
    pub fn one_strip_at_a_time(self) -> Self {
        Plant { equations: self.equations.one_strip_at_a_time(), ..self }
    }

    /// The same plant in another flow of the tunnel (m/s), with all elastic properties multiplied by a factor.
    pub(crate) fn varied(&self, tunnel_flow: Vector3<f64>, stiffness: f64) -> Self {
        Plant { equations: self.equations.varied(tunnel_flow, stiffness), ..self.clone() }
    }

    /// The air around O.
    pub(super) fn air(&self, state: &[f64]) -> Air {
        self.equations.air(state)
    }
}

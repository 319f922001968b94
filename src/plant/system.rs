//! The plant, as control engineers call it: states x and inputs u in, rates ẋ, outputs y and the linear part of ẋ out.
//!
//! [theory: frames.state, equations-of-motion.rows, integration.linear-part]
//!
//! Nobody above asks which strips, modes or fidelity level there are. Time enters by the inputs alone, of which the motion
//! of the air is one.

use std::sync::Arc;

use nalgebra::Vector3;

use crate::air::{Air, FrozenGust};
use crate::aircraft::{Control, Support};
use crate::equations::{ClosesLoop, Configuration, Controls, EquationsOfMotion, StateLayout, Workspace};
use crate::structure::{ModesInUse, ReducedModel, ReducedStation};

use super::air_data::AirData;
use super::course::Course;
use super::outputs::Outputs;

/// One aircraft under one set of equations, with the places at which it is watched.
///
/// ```
/// # use flexible_aircraft::{aircraft::Aircraft, plant::{Plant, PlantSettings}, structure::ReducedModel};
/// # let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
/// # let model = ReducedModel::new(&Aircraft::read(&path)?, 4)?;
/// let settings = PlantSettings::of(&model);
/// let plant = Plant::under(&model, &settings)?;
/// let trim = plant.trim(&settings.trim_condition())?;
/// let (mut rates, mut workspace) = (vec![0.0; trim.state.len()], plant.workspace());
/// plant.rates(&trim.state, &trim.controls, &mut rates, &mut workspace);
/// assert!(rates[plant.layout().velocity()].iter().all(|acceleration| acceleration.abs() < 1e-7)); // m/s²
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plant {
    pub(super) equations: EquationsOfMotion,
    packaged: Packaged,
    /// With the shapes of the modes that take part.
    pub(super) stations: Vec<ReducedStation>,
}

/// What a plant consists of, by its numbers in the packaged model.
#[derive(Clone, Debug)]
pub(crate) struct Packaged {
    /// How many modes are packaged.
    pub mode_count: usize,
    /// How many cuts.
    pub cut_count: usize,
    /// Which of the modes take part.
    pub modes: ModesInUse,
    /// Of each strip of the plant.
    pub strips: Vec<PackagedStrip>,
}

/// A strip as it is known in the packaged model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackagedStrip {
    /// Its number.
    pub number: usize,
    /// The component it belongs to.
    pub component: String,
}

impl Packaged {
    /// A whole model with these of its modes.
    pub fn whole(model: &ReducedModel, modes: &ModesInUse) -> Self {
        let strips = (0..model.strips.len()).map(|strip| PackagedStrip::of(model, strip)).collect();
        let (mode_count, cut_count) = (model.modes.len(), model.cuts.len());
        Packaged { mode_count, cut_count, modes: modes.clone(), strips }
    }
}

impl PackagedStrip {
    /// A strip of a model that has all of the packaged ones.
    pub(crate) fn of(model: &ReducedModel, number: usize) -> Self {
        PackagedStrip { number, component: model.strips[number].component.clone() }
    }
}

impl Plant {
    /// Of a whole aircraft, all of whose modes take part unless it is to be rigid.
    ///
    /// # Errors
    /// When the level is geometrically exact and the model's joints close loops.
    pub fn new(model: &ReducedModel, configuration: &Configuration) -> Result<Self, ClosesLoop> {
        configuration.fidelity.flies(&model.joints)?;
        Ok(Plant::of_chosen(model, configuration))
    }

    /// The same, of a level that is known to fly the model.
    pub(crate) fn of_chosen(model: &ReducedModel, configuration: &Configuration) -> Self {
        let modes = ModesInUse::chosen(&(0..model.modes.len()).collect::<Vec<_>>());
        let reduced = model.in_use(&modes);
        let equations = EquationsOfMotion::of_chosen(&reduced, configuration);
        Plant::of_equations(equations, &reduced, Packaged::whole(model, &modes))
    }

    /// What a coordinate is when it moves or turns some strip by about 1 m or 1 rad.
    pub(crate) fn coordinate_magnitude(&self) -> f64 {
        self.equations.coordinate_magnitude()
    }

    /// Of a whole aircraft with some of its modes, all others held at rest.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of_modes(
        model: &ReducedModel,
        configuration: &Configuration,
        modes: &ModesInUse,
    ) -> Result<Self, ClosesLoop> {
        let reduced = model.in_use(modes);
        let equations = EquationsOfMotion::new(&reduced, configuration)?;
        Ok(Plant::of_equations(equations, &reduced, Packaged::whole(model, modes)))
    }

    /// Of equations of a model of which that is packaged.
    pub(crate) fn of_equations(
        equations: EquationsOfMotion,
        model: &ReducedModel,
        packaged: Packaged,
    ) -> Self {
        Plant { equations, packaged, stations: model.stations.clone() }
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

    /// Index of the packaged mode of a coordinate; none where it combines several.
    pub fn packaged_mode(&self, coordinate: usize) -> Option<usize> {
        self.packaged.modes.packaged(coordinate)
    }

    /// A strip of the plant as it is known in the packaged model.
    pub fn packaged_strip(&self, strip: usize) -> &PackagedStrip {
        &self.packaged.strips[strip]
    }

    /// Number of engines.
    pub fn engine_count(&self) -> usize {
        self.equations.engine_count()
    }

    /// What departures of each of the [groups](StateLayout::groups) of states are measured by: 10 m and 1 m/s of O, 0.1 rad/s,
    /// 0.1 m and 1 m/s of the most moving strip of any mode, 1 m/s of inflow [theory: integration.error].
    pub fn magnitudes(&self) -> [f64; 7] {
        let metre = self.equations.metre_of_displacement();
        [10.0, 1.0, 1.0, 0.1, 0.1 * metre, metre, 1.0]
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

    /// y at a state under some controls, with north along the axes of the state. Allocates.
    ///
    /// ```
    /// # use flexible_aircraft::{Aircraft, plant::{Plant, PlantSettings}};
    /// # let jet = Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
    /// # let settings = PlantSettings::of(&jet);
    /// let plant = Plant::under(&jet, &settings)?;
    /// let trim = plant.trim(&settings.trim_condition())?;
    /// let mut controls = trim.controls.clone();
    /// controls.wind.z = -3.0; // m/s: the air rises
    /// let mut workspace = plant.workspace();
    /// let outputs = plant.outputs_at(&trim.state, &controls, &mut workspace);
    /// assert!(outputs.load_factor.z > 1.02 && outputs.air.angle_of_attack > trim.point.angle_of_attack());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn outputs_at(&self, state: &[f64], controls: &Controls, workspace: &mut Workspace) -> Outputs {
        self.outputs_along(Course::NORTH, state, controls, workspace)
    }

    /// The same where the axes of the state are along a course.
    pub(crate) fn outputs_along(
        &self,
        course: Course,
        state: &[f64],
        controls: &Controls,
        workspace: &mut Workspace,
    ) -> Outputs {
        let mut outputs = self.room_for_outputs();
        self.rates(state, controls, &mut vec![0.0; state.len()], workspace);
        self.write_outputs(state, controls, workspace, course, &mut outputs);
        outputs
    }

    /// ẋ and y at a state under some controls, from one evaluation: as [`rates`](Self::rates) and
    /// [`outputs_at`](Self::outputs_at), without allocating.
    pub fn rates_and_outputs(
        &self,
        state: &[f64],
        controls: &Controls,
        rates: &mut [f64],
        outputs: &mut Outputs,
        workspace: &mut Workspace,
    ) {
        self.rates(state, controls, rates, workspace);
        self.write_outputs(state, controls, workspace, Course::NORTH, outputs);
    }

    /// Room for [`rates_and_outputs`](Self::rates_and_outputs), all zero.
    pub fn room_for_outputs(&self) -> Outputs {
        let acting = [self.controls().len(), self.engine_count(), self.packaged.cut_count];
        Outputs::zero(self.packaged.mode_count, self.stations.len(), acting)
    }

    /// y at the state and under the controls of the last evaluation, in axes along a course.
    pub(crate) fn write_outputs(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &Workspace,
        course: Course,
        outputs: &mut Outputs,
    ) {
        self.write_usual_outputs(state, controls, workspace, course, outputs);
        self.write_further_outputs(state, workspace, course, outputs);
    }

    /// That of y which control laws read at every step, without [the rest](Self::write_further_outputs), which stays as it is.
    pub(crate) fn write_usual_outputs(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &Workspace,
        course: Course,
        outputs: &mut Outputs,
    ) {
        outputs.write_motion(&self.equations, state, workspace, course);
        outputs.write_modes(&self.packaged.modes, self.layout(), state);
        outputs.write_stations(&self.stations, &self.equations, state, workspace);
        outputs.write_controls(controls);
        outputs.write_air(self.uncalibrated_air_data(state, controls));
        outputs.wind = course.north_east_down(&self.equations.air_motion(state, controls));
        outputs.gust_peak_velocity = self.equations.gust_peak_velocity();
        outputs.loads.forget();
    }

    /// Beside the [usual outputs](Self::write_usual_outputs): path, attitudes as quaternions, where stations are, the load factor
    /// at the centre of mass, calibrated airspeed.
    pub(crate) fn write_further_outputs(
        &self,
        state: &[f64],
        workspace: &Workspace,
        course: Course,
        outputs: &mut Outputs,
    ) {
        outputs.write_placements(&self.equations, state, workspace, course);
        outputs.write_load_factor_cg(&self.equations, state, workspace);
        outputs.air.calibrate();
    }

    /// Speed of O relative to the air, m/s.
    pub fn airspeed(&self, state: &[f64], controls: &Controls) -> f64 {
        self.equations.airspeed(state, controls)
    }

    /// The flow at O.
    pub fn air_data(&self, state: &[f64], controls: &Controls) -> AirData {
        let mut air = self.uncalibrated_air_data(state, controls);
        air.calibrate();
        air
    }

    /// The same without the calibrated airspeed, which takes powers.
    fn uncalibrated_air_data(&self, state: &[f64], controls: &Controls) -> AirData {
        AirData::uncalibrated(&self.equations.air_velocity(state, controls), &self.equations.air(state))
    }

    /// How far each strip is in a state from where it is on the undeformed aircraft, without those edge-on, m. Allocates.
    pub fn strip_displacements(&self, state: &[f64]) -> Vec<Vector3<f64>> {
        self.equations.strip_displacements(state)
    }

    /// The first lifting strip that met the air from behind at the last evaluation.
    pub fn reversed_strip(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &Workspace,
    ) -> Option<&PackagedStrip> {
        let reversed = self.equations.reversed_strip(state, controls, workspace);
        reversed.map(|strip| &self.packaged.strips[strip])
    }

    /// The same plant with steady aerodynamics: the same trim, fewer states.
    pub fn with_steady_inflow(&self) -> Self {
        Plant { equations: self.equations.with_steady_inflow(), ..self.clone() }
    }

    /// The same plant without wide vectors: slower, with the same bits. For comparisons.
    pub fn one_strip_at_a_time(self) -> Self {
        Plant { equations: self.equations.one_strip_at_a_time(), ..self }
    }

    /// The same plant before what is frozen in the air.
    pub fn in_gust(mut self, gust: &Arc<FrozenGust>) -> Self {
        self.equations.take_gust(Arc::clone(gust));
        self
    }

    /// The same plant in another flow of the tunnel (m/s), with all elastic properties multiplied by a factor.
    pub(crate) fn varied(&self, tunnel_flow: Vector3<f64>, stiffness: f64) -> Self {
        Plant { equations: self.equations.varied(tunnel_flow, stiffness), ..self.clone() }
    }

    /// From now on the standard atmosphere is warmer by so many K.
    pub(crate) fn take_temperature_offset(&mut self, offset: f64) {
        self.equations.take_temperature_offset(offset);
    }

    /// Velocity of the air mass in the axes of the state, that of a tunnel's flow included, m/s.
    pub(crate) fn air_mass_velocity(&self, controls: &Controls) -> Vector3<f64> {
        controls.wind + self.equations.tunnel_flow
    }

    /// The air around O.
    pub(crate) fn air(&self, state: &[f64]) -> Air {
        self.equations.air(state)
    }
}

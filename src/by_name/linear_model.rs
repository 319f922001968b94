//! A linear model by the names of the FMU's variables [theory: linearisation.inputs, linearisation.outputs].

use nalgebra::{Complex, DMatrix};

use crate::flight::Settings;
use crate::plant::{EigenvaluesNotFound, eigenvalues};

use super::linear_names::Name;

/// What becomes of the wake in a linear model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Inflow {
    /// Its states are states of the model.
    #[default]
    Kept,
    /// There is none: the aircraft with `inflow_states = 0`.
    Steady,
}

/// What a linear model has beside what is always there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct LinearContents {
    /// What becomes of the wake.
    pub inflow: Inflow,
    /// Whether it has all states of a flight: `position.north`, `position.east`, `attitude.yaw`, and how far the air has gone,
    /// `drift.north`, `.east` and `.down`. Nothing depends on them [theory: linearisation.all-states].
    pub all_states: bool,
    /// How many planes across the track there are, 0 or 2 and more, at which a frozen gust is an input, m/s: `gust_plane[i].up` and
    /// `.right`, i from 1 on. They are equally far apart from the foremost leading edge of any strip to the last trailing edge,
    /// and the gust is linear between them. When it comes to which plane is for who gives the inputs:
    /// [`gust_planes`](LinearModel::gust_planes) has where they are [theory: linearisation.gust-planes].
    pub gust_planes: usize,
}

impl Inflow {
    /// Settings with this wake.
    pub(super) fn of(self, settings: &Settings) -> Settings {
        let mut settings = settings.clone();
        if self == Inflow::Steady {
            settings.plant.inflow_states = 0;
        }
        settings
    }
}

/// ẋ = A x + B u + B′ u̇, y = C x + D u + D′ u̇: small departures from the trim with which a flight begins, SI units.
///
/// n states, m inputs, p outputs. Inputs are those of the FMU, the wind uniform; outputs all that are Real and change with
/// time, but for sensors, section loads among them. B′ and D′ are zero but for the wind. Actuators and engines that lag have
/// states, their limits are left out, as are gust and turbulence, which are still ahead. Position north and east and heading
/// are held. [`with`](LinearModel::with) adds inputs for gusts, and those states.
///
/// ```
/// use flexible_aircraft::{Aircraft, Inflow, LinearModel, flight::Settings};
///
/// let jet = Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
/// let mut settings = Settings::of(&jet);
/// settings.plant.mode_count = 2;
/// let model = LinearModel::new(jet, &settings, Inflow::Steady)?;
/// let place = |names: &[flexible_aircraft::LinearName], name: &str| names.iter().position(|n| n.name == name);
/// let row = place(&model.states, "rate.y").ok_or("no such state")?;
/// let column = place(&model.inputs, "elevator").ok_or("no such input")?;
/// assert!(model.b[(row, column)] < -0.1); // rad/s² per rad: positive is nose-down
/// assert_eq!((model.states[row].unit, model.inputs[column].unit), ("rad/s", "rad"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LinearModel {
    /// A, n × n.
    pub a: DMatrix<f64>,
    /// B, n × m.
    pub b: DMatrix<f64>,
    /// C, p × n.
    pub c: DMatrix<f64>,
    /// D, p × m.
    pub d: DMatrix<f64>,
    /// B′, n × m.
    pub bd: DMatrix<f64>,
    /// D′, p × m.
    pub dd: DMatrix<f64>,
    /// States of the trim.
    pub x0: Vec<f64>,
    /// Inputs of the trim, absolute: angles of the controls and thrusts, in still air.
    pub u0: Vec<f64>,
    /// Outputs of the trim.
    pub y0: Vec<f64>,
    /// Name and unit of each state, in the order of A's rows.
    pub states: Vec<Name>,
    /// Name and unit of each input, in the order of B's columns.
    pub inputs: Vec<Name>,
    /// Name and unit of each output, in the order of C's rows.
    pub outputs: Vec<Name>,
    /// How far along the track the planes are ahead of O at which inputs `gust_plane[i]` are given, the first the foremost, m; none
    /// where there are no such inputs [theory: linearisation.gust-planes].
    pub gust_planes: Vec<f64>,
}

impl LinearModel {
    /// The eigenvalues of A, 1/s, in no particular order.
    ///
    /// # Errors
    /// When the iteration does not converge.
    pub fn eigenvalues(&self) -> Result<Vec<Complex<f64>>, EigenvaluesNotFound> {
        eigenvalues(&self.a)
    }
}

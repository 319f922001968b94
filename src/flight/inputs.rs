//! What a pilot, a control law and the atmosphere do to the aircraft [theory: integration.inputs, frames.signs].

use nalgebra::Vector3;

use crate::structure::ReducedModel;

/// Inputs at one instant, or their rates of change (the same quantities per second).
///
/// ```
/// use flexible_aircraft::Aircraft;
/// use flexible_aircraft::flight::Inputs;
///
/// let jet = Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
/// let mut inputs = Inputs::zero(&jet);
/// inputs.thrust[1] = 500.0; // N, of the second engine alone
/// let mut rates = Inputs::zero(&jet);
/// rates.wind.z = -4.0; // m/s²: air that rises faster and faster
/// inputs.add(0.5, &rates); // s
/// assert_eq!((inputs.wind.z, inputs.thrust[1]), (-2.0, 500.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, PartialEq)]
pub struct Inputs {
    /// rad, one per control in the order of [`ReducedModel::controls`].
    pub controls: Vec<f64>,
    /// N, one per engine in the order of [`ReducedModel::engines`].
    pub thrust: Vec<f64>,
    /// Velocity of the air mass, north-east-down, m/s.
    pub wind: Vector3<f64>,
    /// At which the wind changes until it is set again, north-east-down, m/s²: a gust acts on the apparent mass by it.
    ///
    /// [theory: air.wind-rate]
    pub wind_rate: Vector3<f64>,
}

impl Clone for Inputs {
    fn clone(&self) -> Self {
        Inputs { controls: self.controls.clone(), thrust: self.thrust.clone(), ..*self }
    }

    /// Without allocating when both have as many controls and engines: inputs are passed on in every step.
    fn clone_from(&mut self, source: &Self) {
        let Inputs { controls, thrust, wind, wind_rate } = source;
        self.controls.clone_from(controls);
        self.thrust.clone_from(thrust);
        (self.wind, self.wind_rate) = (*wind, *wind_rate);
    }
}

impl Inputs {
    /// Everything zero: under [`InputReference::Trim`](super::InputReference::Trim), trimmed flight in
    /// still air.
    pub fn zero(model: &ReducedModel) -> Self {
        Inputs {
            controls: vec![0.0; model.controls.len()],
            thrust: vec![0.0; model.engines.len()],
            wind: Vector3::zeros(),
            wind_rate: Vector3::zeros(),
        }
    }

    /// Adds `factor` times others.
    pub fn add(&mut self, factor: f64, others: &Inputs) {
        for (value, other) in self.values_mut().zip(others.values()) {
            *value += factor * other;
        }
    }

    /// What they become within a time (s) at some rates: each changes at its own, the wind at the input `wind_rate` too.
    ///
    /// [theory: integration.inputs]
    pub(super) fn ramp(&mut self, elapsed: f64, rates: &Inputs) {
        self.wind += elapsed * (self.wind_rate + 0.5 * elapsed * rates.wind_rate);
        self.add(elapsed, rates);
    }

    /// Whether nothing acts, or as rates, nothing changes.
    pub(super) fn is_zero(&self) -> bool {
        self.values().all(|value| value == 0.0)
    }

    /// All numbers, in the order of [`values_mut`](Self::values_mut).
    pub(crate) fn values(&self) -> impl Iterator<Item = f64> {
        let Inputs { controls, thrust, wind, wind_rate } = self;
        controls.iter().chain(thrust).chain(wind.iter()).chain(wind_rate.iter()).copied()
    }

    /// All numbers, to be changed.
    pub(crate) fn values_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        let Inputs { controls, thrust, wind, wind_rate } = self;
        controls.iter_mut().chain(thrust).chain(wind.iter_mut()).chain(wind_rate.iter_mut())
    }
}

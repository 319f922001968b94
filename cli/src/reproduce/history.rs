//! A flight as numbers over time: flown, and written as comma-separated values.

use std::fmt::Write;
use std::sync::Arc;

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Inputs, Simulation, SimulationError};
use flexible_aircraft::plant::Outputs;
use flexible_aircraft::structure::ReducedModel;

use super::Error;
use super::cases::Flight;

/// Duration of all flights, s: the thesis' axes.
pub const DURATION: f64 = 15.0;
/// Between samples, s. The pulses begin on multiples of it, and the input is linear in between.
const STEP: f64 = 0.01;

/// What a figure shows over time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// V_x, m/s.
    VelocityX,
    /// V_y, m/s.
    VelocityY,
    /// V_z, m/s.
    VelocityZ,
    /// ω_x, rad/s.
    RateX,
    /// ω_y, rad/s.
    RateY,
    /// ω_z, rad/s.
    RateZ,
    /// φ, rad.
    Roll,
    /// θ, rad.
    Pitch,
    /// ψ, rad.
    Yaw,
    /// V̇_x, m/s².
    AccelerationX,
    /// V̇_y, m/s².
    AccelerationY,
    /// V̇_z, m/s².
    AccelerationZ,
    /// Upward deflection of the right wing tip, m.
    WingTip,
    /// Upward deflection of the right tip of the horizontal tail, m.
    TailTip,
}

impl Quantity {
    /// In the order of the columns.
    pub const ALL: [Quantity; 14] = [
        Quantity::VelocityX,
        Quantity::VelocityY,
        Quantity::VelocityZ,
        Quantity::RateX,
        Quantity::RateY,
        Quantity::RateZ,
        Quantity::Roll,
        Quantity::Pitch,
        Quantity::Yaw,
        Quantity::AccelerationX,
        Quantity::AccelerationY,
        Quantity::AccelerationZ,
        Quantity::WingTip,
        Quantity::TailTip,
    ];

    /// Whether a flight has it: the rigid aircraft has no deflection.
    pub fn is_of(self, flight: &Flight) -> bool {
        flight.fidelity != Fidelity::Rigid || ![Quantity::WingTip, Quantity::TailTip].contains(&self)
    }

    /// Symbol and unit, as on an axis.
    pub fn label(self) -> &'static str {
        match self {
            Quantity::VelocityX => "Vx (m/s)",
            Quantity::VelocityY => "Vy (m/s)",
            Quantity::VelocityZ => "Vz (m/s)",
            Quantity::RateX => "ωx (rad/s)",
            Quantity::RateY => "ωy (rad/s)",
            Quantity::RateZ => "ωz (rad/s)",
            Quantity::Roll => "φ (rad)",
            Quantity::Pitch => "θ (rad)",
            Quantity::Yaw => "ψ (rad)",
            Quantity::AccelerationX => "ax (m/s²)",
            Quantity::AccelerationY => "ay (m/s²)",
            Quantity::AccelerationZ => "az (m/s²)",
            Quantity::WingTip => "deflection (m)",
            Quantity::TailTip => "deflection (m)",
        }
    }

    /// In words, as in a title.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::VelocityX => "forward velocity",
            Quantity::VelocityY => "velocity to the right",
            Quantity::VelocityZ => "downward velocity",
            Quantity::RateX => "roll rate",
            Quantity::RateY => "pitch rate",
            Quantity::RateZ => "yaw rate",
            Quantity::Roll => "roll angle",
            Quantity::Pitch => "pitch angle",
            Quantity::Yaw => "yaw angle",
            Quantity::AccelerationX => "forward acceleration",
            Quantity::AccelerationY => "acceleration to the right",
            Quantity::AccelerationZ => "downward acceleration",
            Quantity::WingTip => "right wing tip, upwards",
            Quantity::TailTip => "right tail tip, upwards",
        }
    }

    /// In words, with hyphens, for files and columns.
    pub fn slug(self) -> &'static str {
        match self {
            Quantity::VelocityX => "velocity-x",
            Quantity::VelocityY => "velocity-y",
            Quantity::VelocityZ => "velocity-z",
            Quantity::RateX => "rate-x",
            Quantity::RateY => "rate-y",
            Quantity::RateZ => "rate-z",
            Quantity::Roll => "roll",
            Quantity::Pitch => "pitch",
            Quantity::Yaw => "yaw",
            Quantity::AccelerationX => "acceleration-x",
            Quantity::AccelerationY => "acceleration-y",
            Quantity::AccelerationZ => "acceleration-z",
            Quantity::WingTip => "wing-tip",
            Quantity::TailTip => "tail-tip",
        }
    }
}

/// The outputs of one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// s.
    pub time: f64,
    /// Angle of the moving surface about its trim, rad.
    input: f64,
    /// In the order of [`Quantity::ALL`].
    values: [f64; Quantity::ALL.len()],
}

impl Sample {
    /// The value of a quantity in its unit.
    pub fn value(&self, quantity: Quantity) -> f64 {
        self.values[quantity as usize]
    }
}

/// Where an aircraft has the two tips of Table 5.1, among its stations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tips {
    wing: usize,
    tail: usize,
}

impl Tips {
    /// # Errors
    /// When the aircraft has no such stations.
    pub fn of(model: &ReducedModel) -> Result<Self, Error> {
        let find = |name: &'static str| {
            let place = model.stations.iter().position(|station| station.name == name);
            place.ok_or_else(|| Error::NoStation {
                station: name,
                found: model
                    .stations
                    .iter()
                    .map(|station| station.name.clone())
                    .collect::<Vec<_>>()
                    .join(", "),
            })
        };
        Ok(Tips { wing: find("wing_tip_right")?, tail: find("htail_tip_right")? })
    }
}

/// A flight as far as it went.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    /// What was flown.
    pub flight: Flight,
    /// From time 0; empty when the aircraft has no trim.
    pub samples: Vec<Sample>,
    /// Why it ended before its time.
    pub end: Option<SimulationError>,
}

impl History {
    /// Flies until the end or as far as the model is valid.
    pub fn fly(model: &Arc<ReducedModel>, tips: Tips, flight: Flight, duration: f64) -> Self {
        let mut samples = Vec::new();
        let end = record(model, tips, flight, duration, &mut samples).err();
        History { flight, samples, end }
    }

    /// A quantity over time.
    pub fn curve(&self, quantity: Quantity) -> Vec<(f64, f64)> {
        self.samples.iter().map(|sample| (sample.time, sample.value(quantity))).collect()
    }

    /// One line of names, then one line per sample.
    pub fn to_csv(&self) -> String {
        let names: Vec<&str> = Quantity::ALL.into_iter().map(Quantity::slug).collect();
        let mut csv = format!("time,input,{}\n", names.join(","));
        for Sample { time, input, values } in &self.samples {
            let values: Vec<String> = values.iter().map(|value| format!("{value:.9e}")).collect();
            // PROOF: writing to a string does not fail.
            let _ = writeln!(csv, "{time:.2},{input:.9e},{}", values.join(","));
        }
        csv
    }
}

fn record(
    model: &Arc<ReducedModel>,
    tips: Tips,
    flight: Flight,
    duration: f64,
    samples: &mut Vec<Sample>,
) -> Result<(), SimulationError> {
    let surface = flight.case.surface();
    let manoeuvre = surface.manoeuvre();
    let mut simulation = Simulation::new(Arc::clone(model), &flight.settings(model), 0.0)?;
    let (mut inputs, mut rates) = (Inputs::zero(model.engines.len()), Inputs::zero(model.engines.len()));
    let steps = (duration / STEP).round() as u32;
    for step in 0..=steps {
        let time = STEP * f64::from(step);
        let (angle, next) = (manoeuvre.value(time), manoeuvre.value(time + STEP));
        surface.set(&mut inputs, angle);
        surface.set(&mut rates, (next - angle) / STEP);
        simulation.set_inputs(&inputs, &rates);
        samples.push(sample(time, angle, simulation.outputs(), tips));
        if step < steps {
            simulation.advance_to(time + STEP)?;
        }
    }
    Ok(())
}

fn sample(time: f64, input: f64, outputs: &Outputs, tips: Tips) -> Sample {
    let Outputs { velocity, rate, attitude, acceleration, deflections, .. } = outputs;
    let up = |station: usize| -deflections[station].displacement.z;
    let values = Quantity::ALL.map(|quantity| match quantity {
        Quantity::VelocityX => velocity.x,
        Quantity::VelocityY => velocity.y,
        Quantity::VelocityZ => velocity.z,
        Quantity::RateX => rate.x,
        Quantity::RateY => rate.y,
        Quantity::RateZ => rate.z,
        Quantity::Roll => attitude.x,
        Quantity::Pitch => attitude.y,
        Quantity::Yaw => attitude.z,
        Quantity::AccelerationX => acceleration.x,
        Quantity::AccelerationY => acceleration.y,
        Quantity::AccelerationZ => acceleration.z,
        Quantity::WingTip => up(tips.wing),
        Quantity::TailTip => up(tips.tail),
    });
    Sample { time, input, values }
}

#[cfg(test)]
impl History {
    /// A history of 15 s as somebody would have it.
    pub fn made_up(flight: Flight, value: impl Fn(Quantity, f64) -> f64) -> Self {
        let sample = |step: u32| {
            let time = STEP * f64::from(step);
            Sample { time, input: 0.0, values: Quantity::ALL.map(|quantity| value(quantity, time)) }
        };
        History { flight, samples: (0..=1500).map(sample).collect(), end: None }
    }
}

//! Which outputs have a sensor's channel that mirrors them [theory: sensors.samples].

use crate::devices::{Input, within_half_a_turn};
use crate::plant::Outputs;
use crate::structure::ReducedModel;

/// A channel of a sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Of the output that it mirrors.
    pub mirrored: String,
    /// Which noise it has.
    pub noise: NoiseKind,
    measured: Measured,
}

/// Channels of a kind have noise of the same rms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseKind {
    /// Of attitude angles, rad.
    Attitude,
    /// Of rate gyros, rad/s.
    Rate,
    /// Of load factors.
    LoadFactor,
    /// Of accelerometers, m/s².
    SpecificForce,
    /// Of angle of attack and sideslip, rad.
    AirAngle,
    /// Of the airspeed, m/s.
    AirSpeed,
    /// Of the position, m.
    Position,
}

/// Where a channel's output stands; axes are 0, 1, 2.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Measured {
    Attitude(usize),
    Rate(usize),
    LoadFactor(usize),
    AirSpeed,
    AngleOfAttack,
    Sideslip,
    SpecificForce { station: usize, axis: usize },
    StationRate { station: usize, axis: usize },
    Down,
}

impl NoiseKind {
    /// All kinds.
    pub const ALL: [NoiseKind; 7] = [
        NoiseKind::Attitude,
        NoiseKind::Rate,
        NoiseKind::LoadFactor,
        NoiseKind::SpecificForce,
        NoiseKind::AirAngle,
        NoiseKind::AirSpeed,
        NoiseKind::Position,
    ];

    /// As the last part of a parameter's name.
    pub fn name(self) -> &'static str {
        match self {
            NoiseKind::Attitude => "attitude",
            NoiseKind::Rate => "rate",
            NoiseKind::LoadFactor => "load_factor",
            NoiseKind::SpecificForce => "specific_force",
            NoiseKind::AirAngle => "air_angle",
            NoiseKind::AirSpeed => "air_speed",
            NoiseKind::Position => "position",
        }
    }
}

impl Channel {
    /// All channels of an aircraft.
    pub fn of(model: &ReducedModel) -> Vec<Channel> {
        const XYZ: [&str; 3] = ["x", "y", "z"];
        let one =
            |mirrored: &str, noise, measured| Channel { mirrored: mirrored.to_owned(), noise, measured };
        let mut channels =
            triple("attitude", ["roll", "pitch", "yaw"], NoiseKind::Attitude, Measured::Attitude);
        channels.extend(triple("rate", XYZ, NoiseKind::Rate, Measured::Rate));
        channels.extend(triple("load_factor", XYZ, NoiseKind::LoadFactor, Measured::LoadFactor));
        channels.extend([
            one("air.speed", NoiseKind::AirSpeed, Measured::AirSpeed),
            one("air.alpha", NoiseKind::AirAngle, Measured::AngleOfAttack),
            one("air.beta", NoiseKind::AirAngle, Measured::Sideslip),
        ]);
        for (station, point) in model.stations.iter().enumerate() {
            let name = &point.name;
            let force = |axis| Measured::SpecificForce { station, axis };
            let rate = |axis| Measured::StationRate { station, axis };
            let group = format!("station.{name}.specific_force");
            channels.extend(triple(&group, XYZ, NoiseKind::SpecificForce, force));
            channels.extend(triple(&format!("station.{name}.rate"), XYZ, NoiseKind::Rate, rate));
        }
        channels.push(one("position.down", NoiseKind::Position, Measured::Down));
        channels
    }

    /// The channel's own name.
    pub fn name(&self) -> String {
        format!("sensor.{}", self.mirrored)
    }

    /// What it takes in at a sample, from outputs of the model that the channel is of.
    pub(super) fn input(&self, outputs: &Outputs) -> Input {
        let number = self.read(outputs);
        if self.turns() { Input::Angle(number) } else { Input::Number(number) }
    }

    /// A number within the range of what it mirrors, whole turns away where that jumps by them.
    pub(super) fn within_range(&self, number: f64) -> f64 {
        if self.turns() { within_half_a_turn(number) } else { number }
    }

    /// Whether what it mirrors jumps by a whole turn where it passes half a turn.
    fn turns(&self) -> bool {
        match self.measured {
            // Pitch, axis 1, goes from −π/2 to π/2 and back.
            Measured::Attitude(axis) => axis != 1,
            Measured::AngleOfAttack => true,
            Measured::Rate(_)
            | Measured::LoadFactor(_)
            | Measured::AirSpeed
            | Measured::Sideslip
            | Measured::SpecificForce { .. }
            | Measured::StationRate { .. }
            | Measured::Down => false,
        }
    }

    /// What it mirrors, among outputs of the model that the channel is of.
    pub fn read(&self, outputs: &Outputs) -> f64 {
        match self.measured {
            Measured::Attitude(axis) => outputs.attitude[axis],
            Measured::Rate(axis) => outputs.rate[axis],
            Measured::LoadFactor(axis) => outputs.load_factor[axis],
            Measured::AirSpeed => outputs.air.speed,
            Measured::AngleOfAttack => outputs.air.angle_of_attack,
            Measured::Sideslip => outputs.air.sideslip,
            Measured::SpecificForce { station, axis } => outputs.sensors[station].specific_force[axis],
            Measured::StationRate { station, axis } => outputs.sensors[station].rate[axis],
            Measured::Down => outputs.position.z,
        }
    }
}

fn triple(
    group: &str,
    axes: [&str; 3],
    noise: NoiseKind,
    measured: impl Fn(usize) -> Measured,
) -> Vec<Channel> {
    let channel =
        |(axis, name)| Channel { mirrored: format!("{group}.{name}"), noise, measured: measured(axis) };
    axes.into_iter().enumerate().map(channel).collect()
}

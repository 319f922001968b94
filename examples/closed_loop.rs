//! The aircraft and a control law in one Rust program, stepped as a co-simulation master steps two FMUs.
//!
//! ```sh
//! cargo run --release --example closed_loop -- pitch_attitude_hold > hold.csv
//! cargo run --release --example closed_loop -- gust_load_alleviation > alleviation.csv
//! cargo run --release --example closed_loop -- gust_load_alleviation open > open.csv
//! ```
//!
//! The laws are those of the Python files beside this one, line by line. A law is sampled: it reads its inputs at
//! the beginning of a communication step and what it makes of them acts from the step's end on. All parts step
//! from the same values (Jacobi's way), so that their order does not matter; an aircraft that a law steers answers
//! one step late, and a law's accelerometers feel the old deflections. `tests/coupling` compares what masters make of the FMUs with what this program writes.

use std::error::Error;
use std::f64::consts::PI;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

use flexible_aircraft::air::GustShape;
use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::devices::Actuator;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::Outputs;
use flexible_aircraft::structure::ReducedModel;

/// Communication step, s, and their number.
const STEP: f64 = 0.01;
const STEPS: u32 = 1500;

/// When the laws begin to act, s.
const ENGAGE_TIME: f64 = 0.5;

/// `vertical_gust.py`: beginning and duration, s, and peak, m/s.
const GUST_START: f64 = 1.0;
const GUST_DURATION: f64 = 4.0;
const GUST_PEAK: f64 = -10.0;

/// The gust that is built in, H, m; it begins and peaks as its parameters start: after 1 s, with 10 m/s upwards.
const GUST_GRADIENT: f64 = 63.5;

/// Of the ailerons' actuator: rad/s and rad/s.
const ACTUATOR_FREQUENCY: f64 = 40.0;
const ACTUATOR_RATE_LIMIT: f64 = 0.7;

/// Which wing tip is where among the stations.
struct WingTips {
    right: usize,
    left: usize,
}

/// Where the controls that the laws move are among the inputs.
struct Moved {
    elevator: usize,
    aileron_symmetric: usize,
}

/// A control law between two communication points.
enum Law {
    Open,
    PitchAttitudeHold(PitchAttitudeHold),
    GustLoadAlleviation(GustLoadAlleviation),
}

/// `pitch_attitude_hold.py`.
#[derive(Default)]
struct PitchAttitudeHold {
    reference: Option<f64>,
    integral: f64,
    elevator: f64,
}

/// `gust_load_alleviation.py`.
#[derive(Default)]
struct GustLoadAlleviation {
    steady: Option<f64>,
    slow: f64,
    smooth: f64,
    aileron_symmetric: f64,
}

impl Law {
    /// One step: what is read belongs to its beginning.
    fn step(&mut self, outputs: &Outputs, tips: &WingTips) {
        match self {
            Law::Open => {}
            Law::PitchAttitudeHold(law) => law.step(outputs.attitude.y, outputs.rate.y),
            Law::GustLoadAlleviation(law) => {
                let down = |tip: usize| outputs.sensors[tip].specific_force.z;
                law.step(down(tips.right), down(tips.left));
            }
        }
    }

    /// What acts on the aircraft in the next step.
    fn command(&self, inputs: &mut Inputs, moved: &Moved) {
        match self {
            Law::Open => {}
            Law::PitchAttitudeHold(law) => inputs.controls[moved.elevator] = law.elevator,
            Law::GustLoadAlleviation(law) => inputs.controls[moved.aileron_symmetric] = law.aileron_symmetric,
        }
    }
}

impl PitchAttitudeHold {
    const PITCH_GAIN: f64 = 4.0;
    const INTEGRAL_GAIN: f64 = 0.4;
    const RATE_GAIN: f64 = 2.0;
    const LIMIT: f64 = 0.2;

    fn step(&mut self, pitch: f64, pitch_rate: f64) {
        let deviation = pitch - *self.reference.get_or_insert(pitch);
        self.integral += deviation * STEP;
        let wanted =
            Self::PITCH_GAIN * deviation + Self::INTEGRAL_GAIN * self.integral + Self::RATE_GAIN * pitch_rate;
        self.elevator = wanted.clamp(-Self::LIMIT, Self::LIMIT);
    }
}

impl GustLoadAlleviation {
    const GAIN: f64 = 0.025;
    const HIGH_PASS_TIME: f64 = 2.0;
    const LOW_PASS_TIME: f64 = 0.5;
    const ROLL_OFF_TIME: f64 = 0.05;
    const LIMIT: f64 = 0.35;

    fn step(&mut self, force_right: f64, force_left: f64) {
        let upward = -0.5 * (force_right + force_left);
        let steady = self.steady.get_or_insert(upward);
        *steady += STEP / (Self::HIGH_PASS_TIME + STEP) * (upward - *steady);
        let fast = upward - *steady;
        self.slow += STEP / (Self::LOW_PASS_TIME + STEP) * (fast - self.slow);
        self.smooth += STEP / (Self::ROLL_OFF_TIME + STEP) * (self.slow - self.smooth);
        self.aileron_symmetric = (-Self::GAIN * self.smooth).clamp(-Self::LIMIT, Self::LIMIT);
    }
}

/// `vertical_gust.py`: velocity of the air mass downwards, m/s, at a time, s, and its rate, m/s².
fn wind(time: f64) -> (f64, f64) {
    let phase = (time - GUST_START) / GUST_DURATION;
    if phase <= 0.0 || phase >= 1.0 {
        return (0.0, 0.0);
    }
    let angle = 2.0 * PI * phase;
    (0.5 * GUST_PEAK * (1.0 - angle.cos()), GUST_PEAK * PI / GUST_DURATION * angle.sin())
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    // The law, and whether the gust is a wind from outside, which meets wing and tail at once, or built in.
    let (law, is_wind) = match arguments[..] {
        ["pitch_attitude_hold"] => (Law::PitchAttitudeHold(PitchAttitudeHold::default()), true),
        ["gust_load_alleviation"] => (Law::GustLoadAlleviation(GustLoadAlleviation::default()), false),
        ["pitch_attitude_hold", "open"] => (Law::Open, true),
        ["gust_load_alleviation", "open"] => (Law::Open, false),
        _ => {
            return Err(
                "expected `pitch_attitude_hold` or `gust_load_alleviation`, and perhaps `open`".into()
            );
        }
    };
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft/generic-business-jet.toml");
    let model = Arc::new(ReducedModel::new(&Aircraft::read(&file)?, ReducedModel::USUAL_MODES)?);
    let station = |name: &str| model.stations.iter().position(|station| station.name == name);
    let tips = WingTips {
        right: station("wing_tip_right").ok_or("the aircraft has no station wing_tip_right")?,
        left: station("wing_tip_left").ok_or("the aircraft has no station wing_tip_left")?,
    };
    let moved = Moved {
        elevator: model.control("elevator").ok_or("the aircraft has no elevator")?,
        aileron_symmetric: model
            .control("aileron_symmetric")
            .ok_or("the aircraft has no aileron_symmetric")?,
    };
    let mut settings = Settings::of(&model);
    if !is_wind {
        settings.gust.shape = GustShape::OneMinusCosine;
        settings.gust.gradient = GUST_GRADIENT;
        let actuator = Actuator {
            frequency: ACTUATOR_FREQUENCY,
            rate_limit: ACTUATOR_RATE_LIMIT,
            ..Actuator::default()
        };
        settings.actuators.set(moved.aileron_symmetric, actuator);
    }
    let aircraft = Simulation::new(Arc::clone(&model), &settings, 0.0)?;
    let still = Inputs::zero(&model);
    let table = &mut BufWriter::new(io::stdout().lock());
    fly((aircraft, still), law, is_wind, (&tips, &moved), table)?;
    Ok(())
}

/// Flies the aircraft with the law through the gust and writes a line per communication point.
fn fly(
    (mut aircraft, still): (Simulation, Inputs),
    mut law: Law,
    is_wind: bool,
    (tips, moved): (&WingTips, &Moved),
    table: &mut impl Write,
) -> Result<(), Box<dyn Error>> {
    writeln!(table, "{}", COLUMNS.join(","))?;
    write_line(table, 0.0, aircraft.outputs(), tips, moved)?;
    let mut inputs = still.clone();
    for step in 0..STEPS {
        let (begin, end) = (f64::from(step) * STEP, f64::from(step + 1) * STEP);
        // Before the inputs change: with them, accelerations jump.
        if begin + 0.5 * STEP >= ENGAGE_TIME {
            law.step(aircraft.outputs(), tips);
        }
        aircraft.set_inputs(&inputs, &still);
        aircraft.advance_to(end)?;
        law.command(&mut inputs, moved);
        if is_wind {
            (inputs.wind.z, inputs.wind_rate.z) = wind(end);
        }
        write_line(table, end, aircraft.outputs(), tips, moved)?;
    }
    Ok(())
}

/// Names of the columns: those of the FMU's outputs.
const COLUMNS: [&str; 9] = [
    "time",
    "attitude.pitch",
    "rate.y",
    "load_factor.z",
    "air.speed",
    "deflection.wing_tip_right.up",
    "station.wing_tip_right.specific_force.z",
    "surface.elevator",
    "surface.aileron_symmetric",
];

fn write_line(
    table: &mut impl Write,
    time: f64,
    outputs: &Outputs,
    tips: &WingTips,
    moved: &Moved,
) -> io::Result<()> {
    let values = [
        time,
        outputs.attitude.y,
        outputs.rate.y,
        outputs.load_factor.z,
        outputs.air.speed,
        -outputs.deflections[tips.right].displacement.z,
        outputs.sensors[tips.right].specific_force.z,
        outputs.controls[moved.elevator],
        outputs.controls[moved.aileron_symmetric],
    ];
    writeln!(table, "{}", values.map(|value| value.to_string()).join(","))
}

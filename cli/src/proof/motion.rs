//! Who takes a packaged aircraft from one time to a later one: itself, or its importer.

use flexible_aircraft::fmi::Kind;
use flexible_aircraft_packaging::FmuError;
use flexible_aircraft_packaging::c_abi::{Instance, ValueReference};

use crate::manoeuvre::Manoeuvre;

/// Between two looks at the outputs, s.
pub(super) const STEP: f64 = 0.01;

/// Of the method of Runge and Kutta in one of these: what is fastest in the motion falls 1600 times a second.
const PARTS: u32 = 10;

/// An input that moves.
pub(super) struct Moved {
    pub input: ValueReference,
    pub manoeuvre: Manoeuvre,
}

impl Moved {
    fn set(&self, aircraft: &mut Instance<'_>, time: f64) -> Result<(), FmuError> {
        aircraft.set_real(&[self.input], &[self.manoeuvre.value(time)])
    }
}

/// Who integrates.
pub(super) enum Motion {
    /// The FMU: co-simulation.
    Stepped,
    /// The importer: model exchange.
    Integrated(RungeKutta),
}

/// The classic method of fourth order.
pub(super) struct RungeKutta {
    x: Vec<f64>,
    /// Where a slope is asked for.
    stage: Vec<f64>,
    slopes: [Vec<f64>; 4],
}

impl Motion {
    /// That of an aircraft whose initialisation has ended.
    pub fn of(kind: Kind, aircraft: &mut Instance<'_>) -> Result<Self, FmuError> {
        Ok(match kind {
            Kind::CoSimulation => Motion::Stepped,
            Kind::ModelExchange => {
                aircraft.enter_continuous_time()?;
                let x = aircraft.states()?;
                let (stage, still) = (x.clone(), vec![0.0; x.len()]);
                Motion::Integrated(RungeKutta {
                    x,
                    stage,
                    slopes: [still.clone(), still.clone(), still.clone(), still],
                })
            }
        })
    }

    /// On by [`STEP`] from a time, s.
    pub fn advance(&mut self, aircraft: &mut Instance<'_>, moved: &Moved, time: f64) -> Result<(), FmuError> {
        match self {
            Motion::Stepped => {
                moved.set(aircraft, time)?;
                aircraft.do_step(time, STEP)
            }
            Motion::Integrated(method) => {
                let step = STEP / f64::from(PARTS);
                (0..PARTS).try_for_each(|part| {
                    let begin = time + f64::from(part) * step;
                    moved.set(aircraft, begin)?;
                    method.advance(aircraft, begin, step)
                })
            }
        }
    }
}

impl RungeKutta {
    /// Under inputs that are held.
    fn advance(&mut self, aircraft: &mut Instance<'_>, time: f64, step: f64) -> Result<(), FmuError> {
        let RungeKutta { x, stage, slopes } = self;
        for index in 0..slopes.len() {
            let part = [0.0, 0.5, 0.5, 1.0][index] * step;
            stage.copy_from_slice(x);
            if index > 0 {
                add(stage, part, &slopes[index - 1]);
            }
            aircraft.set_time(time + part)?;
            aircraft.set_states(stage)?;
            aircraft.rates(&mut slopes[index])?;
        }
        for (slope, weight) in slopes.iter().zip([1.0, 2.0, 2.0, 1.0]) {
            add(x, step * weight / 6.0, slope);
        }
        aircraft.set_time(time + step)?;
        aircraft.set_states(x)
    }
}

/// x += factor · slope.
fn add(x: &mut [f64], factor: f64, slope: &[f64]) {
    for (x, slope) in x.iter_mut().zip(slope) {
        *x += factor * slope;
    }
}

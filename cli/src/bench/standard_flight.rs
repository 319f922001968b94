//! The standard flight through the C interface: generic business jet, nominal stiffness, exact model, 12 modes of both
//! families, 5 inflow states, 127 m/s, elevator 2-3-1-1 of [theory: thesis-runs.inputs] by whichever control it has for pitch,
//! 15 s, communication step of 10 ms; and the same geometrically exact.

use std::time::Instant;

use cpu_time::ThreadTime;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft_packaging::FmuError;
use flexible_aircraft_packaging::c_abi::Fmu;

use super::{BenchError, least_time};
use crate::manoeuvre::Manoeuvre;
use crate::progress::Progress;

/// s.
pub const DURATION: f64 = 15.0;

/// Of the flight that counts as exact: its steps are hundreds of times shorter.
const REFERENCE_TOLERANCE: f64 = 1e-12;

/// Those whose accuracy is measured.
const TOLERANCES: [f64; 4] = [1e-4, 1e-5, 1e-6, 1e-7];

/// The FMU's own.
const USUAL_TOLERANCE: f64 = 1e-5;

/// What flies.
#[derive(Clone, Copy)]
pub struct Flown<'f> {
    pub fmu: &'f Fmu,
    /// At which it flies.
    pub level: Fidelity,
    /// The control that moves.
    pub control: &'f str,
    /// The station whose deflection is watched: a wing tip.
    pub station: &'f str,
    /// Parameters that do not start as the FMU has them.
    pub parameters: &'f [(String, ParameterValue)],
}

/// Of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParameterValue {
    /// Of a Real.
    Number(f64),
    /// Of an enumeration, from 1.
    Item(i32),
}

impl Flown<'_> {
    /// A variable that the flight moves or watches and the FMU lacks.
    pub fn missing_variable(&self) -> Option<String> {
        let needed = std::iter::once(self.control.to_owned()).chain(self.watched());
        needed.into_iter().find(|name| self.fmu.variable(name).is_err())
    }

    /// What is compared: pitch, a wing tip, the load factor.
    fn watched(&self) -> [String; 3] {
        ["attitude.pitch".to_owned(), format!("deflection.{}.up", self.station), "load_factor.z".to_owned()]
    }
}

/// One tolerance.
pub struct Accuracy {
    pub tolerance: f64,
    /// Processor time for a second of flight, s.
    pub time_per_second: f64,
    /// Largest errors of pitch, wing tip and load factor in parts of their peaks.
    pub errors: [f64; 3],
}

impl Accuracy {
    /// Against an exact flight.
    pub fn measure(flown: Flown, tolerance: f64, exact: &Flight) -> Result<Self, BenchError> {
        let flights = (0..5).map(|_| fly(flown, tolerance, 1, |_| {})).collect::<Result<Vec<_>, _>>()?;
        let time = flights.iter().fold(f64::INFINITY, |least, flight| least.min(flight.time));
        let errors = errors(&flights[0].history, &exact.history);
        Ok(Accuracy { tolerance, time_per_second: time / DURATION, errors })
    }
}

/// How long single steps take, s.
pub struct Latency {
    /// Communication step, s.
    pub step: f64,
    /// Half, 99 %, 99.9 % and all steps take no longer: of each step the least of several flights, all of which compute
    /// the same, so that the rest is what else the machine does.
    pub quantiles: [f64; 4],
    /// The longest step of the first flight, whatever else the machine did.
    pub longest: f64,
}

impl Latency {
    fn measure(flown: Flown, parts: u32) -> Result<Self, BenchError> {
        const FLIGHTS: usize = 5;
        let (mut least, mut longest) = (Vec::new(), 0.0_f64);
        for flight in 0..FLIGHTS {
            let mut times = Vec::with_capacity(least.len());
            fly(flown, USUAL_TOLERANCE, parts, |seconds| times.push(seconds))?;
            if flight == 0 {
                longest = times.iter().copied().fold(0.0, f64::max);
                least.clone_from(&times);
            }
            for (least, time) in least.iter_mut().zip(times) {
                *least = time.min(*least);
            }
        }
        least.sort_by(f64::total_cmp);
        let quantile = |share: f64| least[((least.len() - 1) as f64 * share) as usize];
        let quantiles = [0.5, 0.99, 0.999, 1.0].map(quantile);
        Ok(Latency { step: 0.01 / f64::from(parts), quantiles, longest })
    }
}

/// What the flights showed.
pub struct StandardFlight {
    pub accuracies: Vec<Accuracy>,
    /// Of the geometrically exact level at the FMU's own tolerance, against an exact flight at that level.
    pub geometrically_exact: Accuracy,
    pub latencies: Vec<Latency>,
    /// `fmi2Instantiate`, s.
    pub instantiation: f64,
    /// To the end of the initialisation mode, s.
    pub trim: f64,
    /// Whether one step of 10 ms and ten of 1 ms give the same bits at every 10 ms.
    pub same_bits: bool,
}

impl StandardFlight {
    /// Flies.
    pub fn measure(flown: Flown) -> Result<Self, BenchError> {
        // Two references, the other level, two latencies and the bits.
        let progress = Progress::new(TOLERANCES.len() + 6, "measurements");
        let exact = fly(flown, REFERENCE_TOLERANCE, 1, |_| {})?;
        progress.advance();
        let accuracy = |tolerance| {
            progress.advance();
            Accuracy::measure(flown, tolerance, &exact)
        };
        let accuracies = TOLERANCES.map(accuracy).into_iter().collect::<Result<_, _>>()?;
        let bending = Flown { level: Fidelity::GeometricallyExact, ..flown };
        let exact = fly(bending, REFERENCE_TOLERANCE, 1, |_| {})?;
        progress.advance();
        let geometrically_exact = Accuracy::measure(bending, USUAL_TOLERANCE, &exact)?;
        progress.advance();
        let latency = |parts| {
            progress.advance();
            Latency::measure(flown, parts)
        };
        let latencies = [1, 10].map(latency).into_iter().collect::<Result<_, _>>()?;
        let bits =
            |flight: Flight| flight.history.into_iter().map(|row| row.map(f64::to_bits)).collect::<Vec<_>>();
        let same_bits =
            bits(fly(flown, USUAL_TOLERANCE, 1, |_| {})?) == bits(fly(flown, USUAL_TOLERANCE, 10, |_| {})?);
        let instantiation = least_time(5, || Ok(flown.fmu.instantiate("bench").map(drop)?))?;
        let mut aircraft = flown.fmu.instantiate("bench")?;
        let trim = least_time(5, || {
            aircraft.reset()?;
            Ok(aircraft.initialise(0.0, None)?)
        })?;
        Ok(StandardFlight { accuracies, geometrically_exact, latencies, instantiation, trim, same_bits })
    }
}

/// One standard flight.
pub struct Flight {
    /// What is watched, after each 10 ms.
    pub history: Vec<[f64; 3]>,
    /// Processor time from the end of the initialisation to the end of the flight, s.
    time: f64,
}

/// Flies with so many communication steps in 10 ms, at the beginning of which the control moves, and tells `timed` how
/// long each step took, s.
pub fn fly(flown: Flown, tolerance: f64, parts: u32, mut timed: impl FnMut(f64)) -> Result<Flight, FmuError> {
    let Flown { fmu, level, control, .. } = flown;
    let (control, watched) = ([fmu.variable(control)?], fmu.variables(&flown.watched())?);
    let manoeuvre = Manoeuvre::two_three_one_one(-0.05, 0.7, 1.0, 0.05);
    let mut aircraft = fmu.instantiate("bench")?;
    // Items of an enumeration are counted from 1.
    aircraft.set_integer(&[fmu.variable("model")?], &[level as i32 + 1])?;
    for (name, value) in flown.parameters {
        let variable = fmu.variable(name)?;
        match *value {
            ParameterValue::Number(number) => aircraft.set_real(&[variable], &[number])?,
            ParameterValue::Item(item) => aircraft.set_integer(&[variable], &[item])?,
        }
    }
    // Of the experiment's tolerance and the parameter the tighter counts.
    aircraft.set_real(&[fmu.variable("tolerance")?], &[tolerance])?;
    aircraft.initialise(0.0, Some(tolerance))?;
    let mut history = Vec::new();
    let begin_of_flight = ThreadTime::now();
    let step = 0.01 / f64::from(parts);
    for index in 0..(DURATION * 100.0) as u32 {
        for part in 0..parts {
            let time = 0.01 * f64::from(index) + step * f64::from(part);
            let begin = Instant::now();
            if part == 0 {
                aircraft.set_real(&control, &[manoeuvre.value(time)])?;
            }
            aircraft.do_step(time, step)?;
            timed(begin.elapsed().as_secs_f64());
        }
        let mut row = [0.0; 3];
        aircraft.get_real(&watched, &mut row)?;
        history.push(row);
    }
    let time = begin_of_flight.elapsed().as_secs_f64();
    aircraft.terminate()?;
    Ok(Flight { history, time })
}

/// Largest differences in parts of the peaks.
pub fn errors(flight: &[[f64; 3]], exact: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|quantity| {
        let peak = exact.iter().fold(0.0_f64, |peak, row| peak.max(row[quantity].abs()));
        let pairs = flight.iter().zip(exact);
        pairs.fold(0.0_f64, |most, (a, b)| most.max((a[quantity] - b[quantity]).abs())) / peak
    })
}

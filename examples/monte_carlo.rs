//! Many random gusts on one trimmed aircraft: quantiles of load factor and wing-tip deflection.
//!
//! ```sh
//! cargo run --release --example monte_carlo             # 200 gusts on as many threads as there are processors
//! cargo run --release --example monte_carlo -- 1000 4   # 1000 on four
//! ```
//!
//! The aircraft is trimmed once. Every run goes back to the snapshot of that trim and draws from a generator of its
//! own, so that the result is the same whatever the number of threads. A gust is 1 − cos, of any size up to 15 m/s
//! upwards or downwards; its gradient distance is between 9 m and 107 m, as in CS-25.341.

use std::env;
use std::error::Error;
use std::f64::consts::PI;
use std::thread;

use flexible_aircraft::{Aircraft, Flight, FlightError};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/aircraft/generic-business-jet.toml");

/// Between two settings of the wind, s, and their number.
const STEP: f64 = 0.01;
const STEPS: u32 = 400;

/// What is watched, and its unit.
const WATCHED: [(&str, &str); 2] = [("load_factor.z", "1"), ("deflection.wing_tip_right.up", "m")];

/// The lowest and the highest value of everything watched in one run.
type Extremes = [[f64; 2]; WATCHED.len()];

/// A vertical gust.
struct Gust {
    /// m/s, positive downwards.
    peak: f64,
    /// s.
    duration: f64,
}

impl Gust {
    /// That of a run, met at an airspeed, m/s.
    fn random(run: u64, airspeed: f64) -> Self {
        let mut random = SplitMix64(run);
        let peak = random.between(-15.0, 15.0);
        Gust { peak, duration: 2.0 * random.between(9.0, 107.0) / airspeed }
    }

    /// Velocity, m/s, and its rate, m/s², at a time, s.
    fn at(&self, time: f64) -> [f64; 2] {
        let Gust { peak, duration } = *self;
        let (sin, cos) = (2.0 * PI * (time / duration).min(1.0)).sin_cos();
        [0.5 * peak * (1.0 - cos), peak * PI / duration * sin]
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut numbers = env::args().skip(1).map(|argument| argument.parse::<u64>());
    let runs = numbers.next().unwrap_or(Ok(200))?.max(1);
    let usual = thread::available_parallelism().map_or(1, |threads| threads.get() as u64);
    let threads = numbers.next().unwrap_or(Ok(usual))?.clamp(1, runs);

    let mut flight = Flight::new(Aircraft::read(FILE)?.reduce()?);
    let trimmed = flight.snapshot()?;
    let airspeed = flight.get("airspeed")?;
    let fly_share = |share: u64| {
        let mut flight = flight.clone();
        let fly = |run| fly(&mut flight, &trimmed, &Gust::random(run, airspeed));
        (share..runs).step_by(threads as usize).map(fly).collect::<Result<Vec<Extremes>, _>>()
    };
    let mut extremes = Vec::new();
    thread::scope(|scope| {
        let shares: Vec<_> = (0..threads).map(|share| scope.spawn(move || fly_share(share))).collect();
        shares.into_iter().try_for_each(|share| {
            extremes.extend(share.join().map_err(|_| "a thread panicked")??);
            Ok::<_, Box<dyn Error>>(())
        })
    })?;

    println!("{runs} gusts of {} s at {airspeed} m/s", STEP * f64::from(STEPS));
    println!("{:36} {:>8} {:>8} {:>8}", "", "5 %", "50 %", "95 %");
    for (watched, (name, unit)) in WATCHED.into_iter().enumerate() {
        for (end, which) in ["lowest", "highest"].into_iter().enumerate() {
            let mut values: Vec<f64> = extremes.iter().map(|extremes| extremes[watched][end]).collect();
            values.sort_by(f64::total_cmp);
            let quantile = |part: f64| values[((runs - 1) as f64 * part).round() as usize];
            let [low, middle, high] = [0.05, 0.5, 0.95].map(quantile);
            println!("{name:28} {which:7} {low:+.5} {middle:+.5} {high:+.5} {unit}");
        }
    }
    Ok(())
}

/// Flies through a gust from the trimmed state.
fn fly(flight: &mut Flight, trimmed: &[u8], gust: &Gust) -> Result<Extremes, FlightError> {
    flight.restore(trimmed)?;
    let mut extremes = [[f64::INFINITY, f64::NEG_INFINITY]; WATCHED.len()];
    for step in 0..STEPS {
        let [wind, rate] = gust.at(STEP * f64::from(step));
        flight.set("wind_down", wind)?;
        flight.set("wind_rate_down", rate)?;
        flight.advance(STEP)?;
        for ([lowest, highest], (name, _)) in extremes.iter_mut().zip(WATCHED) {
            let value = flight.get(name)?;
            (*lowest, *highest) = (lowest.min(value), highest.max(value));
        }
    }
    Ok(extremes)
}

/// Random numbers from a counter (Steele, Lea, Flood 2014): any seed is a good one.
struct SplitMix64(u64);

impl SplitMix64 {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Uniform.
    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

//! A pitch-attitude hold at 100 Hz in a gust, beside the same flight without it.
//!
//! ```sh
//! cargo run --release --example control_law
//! ```
//!
//! The law reads what the aircraft's sensors say now, and the elevator that it commands acts until it reads them again.

use std::error::Error;
use std::f64::consts::PI;

use flexible_aircraft::{Aircraft, Flight, FlightError};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/aircraft/generic-business-jet.toml");

/// Between two readings of the law, s.
const STEP: f64 = 0.01;

/// Of the elevator per pitch angle (1) and per pitch rate (s).
const GAINS: [f64; 2] = [4.0, 2.0];

fn main() -> Result<(), Box<dyn Error>> {
    let mut open = Flight::new(Aircraft::read(FILE)?.reduce()?);
    let mut held = open.clone();
    let pitch = held.get("attitude.pitch")?; // rad
    println!("  time      pitch, open      pitch, held         elevator");
    for step in 0..1000 {
        let time = STEP * f64::from(step);
        let departure = held.get("attitude.pitch")? - pitch;
        let elevator = GAINS[0] * departure + GAINS[1] * held.get("rate.y")?; // positive is nose-down
        held.set("elevator", elevator)?;
        for flight in [&mut open, &mut held] {
            meet_gust(flight, time)?;
            flight.advance(STEP)?;
        }
        if step % 100 == 99 {
            let [open, held] = [open.get("attitude.pitch")? - pitch, held.get("attitude.pitch")? - pitch];
            println!("{:4.1} s {open:+12.6} rad {held:+12.6} rad {elevator:+12.6} rad", time + STEP);
        }
    }
    Ok(())
}

/// Air that rises by up to 10 m/s from 1 s to 3 s, as 1 − cos; its rate is what the apparent mass of the wing feels.
fn meet_gust(flight: &mut Flight, time: f64) -> Result<(), FlightError> {
    let (peak, duration) = (-10.0, 2.0); // m/s, positive downwards; s
    let phase = ((time - 1.0) / duration).clamp(0.0, 1.0);
    flight.set("wind_down", 0.5 * peak * (1.0 - (2.0 * PI * phase).cos()))?;
    flight.set("wind_rate_down", peak * PI / duration * (2.0 * PI * phase).sin())
}

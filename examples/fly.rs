//! Flies the jet by the names of its variables through a pulse of the elevator, and prints what it does.
//!
//! ```sh
//! cargo run --release --example fly
//! ```

use std::error::Error;

use flexible_aircraft::variables::Unit;
use flexible_aircraft::{Aircraft, Flight};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/aircraft/generic-business-jet.toml");

fn main() -> Result<(), Box<dyn Error>> {
    let mut flight = Flight::new(Aircraft::read(FILE)?.reduce()?);
    flight.set("airspeed", 140.0)?; // m/s
    flight.set("stiffness_scale", 0.3)?;
    println!("{} variables, of which", flight.variables().iter().count());
    for name in ["trim.pitch", "trim.elevator", "trim.thrust", "deflection.wing_tip_right.up"] {
        print(&mut flight, name)?;
    }
    for half_second in 0..8 {
        flight.set("elevator", if half_second < 3 { -0.02 } else { 0.0 })?; // rad about the trim, nose-up
        flight.advance(0.5)?; // s
        println!("after {} s", flight.time());
        for name in ["attitude.pitch", "load_factor.z", "deflection.wing_tip_right.up"] {
            print(&mut flight, name)?;
        }
    }
    Ok(())
}

/// Prints a variable with its value, unit and description.
fn print(flight: &mut Flight, name: &str) -> Result<(), Box<dyn Error>> {
    let value = flight.get(name)?;
    let variable = flight.variables().named(name).ok_or("no such variable")?;
    let unit = variable.unit.filter(|unit| *unit != Unit::One).map_or("", Unit::name);
    println!("    {name:28} {value:12.6} {unit:3}  {}", variable.description);
    Ok(())
}

//! Flight high up and on days that are warmer or colder than the standard: what density and speed of sound make of it.

use std::sync::Arc;

use flexible_aircraft::air::Air;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{Outputs, PlantSettings};
use flexible_aircraft::structure::ReducedModel;

use crate::support::jet;

use super::record::Record;

/// What an aircraft has in level flight, and its trim: pitch, elevator, thrust.
fn flown(
    model: &Arc<ReducedModel>,
    fidelity: Fidelity,
    change: impl FnOnce(&mut PlantSettings),
) -> (Outputs, [f64; 3]) {
    let mut settings = PlantSettings { fidelity, mode_count: 6, ..PlantSettings::of(model) };
    change(&mut settings);
    let mut flight = Simulation::new(Arc::clone(model), &Settings::from(settings), 0.0).unwrap();
    let trim = flight.trim();
    let point = [trim.pitch, trim.pitch_control, trim.thrust];
    (flight.outputs().clone(), point)
}

/// The altitude at which the standard atmosphere has a density, m.
fn altitude_of(density: f64) -> f64 {
    let (mut low, mut high) = (-1000.0, 30_000.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if Air::at(middle).density > density { low = middle } else { high = middle }
    }
    low
}

#[test]
fn a_warm_day_is_flown_as_the_standard_one_where_the_air_has_its_density() {
    let mut record = Record::new(
        "warm-day",
        "The jet trimmed at 7620 m in air that is warmer or colder than the standard",
        "the trim of the standard atmosphere at the altitude where that has the same density, for loads know density alone; \
         the Mach number by √T",
    );
    for (fidelity, offset) in [(Fidelity::Exact, 30.0), (Fidelity::GeometricallyExact, -45.0)] {
        let (warm, trim) = flown(&jet(), fidelity, |settings| settings.temperature_offset = offset);
        let standard = Air::at(7620.0);
        let density = standard.density * standard.temperature / (standard.temperature + offset);
        let altitude = altitude_of(density);
        let (there, expected) = flown(&jet(), fidelity, |settings| settings.altitude = altitude);
        let case = |what: &str| format!("{}, {offset:+} K: {what}", fidelity.name().replace('_', " "));
        let names = ["pitch (rad)", "elevator (rad)", "thrust (N)"];
        for ((name, expected), found) in names.into_iter().zip(expected).zip(trim) {
            record.relative(&case(name), expected, 1e-9, found);
        }
        let mach =
            there.air.mach * libm::sqrt(Air::at(altitude).temperature / (standard.temperature + offset));
        record.relative(&case("Mach number"), mach, 1e-12, warm.air.mach);
        record.relative(&case("density (kg/m³)"), density, 1e-12, warm.air.density);
    }
    record.finish();
}

#[test]
fn the_highest_flights_are_held_by_the_standards_density() {
    // Where things weigh a quarter, so that it is not too slow.
    let light = Arc::new(ReducedModel { gravity: 2.5, ..(*jet()).clone() });
    let mut record = Record::new(
        "stratosphere",
        "The rigid jet, on a planet of 2.5 m/s², trimmed in the stratosphere at one dynamic pressure",
        "pitch and thrust of the trim at 7620 m; densities at 25 and 30 km from ISO 2533:1975, table 5",
    );
    let (_, [pitch, _, thrust]) = flown(&light, Fidelity::Rigid, |settings| settings.airspeed = 70.0);
    let pressure_speed = 70.0 * libm::sqrt(Air::at(7620.0).density);
    for (altitude, density) in [(25_000.0, 0.0394658), (30_000.0, 0.0180119)] {
        let (outputs, found) = flown(&light, Fidelity::Rigid, |settings| {
            settings.altitude = altitude;
            settings.airspeed = pressure_speed / libm::sqrt(density);
        });
        record.relative(&format!("{altitude} m: pitch (rad)"), pitch, 3e-5, found[0]);
        record.relative(&format!("{altitude} m: thrust (N)"), thrust, 3e-5, found[2]);
        record.relative(
            &format!("{altitude} m: equivalent airspeed (m/s)"),
            pressure_speed / libm::sqrt(1.225),
            3e-5,
            outputs.air.equivalent,
        );
    }
    record.finish();
}

//! A gust where O is: frozen in the air, which carries it, and met by the nose first [theory: gusts.field].

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use flexible_aircraft::air::{GustSettings, TurbulenceSettings};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::{Aircraft, ReducedModel};
use nalgebra::{UnitQuaternion, Vector3};

use crate::support::jet;

use super::gusts::{flight, gust};
use super::record::Record;

/// The velocity of a 1-cosine gust with its whole peak along the track, m/s, at a distance from where it begins, m.
fn along_the_track(gust: &GustSettings, s: f64) -> f64 {
    let inside = s > 0.0 && s < 2.0 * gust.gradient;
    if inside { 0.5 * gust.peak * (1.0 - (PI * s / gust.gradient).cos()) } else { 0.0 }
}

#[test]
fn what_is_frozen_in_the_air_goes_with_it_and_is_read_where_o_is() {
    let mut record = Record::new(
        "gust-field",
        "A gust along the track in a wind that grows, heading 0.7 rad, and one that meets a wing in a tunnel: wind.* and air.* at O (m/s)",
        "the gust's own formula at O's place; x_nose of the jet 10.4143 m from an independent computation",
    );
    let heading = 0.7_f64;
    let track = Vector3::new(heading.cos(), heading.sin(), 0.0);
    let single = GustSettings { inclination: FRAC_PI_2, ..gust(40.0) };
    let mut settings = flight(1.0, single, TurbulenceSettings::default());
    settings.plant.heading = heading;
    let mut simulation = Simulation::new(jet(), &settings, 0.0).unwrap();
    let (mut inputs, mut rates) = (Inputs::zero(&jet()), Inputs::zero(&jet()));
    // A wind from behind to the right, m/s, m/s² and m/s³.
    let (wind, rate, change) =
        (Vector3::new(4.0, -3.0, 0.5), Vector3::new(2.0, 1.0, -0.5), Vector3::new(-0.6, 0.8, 0.0));
    (inputs.wind, inputs.wind_rate, rates.wind_rate) = (wind, rate, change);
    simulation.set_inputs(&inputs, &rates);
    let begin = simulation.outputs().position;
    let [mut of_wind, mut of_speed, mut blown] = [0.0_f64; 3];
    for step in 1..=150 {
        let time = 0.01 * f64::from(step);
        simulation.advance_to(time).unwrap();
        let found = simulation.outputs();
        let drift = wind * time + rate * (time * time / 2.0) + change * (time * time * time / 6.0);
        let s = track.dot(&(found.position - begin - drift)) - (127.0 * single.start + 10.4143);
        let gust = along_the_track(&single, s);
        let expected = wind + rate * time + change * (time * time / 2.0) + track * gust;
        of_wind = of_wind.max((found.wind - expected).norm());
        let to_earth =
            UnitQuaternion::from_euler_angles(found.attitude.x, found.attitude.y, found.attitude.z);
        of_speed = of_speed.max((found.air.speed - (to_earth * found.velocity - found.wind).norm()).abs());
        blown = blown.max(gust);
        assert_eq!(found.gust_peak_velocity, 10.0);
    }
    assert!(blown > 9.9);
    // x_nose is printed to 5e-5 m, and the gust grows by 0.4 m/s a metre.
    record.rounding("jet: wind", 4e-5, of_wind);
    record.rounding("jet: air.speed", 1e-11, of_speed);
    let [wind, speed] = tunnel_gust();
    record.rounding("yawed wing in a tunnel: wind", 1e-11, wind);
    record.rounding("yawed wing in a tunnel: air.speed", 1e-11, speed);
    record.finish();
}

/// Largest differences of the wind and of the airspeed at O from the formula's, m/s, of a wing that is mounted with a yaw of
/// 0.4 rad in a tunnel along a heading of 0.3 rad.
fn tunnel_gust() -> [f64; 2] {
    let (heading, yaw) = (0.3_f64, 0.4);
    let mut aircraft =
        Aircraft::read(concat!(env!("CARGO_MANIFEST_DIR"), "/aircraft/goland-wing.toml")).unwrap();
    aircraft.mount = Vector3::new(0.0, 0.0, yaw);
    let wing = Arc::new(ReducedModel::new(&aircraft, 4).unwrap());
    let single = GustSettings { inclination: FRAC_PI_2, ..gust(20.0) };
    let plant = PlantSettings { heading, airspeed: 60.0, ..PlantSettings::of(&wing) };
    let mut simulation =
        Simulation::new(Arc::clone(&wing), &Settings { gust: single, ..plant.into() }, 0.0).unwrap();
    // The tunnel's flow comes along the heading; the foremost edge along it meets the gust first.
    let ahead = Vector3::new(yaw.cos(), -yaw.sin(), 0.0);
    let edges = wing.strips.iter().map(|strip| {
        ahead.dot(&(strip.position + strip.forward * (strip.elastic_axis_aft_of_midchord + strip.semichord)))
    });
    let nose = edges.fold(f64::NEG_INFINITY, f64::max);
    let track = Vector3::new(heading.cos(), heading.sin(), 0.0);
    let mut apart = [0.0_f64; 2];
    for step in 1..=150 {
        let time = 0.01 * f64::from(step);
        simulation.advance_to(time).unwrap();
        let found = simulation.outputs();
        let gust = along_the_track(&single, 60.0 * (time - single.start) - nose);
        apart[0] = apart[0].max((found.wind - track * (gust - 60.0)).norm());
        apart[1] = apart[1].max((found.air.speed - (60.0 - gust)).abs());
    }
    apart
}

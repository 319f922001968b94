//! What is measured of an aircraft of the fleet.

use std::f64::consts::{LN_2, TAU};
use std::sync::Arc;

use flexible_aircraft::air::Air;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::{LimitExceeded, Plant, PlantSettings};
use flexible_aircraft::structure::{ModeFamily, ReducedModel};
use flexible_aircraft::symmetry::Plants;
use flexible_aircraft::{Aircraft, Flight};

use super::{CLEARANCE, Entry, MACH, MODES, SPIRAL_DOUBLES};

/// Airspeeds at which all roots of the linearised motion are looked at.
const AIRSPEEDS: u32 = 12;

/// Roots of position and heading are 0 but for rounding, 1/s.
const MARGINAL: f64 = 1e-6;

/// How often the outputs of flights are looked at, s.
const STEP: f64 = 0.02;

/// All of it.
pub struct Measured {
    /// m, m² and kg.
    pub span: f64,
    pub area: f64,
    pub mass: f64,
    /// Trimmed, m/s and m.
    pub airspeed: f64,
    pub altitude: f64,
    pub static_margin: f64,
    /// Of the trim, rad; of the control with the role of pitch.
    pub angle_of_attack: f64,
    pub pitch_control: f64,
    /// Of each engine, N; without engines none.
    pub thrust: Option<f64>,
    /// Of the path, rad.
    pub climb_angle: f64,
    /// Of the structure held at O: Hz, and whether symmetric.
    pub modes: Vec<(f64, bool)>,
    /// m/s, up to which nothing flutters.
    pub flutter_free: f64,
    /// Doubling of the spiral that grows fastest, s.
    pub spiral_doubles: Option<f64>,
    /// The level of the file and the other.
    pub levels: [Fidelity; 2],
    /// At both levels.
    pub trims: [Watched; 2],
    pub gusts: [Watched; 2],
    pub doublets: [Watched; 2],
}

/// In a trim, or how far each swings in a flight: from the least to the greatest.
#[derive(Clone, Copy)]
pub struct Watched {
    /// Of the right wing's, m.
    pub tip_up: f64,
    /// rad.
    pub pitch: f64,
    pub load_factor: f64,
    /// N m.
    pub bending: f64,
}

impl Measured {
    pub fn of(entry: &Entry, aircraft: &Aircraft) -> Self {
        let model = Arc::new(ReducedModel::new(aircraft, MODES).unwrap());
        let settings = PlantSettings { mode_count: MODES, ..PlantSettings::of(&model) };
        let plants = Plants::under(&model, &settings).unwrap();
        let found = plants.trim(&settings.trim_condition()).unwrap();
        let plant = plants.half().expect("a mirror plane");
        let trim = found.trim();
        let exceeded = LimitExceeded::find(&model.limits, plant, trim);
        assert!(exceeded.is_empty(), "{:?}", LimitExceeded::warning(&exceeded, &model, &settings));
        let lengths = aircraft.reference_lengths().expect("a wing");
        let stability = plant.static_stability(trim).unwrap_or_else(|error| panic!("{error}"));
        let levels = [model.fidelity, entry.other_level];
        let at_both = |fly: &dyn Fn(Fidelity) -> Watched| levels.map(fly);
        Measured {
            span: lengths.span,
            area: lengths.area,
            mass: aircraft.bays.iter().map(|bay| bay.mass).sum(),
            airspeed: settings.airspeed,
            altitude: settings.altitude,
            static_margin: stability.margin(lengths.chord),
            angle_of_attack: trim.point.angle_of_attack(),
            pitch_control: trim.point.pitch_control,
            thrust: (!model.engines.is_empty()).then_some(trim.point.thrust),
            climb_angle: trim.point.climb_angle,
            modes: model
                .modes
                .iter()
                .map(|mode| (mode.angular_frequency / TAU, mode.family == ModeFamily::Symmetric))
                .collect(),
            flutter_free: CLEARANCE * entry.maximum_speed,
            spiral_doubles: flutter_free(entry, &model, &settings),
            levels,
            trims: at_both(&|level| trimmed(&mut begun(&model, level), entry.cut)),
            gusts: at_both(&|level| gust(entry, &model, level)),
            doublets: at_both(&|level| doublet(entry, &model, level)),
        }
    }
}

/// Asserts that no root grows at any of the airspeeds from the trim's to beyond the maximum, but for a spiral that does so slowly; says how long the fastest takes to
/// double, s.
fn flutter_free(entry: &Entry, model: &ReducedModel, settings: &PlantSettings) -> Option<f64> {
    let (from, to) = (settings.airspeed, CLEARANCE * entry.maximum_speed);
    let mach = to / Air::at(settings.altitude).speed_of_sound;
    assert!(mach < MACH, "{}: {to} m/s is Mach {mach}", entry.name);
    let mut fastest = 0.0_f64;
    for point in 0..AIRSPEEDS {
        let airspeed = from + (to - from) * f64::from(point) / f64::from(AIRSPEEDS - 1);
        let settings = PlantSettings { airspeed, ..*settings };
        let plant = Plant::under(model, &settings).unwrap();
        let trim = plant.trim(&settings.trim_condition()).unwrap_or_else(|error| panic!("{error}"));
        for root in plant.linearise(&trim).eigenvalues().unwrap_or_else(|error| panic!("{error}")) {
            let is_stable = root.re <= MARGINAL;
            let is_spiral = root.im == 0.0 && root.re <= LN_2 / SPIRAL_DOUBLES;
            assert!(is_stable || is_spiral, "{}: a root of {root} 1/s at {airspeed} m/s", entry.name);
            fastest = fastest.max(root.re);
        }
    }
    (fastest > MARGINAL).then_some(LN_2 / fastest)
}

fn begun(model: &Arc<ReducedModel>, level: Fidelity) -> Flight {
    let mut flight = Flight::new(Arc::clone(model));
    flight.set("model", level.name()).unwrap();
    flight.set("mode_count", MODES as i32).unwrap();
    flight
}

fn trimmed(flight: &mut Flight, cut: &str) -> Watched {
    let mut get = |name: &str| flight.get(name).unwrap_or_else(|error| panic!("{error}"));
    Watched {
        tip_up: get("deflection.wing_tip_right.up"),
        pitch: get("attitude.pitch"),
        load_factor: get("load_factor.z"),
        bending: get(&format!("loads.{cut}.bending")),
    }
}

/// Trims of an aircraft at some levels.
pub fn trims<const N: usize>(aircraft: &Aircraft, levels: [Fidelity; N]) -> [Watched; N] {
    let model = Arc::new(ReducedModel::new(aircraft, MODES).unwrap());
    levels.map(|level| trimmed(&mut begun(&model, level), "wing_root_right"))
}

fn gust(entry: &Entry, model: &Arc<ReducedModel>, level: Fidelity) -> Watched {
    let mut flight = begun(model, level);
    let [gradient, peak] = entry.flights.gust;
    flight.set("gust.shape", "one_minus_cosine").unwrap();
    flight.set("gust.gradient", gradient).unwrap();
    flight.set("gust.peak", peak).unwrap();
    flight.set("gust.start", 0.2).unwrap();
    swings(entry, &mut flight, |_, _| ())
}

fn doublet(entry: &Entry, model: &Arc<ReducedModel>, level: Fidelity) -> Watched {
    let [amplitude, length] = entry.flights.doublet;
    swings(entry, &mut begun(model, level), |flight, time| {
        let angle = match time - 0.2 {
            since if since < 0.0 => 0.0,
            since if since < length => -amplitude,
            since if since < 2.0 * length => amplitude,
            _ => 0.0,
        };
        flight.set("elevator", angle).unwrap();
    })
}

/// Flies, and takes how far each quantity swings.
fn swings(entry: &Entry, flight: &mut Flight, steer: impl Fn(&mut Flight, f64)) -> Watched {
    let mut history = vec![trimmed(flight, entry.cut)];
    for step in 0..(entry.flights.duration / STEP).round() as usize {
        steer(flight, step as f64 * STEP);
        flight.advance(STEP).unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        history.push(trimmed(flight, entry.cut));
    }
    let swing = |of: fn(&Watched) -> f64| {
        let ends = history
            .iter()
            .map(of)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], now| [low.min(now), high.max(now)]);
        ends[1] - ends[0]
    };
    Watched {
        tip_up: swing(|watched| watched.tip_up),
        pitch: swing(|watched| watched.pitch),
        load_factor: swing(|watched| watched.load_factor),
        bending: swing(|watched| watched.bending),
    }
}

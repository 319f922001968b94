//! A clamped wing in a wind tunnel: no rigid-body motion, the air moves.

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Support};
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::{Plant, PlantSettings};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::VariableTable;
use nalgebra::Vector3;

use crate::support::jet;

use super::record::Record;

/// A uniform half wing of 6 m, elastic axis and centre of mass at mid-chord.
const WING: &str = r#"
format = 1
name = "Half wing"
gravity_m_s2 = 0.0
support = "clamped"
mode_basis = "bending_torsion"
model = "exact"

[[component]]
name = "wing"
attached_to = "origin"
axis_m = [[0.0, 0.0, 0.0], [0.0, 6.0, 0.0]]
elements = 12
y_axis = [1.0, 0.0, 0.0]
EA_N = 1e9
GJ_N_m2 = 1e5
EI_y_N_m2 = 1e5
EI_z_N_m2 = 4e6
chord_m = 1.0

[[component.distributed_mass]]
parts = [{ total_kg = 60.0, chord_power = 0.0 }]
gyration_chords = [0.01, 0.3, 0.3]

[[component.surface]]
elastic_axis = 0.5
lift_slope_per_rad = 6.283185307179586
profile_drag = 0.0
incidence_deg = 2.0

[[station]]
name = "tip"
component = "wing"
at = 1.0
"#;

fn wing() -> Arc<ReducedModel> {
    wing_in("")
}

/// The wing, with more said about its tunnel.
fn wing_in(tunnel: &str) -> Arc<ReducedModel> {
    let text = WING.replace("support = \"clamped\"", &format!("support = \"clamped\"\n{tunnel}"));
    let text = if tunnel.contains("gravity") { text.replacen("gravity_m_s2 = 0.0\n", "", 1) } else { text };
    Arc::new(ReducedModel::new(&Aircraft::parse(&text, "wing.toml").unwrap(), 6).unwrap())
}

/// Where displacements of the modes superpose, and where their strains do.
const LEVELS: [Fidelity; 2] = [Fidelity::Exact, Fidelity::GeometricallyExact];

fn settings(fidelity: Fidelity, airspeed: f64) -> Settings {
    let usual = PlantSettings::of(&wing());
    Settings::from(PlantSettings { fidelity, airspeed, altitude: 0.0, mode_count: 6, ..usual })
}

#[test]
fn the_clamped_wing_stands_still_bends_up_and_shows_the_tunnels_flow() {
    LEVELS.into_iter().for_each(stands_still_at);
}

fn stands_still_at(fidelity: Fidelity) {
    let mut flight = Simulation::new(wing(), &settings(fidelity, 20.0), 0.0).unwrap();
    flight.advance_to(5.0).unwrap();
    let outputs = flight.outputs();
    assert_eq!(outputs.position.x, 0.0);
    assert_eq!((outputs.velocity.norm(), outputs.rate.norm(), outputs.acceleration.norm()), (0.0, 0.0, 0.0));
    assert!((outputs.air.speed - 20.0).abs() < 1e-12 && outputs.air.angle_of_attack.abs() < 1e-12);
    assert!(-outputs.deflections[0].displacement.z > 0.0);
    assert!(outputs.deflections[0].twist > 0.0);
}

#[test]
fn static_twist_is_that_of_the_divergence_problem() {
    // Bisplinghoff, Ashley, Halfman, Aeroelasticity (1955), §8-2: a uniform wing under strip theory with its
    // aerodynamic centre a distance e ahead of the elastic axis twists by α₀ (1/cos λl − 1) at the tip,
    // λ² = q c e CLα / GJ. Six modes of a wing without bending–torsion coupling hold three of torsion.
    let (speed, length, chord) = (25.0, 6.0, 1.0);
    let pressure = 0.5 * 1.225 * speed * speed;
    let lambda = libm::sqrt(pressure * chord * 0.25 * std::f64::consts::TAU / 1e5);
    let expected = f64::to_radians(2.0) * (1.0 / libm::cos(lambda * length) - 1.0);
    let twist = |fidelity| {
        let mut flight = Simulation::new(wing(), &settings(fidelity, speed), 0.0).unwrap();
        flight.outputs().deflections[0].twist
    };
    let mut record = Record::new(
        "divergence",
        "Static tip twist of a uniform wing near divergence, rad",
        "α₀ (1/cos λl − 1), λ² = qceCLα/GJ: Bisplinghoff, Ashley, Halfman, *Aeroelasticity* (1955), §8-2; \
         three torsion modes carry the twist",
    );
    record.relative("25 m/s at sea level, λl = 0.85", expected, 0.02, twist(Fidelity::Exact));
    record.relative("the same, GE", expected, 0.02, twist(Fidelity::GeometricallyExact));
    record.finish();
}

#[test]
fn a_gust_shakes_the_wing_and_it_settles_again() {
    LEVELS.into_iter().for_each(a_gust_shakes_the_wing_at);
}

fn a_gust_shakes_the_wing_at(fidelity: Fidelity) {
    let mut flight = Simulation::new(wing(), &settings(fidelity, 20.0), 0.0).unwrap();
    let tip = |flight: &mut Simulation| -flight.outputs().deflections[0].displacement.z;
    let steady = tip(&mut flight);
    let calm = Inputs::zero(&wing());
    let mut gust = calm.clone();
    gust.wind.z = -1.0;
    flight.set_inputs(&gust, &calm);
    flight.advance_to(0.2).unwrap();
    let shaken = tip(&mut flight);
    assert!(shaken > 1.2 * steady, "{shaken} {steady}");
    flight.set_inputs(&calm, &calm);
    flight.advance_to(30.0).unwrap();
    assert!((tip(&mut flight) / steady - 1.0).abs() < 1e-3);
}

/// As a linear beam, and as one that keeps its length: the membrane stiffness of the exact level holds it straight.
const BENDING: [Fidelity; 2] = [Fidelity::Inconsistent, Fidelity::GeometricallyExact];

fn at(fidelity: Fidelity, model: &ReducedModel) -> Settings {
    Settings::from(PlantSettings { fidelity, ..PlantSettings::of(model) })
}

/// As a linear beam.
fn linear(model: &ReducedModel) -> Settings {
    at(Fidelity::Inconsistent, model)
}

/// Deflection of the tip at rest, m.
fn tip_at_rest(model: &Arc<ReducedModel>) -> Vector3<f64> {
    let settings = linear(model);
    let mut flight = Simulation::new(Arc::clone(model), &settings, 0.0).unwrap();
    flight.outputs().deflections[0].displacement
}

#[test]
fn a_wing_in_still_air_sags_as_a_beam_does_and_stays_so() {
    BENDING.into_iter().for_each(sags_as_a_beam_does_at);
}

fn sags_as_a_beam_does_at(fidelity: Fidelity) {
    let still = wing_in("airspeed_m_s = 0\naltitude_m = 0\ngravity_m_s2 = 9.81");
    let settings = at(fidelity, &still);
    assert_eq!(settings.plant.airspeed, 0.0);
    let mut flight = Simulation::new(Arc::clone(&still), &settings, 0.0).unwrap();
    let sag = flight.outputs().deflections[0].displacement.z;
    // mgL³/8EI of a uniform cantilever; the air does nothing to it at rest.
    let expected = 60.0 * 9.81 * 216.0 / (8.0 * 1e5);
    assert!((sag / expected - 1.0).abs() < 0.02, "{sag} {expected}");
    flight.advance_to(10.0).unwrap();
    assert!((flight.outputs().deflections[0].displacement.z - sag).abs() < 1e-9);
    assert_eq!((flight.outputs().air.speed, flight.outputs().air.mach), (0.0, 0.0));
}

#[test]
fn a_wing_in_still_air_swings_with_the_mass_of_the_air_around_it() {
    BENDING.into_iter().for_each(swings_with_the_air_at);
}

fn swings_with_the_air_at(fidelity: Fidelity) {
    let still = wing_in("airspeed_m_s = 0\naltitude_m = 0");
    let settings = at(fidelity, &still);
    // First bending: 3.516 √(EI/mL⁴) with m + πρb² in place of m, ρ = 1.225 kg/m³.
    let mass = 60.0 / 6.0 + std::f64::consts::PI * 1.225 * 0.25;
    let expected = 3.5160 * libm::sqrt(1e5 / (mass * 1296.0));
    let equations = Plant::under(&still, &settings.plant).unwrap();
    let matrix = equations.linearise(&equations.trim(&settings.plant.trim_condition()).unwrap());
    let eigenvalues = matrix.eigenvalues().unwrap();
    let first = eigenvalues.iter().filter(|root| root.im > 1.0).min_by(|a, b| a.im.total_cmp(&b.im)).unwrap();
    assert!((first.im / expected - 1.0).abs() < 5e-3, "{first} {expected}");

    // Shaken by a puff of air it swings on at that frequency, in air that now and then comes from behind.
    let mut flight = Simulation::new(Arc::clone(&still), &settings, 0.0).unwrap();
    let puff = |rate: f64| Inputs { wind: Vector3::new(0.0, 0.0, rate), ..Inputs::zero(&still) };
    flight.set_inputs(&Inputs::zero(&still), &puff(-18.0));
    flight.advance_to(0.05).unwrap();
    flight.set_inputs(&puff(-0.9), &puff(18.0));
    flight.advance_to(0.1).unwrap();
    flight.set_inputs(&Inputs::zero(&still), &Inputs::zero(&still));
    let mut crossings = Vec::new();
    let mut before = 0.0;
    for step in 1..=3000 {
        let time = 0.1 + 0.01 * f64::from(step);
        flight.advance_to(time).unwrap();
        let bending = flight.outputs().modal_q[0];
        if before < 0.0 && bending >= 0.0 {
            crossings.push(time - 0.01 * bending / (bending - before));
        }
        before = bending;
    }
    let periods = crossings.len() - 1;
    let frequency = std::f64::consts::TAU * periods as f64 / (crossings[periods] - crossings[0]);
    assert!(periods > 30 && (frequency / first.im - 1.0).abs() < 5e-3, "{periods} {frequency} {first}");
}

#[test]
fn a_free_aircraft_does_not_fly_at_airspeed_zero() {
    let mut free = (*wing()).clone();
    free.support = Support::Free;
    let settings = Settings::from(PlantSettings { airspeed: 0.0, ..settings(Fidelity::Exact, 0.0).plant });
    let error = Simulation::new(Arc::new(free), &settings, 0.0).unwrap_err().to_string();
    assert_eq!(error, "airspeed: found 0, allowed is 1 to 400 (m/s)");
}

#[test]
fn the_air_of_a_tunnel_may_be_given_by_its_density() {
    let standard = wing_in("airspeed_m_s = 20\naltitude_m = 0");
    let given = wing_in("airspeed_m_s = 20\ndensity_kg_m3 = 1.225\ntemperature_K = 300");
    let thick = wing_in("airspeed_m_s = 20\ndensity_kg_m3 = 2.45");
    let [usual, same, double] = [&standard, &given, &thick].map(|model| tip_at_rest(model).z);
    assert!((same / usual - 1.0).abs() < 1e-5 && double / usual > 2.0, "{usual} {same} {double}");

    let outputs = |model: &Arc<ReducedModel>| {
        let mut flight = Simulation::new(Arc::clone(model), &Settings::of(model), 0.0).unwrap();
        flight.outputs().air
    };
    let (warm, thick_air) = (outputs(&given), outputs(&thick));
    // √(1.4 · 287.05287 · T): 347.221 m/s at 300 K, 340.294 at 288.15 K.
    assert!(
        (warm.mach * 347.220687 / 20.0 - 1.0).abs() < 1e-6
            && (thick_air.mach * 340.294 / 20.0 - 1.0).abs() < 1e-6
    );
    assert_eq!((warm.density, thick_air.density), (1.225, 2.45));
    assert!((thick_air.dynamic_pressure / 490.0 - 1.0).abs() < 1e-14);

    let has_altitude = |model: &ReducedModel| VariableTable::new(model).reference("altitude").is_some();
    assert!(has_altitude(&standard) && !has_altitude(&given));
    let restored = ReducedModel::from_bytes(&given.to_bytes()).unwrap();
    assert_eq!(restored.tunnel_air, given.tunnel_air);
}

#[test]
fn the_mount_turns_gravity_and_the_flow_about_the_wing() {
    let mounted = |mount: &str| {
        tip_at_rest(&wing_in(&format!(
            "airspeed_m_s = 0\naltitude_m = 0\ngravity_m_s2 = 9.81\nmount_attitude_deg = {mount}"
        )))
    };
    let level = mounted("[0, 0, 0]");
    // Upside down it bends the other way; stood on its root or hung from it, hardly at all; on its nose, forwards.
    let upside_down = mounted("[180, 0, 0]");
    assert!((upside_down + level).norm() < 1e-3 * level.norm(), "{level} {upside_down}");
    assert!(mounted("[-90, 0, 0]").z.abs() < 1e-9 && mounted("[90, 0, 0]").z.abs() < 1e-9);
    let nose_down = mounted("[0, -60, 0]");
    // EI_z is 40 EI_y.
    assert!((nose_down.z / level.z - 0.5).abs() < 1e-3, "{nose_down}");
    assert!((nose_down.x / level.z - libm::sin(f64::to_radians(60.0)) / 40.0).abs() < 1e-3, "{nose_down}");

    // Pitched in the tunnel's flow it has that incidence, as if the file had given it to its sections.
    let pitched = wing_in("airspeed_m_s = 20\naltitude_m = 0\nmount_attitude_deg = [0, 3, 0]");
    let mut flight = Simulation::new(Arc::clone(&pitched), &linear(&pitched), 0.0).unwrap();
    assert_eq!(flight.trim().pitch, f64::to_radians(3.0));
    let outputs = flight.outputs();
    assert!((outputs.air.angle_of_attack - f64::to_radians(3.0)).abs() < 1e-14);
    assert!((outputs.attitude.y - f64::to_radians(3.0)).abs() < 1e-14 && outputs.acceleration.norm() == 0.0);
    let set = WING.replace("incidence_deg = 2.0", "incidence_deg = 5.0");
    let set = Arc::new(ReducedModel::new(&Aircraft::parse(&set, "wing.toml").unwrap(), 6).unwrap());
    let by_sections = Settings::from(PlantSettings { airspeed: 20.0, altitude: 0.0, ..linear(&set).plant });
    let mut level = Simulation::new(set, &by_sections, 0.0).unwrap();
    let (twist, expected) = (outputs.deflections[0].twist, level.outputs().deflections[0].twist);
    assert!((twist / expected - 1.0).abs() < 2e-3, "{twist} {expected}");
}

#[test]
fn an_aircraft_that_hangs_askew_does_not_fly_as_half_of_itself() {
    let is_half = |mount: Vector3<f64>| {
        let model = ReducedModel { support: Support::Clamped, mount, ..(*jet()).clone() };
        let settings = Settings::from(PlantSettings { airspeed: 60.0, ..PlantSettings::of(&model) });
        let mut flight = Simulation::new(Arc::new(model), &settings, 0.0).unwrap();
        flight.advance_to(0.05).unwrap();
        (flight.is_symmetric(), flight.outputs().attitude)
    };
    assert!(is_half(Vector3::zeros()).0);
    let (half, attitude) = is_half(Vector3::new(0.0, 0.1, 0.0));
    assert!(half && (attitude.y - 0.1).abs() < 1e-15);
    for mount in [Vector3::new(0.2, 0.0, 0.0), Vector3::new(0.0, 0.0, 0.1)] {
        let (half, attitude) = is_half(mount);
        assert!(!half && (attitude - mount).amax() < 1e-15, "{attitude}");
    }
}

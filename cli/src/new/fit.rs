//! What rules do not say is found with the library: the file is written, read, trimmed, and written again, until the wing has
//! its frequency, the aircraft its static margin, the body is level and the elevator at rest.

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::{
    ModalBasis, ModeCount, ModeFamily, ModeKind, ModeMotion, ReducedModel, Structure,
};
use flexible_aircraft::symmetry::Plants;

use super::basis::{Basis, Unknowns};
use super::build;
use super::failure::Failure;
use super::kind::Kind;
use super::planform::flap_share;
use super::quantity::STATIC_MARGIN;
use super::sizing::Sizing;
use super::tails::{HINGE, kept_lift};
use super::text;
use crate::describe::modes::{self, NaturalMode};
use crate::numbers::fixed;

/// An aircraft file, and what was found of it.
pub struct Fitted {
    pub text: String,
    pub found: Found,
}

/// What the library says of a file.
pub struct Found {
    /// First bending of the wing, Hz.
    pub frequency: f64,
    /// None of what is clamped.
    pub flight: Option<Flight>,
}

/// A trimmed flight.
pub struct Flight {
    /// In mean aerodynamic chords.
    pub margin: f64,
    /// The mean aerodynamic chord, m.
    chord: f64,
    /// By the payload's.
    mass_ratio: f64,
    /// Angle of attack, control for pitch, path, degrees.
    pub angle_of_attack: f64,
    pub elevator: f64,
    pub climb: f64,
    /// Of each engine, N.
    pub thrust: f64,
}

/// How near is near enough: frequency by the one asked for, static margin, degrees.
const FREQUENCY: f64 = 2e-3;
const MARGIN: f64 = 5e-3;
const ANGLE: f64 = 0.1;

/// Rounds of the search; the shipped rules need 4 to 8.
const MOST_ROUNDS: usize = 30;

/// Natural modes beside the one that is looked for: engines and tails have some below.
const MODES: usize = 12;

/// How a wing's zero-lift moment moves its elevons, per degree: the search begins with this and finds its own.
const MOMENT_PER_DEGREE: f64 = 0.008;

/// No aerofoil has a greater zero-lift moment: elevons that need it do nothing.
const MOST_MOMENT: f64 = 0.5;

/// A surface that stands at a greater angle stalls, degrees: a search that comes there finds nothing.
const MOST_INCIDENCE: f64 = 30.0;

impl Found {
    /// For people.
    pub fn told(&self) -> String {
        let bending = format!("first bending of the wing {} Hz", fixed(self.frequency, 3));
        let Some(flight) = &self.flight else { return bending };
        format!(
            "{bending}, static margin {}, angle of attack {} deg, elevator {} deg",
            fixed(flight.margin, 3),
            fixed(flight.angle_of_attack, 1),
            fixed(flight.elevator, 1)
        )
    }
}

/// Finds it all.
///
/// # Errors
/// When it cannot be found.
pub fn fit(name: &str, sizing: &Sizing) -> Result<Fitted, Failure> {
    let mut unknowns = Unknowns::first(sizing);
    let mut slope = Slope { latest: None, value: MOMENT_PER_DEGREE };
    let mut latest = String::new();
    for _ in 0..MOST_ROUNDS {
        let basis = Basis::new(sizing, unknowns);
        let text = text::file(name, sizing, &build::design(&basis));
        let found = look(&text, &basis)?;
        if is_near(&found, sizing) {
            return Ok(Fitted { text, found });
        }
        latest = found.told();
        improve(&mut unknowns, &found, (&basis, &mut slope));
        check(&unknowns, sizing)?;
    }
    Err(Failure::Restless(latest))
}

/// That what is to be tried next is an aircraft that people would build.
fn check(unknowns: &Unknowns, sizing: &Sizing) -> Result<(), Failure> {
    let Unknowns { incidence, relief, load, .. } = *unknowns;
    let turned = |part, angle: f64| {
        let is_usual = angle.abs() <= MOST_INCIDENCE;
        if is_usual { Ok(()) } else { Err(Failure::Turned { part, angle }) }
    };
    turned("wing", incidence)?;
    match sizing.kind {
        Kind::FlyingWing if relief.is_nan() || relief.abs() > MOST_MOMENT => {
            return Err(Failure::Moment(relief));
        }
        Kind::FlyingWing | Kind::WingOnWall => {}
        _ => turned("tail", relief)?,
    }
    if load.abs() <= sizing.span { Ok(()) } else { Err(Failure::Payload(load)) }
}

fn is_near(found: &Found, sizing: &Sizing) -> bool {
    let is_level = |flight: &Flight| {
        let is_body_level = sizing.kind == Kind::FlyingWing || flight.angle_of_attack.abs() < ANGLE;
        is_body_level && flight.elevator.abs() < ANGLE && (flight.margin - STATIC_MARGIN).abs() < MARGIN
    };
    (found.frequency / sizing.frequency - 1.0).abs() < FREQUENCY && found.flight.as_ref().is_none_or(is_level)
}

/// The next to try.
fn improve(unknowns: &mut Unknowns, found: &Found, (basis, slope): (&Basis, &mut Slope)) {
    let sizing = basis.sizing;
    unknowns.bending *= (sizing.frequency / found.frequency).powi(2);
    let Some(flight) = &found.flight else { return };
    unknowns.load += (STATIC_MARGIN - flight.margin) * flight.chord * flight.mass_ratio;
    if sizing.kind == Kind::FlyingWing {
        unknowns.relief += slope.step(unknowns.relief, flight.elevator);
        return;
    }
    unknowns.incidence += flight.angle_of_attack;
    if let Some(tail) = basis.layout.tail {
        // A flap at rest and its surface turned do what the surface did and its flap turned.
        let sign = if sizing.kind == Kind::Canard { -1.0 } else { 1.0 };
        let by_angle = tail.flap_slope() * flap_share(HINGE) / (tail.lift_slope() * kept_lift(basis));
        // The body will be level: what turned with it turns back.
        unknowns.relief += sign * by_angle * flight.elevator + flight.angle_of_attack;
    }
}

/// How much a number goes up for an angle that goes up by a degree, from the last two that were tried.
struct Slope {
    latest: Option<[f64; 2]>,
    value: f64,
}

impl Slope {
    fn step(&mut self, number: f64, angle: f64) -> f64 {
        if let Some([before, angle_before]) = self.latest {
            let found = (number - before) / (angle - angle_before);
            // Other numbers moved too: nothing is believed that is far from what is usual.
            if found.is_finite() && (0.1 * MOMENT_PER_DEGREE..10.0 * MOMENT_PER_DEGREE).contains(&found) {
                self.value = found;
            }
        }
        self.latest = Some([number, angle]);
        -self.value * angle
    }
}

/// What the library says of a file.
fn look(text: &str, basis: &Basis) -> Result<Found, Failure> {
    let aircraft = Aircraft::parse(text, "the new file").map_err(refused)?;
    let structure = Structure::new(&aircraft).map_err(refused)?;
    let modes = ModalBasis::with(&structure, ModeCount::Usual(MODES), ModeKind::All).map_err(refused)?;
    let motions = ModeMotion::of_modes(&structure, &modes.shapes);
    let model = ReducedModel::of_basis(&structure, modes).map_err(refused)?;
    let settings =
        PlantSettings { mode_count: MODES.min(model.natural_modes()), ..PlantSettings::of(&model) };
    let frequency =
        bending(&modes::name(&aircraft, &model.modes, &motions, &settings)).ok_or(Failure::Unbent(MODES))?;
    let flight = match basis.sizing.kind {
        Kind::WingOnWall => None,
        _ => Some(flight(&aircraft, (&model, &settings), basis)?),
    };
    Ok(Found { frequency, flight })
}

/// Of the first symmetric bending of the wing, as `flexair describe` names it, Hz.
fn bending(modes: &[NaturalMode]) -> Option<f64> {
    let is_it = |mode: &&NaturalMode| {
        mode.motion.starts_with("wing bending") && mode.family != ModeFamily::Antisymmetric
    };
    modes.iter().find(is_it).map(NaturalMode::frequency)
}

fn flight(
    aircraft: &Aircraft,
    (model, settings): (&ReducedModel, &PlantSettings),
    basis: &Basis,
) -> Result<Flight, Failure> {
    let plants = Plants::under(model, settings).map_err(refused)?;
    let trimmed = plants.trim(&settings.trim_condition()).map_err(|_| Failure::NoTrim)?;
    let plant = plants.half().filter(|_| trimmed.form.is_symmetric()).unwrap_or(plants.whole());
    let trim = trimmed.trim();
    let stability = plant.static_stability(trim)?;
    let chord = aircraft.reference_lengths().map_or(basis.sizing.wing.mean_chord(), |lengths| lengths.chord);
    Ok(Flight {
        margin: stability.margin(chord),
        chord,
        mass_ratio: model.integrals.mass / basis.layout.masses.load,
        angle_of_attack: trim.point.angle_of_attack().to_degrees(),
        elevator: trim.point.pitch_control.to_degrees(),
        climb: trim.point.climb_angle.to_degrees(),
        thrust: trim.point.thrust,
    })
}

/// Of rules that are at fault, for what they make is an aircraft.
fn refused(error: impl std::error::Error) -> Failure {
    Failure::Refused(error.to_string())
}

//! What was asked for and what is usual, as the main numbers of an aircraft.

use flexible_aircraft::air::{Air, STANDARD_GRAVITY};

use super::Error;
use super::interview::{self, Choice, Interview};
use super::kind::{Kind, Usual};
use super::planform::Planform;
use super::quantity::{
    AIRSPEED, ALTITUDE, ASPECT_RATIOS, DIHEDRAL, FREQUENCY, FREQUENCY_RATIOS, LIFT_COEFFICIENTS, MASS,
    MOST_MACH, ROOT_CHORD, SPAN, SWEEP, SWEEPS_WITHOUT_TAIL, TAPERS, TIP_CHORD, in_three_digits,
};
use crate::describe::warnings::LOADINGS;
use crate::numbers::short;

/// The main numbers.
pub struct Sizing {
    pub kind: Kind,
    pub usual: Usual,
    /// The right half.
    pub wing: Planform,
    /// m; of a wing on a wall from there to the tip.
    pub span: f64,
    /// Of both halves, m²; of a wing on a wall of the one.
    pub area: f64,
    /// kg.
    pub mass: f64,
    pub engines: usize,
    /// m/s.
    pub airspeed: f64,
    /// m.
    pub altitude: f64,
    /// Hz.
    pub frequency: f64,
    pub choices: Vec<Choice>,
}

/// Why a default is what it is.
const OF_KIND: &str = "usual of the kind";

/// Below this altitude people fly aircraft of a metre of span, m each, and none above the second.
const ALTITUDE_PER_SPAN: f64 = 100.0;
const MOST_ALTITUDE: f64 = 6000.0;

/// Small models are no lighter than this by their wing area, kg/m².
const LEAST_LOADING: f64 = 6.0;

/// Masses stand in the file with four digits: the lightest has a little more than what `flexair check` calls unusual.
const LEAST_MASS_ROOM: f64 = 1.01;

/// Small models are not as stiff as what is built of metal, Hz: our own.
const MOST_FREQUENCY: f64 = 40.0;

/// The usual Mach number is not above this.
const USUAL_MACH: f64 = 0.6;

impl Sizing {
    /// Of what was given, answered, or is usual.
    ///
    /// # Errors
    /// When something is not allowed, by itself or beside the others.
    pub fn new(interview: &mut Interview) -> Result<Self, Error> {
        let kind = interview.kind()?;
        let usual = kind.usual();
        let span = interview.number(&SPAN, (usual.span, OF_KIND.to_owned()))?;
        let halves = if kind == Kind::WingOnWall { 1.0 } else { 2.0 };
        let half_span = span / halves;
        let wing = wing(interview, (kind, &usual, half_span))?;
        let area = halves * half_span * 0.5 * (wing.root_chord + wing.tip_chord);

        // A wing on a wall is that of an aircraft, of whose mass it is a part.
        let part = if kind == Kind::WingOnWall { 0.5 * usual.wing_mass } else { 1.0 };
        let whole_area = 2.0 / halves * area;
        let carried = usual.loading.powf(1.5) * whole_area.powf(1.5) / STANDARD_GRAVITY;
        let carried = carried.max(LEAST_LOADING * whole_area);
        let reason = match kind {
            Kind::WingOnWall => {
                format!("{} of an aircraft with W/S = {} W^(1/3), N and m", short(part), usual.loading)
            }
            _ => format!("W/S = {} W^(1/3), N and m, usual of the kind", usual.loading),
        };
        let because = " with this wing, for 0.5 to 1000 kg/m2 of it (of all of the aircraft)";
        let masses = [LEAST_MASS_ROOM * LOADINGS.start(), *LOADINGS.end()];
        let quantity = MASS.within(masses.map(|loading| part * loading * whole_area), because);
        let mass = interview.number(&quantity, (part * carried, reason))?;
        let engines = interview.engines(&usual.engine_range, usual.engines)?;

        let usual_altitude = (ALTITUDE_PER_SPAN * span).min(MOST_ALTITUDE);
        let reason = format!("{ALTITUDE_PER_SPAN} m for each m of span, up to {MOST_ALTITUDE} m");
        let altitude = interview.number(&ALTITUDE, (usual_altitude, reason))?;
        let lift = mass / part * STANDARD_GRAVITY / whole_area;
        let airspeed = airspeed(interview, (lift, altitude, usual.lift_coefficient))?;

        let frequency = frequency(interview, &usual, 2.0 * half_span)?;
        let choices = std::mem::take(&mut interview.choices);
        Ok(Sizing { kind, usual, wing, span, area, mass, engines, airspeed, altitude, frequency, choices })
    }
}

/// One half of the wing, as wide as that seen from above.
fn wing(interview: &mut Interview, (kind, usual, half_span): (Kind, &Usual, f64)) -> Result<Planform, Error> {
    let [root_chord, tip_chord] = chords(interview, usual, 2.0 * half_span)?;
    let sweeps = match kind {
        Kind::FlyingWing => SWEEP.within(SWEEPS_WITHOUT_TAIL, " of a flying wing, whose tips are its tail"),
        _ => SWEEP,
    };
    let sweep = interview.number(&sweeps, (usual.sweep, OF_KIND.to_owned()))?.to_radians();
    let dihedral = interview.number(&DIHEDRAL, (usual.dihedral, OF_KIND.to_owned()))?.to_radians();
    let aspect_ratio = 4.0 * half_span / (root_chord + tip_chord);
    Ok(Planform { length: half_span / dihedral.cos(), root_chord, tip_chord, sweep, dihedral, aspect_ratio })
}

/// Root and tip chord, of a span of both halves.
fn chords(interview: &mut Interview, usual: &Usual, span: f64) -> Result<[f64; 2], Error> {
    let tip_chord = interview.given.tip_chord;
    let Usual { aspect_ratio, taper, .. } = *usual;
    let from_ratio = format!("aspect ratio {aspect_ratio} and taper {taper}, usual of the kind");
    let from_taper = format!("taper {taper}, usual of the kind");
    let (root, reason) = match tip_chord {
        Some(tip) => (tip / taper, from_taper.clone()),
        None => (2.0 * span / (aspect_ratio * (1.0 + taper)), from_ratio),
    };
    // Of root and tip, m.
    let [least, most] = [ASPECT_RATIOS[1], ASPECT_RATIOS[0]].map(|ratio| 2.0 * span / ratio);
    let ends = [least / (1.0 + 1.0 / TAPERS[0]), most / (1.0 + 1.0 / TAPERS[1])];
    interview::check(&TIP_CHORD.within(ends, " for aspect ratios from 3 to 60 at this span"), tip_chord)?;
    let quantity = match tip_chord {
        None => {
            let ends = [least / (1.0 + TAPERS[1]), most / (1.0 + TAPERS[0])];
            ROOT_CHORD.within(ends, " for aspect ratios from 3 to 60 at this span")
        }
        Some(tip) => {
            let ends = [(tip / TAPERS[1]).max(least - tip), (tip / TAPERS[0]).min(most - tip)];
            ROOT_CHORD
                .within(ends, " beside this tip, for tapers from 0.1 to 1 and aspect ratios from 3 to 60")
        }
    };
    let root = interview.number(&quantity, (root, reason))?;
    let low = (TAPERS[0] * root).max(least - root);
    // At an end of the range both are one number but for its rounding, and what is given was checked.
    let ends = [low.min(tip_chord.unwrap_or(low)), (TAPERS[1] * root).min(most - root).max(low)];
    let quantity = TIP_CHORD.within(ends, " for tapers from 0.1 to 1 and aspect ratios from 3 to 60");
    let tip = interview.number(&quantity, (taper * root, from_taper))?;
    Ok([root, tip])
}

/// The airspeed at which a wing loading, N/m², is carried with a lift coefficient.
fn airspeed(
    interview: &mut Interview,
    (loading, altitude, coefficient): (f64, f64, f64),
) -> Result<f64, Error> {
    let air = Air::at(altitude);
    let at = |coefficient: f64| (2.0 * loading / (air.density * coefficient)).sqrt();
    let [fastest, slowest] = LIFT_COEFFICIENTS.map(at);
    let ends = [slowest, fastest.min(MOST_MACH * air.speed_of_sound)];
    let why = " with this mass and wing, for lift coefficients from 0.1 to 1.3 and Mach numbers up to 0.7";
    let quantity = AIRSPEED.within(ends, why);
    if quantity.allowed.is_empty() {
        let [low, high] =
            [quantity.allowed.start(), quantity.allowed.end()].map(|speed| in_three_digits(*speed));
        return Err(Error::NotAllowed {
            option: "--mass and the wing's area",
            found: format!("{} kg/m2", in_three_digits(loading / STANDARD_GRAVITY)),
            allowed: format!(
                "what flies at this altitude: it would be faster than {low} and slower than {high} m/s"
            ),
        });
    }
    let most = USUAL_MACH * air.speed_of_sound;
    let usual = match at(coefficient) {
        speed if speed > most => (most, format!("Mach {USUAL_MACH}, the most that is usual")),
        speed => (speed, format!("lift coefficient {coefficient}, usual of the kind")),
    };
    interview.number(&quantity, usual)
}

/// Of the wing's first bending, Hz, by the span of both halves, m.
fn frequency(interview: &mut Interview, usual: &Usual, span: f64) -> Result<f64, Error> {
    let by_span = usual.frequency_span / span;
    let quantity = FREQUENCY.within(FREQUENCY_RATIOS.map(|ratio| ratio * by_span), " at this span");
    let usual = if by_span > MOST_FREQUENCY {
        (MOST_FREQUENCY, format!("{MOST_FREQUENCY} Hz, the most that is usual of models"))
    } else {
        (by_span, format!("{} m/s by the span of both halves, usual of the kind", usual.frequency_span))
    };
    interview.number(&quantity, usual)
}

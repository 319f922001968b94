//! Where things are and what they weigh, from the main numbers by rules of conceptual design.

use super::kind::Kind;
use super::planform::Planform;
use super::sizing::Sizing;

/// Sizes of all but the wing.
pub struct Layout {
    /// Of the fuselage ahead of O and behind it, m.
    pub nose: f64,
    pub aft: f64,
    /// Of the fuselage, m.
    pub radius: f64,
    /// Of twin booms from the wing, m.
    pub boom: f64,
    /// One side of a horizontal tail, a V-tail or a canard.
    pub tail: Option<Planform>,
    /// A fin: one of two on booms and of two winglets.
    pub fin: Option<Planform>,
    pub has_pair_of_fins: bool,
    pub masses: Masses,
    /// What sized tail and fin, for people.
    pub tail_rule: String,
}

/// kg.
#[derive(Clone, Copy, Debug, Default)]
pub struct Masses {
    /// Structure of one half of the wing.
    pub wing: f64,
    /// In one half.
    pub fuel: f64,
    /// Structure of the fuselage or pod.
    pub body: f64,
    /// Structure of one boom.
    pub boom: f64,
    /// One side.
    pub tail: f64,
    /// One fin or winglet.
    pub fin: f64,
    /// One engine with its propeller.
    pub engine: f64,
    /// Payload, crew, systems and gear.
    pub load: f64,
}

/// Of a kind: lengths ahead of and behind the wing's mean aerodynamic chord by the span, volume coefficients of tail and fin
/// [Raymer table 6.4: 0.50 and 0.02 of a sailplane, 0.70 and 0.04 of a light single, 0.80 and 0.07 of a light twin, 1.00 and
/// 0.09 of a jet, 5 % less of a T-tail].
struct Proportions {
    nose: f64,
    aft: f64,
    tail_volume: f64,
    fin_volume: f64,
}

/// Of wing area and mean chord, of a canard that lifts its share: its area by the wing's [Raymer §6.5: up to 0.25].
const CANARD_AREA: f64 = 0.15;

/// Of a canard's fin, by one whose arm begins at the wing: our own.
const CANARD_FIN: f64 = 0.75;

/// Length of a fuselage by its diameter: our own, round.
const FINENESS: f64 = 8.0;

/// Aspect ratio and taper of horizontal tails and fins [Raymer table 4.3: 3 to 5 and 0.3 to 0.6, of
/// sailplanes 6 to 10 and 0.3 to 0.5; 1.3 to 2.0 and 0.3 to 0.6,
/// 0.7 to 1.2 and 0.6 to 1.0 under a T-tail], and sweep of fins, rad.
const TAIL: [f64; 2] = [4.5, 0.6];
const TAIL_OF_SAILPLANE: [f64; 2] = [6.0, 0.5];
const FIN: [f64; 2] = [1.6, 0.5];
const FIN_UNDER_TAIL: [f64; 2] = [1.2, 0.7];
const FIN_SWEEP: f64 = 0.5;

/// Aspect ratio that a fin on a body acts with by its own [Raymer §16.4.4].
const FIN_ON_BODY: f64 = 1.55;

/// The wing's, behind the leading edge, chords: in the middle of the box.
pub const ELASTIC_AXIS: f64 = 0.37;

/// Where booms stand on the wing: a node of its elements; and how far behind it their tails are, by the span.
pub const BOOM_PLACE: f64 = 0.3125;
const BOOM_REACH: f64 = 0.42;

/// Winglets by the half span, and their root chord by the tip chord of the wing.
const WINGLET: [f64; 2] = [0.15, 0.9];

/// Structures by the aircraft's mass [Torenbeek §8.4: fuselage 0.08 to 0.12, tails 0.02 to 0.03].
const BODY_MASS: f64 = 0.1;
const POD_MASS: f64 = 0.06;
const BOOM_MASS: f64 = 0.02;
const TAIL_MASS: f64 = 0.02;
const FIN_MASS: f64 = 0.01;

/// All engines by the aircraft's mass [Torenbeek §6.3: 0.16 to 0.20 with pistons, 0.06 to 0.10 of jets].
const ENGINE_MASS: f64 = 0.12;

impl Layout {
    pub fn new(sizing: &Sizing) -> Self {
        let Sizing { kind, ref wing, span, area, .. } = *sizing;
        let Proportions { nose, aft, tail_volume, fin_volume } = proportions(kind);
        let setback = wing.setback();
        let mut layout = Layout {
            nose: (nose * span - setback).max(0.5 * nose * span),
            aft: (aft * span + setback).max(0.5 * aft * span),
            radius: 0.0,
            boom: 0.0,
            tail: None,
            fin: None,
            has_pair_of_fins: matches!(kind, Kind::FlyingWing | Kind::TwinBoom),
            masses: masses(sizing),
            tail_rule: format!(
                "volume coefficients {tail_volume} (tail) and {fin_volume} (fin), Raymer table 6.4"
            ),
        };
        let arm = aft * span;
        let tail_area = tail_volume * wing.mean_chord() * area / arm;
        let fin_area = fin_volume * span * area / arm;
        match kind {
            Kind::Conventional => {
                layout.tail = Some(Planform::of_area(tail_area, TAIL[0], TAIL[1], 2.0));
                layout.fin = Some(fin(fin_area, FIN));
            }
            Kind::TTail | Kind::Sailplane => {
                let [aspect_ratio, taper] = if kind == Kind::Sailplane { TAIL_OF_SAILPLANE } else { TAIL };
                layout.tail = Some(Planform::of_area(tail_area, aspect_ratio, taper, 2.0));
                layout.fin = Some(fin(fin_area, FIN_UNDER_TAIL));
            }
            Kind::VTail => {
                // The area of both, at the angle at which their sides are those of the two. Where lift is less for the wing's
                // downwash, side forces would be too.
                let fin_area = fin_area / wing.kept_behind();
                let tail = Planform::of_area(tail_area + fin_area, TAIL[0], TAIL[1], 2.0);
                layout.tail = Some(Planform { dihedral: (fin_area / tail_area).sqrt().atan(), ..tail });
            }
            Kind::Canard => {
                layout.tail = Some(Planform::of_area(CANARD_AREA * area, 1.6 * TAIL[0], TAIL[1], 2.0));
                // The centre of mass is ahead of the wing.
                layout.fin = Some(fin(CANARD_FIN * fin_area, FIN));
                layout.tail_rule = format!(
                    "canard of {CANARD_AREA} of the wing's area; fin of {CANARD_FIN} of a volume coefficient {fin_volume}, Raymer table 6.4"
                );
            }
            Kind::FlyingWing => {
                layout.nose = 0.45 * wing.root_chord;
                layout.aft = 0.75 * wing.root_chord;
                layout.fin = Some(winglet(wing));
                layout.tail_rule = format!("winglets of {} of the half span", WINGLET[0]);
            }
            Kind::TwinBoom => {
                layout.boom = BOOM_REACH * span + setback - BOOM_PLACE * wing.length * wing.sweep.tan();
                let [tail_area, fin_area] = [tail_area, fin_area].map(|area| area * aft / BOOM_REACH);
                let fin = fin(0.5 * fin_area, FIN);
                let apart = 2.0 * BOOM_PLACE * wing.length * wing.dihedral.cos();
                layout.tail = Some(between_booms(tail_area, apart, fin.length));
                layout.fin = Some(fin);
            }
            Kind::WingOnWall => {}
        }
        layout.radius = match kind {
            Kind::FlyingWing => 0.12 * wing.root_chord,
            _ => 0.5 * (layout.nose + layout.aft) / FINENESS,
        };
        layout
    }
}

impl Layout {
    /// Of all tails, fins and winglets, m².
    pub fn area_of_tails(&self) -> f64 {
        let fins = if self.has_pair_of_fins { 2.0 } else { 1.0 };
        let area = |planform: Option<Planform>| planform.map_or(0.0, |planform| planform.area());
        2.0 * area(self.tail) + fins * area(self.fin)
    }
}

fn proportions(kind: Kind) -> Proportions {
    let of = |nose, aft, tail_volume, fin_volume| Proportions { nose, aft, tail_volume, fin_volume };
    match kind {
        Kind::Conventional | Kind::VTail => of(0.28, 0.42, 0.7, 0.04),
        Kind::TTail => of(0.5, 0.42, 0.95, 0.085),
        Kind::Canard => of(0.4, 0.18, 0.0, 0.04),
        Kind::TwinBoom => of(0.25, 0.12, 0.8, 0.07),
        Kind::Sailplane => of(0.12, 0.29, 0.5, 0.02),
        Kind::FlyingWing | Kind::WingOnWall => of(0.1, 0.1, 0.0, 0.0),
    }
}

fn fin(area: f64, [aspect_ratio, taper]: [f64; 2]) -> Planform {
    let plain = Planform::of_area(area, aspect_ratio, taper, 1.0);
    Planform {
        sweep: FIN_SWEEP,
        dihedral: std::f64::consts::FRAC_PI_2,
        aspect_ratio: FIN_ON_BODY * aspect_ratio,
        ..plain
    }
}

fn winglet(wing: &Planform) -> Planform {
    let (length, root_chord) = (WINGLET[0] * wing.length, WINGLET[1] * wing.tip_chord);
    let tip_chord = TAIL[1] * root_chord;
    // The wing mirrors it.
    let aspect_ratio = 4.0 * length / (root_chord + tip_chord);
    Planform {
        length,
        root_chord,
        tip_chord,
        sweep: FIN_SWEEP,
        dihedral: std::f64::consts::FRAC_PI_2,
        aspect_ratio,
    }
}

/// One half of a tail of an area, as wide as booms stand apart, between fins of a height.
fn between_booms(area: f64, width: f64, height: f64) -> Planform {
    let chord = area / width;
    Planform {
        length: 0.5 * width,
        root_chord: chord,
        tip_chord: chord,
        sweep: 0.0,
        dihedral: 0.0,
        // The fins hold the flow at its ends [Raymer eq. 12.10, endplates: 1 + 1.9 h/b].
        aspect_ratio: (1.0 + 1.9 * height / width) * width / chord,
    }
}

fn masses(sizing: &Sizing) -> Masses {
    let Sizing { kind, ref usual, mass, engines, .. } = *sizing;
    let has_engines = if engines > 0 { 1.0 } else { 0.0 };
    let (body, boom, tail, fin) = match kind {
        Kind::WingOnWall => return Masses { wing: mass, ..Masses::default() },
        Kind::FlyingWing => (POD_MASS, 0.0, 0.0, 0.5 * FIN_MASS),
        Kind::TwinBoom => (POD_MASS, BOOM_MASS, 0.5 * TAIL_MASS, 0.5 * FIN_MASS),
        Kind::VTail => (BODY_MASS, 0.0, 0.5 * (TAIL_MASS + FIN_MASS), 0.0),
        _ => (BODY_MASS, 0.0, 0.5 * TAIL_MASS, FIN_MASS),
    };
    let fins = if matches!(kind, Kind::FlyingWing | Kind::TwinBoom) { 2.0 } else { 1.0 };
    let fuel = usual.fuel * has_engines;
    let structure = usual.wing_mass + body + 2.0 * (boom + tail) + fins * fin;
    let load = 1.0 - structure - fuel - ENGINE_MASS * has_engines;
    Masses {
        wing: 0.5 * usual.wing_mass * mass,
        fuel: 0.5 * fuel * mass,
        body: body * mass,
        boom: boom * mass,
        tail: tail * mass,
        fin: fin * mass,
        engine: ENGINE_MASS * has_engines * mass / (engines.max(1) as f64),
        load: load * mass,
    }
}

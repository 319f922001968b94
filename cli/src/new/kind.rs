//! Which kinds of aircraft there are, and what is usual of each.
//!
//! Numbers without a source are our own, round, of the middle of what flies. Raymer: Aircraft Design: A Conceptual Approach,
//! AIAA. Torenbeek: Synthesis of Subsonic Airplane Design, Delft.

use std::ops::RangeInclusive;

use clap::ValueEnum;

/// What an aircraft looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Tail at the end of the fuselage, engine in the nose, pairs of engines on the wing
    Conventional,
    /// Tail on top of the fin, a pair of engines at the rear fuselage
    TTail,
    /// Two tails in a V with ruddervators, engine in the nose
    VTail,
    /// Tail ahead of the wing, engine at the rear
    Canard,
    /// Wing with elevons and winglets, engine at the rear
    FlyingWing,
    /// Two booms that carry fins and half a tail each between them, engine at the rear of a pod
    TwinBoom,
    /// Slender wing, T-tail, no engine
    Sailplane,
    /// Half a wing that is clamped to the wall of a wind tunnel
    WingOnWall,
}

/// What is usual of a kind.
pub struct Usual {
    /// For people.
    pub name: &'static str,
    /// m.
    pub span: f64,
    /// b²/S; of a wing on a wall that of both halves.
    pub aspect_ratio: f64,
    /// Tip chord by root chord [Raymer §4.3.3: 0.4 to 0.5 comes close to an elliptic lift, less where the wing is swept].
    pub taper: f64,
    /// Of the quarter-chord line, degrees.
    pub sweep: f64,
    /// Degrees [Raymer table 4.2: 3 to 7 of swept low wings, 5 to 7 of unswept ones, 2 to 4 of mid wings].
    pub dihedral: f64,
    pub engines: usize,
    /// How many there may be.
    pub engine_range: RangeInclusive<usize>,
    /// k of W/S = k W^(1/3), N^(2/3)/m²: the square-cube law along which Tennekes (The Simple Science of Flight, MIT
    /// Press, chapter 1) draws all that flies. 36 lies between a Cessna 172 (30) and a Boeing 747 (45), 27 is a B-2's, 22 that of
    /// a sailplane of the standard class.
    pub loading: f64,
    /// In the flight that it is trimmed for.
    pub lift_coefficient: f64,
    /// Of the whole aircraft by the wing's area [Raymer table 12.3, C_fe S_wet/S: a light single 0.0055 × 4, a jet
    /// 0.0026 × 6; of a sailplane, which has no row there, 0.003 × 3 is our own].
    pub profile_drag: f64,
    /// First bending frequency times span, m/s: 70 is 6.4 Hz of a light single of 11 m and 2 Hz of an airliner of 35 m, 45 is 3 Hz
    /// of a sailplane of 15 m.
    pub frequency_span: f64,
    /// Mass of the structure of the wing by the aircraft's [Torenbeek §8.4: 0.09 to 0.14 of powered aircraft].
    pub wing_mass: f64,
    /// Of fuel in the wing by the aircraft's, where there are engines.
    pub fuel: f64,
}

impl Kind {
    /// Its name on the command line.
    pub fn option(self) -> String {
        self.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned())
    }

    /// All names, for people.
    pub fn options() -> String {
        Kind::value_variants().iter().map(|kind| kind.option()).collect::<Vec<_>>().join(", ")
    }

    /// What is usual of it.
    pub fn usual(self) -> Usual {
        let powered = Usual {
            name: "",
            span: 11.0,
            aspect_ratio: 8.0,
            taper: 0.5,
            sweep: 0.0,
            dihedral: 5.0,
            engines: 1,
            engine_range: 0..=8,
            loading: 36.0,
            lift_coefficient: 0.5,
            profile_drag: 0.022,
            frequency_span: 70.0,
            wing_mass: 0.12,
            fuel: 0.1,
        };
        match self {
            Kind::Conventional => Usual { name: "conventional aircraft", ..powered },
            Kind::TTail => Usual {
                name: "aircraft with a T-tail",
                span: 22.0,
                taper: 0.35,
                sweep: 20.0,
                dihedral: 3.0,
                engines: 2,
                profile_drag: 0.018,
                ..powered
            },
            Kind::VTail => {
                Usual { name: "aircraft with a V-tail", span: 10.0, aspect_ratio: 10.0, ..powered }
            }
            Kind::Canard => {
                Usual { name: "canard aircraft", span: 8.0, sweep: 15.0, dihedral: 2.0, ..powered }
            }
            Kind::FlyingWing => Usual {
                name: "flying wing",
                span: 12.0,
                aspect_ratio: 7.0,
                taper: 0.45,
                sweep: 25.0,
                dihedral: 1.0,
                loading: 27.0,
                lift_coefficient: 0.4,
                profile_drag: 0.012,
                wing_mass: 0.28,
                ..powered
            },
            Kind::TwinBoom => {
                Usual { name: "twin-boom aircraft", aspect_ratio: 9.0, dihedral: 3.0, ..powered }
            }
            Kind::Sailplane => Usual {
                name: "sailplane",
                span: 18.0,
                aspect_ratio: 22.0,
                taper: 0.4,
                dihedral: 3.0,
                engines: 0,
                engine_range: 0..=1,
                loading: 22.0,
                lift_coefficient: 0.7,
                profile_drag: 0.010,
                frequency_span: 45.0,
                wing_mass: 0.36,
                fuel: 0.0,
                ..powered
            },
            Kind::WingOnWall => Usual {
                name: "wing on a wall",
                span: 2.0,
                aspect_ratio: 10.0,
                dihedral: 0.0,
                engines: 0,
                engine_range: 0..=0,
                profile_drag: 0.010,
                fuel: 0.0,
                ..powered
            },
        }
    }
}

//! The expanded aircraft: plain data in body axes, SI units.

use std::ops::RangeInclusive;

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use super::control::Control;
use super::coupling::{Coupling, Hinge};
use super::fidelity::Fidelity;
use super::limits::Limits;

/// Whether the airframe flies or is held at O.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Support {
    /// Free flight: six rigid-body degrees of freedom.
    Free,
    /// Held at O in a wind tunnel: no rigid-body motion, the air moves.
    Clamped,
}

impl Support {
    /// Airspeeds that may be asked for, m/s.
    pub fn airspeeds(self) -> RangeInclusive<f64> {
        match self {
            Support::Free => AIRSPEEDS,
            Support::Clamped => TUNNEL_SPEEDS,
        }
    }
}

/// Air that is the same everywhere, of a wind tunnel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TunnelAir {
    /// ρ, kg/m³.
    pub density: f64,
    /// K.
    pub temperature: f64,
}

/// Which natural modes span the deformation [theory: structure.axially-rigid].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ModeBasis {
    /// Modes of the axially rigid structure: bending and torsion only.
    BendingTorsion,
    /// Modes of the structure as it is, axial ones included.
    Full,
}

/// Airspeeds at which an aircraft may be trimmed, m/s: below, nothing flies; above, air is compressible.
pub const AIRSPEEDS: RangeInclusive<f64> = 1.0..=400.0;

/// Speeds of a wind tunnel's flow, m/s: it may be off.
pub const TUNNEL_SPEEDS: RangeInclusive<f64> = 0.0..=400.0;

/// Altitudes at which an aircraft may be trimmed, m: within the standard atmosphere's three lowest layers.
pub const ALTITUDES: RangeInclusive<f64> = -1000.0..=30_000.0;

/// By how much the air may be warmer than the standard atmosphere, K.
pub const TEMPERATURE_OFFSETS: RangeInclusive<f64> = -60.0..=60.0;

/// Most inflow states of a strip: beyond, the coefficients of the inflow model lose their digits.
pub const MOST_INFLOW_STATES: usize = 8;

/// What the aircraft file gives of reference lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GivenReference {
    /// m.
    pub chord: Option<f64>,
    /// m².
    pub area: Option<f64>,
    /// m.
    pub span: Option<f64>,
}

/// A whole aircraft, expanded. Built by [`Aircraft::read`](super::Aircraft) from an aircraft file.
///
/// ```
/// use flexible_aircraft::Aircraft;
///
/// let wing = Aircraft::read("aircraft/goland-wing.toml")?;
/// let span: f64 = wing.strips.iter().map(|strip| strip.width).sum();
/// assert!((span - 6.096).abs() < 1e-9); // m
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Aircraft {
    /// Name for people.
    pub name: String,
    /// Gravitational acceleration, m/s², down.
    pub gravity: f64,
    /// Free flight or wind tunnel.
    pub support: Support,
    /// Which modes span the deformation.
    pub mode_basis: ModeBasis,
    /// Whether the shapes that static loads give stand beside the natural modes.
    pub load_modes: bool,
    /// The level of fidelity at which it flies unless someone asks for another.
    pub fidelity: Fidelity,
    /// Default number of Peters inflow states per strip, 0…8.
    pub inflow_states: usize,
    /// Airspeed at which it is trimmed unless someone asks for another, m/s.
    pub airspeed: f64,
    /// Altitude at which it is trimmed unless someone asks for another, m.
    pub altitude: f64,
    /// By how much the air is warmer than the standard atmosphere unless someone asks for another number, K; 0 in a tunnel's own air.
    pub temperature_offset: f64,
    /// What the file says of reference lengths; [`reference_lengths`](Aircraft::reference_lengths) are all of them.
    pub reference: GivenReference,
    /// What its trims should stay within.
    pub limits: Limits,
    /// The air around a clamped aircraft; `None`: that of the standard atmosphere at the altitude.
    pub tunnel_air: Option<TunnelAir>,
    /// Roll, pitch and yaw of a clamped aircraft against a level one that heads into the tunnel's flow: 3-2-1 Euler
    /// angles, rad. Zero for a free one.
    pub mount: Vector3<f64>,
    /// Node positions, m; node 0 is O and clamped.
    pub nodes: Vec<Vector3<f64>>,
    /// Beam elements: a tree rooted at node 0, each element leading from a known node to a new one.
    pub beams: Vec<Beam>,
    /// What moves its flaps, in the order of the inputs.
    pub controls: Vec<Control>,
    /// Nodes that move together: what closes loops in the tree of beams.
    pub joints: Vec<Joint>,
    /// Lumped masses.
    pub bays: Vec<MassBay>,
    /// Aerodynamic strips.
    pub strips: Vec<Strip>,
    /// Engines.
    pub engines: Vec<Engine>,
    /// Named points of interest, whose deflections are outputs.
    pub stations: Vec<Station>,
    /// What of it hangs on what.
    pub components: Vec<Component>,
    /// What each component of the file has become.
    pub written: Vec<WrittenComponent>,
    /// Where section loads are outputs.
    pub cuts: Vec<Cut>,
}

impl Aircraft {
    /// The component that an element belongs to, by its index.
    pub fn component_of(&self, beam: usize) -> Option<usize> {
        let has_it = |component: &Component| {
            (component.first_beam..component.first_beam + component.nodes.len() - 1).contains(&beam)
        };
        self.components.iter().position(has_it)
    }
}

/// A straight Euler–Bernoulli beam element with constant section [theory: structure.tree, structure.beam].
#[derive(Clone, Debug, PartialEq)]
pub struct Beam {
    /// The component it belongs to.
    pub component: String,
    /// First and second node; local x points from the first to the second.
    pub nodes: [usize; 2],
    /// Local y axis (chordwise), a unit vector perpendicular to local x.
    pub y_axis: Vector3<f64>,
    /// EA, N.
    pub axial_stiffness: f64,
    /// GJ, N·m².
    pub torsional_stiffness: f64,
    /// EI_y, N·m²: resists w″ (= ∫E z² dA).
    pub bending_stiffness_y: f64,
    /// EI_z, N·m²: resists v″.
    pub bending_stiffness_z: f64,
    /// What couples these, and axes apart from the reference axis.
    pub coupling: Coupling,
    /// By which it turns against its first node, if it does.
    pub hinge: Option<Hinge>,
}

/// Two nodes that move together [theory: structure.joints].
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Different nodes, at most 1 mm apart.
    pub ends: [JointEnd; 2],
    /// Whether they turn together about the body x, y and z axis.
    pub rotations: [bool; 3],
}

impl Joint {
    /// Nodes that are joined are at most this far apart, m.
    pub const REACH: f64 = 1e-3;
}

/// A node that is joined.
#[derive(Clone, Debug, PartialEq)]
pub struct JointEnd {
    /// The component that has it.
    pub component: String,
    /// Where along it, as a fraction of its length.
    pub at: f64,
    /// Among [`Aircraft::nodes`].
    pub node: usize,
}

impl Joint {
    /// Its nodes.
    pub fn nodes(&self) -> [usize; 2] {
        [self.ends[0].node, self.ends[1].node]
    }
}

impl std::fmt::Display for Joint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [one, other] = &self.ends;
        let (name, other_name) = (&one.component, &other.component);
        write!(f, "the joint of \"{name}\" at {} and \"{other_name}\" at {}", one.at, other.at)
    }
}

/// A place on the elastic axis: a fraction of an element's length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attachment {
    /// Index of the element in [`Aircraft::beams`].
    pub beam: usize,
    /// Fraction of the element's length, 0…1.
    pub fraction: f64,
}

/// A rigid lump of mass carried by an element's section [theory: structure.bay; thesis §3.1].
#[derive(Clone, Debug, PartialEq)]
pub struct MassBay {
    /// Where the carrying section sits.
    pub attachment: Attachment,
    /// kg.
    pub mass: f64,
    /// From the elastic axis to the centre of mass, body axes, m.
    pub offset: Vector3<f64>,
    /// About the centre of mass, body axes, kg·m².
    pub inertia: Matrix3<f64>,
}

/// An aerodynamic strip: a rigid aerofoil section of some width, carried by the elastic axis.
///
/// [theory: air-loads.strip; thesis §4.1]
#[derive(Clone, Debug, PartialEq)]
pub struct Strip {
    /// Where the carrying section sits.
    pub attachment: Attachment,
    /// Unit vector f along the chord, towards the leading edge.
    pub forward: Vector3<f64>,
    /// Unit vector s, perpendicular to f; a positive rotation about it is nose-up. n = f × s.
    pub span: Vector3<f64>,
    /// b, m.
    pub semichord: f64,
    /// d, m: distance of the elastic axis behind mid-chord (negative when ahead).
    pub elastic_axis_aft_of_midchord: f64,
    /// Δy, m.
    pub width: f64,
    /// CLα, 1/rad.
    pub lift_slope: f64,
    /// α0, rad: angle of the zero-lift line against f, nose-up positive [theory: air-loads.triad].
    pub zero_lift_offset: f64,
    /// c_m0: moment coefficient about the aerodynamic centre, nose-up positive, referred to the chord squared.
    ///
    /// [theory: air-loads.moment]
    pub zero_lift_moment: f64,
    /// c_mα, 1/rad: slope of the moment coefficient about the quarter chord, nose-up [theory: air-loads.moment-slope].
    pub moment_slope: f64,
    /// CD0.
    pub profile_drag: f64,
    /// η: share of the two-dimensional leading-edge suction that is recovered [theory: air-loads.suction].
    pub leading_edge_suction: f64,
    /// The trailing-edge flap, when there is one.
    pub flap: Option<Flap>,
}

/// A plain trailing-edge flap [theory: air-loads.flap; thesis §4.1].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Flap {
    /// CLδ, 1/rad.
    pub lift_slope: f64,
    /// Hinge position as a fraction of the chord from the leading edge, 0…1 exclusive.
    pub hinge: f64,
    /// c_mδ, 1/rad: moment coefficient about the quarter chord, nose-up; `None`: that of thin-aerofoil theory.
    pub moment_slope: Option<f64>,
    /// k, 1/rad²: profile drag per square of its angle, ≥ 0 [theory: air-loads.drag].
    pub drag: f64,
    /// Its angle per angle of each control of the aircraft; a positive angle is trailing edge towards +n ("down").
    pub gains: Vec<f64>,
}

impl Flap {
    /// Whether any control moves it.
    pub fn is_moved(&self) -> bool {
        self.gains.iter().any(|gain| *gain != 0.0)
    }
}

/// An engine: a thrust along an axis fixed to its section [theory: gravity-and-thrust.thrust; thesis §4.2].
#[derive(Clone, Debug, PartialEq)]
pub struct Engine {
    /// Its input is `thrust_<name>`.
    pub name: String,
    /// Where the carrying section sits.
    pub attachment: Attachment,
    /// From the elastic axis to the point where the thrust acts, body axes, m.
    pub offset: Vector3<f64>,
    /// Unit vector of positive thrust, body axes.
    pub direction: Vector3<f64>,
    /// N·m per N of thrust, right-handed about the direction [theory: gravity-and-thrust.torque].
    pub torque: f64,
    /// Of what turns in it, along the direction, kg·m²/s [theory: gravity-and-thrust.gyroscopic].
    pub angular_momentum: f64,
    /// In what proportion it has the thrust of trims, ≥ 0 [theory: trim.shares].
    pub trim_share: f64,
}

/// A beam of several elements, and what it hangs on.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// That of its elements.
    pub name: String,
    /// Its nodes, from that on which it hangs.
    pub nodes: Vec<usize>,
    /// Its first element; the others follow.
    pub first_beam: usize,
    /// Its mirror image, if it has one.
    pub image: Option<usize>,
    /// Which component it hangs on and at which of that one's nodes, counted from its root; `None`: at O.
    pub parent: Option<(usize, usize)>,
}

/// What a component of the file has become: itself and its mirror image.
#[derive(Clone, Debug, PartialEq)]
pub struct WrittenComponent {
    /// As the file names it.
    pub name: String,
    /// The name of its mirror image, if it has one.
    pub image: Option<String>,
    /// Its masses, in the order of the file.
    pub groups: Vec<MassGroup>,
}

/// The bays of one table of masses.
#[derive(Clone, Debug, PartialEq)]
pub struct MassGroup {
    /// Of the table, counted within its component: `distributed_mass[1]`, `point_masses[2]`.
    pub name: String,
    /// Among [`Aircraft::bays`], those of the mirror image too.
    pub bays: Vec<usize>,
}

/// A node of a component at which the airframe is cut in thought, to sum what acts outboard of it.
///
/// [theory: section-loads.outboard]
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// Its outputs are `loads.<name>.*`.
    pub name: String,
    /// The component that is cut.
    pub component: String,
    /// Where along it, as a fraction of its length: at a node.
    pub at: f64,
    /// The fraction that was asked for.
    pub asked: f64,
    /// The element outboard of the node and its beginning; at a component's end the last element and its end.
    pub attachment: Attachment,
    /// All elements outboard, ascending.
    pub outboard: Vec<usize>,
}

/// A named point of the elastic axis whose deflection is an output.
#[derive(Clone, Debug, PartialEq)]
pub struct Station {
    /// Its outputs are `deflection.<name>.*`.
    pub name: String,
    /// Where it sits.
    pub attachment: Attachment,
    /// Unit vector about which the twist counts: the span axis of the strip on the same element (so that
    /// positive is nose-up on both wings), the beam's axis where there is none.
    pub twist_axis: Vector3<f64>,
}

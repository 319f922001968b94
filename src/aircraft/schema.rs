//! The aircraft file as its author thinks of it: controls, components, masses, surfaces, engines, stations.

use nalgebra::{Matrix6, Vector3};

use super::control::{Control, Mirroring};
use super::document::Located;
use super::error::Place;
use super::fidelity::Fidelity;
use super::law::Law;
use super::limits::Limits;
use super::model::{GivenReference, ModeBasis, Support, TunnelAir};
use super::stretch::Stretch;

pub(super) struct FileSpec {
    pub(super) name: String,
    pub(super) gravity: f64,
    pub(super) support: Located<Support>,
    pub(super) mode_basis: ModeBasis,
    pub(super) load_modes: bool,
    pub(super) fidelity: Fidelity,
    /// Where it stands, if it does.
    pub(super) fidelity_place: Option<Place>,
    pub(super) inflow_states: usize,
    pub(super) airspeed: Located<f64>,
    pub(super) altitude: f64,
    pub(super) temperature_offset: f64,
    pub(super) tunnel_air: Option<Located<TunnelAir>>,
    pub(super) mount: Option<Located<Vector3<f64>>>,
    /// Whether the structure must be its own mirror image.
    pub(super) symmetric: bool,
    pub(super) reference: GivenReference,
    pub(super) limits: Limits,
    /// Limits of controls where they stood before controls had tables of their own.
    pub(super) former_limits: Vec<FormerLimits>,
    pub(super) controls: Vec<ControlSpec>,
    /// Whether the names of all controls could be read.
    pub(super) has_all_controls: bool,
    pub(super) components: Vec<ComponentSpec>,
    pub(super) joints: Vec<JointSpec>,
    pub(super) engines: Vec<EngineSpec>,
    pub(super) stations: Vec<StationSpec>,
    pub(super) cuts: Vec<CutSpec>,
}

pub(super) struct ComponentSpec {
    pub(super) name: Located<String>,
    pub(super) mirror: Option<Located<String>>,
    pub(super) parent: ParentSpec,
    /// Corners of the elastic axis, from the attachment point.
    pub(super) axis: Located<Vec<Vector3<f64>>>,
    /// Number of elements between each corner and the next.
    pub(super) elements: Vec<usize>,
    pub(super) y_axis: Located<Vector3<f64>>,
    /// By the names of their fields; none where something else says how stiff it is.
    pub(super) stiffness: Vec<(&'static str, Law)>,
    pub(super) section: SectionSpec,
    pub(super) chord: Option<Law>,
    pub(super) distributed_masses: Vec<DistributedMassSpec>,
    pub(super) point_masses: Vec<PointMassesSpec>,
    pub(super) surfaces: Vec<SurfaceSpec>,
}

/// What of a component's sections goes beyond four stiffnesses.
pub(super) struct SectionSpec {
    pub(super) source: StiffnessSource,
    /// EI_yz, two bend–twist couplings, two places of the tension axis, two of the shear centre.
    pub(super) beside: Vec<Option<Law>>,
    pub(super) masses: Vec<MatrixSpec>,
    pub(super) hinge: Option<HingeSpec>,
}

/// What says how stiff a component is.
pub(super) enum StiffnessSource {
    /// EA, GJ and two EI.
    Laws,
    Matrices(Vec<MatrixSpec>),
    Box(Box<BoxSpec>),
}

/// A matrix of the section at a fraction of the component's length.
pub(super) struct MatrixSpec {
    pub(super) at: f64,
    pub(super) matrix: Located<Matrix6<f64>>,
}

/// A rectangular tube; Pa, kg/m³.
pub(super) struct BoxSpec {
    pub(super) place: Place,
    pub(super) height: Law,
    pub(super) width: Law,
    pub(super) skin: Law,
    pub(super) web: Option<Law>,
    pub(super) young: f64,
    pub(super) shear: f64,
    pub(super) density: Option<f64>,
}

/// Springs of a hinge, N m/rad.
pub(super) enum HingeSpec {
    /// About one axis.
    About { axis: Vector3<f64>, stiffness: f64 },
    /// About local x, y and z.
    AboutLocalAxes(Vector3<f64>),
}

pub(super) enum ParentSpec {
    Origin,
    Component { name: Located<String>, at: Located<f64> },
}

/// Places along a component.
pub(super) enum Along {
    /// Distances from the root, m.
    Metres(Vec<Located<f64>>),
    /// Fractions of the component's length.
    Fractions(Vec<Located<f64>>),
}

pub(super) struct DistributedMassSpec {
    pub(super) place: Place,
    pub(super) parts: Vec<MassPartSpec>,
    pub(super) offset_chords: Option<Located<[Law; 3]>>,
    pub(super) offset: Vector3<f64>,
    pub(super) gyration_chords: Option<Located<[Law; 3]>>,
    pub(super) gyration_lengths: Vector3<f64>,
    pub(super) added_inertia: Vector3<f64>,
}

pub(super) struct MassPartSpec {
    pub(super) place: Place,
    pub(super) total: f64,
    pub(super) chord_power: f64,
    pub(super) stretch: Stretch,
}

pub(super) struct PointMassesSpec {
    pub(super) along: Along,
    pub(super) masses: Located<Vec<f64>>,
    pub(super) offset: Vector3<f64>,
    pub(super) inertia: InertiaSpec,
    pub(super) products: Vector3<f64>,
    pub(super) inertia_place: Place,
}

pub(super) enum InertiaSpec {
    /// Radii of gyration, m.
    Gyration(Vector3<f64>),
    /// Moments of inertia, kg·m².
    Moments(Vector3<f64>),
}

pub(super) struct SurfaceSpec {
    pub(super) place: Place,
    pub(super) position: f64,
    pub(super) stretch: Stretch,
    pub(super) elastic_axis: Law,
    pub(super) chord: Option<Law>,
    pub(super) span_axis: Option<Vector3<f64>>,
    /// degrees.
    pub(super) incidence: Option<Law>,
    pub(super) width: Option<Law>,
    pub(super) lift_slope: Law,
    /// degrees.
    pub(super) zero_lift_offset: Option<Law>,
    pub(super) zero_lift_moment: Option<Law>,
    /// per rad.
    pub(super) moment_slope: Option<Law>,
    pub(super) profile_drag: Law,
    pub(super) leading_edge_suction: Option<Law>,
    pub(super) flap: Option<FlapSpec>,
    pub(super) moves: Vec<MoveSpec>,
}

pub(super) struct FlapSpec {
    pub(super) lift_slope: Law,
    pub(super) hinge: Law,
    pub(super) moment_slope: Option<Law>,
    pub(super) drag: Option<Law>,
}

pub(super) struct ControlSpec {
    /// That of the control, with its place.
    pub(super) name: Located<String>,
    pub(super) control: Control,
    /// That of the control, unless the file's makes no sense.
    pub(super) mirroring: Option<Mirroring>,
    /// Where its role stands, if it has one.
    pub(super) role_place: Option<Place>,
}

/// What `[limits.surface.<name>]` says.
pub(super) struct FormerLimits {
    /// Of the control.
    pub(super) name: String,
    /// As lines of a `[[control]]`.
    pub(super) lines: Vec<String>,
}

/// A control that moves the flap of a surface.
pub(super) struct MoveSpec {
    pub(super) place: Place,
    pub(super) control: Located<String>,
    pub(super) gain: f64,
    pub(super) stretch: Stretch,
    /// The one side that it moves, of a component and its mirror image.
    pub(super) hand: Option<Located<Hand>>,
}

/// A side of the aircraft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hand {
    Right,
    Left,
}

/// Two nodes that move together.
pub(super) struct JointSpec {
    pub(super) place: Place,
    pub(super) ends: [JointEndSpec; 2],
    /// Whether they turn together about each of the body axes.
    pub(super) rotations: [bool; 3],
}

/// A node of a component: at a fraction of its length.
pub(super) struct JointEndSpec {
    pub(super) component: Located<String>,
    pub(super) at: Located<f64>,
}

pub(super) struct EngineSpec {
    pub(super) name: Located<String>,
    pub(super) component: Located<String>,
    pub(super) along: Along,
    pub(super) offset: Vector3<f64>,
    pub(super) direction: Vector3<f64>,
    pub(super) torque: Located<f64>,
    pub(super) angular_momentum: Located<f64>,
    pub(super) trim_share: Located<f64>,
}

pub(super) struct StationSpec {
    pub(super) name: Located<String>,
    pub(super) component: Located<String>,
    pub(super) along: Along,
}

/// A node of a component at which section loads are summed: the nearest to a fraction of its length.
pub(super) struct CutSpec {
    pub(super) name: Located<String>,
    pub(super) component: Located<String>,
    pub(super) at: f64,
}

//! An aircraft as it stands in its file: tables, and what is said about them.

/// All of an aircraft.
pub struct Design {
    pub controls: Vec<Control>,
    pub components: Vec<Component>,
    pub engines: Vec<Engine>,
    /// Components that are watched at their tips.
    pub watched: Vec<String>,
    /// Names and components of cuts at roots.
    pub cut: Vec<String>,
    pub joined_tail: Option<JoinedTail>,
}

/// A tail in one piece, in place of one in halves.
pub struct JoinedTail {
    /// From the root of the right half, m: in the plane of symmetry.
    pub tip: [f64; 3],
}

pub struct Control {
    pub name: &'static str,
    pub description: &'static str,
    pub positive: &'static str,
    pub mirror: &'static str,
    /// Its role in trims.
    pub trim: Option<&'static str>,
    /// Degrees to both sides.
    pub limit: f64,
}

pub struct Component {
    /// What it is and which rules sized it.
    pub comment: String,
    pub name: String,
    pub mirror: Option<String>,
    /// O, or a component and a fraction of its length.
    pub parent: Option<(String, f64)>,
    /// From the root, m.
    pub tip: [f64; 3],
    pub elements: usize,
    pub y_axis: [i32; 3],
    /// At root and tip, m.
    pub chords: Option<[f64; 2]>,
    pub beam: Beam,
    pub structure: Structure,
    pub lumps: Vec<Lump>,
    pub surface: Option<Surface>,
}

/// Stiffnesses.
pub struct Beam {
    pub comment: String,
    /// N m², at the root.
    pub bending: f64,
    /// Stiffnesses go with such a power of the chord, EA with two less.
    pub chord_power: Option<f64>,
    /// By the bending stiffness.
    pub torsion: f64,
    pub in_surface: f64,
    /// At the root, N.
    pub axial: f64,
}

/// Mass along a component.
pub struct Structure {
    pub parts: Vec<Part>,
    /// Behind the elastic axis, chords.
    pub aft: Option<f64>,
    /// Chords.
    pub gyration_chords: Option<[f64; 3]>,
    /// Lengths of an element.
    pub gyration_lengths: [f64; 3],
    /// Of each element, a thin ring, about x, kg m².
    pub added_inertia: Option<f64>,
}

pub struct Part {
    pub comment: &'static str,
    /// kg.
    pub mass: f64,
    pub chord_power: Option<f64>,
    /// Ends at this fraction of the component.
    pub to: Option<f64>,
}

/// A point mass.
pub struct Lump {
    pub comment: String,
    pub at: Place,
    /// kg.
    pub mass: f64,
    /// m.
    pub offset: [f64; 3],
    pub gyration: [f64; 3],
}

/// Along a component.
#[derive(Clone, Copy)]
pub enum Place {
    /// m.
    Metres(f64),
    /// Of its length.
    Fraction(f64),
}

pub struct Surface {
    pub elastic_axis: f64,
    /// Degrees, at root and tip.
    pub incidence: [f64; 2],
    pub lift_slope: f64,
    /// What the lift slope holds beside that of the surface.
    pub lift_comment: String,
    pub profile_drag: f64,
    pub drag_comment: String,
    pub suction: f64,
    /// Degrees.
    pub zero_lift_offset: f64,
    pub zero_lift_moment: f64,
    /// C_Lδ and hinge.
    pub flap: Option<[f64; 2]>,
    pub moves: Vec<Move>,
}

/// A control and the flaps that it turns.
pub struct Move {
    pub input: &'static str,
    pub gain: f64,
    /// From and to where along the component.
    pub stretch: Option<[f64; 2]>,
}

pub struct Engine {
    pub name: String,
    pub component: String,
    pub at: Place,
    /// m.
    pub offset: [f64; 3],
}

//! Where engines are: in the plane of symmetry, in pairs on the wing or at the rear fuselage.

use super::design::{Engine, Lump, Place};
use super::kind::Kind;
use super::layout::{BOOM_PLACE, ELASTIC_AXIS, Layout};
use super::sizing::Sizing;

/// An engine, or a pair of them on both wings, of which this is the right one.
pub struct Mount {
    name: String,
    component: &'static str,
    at: Place,
    offset: [f64; 3],
    /// kg.
    mass: f64,
}

/// Pairs on a wing stand at these fractions of it.
const PLACES: [f64; 4] = [BOOM_PLACE, 0.5, 0.6875, 0.875];

/// Where a pair at the rear fuselage is, by its length.
const REAR: f64 = 0.6;

/// All engines.
pub fn mounts(sizing: &Sizing, layout: &Layout) -> Vec<Mount> {
    let count = sizing.engines;
    let (mut pairs, single) = (count / 2, count % 2 == 1);
    let mut mounts = Vec::new();
    if single {
        mounts.push(in_plane(sizing, layout));
    }
    if sizing.kind == Kind::TTail && pairs > 0 {
        pairs -= 1;
        mounts.extend(at_rear(layout));
    }
    for (pair, place) in PLACES.into_iter().take(pairs).enumerate() {
        let number = if pairs > 1 { format!("_{}", pair + 1) } else { String::new() };
        let prefix = if sizing.kind == Kind::TTail { "wing_" } else { "" };
        for (side, sign) in [("right", 1.0), ("left", -1.0)] {
            mounts.push(on_wing(sizing, layout, (format!("{prefix}{side}{number}"), sign, place)));
        }
    }
    mounts
}

fn in_plane(sizing: &Sizing, layout: &Layout) -> Mount {
    let at_nose = match sizing.kind {
        Kind::Canard | Kind::FlyingWing | Kind::TwinBoom => false,
        Kind::TTail => sizing.engines == 1,
        _ => true,
    };
    let (name, component) = if at_nose { ("nose", "fuselage_fore") } else { ("rear", "fuselage_aft") };
    Mount {
        name: name.to_owned(),
        component,
        at: Place::Fraction(if at_nose { 0.9 } else { 1.0 }),
        offset: [0.0; 3],
        mass: layout.masses.engine,
    }
}

fn at_rear(layout: &Layout) -> [Mount; 2] {
    [("right", 1.0), ("left", -1.0)].map(|(side, sign)| Mount {
        name: side.to_owned(),
        component: "fuselage_aft",
        at: Place::Fraction(REAR),
        offset: [0.0, sign * 1.6 * layout.radius, -0.4 * layout.radius],
        mass: layout.masses.engine,
    })
}

/// Ahead of the leading edge and below it.
fn on_wing(sizing: &Sizing, layout: &Layout, (name, sign, place): (String, f64, f64)) -> Mount {
    let chord = sizing.wing.chord(place);
    Mount {
        name,
        component: if sign > 0.0 { "wing_right" } else { "wing_left" },
        at: Place::Fraction(place),
        offset: [(ELASTIC_AXIS + 0.15) * chord, 0.0, 0.12 * chord],
        mass: layout.masses.engine,
    }
}

impl Mount {
    /// Its mass, where it is on a component; what the wing carries is mirrored.
    pub fn lump_on(&self, component: &str) -> Option<Lump> {
        // A cylinder of the density of engines, 1000 kg/m³, twice as long as wide.
        let size = 0.3 * (self.mass / 1000.0).cbrt();
        (self.component == component).then(|| Lump {
            comment: "engine".to_owned(),
            at: self.at,
            mass: self.mass,
            offset: self.offset,
            gyration: [size, 1.8 * size, 1.8 * size],
        })
    }
}

/// Where they push.
pub fn engines(mounts: &[Mount]) -> Vec<Engine> {
    let engine = |mount: &Mount| Engine {
        name: mount.name.clone(),
        component: mount.component.to_owned(),
        at: mount.at,
        offset: mount.offset,
    };
    mounts.iter().map(engine).collect()
}

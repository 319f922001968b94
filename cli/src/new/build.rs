//! The tables of an aircraft from what it is built of.

use super::basis::Basis;
use super::design::{Component, Design};
use super::kind::Kind;
use super::{bodies, controls, engines, tails, wing};

/// All tables.
pub fn design(basis: &Basis) -> Design {
    let kind = basis.sizing.kind;
    let wing = wing::component(basis);
    let mut components: Vec<Component> = vec![wing];
    if kind != Kind::WingOnWall {
        components.extend(bodies::components(basis));
        components.extend(tails::components(basis));
    }
    let side = |name: &str| match kind {
        Kind::WingOnWall => vec![name.to_owned()],
        _ => ["right", "left"].map(|side| format!("{name}_{side}")).to_vec(),
    };
    let mut watched = side("wing");
    let mut cut = side("wing");
    match kind {
        Kind::Conventional | Kind::TTail | Kind::Sailplane | Kind::VTail | Kind::Canard => {
            let tail = tails::name(kind);
            watched.extend(side(tail));
            cut.extend(side(tail).into_iter().chain(["fuselage_aft".to_owned()]));
        }
        Kind::TwinBoom => cut.extend(side("boom").into_iter().chain(side("fin"))),
        Kind::FlyingWing | Kind::WingOnWall => {}
    }
    let fin = ["fin".to_owned()];
    if components.iter().any(|component| component.name == fin[0]) {
        watched.extend(fin.clone());
        cut.extend(fin);
    }
    let engines = engines::engines(&basis.mounts);
    let joined_tail = tails::joined(basis);
    Design { controls: controls::of(kind), components, engines, watched, cut, joined_tail }
}

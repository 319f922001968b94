//! Bodies: rings around beams that are no lifting surfaces. Aircraft files say nothing of their size; what is assumed is told.

use flexible_aircraft::Aircraft;
use nalgebra::Vector3;

use crate::describe::surfaces;

use super::airframe::Airframe;

/// Part of a length over which a free end becomes thin.
const TAPER: f64 = 0.35;

/// The radius at a free end, in parts of the largest.
const TIP: f64 = 0.12;

/// The radius of a body of which nothing is known, in parts of its length and of the airframe's size; of one that hangs on another
/// component, such as a boom.
const OF_LENGTH: f64 = 0.07;
const OF_SIZE: f64 = 0.045;
const OF_LENGTH_HANGING: f64 = 0.025;

/// Parts of the airframe's size within which two places are one.
const TOGETHER: f64 = 1e-6;

/// A body.
pub struct Body {
    pub component: String,
    /// Section and radii, horizontally and vertically, m.
    pub rings: Vec<(usize, [f64; 2])>,
}

/// Of all components that are no lifting surfaces, and what was assumed of them.
pub fn bodies(airframe: &Airframe) -> (Vec<Body>, Option<String>) {
    let aircraft = &airframe.aircraft;
    let is_body = |component: &usize| !surfaces::is_lifting(aircraft, *component);
    let components: Vec<usize> = (0..aircraft.components.len()).filter(is_body).collect();
    let radii = radii(airframe, &components);
    let bodies: Vec<Body> =
        components.iter().zip(radii).map(|(&component, radii)| body(airframe, component, radii)).collect();
    let names: Vec<&str> = bodies.iter().map(|body| body.component.as_str()).collect();
    let note = (!names.is_empty()).then(|| {
        format!(
            "the thickness of {} is assumed: aircraft files do not give it, nothing depends on it",
            names.join(", ")
        )
    });
    (bodies, note)
}

/// The radii of bodies where they begin, m: those that begin at one place are one body, as wide as the widest.
fn radii(airframe: &Airframe, components: &[usize]) -> Vec<[f64; 2]> {
    let own: Vec<[f64; 2]> = components.iter().map(|&component| own_radii(airframe, component)).collect();
    let root = |component: usize| airframe.sections[airframe.nodes[component][0]].position;
    let meet = |one: usize, other: usize| (root(one) - root(other)).norm() < TOGETHER * airframe.size();
    let of_all = |&one: &usize| {
        let met = components.iter().zip(&own).filter(|(other, _)| meet(one, **other));
        met.fold([0.0_f64; 2], |[wide, high], (_, radii)| [wide.max(radii[0]), high.max(radii[1])])
    };
    components.iter().map(of_all).collect()
}

/// What strips across a body say of its radii, m, or else what is assumed.
fn own_radii(airframe: &Airframe, component: usize) -> [f64; 2] {
    let places: Vec<Vector3<f64>> =
        airframe.nodes[component].iter().map(|&node| airframe.sections[node].position).collect();
    let length: f64 = places.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    let hangs = airframe.aircraft.components[component].parent.is_some();
    let of_length = if hangs { OF_LENGTH_HANGING } else { OF_LENGTH };
    let assumed = (of_length * length).min(OF_SIZE * airframe.size());
    let widths = |is_level: bool| widest(&airframe.aircraft, component, is_level).map(|width| 0.5 * width);
    match [widths(true), widths(false)] {
        [Some(horizontal), Some(vertical)] => [horizontal, vertical],
        [Some(one), None] | [None, Some(one)] => [one; 2],
        [None, None] => [assumed; 2],
    }
}

fn body(airframe: &Airframe, component: usize, radii: [f64; 2]) -> Body {
    let aircraft = &airframe.aircraft;
    let nodes = &airframe.nodes[component];
    let places: Vec<Vector3<f64>> = nodes.iter().map(|&node| airframe.sections[node].position).collect();
    let mut distances = vec![0.0];
    for pair in places.windows(2) {
        distances.push(distances[distances.len() - 1] + (pair[1] - pair[0]).norm());
    }
    let length = distances[distances.len() - 1];
    let carries = is_carrying(aircraft, component);
    let ring = |(&node, distance): (&usize, &f64)| {
        let free = if carries { 0.0 } else { (distance / length - (1.0 - TAPER)) / TAPER };
        let thin = (1.0 - free.clamp(0.0, 1.0).powi(2)).sqrt().max(TIP);
        // What carries tails goes on thin.
        let slender = if carries { 1.0 - 0.6 * distance / length } else { 1.0 };
        (node, radii.map(|radius| radius * thin * slender))
    };
    Body {
        component: aircraft.components[component].name.clone(),
        rings: nodes.iter().zip(&distances).map(ring).collect(),
    }
}

/// The largest width of strips across a body whose span is level, or upright.
fn widest(aircraft: &Aircraft, component: usize, is_level: bool) -> Option<f64> {
    let strips = surfaces::strips(aircraft, component).into_iter();
    let widths = strips.filter(|strip| (strip.span.y.abs() > 0.7) == is_level).map(|strip| strip.width);
    widths.reduce(f64::max)
}

/// Whether something hangs on a component beyond its root.
fn is_carrying(aircraft: &Aircraft, component: usize) -> bool {
    aircraft.components.iter().any(|other| other.parent.is_some_and(|(on, at)| on == component && at > 0))
}

#[cfg(test)]
mod tests {
    use super::super::airframe::tests::jet;
    use super::*;

    #[test]
    fn the_fuselage_of_the_jet_is_a_body_and_its_wings_are_none() {
        let airframe = Airframe::new(&jet());
        let (bodies, note) = bodies(&airframe);
        assert!(!bodies.is_empty() && bodies.iter().all(|body| body.component.contains("fuselage")));
        assert!(note.unwrap().contains("fuselage"));
        for body in &bodies {
            assert!(body.rings.len() > 2);
            assert!(
                body.rings.iter().flat_map(|(_, radii)| radii).all(|radius| (0.05..3.0).contains(radius))
            );
        }
        let [forward, aft] = bodies.as_slice() else { panic!("the jet has two fuselages") };
        assert_eq!(forward.rings[0].1, aft.rings[0].1, "they meet with a step");
    }
}

//! A description as JSON, in SI units and radians.

use flexible_aircraft::plant::StaticStability;
use nalgebra::Matrix3;
use serde_json::{Map, Value, json};

use super::Description;
use super::balance::Balance;
use super::modes::{NaturalMode, family_name};

/// An object with all of it.
pub fn text(description: &Description) -> String {
    let Description { facts, balance, modes, warnings } = description;
    let counts: Map<String, Value> =
        facts.counts.iter().map(|(what, count)| ((*what).to_owned(), json!(count))).collect();
    let reference = facts.reference.map(
        |lengths| json!({ "chord": lengths.chord, "area": lengths.area, "span": lengths.span, "wing": facts.wing }),
    );
    let all = json!({
        "aircraft": facts.name,
        "units": {
            "mass": "kg", "centre_of_mass": "m", "inertia": "kg m²", "chord": "m", "area": "m²", "span": "m",
            "neutral_point": "m", "lift_slope": "1/rad", "frequency": "Hz", "angular_frequency": "rad/s",
        },
        "mass": facts.mass,
        "centre_of_mass": facts.centre_of_mass.as_slice(),
        "inertia": { "about_centre_of_mass": rows(&facts.about_centre), "about_origin": rows(&facts.about_origin) },
        "reference": reference,
        "counts": counts,
        "joints": facts.joints,
        "stability": stability(balance),
        "modes": modes.iter().map(mode).collect::<Vec<_>>(),
        "warnings": warnings,
    });
    format!("{all:#}\n")
}

fn rows(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| matrix[(row, column)]))
}

/// What there is not is null, and `message` says why.
fn stability(balance: &Balance) -> Value {
    let found = balance.stability.as_ref().ok();
    json!({
        "condition": balance.condition,
        "static_margin": balance.margin.as_ref().map(|margin| margin.margin),
        "lift_slope": balance.margin.as_ref().map(|margin| margin.lift_slope),
        "neutral_point": found.map(StaticStability::neutral_point),
        "centre_of_mass": found.map(|stability| <[f64; 3]>::from(stability.centre_of_mass)),
        "message": balance.stability.as_ref().err(),
    })
}

fn mode(mode: &NaturalMode) -> Value {
    let kinetic: Vec<Value> =
        mode.kinetic.iter().map(|(name, share)| json!({ "component": name, "share": share })).collect();
    json!({
        "number": mode.number,
        "frequency": mode.frequency(),
        "angular_frequency": mode.angular_frequency,
        "family": family_name(mode.family),
        "motion": mode.motion,
        "kinetic_energy": kinetic,
        "strain_energy": {
            "bending": mode.strain.bending,
            "in_plane": mode.strain.in_plane,
            "torsion": mode.strain.torsion,
            "stretch": mode.strain.stretch,
        },
    })
}

//! `--surface`: a lifting surface between two grids, where a deck has no panels.

use std::str::FromStr;

/// What a line says.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceLine {
    pub grids: [i64; 2],
    /// At these grids, m.
    pub chords: [f64; 2],
    /// Where the grids are, as a fraction of the chord behind the leading edge.
    pub axis: f64,
    /// Name of a control, and the hinge as a fraction of the chord.
    pub flap: Option<(String, f64)>,
}

/// What is allowed.
const FORM: &str = "allowed is GRID:GRID,chord=ROOT:TIP,axis=FRACTION and, with a flap, ,control=NAME,hinge=FRACTION; chords in m";

impl FromStr for SurfaceLine {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut parts = text.split(',');
        let grids = parts
            .next()
            .and_then(pair::<i64>)
            .filter(|[one, other]| one != other)
            .ok_or_else(|| FORM.to_owned())?;
        let (mut chords, mut axis, mut control, mut hinge) = (None, None, None, None);
        for part in parts {
            let (name, value) = part.split_once('=').ok_or_else(|| format!("found {part}; {FORM}"))?;
            let fraction = || value.parse().ok().filter(|fraction: &f64| (0.0..1.0).contains(fraction));
            match name.trim() {
                "chord" => {
                    let one = value.parse().ok().map(|chord| [chord, chord]);
                    let given = pair::<f64>(value).or(one);
                    chords =
                        given.filter(|chords| chords.iter().all(|chord| *chord > 0.0 && *chord <= 1000.0));
                }
                "axis" => axis = fraction(),
                "control" => control = Some(value.trim().to_owned()).filter(|name| !name.is_empty()),
                "hinge" => hinge = fraction().filter(|hinge| *hinge > 0.0),
                _ => return Err(format!("found {name}; {FORM}")),
            }
        }
        let flap = match (control, hinge) {
            (Some(control), Some(hinge)) => Some((control, hinge)),
            (None, None) => None,
            _ => return Err(FORM.to_owned()),
        };
        let (Some(chords), Some(axis)) = (chords, axis) else { return Err(FORM.to_owned()) };
        Ok(SurfaceLine { grids, chords, axis, flap })
    }
}

fn pair<T: FromStr>(text: &str) -> Option<[T; 2]> {
    let (one, other) = text.split_once(':')?;
    Some([one.trim().parse().ok()?, other.trim().parse().ok()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_says_where_a_surface_is_and_what_moves_it() {
        let line: SurfaceLine = "101:120,chord=2.4:1.2,axis=0.35,control=aileron,hinge=0.75".parse().unwrap();
        assert_eq!((line.grids, line.chords, line.axis), ([101, 120], [2.4, 1.2], 0.35));
        assert_eq!(line.flap, Some(("aileron".to_owned(), 0.75)));
        let plain: SurfaceLine = "1:2,chord=1,axis=0".parse().unwrap();
        assert_eq!((plain.chords, plain.flap), ([1.0, 1.0], None));
        for wrong in [
            "",
            "1:1,chord=1,axis=0",
            "1:2",
            "1:2,chord=-1,axis=0",
            "1:2,chord=1,axis=0,hinge=0.7",
            "1:2,chord=1,axis=0,x=1",
        ] {
            assert!(wrong.parse::<SurfaceLine>().unwrap_err().contains("allowed is GRID:GRID"), "{wrong}");
        }
    }
}

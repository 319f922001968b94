//! What the flaps of a control can do for a trim: hold pitch, or what goes aside [theory: trim.unknowns, trim.lateral].
//!
//! A flap and its mirror image turned alike push in the plane y = 0 and pitch; turned against each other they push across it, and
//! roll and yaw. One without image does both, unless it stands in the plane.

use nalgebra::Vector3;

use super::control::{Control, TrimRole};
use super::model::{Aircraft, Attachment, Flap, Strip};

/// Gains, directions and sizes that differ by less than this share are equal.
const EQUAL: f64 = 1e-9;

/// A centre of mass this near to the plane of symmetry, as a share of the aircraft's size, is in it.
const BALANCED: f64 = 1e-6;

/// Which motions a control alone acts on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Effect {
    /// In the plane of symmetry: pitch.
    in_plane: bool,
    /// Across it: roll and yaw.
    aside: bool,
}

impl Effect {
    /// Of a control by its place among those of the aircraft.
    pub(super) fn of(aircraft: &Aircraft, control: usize) -> Effect {
        let mut effect = Effect::default();
        let slack = slack(aircraft);
        for strip in &aircraft.strips {
            let gain = gain(strip, control);
            if gain == 0.0 {
                continue;
            }
            let normal = normal(strip);
            match image(aircraft, strip, slack) {
                Some((other, sign)) => {
                    let mirrored = sign * self::gain(other, control);
                    let least = EQUAL * gain.abs();
                    effect.in_plane |= (gain + mirrored).abs() > least && pushes_in_plane(&normal);
                    effect.aside |= (gain - mirrored).abs() > least;
                }
                None => {
                    effect.in_plane |= pushes_in_plane(&normal);
                    effect.aside |= normal.y.abs() > EQUAL || place(aircraft, strip).y.abs() > slack;
                }
            }
        }
        effect
    }

    /// Whether it acts on what the role holds.
    pub(super) fn can_hold(self, role: TrimRole) -> bool {
        match role {
            TrimRole::Pitch => self.in_plane,
            TrimRole::Roll | TrimRole::Yaw => self.aside,
        }
    }

    /// Whether the control moves nothing at all, as one whose gains are 0.
    pub(super) fn is_none(self) -> bool {
        self == Effect::default()
    }
}

impl Aircraft {
    /// The control for pitch of an aircraft with a mirror plane, if it does not act alike on both sides: trims then go aside.
    ///
    /// ```
    /// # use flexible_aircraft::Aircraft;
    /// assert_eq!(Aircraft::read("aircraft/generic-business-jet.toml")?.lopsided_pitch_control(), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lopsided_pitch_control(&self) -> Option<&Control> {
        let has_role = |control: &Control| control.role == Some(TrimRole::Pitch);
        let control = self.controls.iter().position(has_role)?;
        let lopsided = Effect::of(self, control).aside && self.has_mirrored_strips_and_balance();
        lopsided.then(|| &self.controls[control])
    }

    /// Whether every strip has an image, and masses are in balance about the plane y = 0.
    fn has_mirrored_strips_and_balance(&self) -> bool {
        let slack = slack(self);
        let [mass, moment] = self.bays.iter().fold([0.0; 2], |[mass, moment], bay| {
            let y = at(self, bay.attachment).y + bay.offset.y;
            [mass + bay.mass, moment + bay.mass * y]
        });
        moment.abs() <= BALANCED * mass * size(self)
            && self.strips.iter().all(|strip| image(self, strip, slack).is_some())
    }
}

/// Lengths that differ by less are equal, m.
fn slack(aircraft: &Aircraft) -> f64 {
    EQUAL * size(aircraft)
}

/// The distance of its farthest node from O, m.
fn size(aircraft: &Aircraft) -> f64 {
    aircraft.nodes.iter().map(Vector3::norm).fold(0.0, f64::max)
}

fn place(aircraft: &Aircraft, strip: &Strip) -> Vector3<f64> {
    at(aircraft, strip.attachment)
}

fn at(aircraft: &Aircraft, attachment: Attachment) -> Vector3<f64> {
    let [from, to] = aircraft.beams[attachment.beam].nodes.map(|node| aircraft.nodes[node]);
    from + (to - from) * attachment.fraction
}

/// Where lift pushes: n = f × s.
fn normal(strip: &Strip) -> Vector3<f64> {
    strip.forward.cross(&strip.span)
}

fn pushes_in_plane(normal: &Vector3<f64>) -> bool {
    libm::hypot(normal.x, normal.z) > EQUAL
}

fn gain(strip: &Strip, control: usize) -> f64 {
    strip.flap.as_ref().and_then(|flap| flap.gains.get(control)).copied().unwrap_or(0.0)
}

/// The strip that is the mirror image of another one, itself among them, and the sign with which positive flap angles mirror.
fn image<'a>(aircraft: &'a Aircraft, strip: &Strip, slack: f64) -> Option<(&'a Strip, f64)> {
    let mirrored = |v: Vector3<f64>| Vector3::new(v.x, -v.y, v.z);
    let (at, normal) = (mirrored(place(aircraft, strip)), mirrored(normal(strip)));
    let fits = |other: &&Strip| {
        (place(aircraft, other) - at).norm() <= slack
            && self::normal(other).cross(&normal).norm() <= EQUAL
            && are_equal(other.width * other.semichord, strip.width * strip.semichord)
            && are_alike(other.flap.as_ref(), strip.flap.as_ref())
    };
    let other = aircraft.strips.iter().find(fits)?;
    Some((other, self::normal(other).dot(&normal).signum()))
}

fn are_alike(one: Option<&Flap>, other: Option<&Flap>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => {
            are_equal(one.lift_slope, other.lift_slope) && are_equal(one.hinge, other.hinge)
        }
        (one, other) => one.is_none() && other.is_none(),
    }
}

fn are_equal(a: f64, b: f64) -> bool {
    (a - b).abs() <= EQUAL * a.abs().max(b.abs())
}

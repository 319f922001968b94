//! The right half of an aircraft, for motion that is its own mirror image in the plane y = 0.
//!
//! [theory: symmetry.half, symmetry.conditions]
//!
//! In such motion antisymmetric modes rest, left and right carry the same loads, and what the left half does is known
//! from the right one. The half keeps the symmetric modes, the strips on the right at twice their width and those in
//! the plane, laid into it exactly; integrals over the mass and strain energy stay those of the whole aircraft. Strips in the
//! plane whose normal points sideways, such as a fin's, meet the flow edge-on: only their drag remains.

use nalgebra::Vector3;

use crate::aircraft::{Support, TrimRole};
use crate::equations::{ClosesLoop, Configuration, EquationsOfMotion};
use crate::math::{are_alike, largest};
use crate::structure::{ModeFamily, ModeShapes, ReducedEngine, ReducedModel, ReducedStrip};

use super::even_controls::EvenControls;
use super::half_sections::HalfSections;

/// How far mirror images may differ, in parts of the aircraft's size or of each number.
const SYMMETRIC: f64 = 1e-9;

/// What symmetric motion needs of an aircraft with a mirror plane.
#[derive(Clone, Debug)]
pub struct SymmetricHalf {
    /// The half's strips but those edge-on, those in the plane last; the symmetric modes, all engines and stations.
    pub model: ReducedModel,
    /// The strips that meet the flow edge-on.
    pub edge_on: Vec<ReducedStrip>,
    /// Which modes of the whole aircraft the half has.
    pub modes: Vec<usize>,
    /// For each strip of the whole aircraft the one of the half that moves as it does or as its mirror image.
    pub strips: Vec<Counterpart>,
    /// For each strip of the half, those edge-on last, the first of the whole aircraft that it is or stands for.
    pub stands_for: Vec<usize>,
    /// For each engine its mirror image.
    pub engines: Vec<usize>,
    /// When the controls act alike on both sides.
    pub controls: EvenControls,
}

/// The strip of the half that stands for one of the whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Counterpart {
    /// One of the half's model.
    Lifting {
        /// Its index there.
        index: usize,
        /// 1, or −1 where the span axis points the other way than the mirrored one: upwash and inflow change their
        /// sign.
        sign: f64,
    },
    /// One of those edge-on, by its index; its inflow rests.
    EdgeOn(usize),
}

impl SymmetricHalf {
    /// The half of an aircraft; `None` when it has no mirror plane, or when gravity, the tunnel's flow or what the control
    /// for pitch does is not in it.
    pub fn find(whole: &ReducedModel) -> Option<Self> {
        if !body_is_symmetric(whole) {
            return None;
        }
        let symmetric = |&mode: &usize| whole.modes[mode].family == ModeFamily::Symmetric;
        let modes: Vec<usize> = (0..whole.modes.len()).filter(symmetric).collect();
        let model = whole.select(&modes);
        let reflection = Reflection::of(&model);
        let engines = reflection.engine_images(&model.engines)?;
        let images = reflection.images(&model.strips)?;
        let controls = even_controls(&model.strips, &images);
        if trim_control(&model).is_some_and(|control| !controls.leave_free(control)) {
            return None;
        }
        let [lifting, edge_on] = kept_strips(&images);
        let strips = counterparts(&images, [&lifting, &edge_on])?;
        let stands_for = lifting.iter().chain(&edge_on).map(|&strip| first_of(&images, strip)).collect();
        let half = |&strip: &usize| half_strip(&model.strips[strip], images[strip].is_in_plane, &controls);
        let lifting = lifting.iter().map(half).collect();
        let edge_on = edge_on.iter().map(|&strip| model.strips[strip].clone()).collect();
        // Section loads are those of the whole aircraft.
        let mut model = ReducedModel { strips: lifting, cuts: Vec::new(), ..model };
        HalfSections::of(&model.sections).take_place_in(&mut model);
        Some(SymmetricHalf { model, edge_on, modes, strips, stands_for, engines, controls })
    }

    /// The equations of symmetric motion, under controls that act alike on both sides and without wind from the side.
    ///
    /// # Errors
    /// When the level is geometrically exact and the model's joints close loops.
    pub fn equations(&self, configuration: &Configuration) -> Result<EquationsOfMotion, ClosesLoop> {
        EquationsOfMotion::in_plane(&self.model, &self.edge_on, configuration)
    }
}

/// Whether mass and modes are symmetric and, of a clamped aircraft, the mount.
fn body_is_symmetric(whole: &ReducedModel) -> bool {
    let has_families = whole.modes.iter().all(|mode| mode.family != ModeFamily::Unsymmetric);
    has_families && mass_is_symmetric(whole) && (whole.mount.x, whole.mount.z) == (0.0, 0.0)
}

/// When the controls act alike on strips and their images.
fn even_controls(strips: &[ReducedStrip], images: &[Image]) -> EvenControls {
    let pairs = strips.iter().zip(images);
    EvenControls::new(pairs.map(|(strip, image)| (&strips[image.of], strip, image.sign)))
}

/// The strips on the right and in the plane: those that lift, in the plane last, so that they are computed together; and
/// those that the flow meets edge-on.
fn kept_strips(images: &[Image]) -> [Vec<usize>; 2] {
    let kept = (0..images.len()).filter(|&strip| images[strip].of == strip);
    let (edge_on, mut lifting): (Vec<_>, Vec<_>) = kept.partition(|&strip| images[strip].is_edge_on());
    lifting.sort_by_key(|&strip| images[strip].is_in_plane);
    [lifting, edge_on]
}

/// For each strip that of the kept ones that moves as it does or as its mirror image.
fn counterparts(images: &[Image], [lifting, edge_on]: [&[usize]; 2]) -> Option<Vec<Counterpart>> {
    let place = |kept: &[usize], image: &Image| kept.iter().position(|&strip| strip == image.of);
    let counterpart = |image: &Image| match place(lifting, image) {
        Some(index) => Some(Counterpart::Lifting { index, sign: image.sign }),
        None => place(edge_on, image).map(Counterpart::EdgeOn),
    };
    images.iter().map(counterpart).collect()
}

/// The first strip that is a kept one or its mirror image.
fn first_of(images: &[Image], kept: usize) -> usize {
    // It is itself one of them: none comes before it, or one does.
    images[..kept].iter().position(|image| image.of == kept).unwrap_or(kept)
}

/// The control that holds the pitch of a free aircraft.
fn trim_control(model: &ReducedModel) -> Option<usize> {
    model.control_for(TrimRole::Pitch).filter(|_| model.support == Support::Free)
}

/// A strip as it counts in the half.
fn half_strip(strip: &ReducedStrip, is_in_plane: bool, controls: &EvenControls) -> ReducedStrip {
    let mut strip = strip.clone();
    if is_in_plane {
        strip.lay_in_plane();
    } else {
        strip.width *= 2.0;
    }
    for (control, gain) in strip.flap.iter_mut().flat_map(|flap| flap.gains.iter_mut().enumerate()) {
        // What turns the two sides differently is at rest.
        *gain = if controls.hold_at_zero(control) { 0.0 } else { *gain };
    }
    strip
}

/// The strip on the right or in the plane that is a strip or its mirror image.
#[derive(Clone, Copy)]
struct Image {
    of: usize,
    sign: f64,
    is_in_plane: bool,
}

impl Image {
    /// Whether symmetric flow meets the strip edge-on [theory: symmetry.edge-on].
    fn is_edge_on(self) -> bool {
        self.is_in_plane && self.sign < 0.0
    }
}

/// Whether the undeformed aircraft's mass is symmetric; that of its modes is, if they have families.
fn mass_is_symmetric(model: &ReducedModel) -> bool {
    let (c, j) = (&model.integrals.first_moment, &model.integrals.inertia);
    let (c_size, j_size) = (c.norm(), j.norm());
    c.y.abs() <= SYMMETRIC * c_size && [j[(0, 1)], j[(1, 2)]].iter().all(|x| x.abs() <= SYMMETRIC * j_size)
}

/// The reflection in y = 0 of an aircraft's symmetric modes.
struct Reflection {
    /// Largest distance of a strip from O, m.
    size: f64,
    /// Largest displacement or rotation of a strip per unit coordinate.
    shape: f64,
}

impl Reflection {
    fn of(model: &ReducedModel) -> Self {
        let shapes = model.strips.iter().map(|strip| &strip.shapes);
        Reflection {
            size: largest(model.strips.iter().map(|strip| strip.position.norm())),
            shape: largest(
                shapes.flat_map(|shapes| shapes.translation.iter().chain(&shapes.rotation)).copied(),
            ),
        }
    }

    /// 1 on the right, −1 on the left, 0 in the plane.
    fn side(&self, position: &Vector3<f64>) -> i8 {
        match position.y {
            y if y > SYMMETRIC * self.size => 1,
            y if y < -SYMMETRIC * self.size => -1,
            _ => 0,
        }
    }

    /// For every strip the one on the right or in the plane that it moves like, each with one image. Of two strips that
    /// meet in the plane, being images of each other, the first counts as the right one. Where several could be the image,
    /// it is one whose flap turns alike whatever the controls do, if there is one.
    fn images(&self, strips: &[ReducedStrip]) -> Option<Vec<Image>> {
        let side = |index: usize| self.side(&strips[index].position);
        let mut images: Vec<Option<Image>> = vec![None; strips.len()];
        for turns_alike in [true, false] {
            let sign = |one: usize, other: usize| {
                let (strip, image) = (&strips[one], &strips[other]);
                let sign = self.sign(strip, image)?;
                let is_even = || EvenControls::new([(strip, image, sign)].into_iter()).are_met_by_all();
                (!turns_alike || is_even()).then_some(sign)
            };
            for index in 0..strips.len() {
                if images[index].is_some() {
                    continue;
                }
                if let Some(sign) = (side(index) == 0).then(|| sign(index, index)).flatten() {
                    images[index] = Some(Image { of: index, sign, is_in_plane: true });
                    continue;
                }
                let mut others =
                    (index + 1..strips.len()).filter(|&o| images[o].is_none() && side(o) == -side(index));
                if let Some((other, sign)) = others.find_map(|other| Some((other, sign(index, other)?))) {
                    let [right, left] = if side(index) < 0 { [other, index] } else { [index, other] };
                    images[right] = Some(Image { of: right, sign: 1.0, is_in_plane: false });
                    images[left] = Some(Image { of: right, sign, is_in_plane: false });
                }
            }
        }
        images.into_iter().collect()
    }

    /// For every engine its image, each with one: itself or another.
    fn engine_images(&self, engines: &[ReducedEngine]) -> Option<Vec<usize>> {
        let mut images = vec![None; engines.len()];
        for index in 0..engines.len() {
            if images[index].is_none() {
                let mut others = (index..engines.len()).filter(|&other| images[other].is_none());
                let image = others.find(|&other| self.maps_engine(&engines[index], &engines[other]))?;
                (images[index], images[image]) = (Some(image), Some(index));
            }
        }
        images.into_iter().collect()
    }

    /// Whether one strip is the mirror image of another, and whether its span axis is the mirrored one (1) or its
    /// opposite (−1).
    fn sign(&self, strip: &ReducedStrip, image: &ReducedStrip) -> Option<f64> {
        let ReducedStrip { position, forward, span, shapes, .. } = strip;
        if !self.maps(position, &image.position, self.size) || !self.maps(forward, &image.forward, 1.0) {
            return None;
        }
        let sign = [1.0, -1.0].into_iter().find(|&sign| maps_axial(&(span * sign), &image.span, 1.0))?;
        let numbers = |strip: &ReducedStrip| {
            [
                strip.semichord,
                strip.elastic_axis_aft_of_midchord,
                strip.width,
                strip.lift_slope,
                strip.moment_slope,
                strip.profile_drag,
                strip.leading_edge_suction,
            ]
        };
        let alike = numbers(strip).into_iter().zip(numbers(image)).all(|(a, b)| are_alike(a, b, SYMMETRIC))
            && are_alike(strip.zero_lift_offset, sign * image.zero_lift_offset, SYMMETRIC)
            && are_alike(strip.zero_lift_moment, sign * image.zero_lift_moment, SYMMETRIC)
            && self.maps_shapes(shapes, &image.shapes);
        alike.then_some(sign)
    }

    fn maps_engine(&self, engine: &ReducedEngine, image: &ReducedEngine) -> bool {
        self.maps(&engine.position, &image.position, self.size)
            && self.maps(&engine.direction, &image.direction, 1.0)
            && are_alike(engine.torque, -image.torque, SYMMETRIC)
            && are_alike(engine.angular_momentum, -image.angular_momentum, SYMMETRIC)
            && are_alike(engine.trim_share, image.trim_share, SYMMETRIC)
            && self.maps_shapes(&engine.shapes, &image.shapes)
    }

    fn maps_shapes(&self, shapes: &ModeShapes, image: &ModeShapes) -> bool {
        (0..shapes.modes()).all(|mode| {
            let [translation, rotation] = shapes.of_mode(mode);
            let [moved, turned] = image.of_mode(mode);
            self.maps(&translation, &moved, self.shape) && maps_axial(&rotation, &turned, self.shape)
        })
    }

    /// Whether an arrow becomes another one in the mirror [theory: symmetry.mirror].
    fn maps(&self, arrow: &Vector3<f64>, image: &Vector3<f64>, size: f64) -> bool {
        (Vector3::new(arrow.x, -arrow.y, arrow.z) - image).amax() <= SYMMETRIC * size
    }
}

/// Whether an axis of rotation becomes another one in the mirror [theory: symmetry.mirror].
fn maps_axial(axis: &Vector3<f64>, image: &Vector3<f64>, size: f64) -> bool {
    (Vector3::new(-axis.x, axis.y, -axis.z) - image).amax() <= SYMMETRIC * size
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::test_jet::jet;

    #[test]
    fn the_jet_has_a_half_of_its_right_strips_and_those_in_the_plane() {
        let jet = jet();
        let half = SymmetricHalf::find(jet).unwrap();
        assert_eq!(jet.strips.len(), 99);
        assert_eq!((half.model.strips.len(), half.edge_on.len()), (24 + 8 + 10, 10 + 15));
        assert_eq!((half.modes.len(), half.engines.as_slice()), (12, &[1, 0][..]));
        let area = |strips: &[ReducedStrip]| -> f64 {
            strips.iter().map(|strip| strip.semichord * strip.width).sum()
        };
        let halved = area(&half.model.strips) + area(&half.edge_on);
        assert!((area(&jet.strips) / halved - 1.0).abs() < 1e-14);
        for (strip, counterpart) in jet.strips.iter().zip(&half.strips) {
            let kept = match *counterpart {
                Counterpart::Lifting { index, sign } => {
                    assert_eq!(sign, 1.0);
                    &half.model.strips[index]
                }
                Counterpart::EdgeOn(index) => &half.edge_on[index],
            };
            assert!((strip.position.y.abs() - kept.position.y).abs() < 1e-12);
            assert_eq!(strip.component.replace("left", "right"), kept.component);
        }
    }

    /// Whether the jet, changed, has a half.
    fn has_half(change: impl FnOnce(&mut ReducedModel)) -> bool {
        let mut model = jet().clone();
        change(&mut model);
        SymmetricHalf::find(&model).is_some()
    }

    #[test]
    fn an_aircraft_without_a_mirror_plane_has_no_half() {
        assert!(has_half(|_| {}));
        assert!(!has_half(|jet| jet.strips[3].semichord *= 1.001));
        assert!(!has_half(|jet| jet.strips[3].shapes.rotation[0] += 1e-3));
        assert!(!has_half(|jet| jet.engines[0].position.y -= 0.1));
        assert!(!has_half(|jet| jet.engines[0].trim_share = 0.5));
        for sense in [1.0, -1.0] {
            let has_mirrored_rotors = has_half(|jet| {
                for (engine, sense) in jet.engines.iter_mut().zip([1.0, sense]) {
                    (engine.torque, engine.angular_momentum) = (0.2 * sense, 500.0 * sense);
                }
            });
            assert_eq!(has_mirrored_rotors, sense == -1.0);
        }
        assert!(!has_half(|jet| jet.modes[5].family = ModeFamily::Unsymmetric));
        assert!(!has_half(|jet| jet.integrals.first_moment.y = 1.0));
        assert!(!has_half(|jet| drop(jet.strips.remove(0))));
        let fin = jet().strips.iter().position(|strip| strip.component == "vtail").unwrap();
        assert!(!has_half(|jet| jet.strips[fin].zero_lift_offset = 0.01));
        assert!(!has_half(|jet| jet.strips[fin].zero_lift_moment = 0.01));
        assert!(!has_half(|jet| jet.strips[3].zero_lift_moment = -0.1));
        assert!(!has_half(|jet| jet.strips[3].moment_slope = 0.1));
    }

    #[test]
    fn a_strip_whose_span_axis_points_the_other_way_counts_with_the_opposite_sign() {
        let mut model = jet().clone();
        let left = model.strips.iter().position(|strip| strip.component == "wing_left").unwrap();
        let strip = &mut model.strips[left];
        strip.span = -strip.span;
        let symmetric = jet().control("aileron_symmetric").unwrap();
        let gains = &mut strip.flap.as_mut().unwrap().gains;
        gains[symmetric] = -gains[symmetric];
        let half = SymmetricHalf::find(&model).unwrap();
        assert!(matches!(half.strips[left], Counterpart::Lifting { sign: -1.0, .. }));
    }
}

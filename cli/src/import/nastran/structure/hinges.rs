//! Springs at the beginning of components: of a CBUSH at the root, and of pinned ends, whose springs are as soft as the format allows
//! [theory: coupled-sections.hinge].

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::super::members::Member;
use super::super::mistakes::Origin;
use super::super::stiffness::{ALIGNED, Stiffness};
use super::bodies::Hinge;
use super::pins;
use super::rigid::{RIGID, STIFFEST, rigid};
use super::tree::Tree;
use super::{Component, ComponentElement, NodeRef, SAME_PLACE};

/// Length of the elements there and back between O and a root that springs hold, where no component has their axes, m.
const LINK: f64 = 1e-3;

/// How much stiffer these are than the springs about their axes.
const BESIDE_SPRING: f64 = 1e7;

/// The softest spring of the format, N m/rad: as good as none.
const FREE: f64 = 1e-6;

/// By which a component turns against what it hangs on.
#[derive(Clone, Debug)]
pub struct ComponentHinge {
    pub springs: Springs,
    /// The card that it comes from.
    pub origin: Origin,
    /// What it is, for people.
    pub said: String,
    /// Local y of the component.
    pub y_axis: Vector3<f64>,
}

/// N m/rad; about what has no spring it does not turn.
#[derive(Clone, Debug)]
pub enum Springs {
    About { axis: Vector3<f64>, stiffness: f64 },
    AboutLocalAxes([f64; 3]),
}

/// All hinges, by the elements that begin with them.
#[derive(Debug, Default)]
pub struct Hinges {
    /// The component that leads from O to the root, if springs hold that and no component has their axes.
    pub before_root: Option<Component>,
    of_elements: BTreeMap<usize, ComponentHinge>,
}

impl Hinges {
    /// Of a root that springs hold, and of chains that hang on the tree by pinned ends.
    pub fn new(
        (members, tree, stiffest): (&[Member], &Tree, &[Stiffness]),
        (origin, root): (&Vector3<f64>, Option<&Hinge>),
    ) -> Hinges {
        let mut hinges = Hinges::default();
        if let Some(root) = root {
            hinges.hold_root((members, tree, stiffest), (origin, root));
        }
        for closing in &tree.closings {
            let holds_twist = pins::holds_twist(members, closing);
            for &(element, end) in &closing.roots {
                let member = &members[element];
                let free = pins::free_rotations(member, end);
                let free = [free[0] && holds_twist, free[1], free[2]];
                if let Some(hinge) = pinned(member, free) {
                    hinges.of_elements.insert(element, hinge);
                }
            }
        }
        hinges
    }

    /// That of an element.
    pub fn of(&self, element: usize) -> Option<&ComponentHinge> {
        self.of_elements.get(&element)
    }

    fn hold_root(
        &mut self,
        (members, tree, stiffest): (&[Member], &Tree, &[Stiffness]),
        (origin, root): (&Vector3<f64>, &Hinge),
    ) {
        let is_spring = |stiffness: f64| stiffness > 0.0 && stiffness.is_finite();
        let turning: Vec<usize> = (0..3).filter(|&about| is_spring(root.stiffness[about])).collect();
        if turning.is_empty() {
            return;
        }
        let stiffest = &stiffest[tree.root];
        let otherwise = RIGID * stiffest.gj.max(stiffest.ei_y).max(stiffest.ei_z);
        let spring = |about: usize| {
            let given = root.stiffness[about];
            (if is_spring(given) { given } else { otherwise }).clamp(FREE, STIFFEST)
        };
        let column = |axis: usize| -> Vector3<f64> { root.axes.column(axis).into() };
        let first = only_element(tree).map(|element| (element, &members[element]));
        let first = first.filter(|(element, member)| {
            (member.ends[tree.end_at(*element, tree.root)] - origin).norm() <= SAME_PLACE
        });
        let away = first.map_or_else(Vector3::x, |(_, member)| member.span());
        let alike = |axis: &usize| column(*axis).dot(&away).abs();
        let along = (0..3).max_by(|one, other| alike(one).total_cmp(&alike(other))).unwrap_or(0);
        let [y, z] = [(along + 1) % 3, (along + 2) % 3];
        let springs = match turning[..] {
            [about] => Springs::About { axis: column(about), stiffness: spring(about) },
            _ => Springs::AboutLocalAxes([spring(along), spring(y), spring(z)]),
        };
        let said = match turning.len() {
            3 => String::new(),
            _ => "; what has no spring is rigid".to_owned(),
        };
        let hinge = |y_axis| ComponentHinge { springs, origin: root.origin.clone(), said, y_axis };
        let is_one = |other: &Vector3<f64>, axis: usize| column(axis).cross(other).norm() < ALIGNED;
        match first {
            Some((element, member)) if turning.len() == 1 => {
                self.of_elements.insert(element, hinge(member.y_axis));
            }
            Some((element, member))
                if is_one(&member.span().normalize(), along)
                    && (member.stiffness.is_round() || is_one(&member.y_axis, y)) =>
            {
                self.of_elements.insert(element, hinge(column(y)));
            }
            _ => {
                // About a spring rigid beside that: beside stiff beams too, rounding would spoil it.
                let about = |axis: usize| {
                    let is_spring = is_spring(root.stiffness[axis]);
                    let stiffness = if is_spring { BESIDE_SPRING * spring(axis) } else { otherwise };
                    (stiffness * LINK).clamp(FREE, STIFFEST)
                };
                let stiffness =
                    Stiffness { gj: about(along), ei_y: about(y), ei_z: about(z), ..rigid(stiffest, LINK) };
                let element = ComponentElement { member: None, stiffness };
                let side = if column(along).dot(&away) < 0.0 { -LINK } else { LINK };
                self.before_root = Some(Component {
                    parent: NodeRef::Origin,
                    points: vec![*origin, origin + column(along) * side, *origin],
                    elements: vec![element; 2],
                    y_axis: column(y),
                    hinge: Some(hinge(column(y))),
                    is_strut: false,
                    made_for: None,
                });
            }
        }
    }
}

/// The element on the root, if it is the only one.
fn only_element(tree: &Tree) -> Option<usize> {
    let is_joined = tree.closings.iter().any(|closing| closing.joined_to == tree.root);
    match tree.outward[tree.root][..] {
        [element] if !is_joined => Some(element),
        _ => None,
    }
}

/// Of an end that is free about some of the element's axes.
fn pinned(member: &Member, free: [bool; 3]) -> Option<ComponentHinge> {
    let axes = pins::axes(member);
    let rigid = RIGID * {
        let Stiffness { gj, ei_y, ei_z, .. } = member.stiffness;
        gj.max(ei_y).max(ei_z) / member.length()
    };
    let about: Vec<usize> = (0..3).filter(|&axis| free[axis]).collect();
    let springs = match about[..] {
        [] => return None,
        [about] => Springs::About { axis: axes[about], stiffness: FREE },
        _ => Springs::AboutLocalAxes(free.map(|free| if free { FREE } else { rigid.clamp(FREE, STIFFEST) })),
    };
    let said = format!("; a pin: {FREE:e} N m/rad is as good as none");
    Some(ComponentHinge { springs, origin: member.origin.clone(), said, y_axis: member.y_axis })
}

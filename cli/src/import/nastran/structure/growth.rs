//! From a tree of elements to components: chains that run on, each with one y axis, from the root out.
//!
//! A component is a chain of elements and of the rigid links between their ends. It ends where elements turn by more than 45°, beyond a rigid
//! link by more than 30°, where the principal axes of the next section lie otherwise, and where nothing follows.

use std::collections::VecDeque;

use nalgebra::Vector3;

use super::super::members::{Member, Stiffness, across};
use super::bodies::Hinge;
use super::tree::Tree;
use super::{Component, ComponentElement, NodeRef};

/// A chain goes on where directions have at least this cosine; beyond a rigid link, where one part ends on another, at least the second.
const ONWARD: f64 = std::f64::consts::FRAC_1_SQRT_2;
const ONWARD_BEYOND_A_LINK: f64 = 0.866_025_403_784_438_6;

/// Elements of a component, rigid links with them: the format takes no more.
const LONGEST: usize = 1000;

/// Sine of the least angle between an element and the y axis of its component.
const BESIDE: f64 = 0.05;

/// Sine of 0.01°: axes that are nearer are one.
const ALIGNED: f64 = 1.75e-4;

/// Ends nearer than this share of the next element's length are one place: a rigid link there would be as stiff as rounding is fine.
const SAME_PLACE: f64 = 1e-3;

/// The shortest element of the format, m.
const SHORTEST: f64 = 1e-6;

/// How much stiffer rigid links are than the stiffest element beside them, as stiffness by length.
const RIGID: f64 = 1e5;

/// The stiffest that the format takes.
const STIFFEST: f64 = 1e15;

/// Length of the element that stands for springs at a root, m.
const HINGE_LENGTH: f64 = 1e-3;

/// What has grown.
pub struct Growth<'a> {
    members: &'a [Member],
    tree: &'a Tree,
    /// Of each body the stiffest element on it.
    stiffest: Vec<Stiffness>,
    pub components: Vec<Component>,
    /// Of each body the places on it that are nodes.
    pub ports: Vec<Vec<(Vector3<f64>, NodeRef)>>,
    /// Ends that were moved to a node nearby: the element, how far, m.
    pub moved: Vec<(usize, f64)>,
}

impl<'a> Growth<'a> {
    /// All components of a tree whose root is at a place.
    pub fn new(
        (members, tree): (&'a [Member], &'a Tree),
        origin: Vector3<f64>,
        hinge: Option<&Hinge>,
    ) -> Self {
        let ports = vec![Vec::new(); tree.outward.len()];
        let stiffest = stiffest(members, tree);
        let mut growth = Growth { members, tree, stiffest, components: Vec::new(), ports, moved: Vec::new() };
        let root = match hinge {
            None => NodeRef::Origin,
            Some(hinge) => growth.add_hinge(hinge, &origin),
        };
        growth.ports[tree.root].push((origin, root));
        let mut waiting: VecDeque<(usize, usize)> =
            tree.outward[tree.root].iter().map(|&element| (tree.root, element)).collect();
        while let Some(branch) = waiting.pop_front() {
            growth.grow(branch, &mut waiting);
        }
        growth
    }

    fn grow(&mut self, (mut body, mut element): (usize, usize), waiting: &mut VecDeque<(usize, usize)>) {
        let beginning = self.end_at(element, body);
        let Some((start, parent)) = self.port(body, &beginning, SAME_PLACE * self.members[element].length())
        else {
            return;
        };
        let mut chain = Chain::new(parent, start);
        loop {
            let member = &self.members[element];
            let from = self.end_at(element, body);
            let far = self.tree.other_end(element, body);
            let to = self.end_at(element, far);
            let here = chain.end();
            let gap = (from - here).norm();
            let is_apart = gap > (SAME_PLACE * member.length()).max(SHORTEST);
            let reach = if is_apart { from } else { here };
            let mut longer = chain.clone();
            let goes_on = chain.elements.len() + 2 <= LONGEST
                && !(is_apart && chain.turns((to - from).normalize(), ONWARD_BEYOND_A_LINK));
            let fits = goes_on
                && (!is_apart || longer.add_link(from, body))
                && longer.add_member((element, member), (reach, to));
            if !fits {
                if chain.elements.is_empty() && is_apart {
                    // The link alone, and the element on it.
                    chain.add_link(from, body);
                    let component = self.components.len();
                    self.ports[body].push((from, NodeRef::Node { component, node: 1 }));
                }
                waiting.push_front((body, element));
                break;
            }
            if !is_apart && gap > 0.0 {
                self.moved.push((element, gap));
            }
            chain = longer;
            let component = self.components.len();
            let nodes = chain.points.len();
            if is_apart {
                self.ports[body].push((from, NodeRef::Node { component, node: nodes - 2 }));
            }
            self.ports[far].push((to, NodeRef::Node { component, node: nodes - 1 }));
            let along = (to - reach).normalize();
            let next = self.next(far, &along);
            let others = self.tree.outward[far].iter().filter(|other| Some(**other) != next);
            waiting.extend(others.map(|&other| (far, other)));
            let Some(next) = next else { break };
            (body, element) = (far, next);
        }
        if !chain.elements.is_empty() {
            let component = chain.component(&self.stiffest, self.members);
            self.components.push(component);
        }
    }

    /// The element that goes on most straight.
    fn next(&self, body: usize, along: &Vector3<f64>) -> Option<usize> {
        let cosine = |element: &usize| {
            let away =
                self.end_at(*element, self.tree.other_end(*element, body)) - self.end_at(*element, body);
            away.normalize().dot(along)
        };
        let best = self.tree.outward[body]
            .iter()
            .copied()
            .max_by(|one, other| cosine(one).total_cmp(&cosine(other)));
        best.filter(|element| cosine(element) >= ONWARD)
    }

    fn end_at(&self, element: usize, body: usize) -> Vector3<f64> {
        let member = &self.members[element];
        member.ends[usize::from(self.tree.ends[element][0] != body)]
    }

    /// The node of a body at a place, else the one by which the tree leads to the body: which of the others is nearest, left or right, says
    /// nothing.
    fn port(&self, body: usize, place: &Vector3<f64>, slack: f64) -> Option<(Vector3<f64>, NodeRef)> {
        let ports = &self.ports[body];
        ports.iter().find(|port| (port.0 - place).norm() <= slack).or(ports.first()).copied()
    }

    /// A short element whose ends turn against each other as springs do; it leads to the root from O, which lies beside it.
    fn add_hinge(&mut self, hinge: &Hinge, origin: &Vector3<f64>) -> NodeRef {
        let first = self.tree.outward[self.tree.root].first().copied();
        let away = first.map_or_else(Vector3::y, |element| {
            self.end_at(element, self.tree.other_end(element, self.tree.root)) - origin
        });
        let alike = |axis: usize| hinge.axes.column(axis).dot(&away).abs();
        let along = (0..3).max_by(|&one, &other| alike(one).total_cmp(&alike(other))).unwrap_or(0);
        let [y, z] = [(along + 1) % 3, (along + 2) % 3];
        let axis: Vector3<f64> = hinge.axes.column(along).into();
        let axis = if axis.dot(&away) < 0.0 { -axis } else { axis };
        let stiffest = self.stiffest[self.tree.root];
        let rigid = |of: fn(&Stiffness) -> f64| RIGID * of(&stiffest);
        let spring = |about: usize, otherwise: f64| {
            let given = hinge.stiffness[about];
            let given = if given > 0.0 && given.is_finite() { given } else { otherwise };
            (given * HINGE_LENGTH).clamp(1e-6, STIFFEST)
        };
        let stiffness = Stiffness {
            ea: (rigid(|of| of.ea) * HINGE_LENGTH).clamp(1e-6, STIFFEST),
            gj: spring(along, rigid(|of| of.gj)),
            ei_y: spring(y, rigid(|of| of.ei_y.max(of.ei_z))),
            ei_z: spring(z, rigid(|of| of.ei_y.max(of.ei_z))),
        };
        self.components.push(Component {
            parent: NodeRef::Origin,
            points: vec![origin - axis * HINGE_LENGTH, *origin],
            elements: vec![ComponentElement { member: None, stiffness }],
            y_axis: hinge.axes.column(y).into(),
        });
        NodeRef::Node { component: 0, node: 1 }
    }
}

/// Of each body the greatest stiffness by length of the elements on it.
fn stiffest(members: &[Member], tree: &Tree) -> Vec<Stiffness> {
    let mut stiffest = vec![Stiffness { ea: 0.0, gj: 0.0, ei_y: 0.0, ei_z: 0.0 }; tree.outward.len()];
    for (member, ends) in members.iter().zip(&tree.ends) {
        let Stiffness { ea, gj, ei_y, ei_z } = member.stiffness;
        let length = member.length();
        for &body in ends {
            let most = &mut stiffest[body];
            most.ea = most.ea.max(ea / length);
            most.gj = most.gj.max(gj / length);
            most.ei_y = most.ei_y.max(ei_y / length);
            most.ei_z = most.ei_z.max(ei_z / length);
        }
    }
    stiffest
}

/// A component that is growing.
#[derive(Clone)]
struct Chain {
    parent: NodeRef,
    points: Vec<Vector3<f64>>,
    /// Members, or the bodies of links.
    elements: Vec<Result<usize, usize>>,
    /// Stiffness of members in the axes of the component; of links none.
    stiffness: Vec<Option<Stiffness>>,
    y_axis: Option<Vector3<f64>>,
}

impl Chain {
    fn new(parent: NodeRef, start: Vector3<f64>) -> Self {
        Chain { parent, points: vec![start], elements: Vec::new(), stiffness: Vec::new(), y_axis: None }
    }

    fn end(&self) -> Vector3<f64> {
        self.points[self.points.len() - 1]
    }

    fn directions(&self) -> impl Iterator<Item = Vector3<f64>> + '_ {
        self.points.windows(2).map(|ends| (ends[1] - ends[0]).normalize())
    }

    /// Whether its last element has another direction than one that is to follow.
    fn turns(&self, next: Vector3<f64>, least_cosine: f64) -> bool {
        self.directions().last().is_some_and(|last| last.dot(&next) < least_cosine)
    }

    /// Whether a rigid link could be added.
    fn add_link(&mut self, to: Vector3<f64>, body: usize) -> bool {
        let along = (to - self.end()).normalize();
        let fits = self.y_axis.is_none_or(|y| is_beside(&y, &along));
        self.points.push(to);
        self.elements.push(Err(body));
        self.stiffness.push(None);
        fits
    }

    /// Whether an element could be added.
    fn add_member(
        &mut self,
        (element, member): (usize, &Member),
        (from, to): (Vector3<f64>, Vector3<f64>),
    ) -> bool {
        let along = (to - from).normalize();
        let fitted = match self.y_axis {
            Some(y) => fitted(member, &y, &along),
            None if member.stiffness.is_round() => Some(member.stiffness),
            None => {
                let written = member.y_written;
                let y = if is_beside(&written, &along) { written } else { member.y_axis };
                self.y_axis = Some(y);
                self.directions().all(|along| is_beside(&y, &along)).then_some(member.stiffness)
            }
        };
        self.points.push(to);
        self.elements.push(Ok(element));
        self.stiffness.push(fitted);
        fitted.is_some()
    }

    fn component(self, stiffest: &[Stiffness], members: &[Member]) -> Component {
        let y_axis = self.y_axis.unwrap_or_else(|| self.any_y_axis());
        let mut elements = Vec::with_capacity(self.elements.len());
        for (place, (element, stiffness)) in self.elements.iter().zip(&self.stiffness).enumerate() {
            let length = (self.points[place + 1] - self.points[place]).norm();
            elements.push(match element {
                Ok(member) => {
                    let stiffness = stiffness.unwrap_or(members[*member].stiffness);
                    ComponentElement { member: Some(*member), stiffness }
                }
                Err(body) => ComponentElement { member: None, stiffness: rigid(&stiffest[*body], length) },
            });
        }
        Component { parent: self.parent, points: self.points, elements, y_axis }
    }

    /// Of round sections: the one of the body's axes that is most across all elements.
    fn any_y_axis(&self) -> Vector3<f64> {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let worst =
            |axis: &Vector3<f64>| self.directions().map(|along| along.cross(axis).norm()).fold(1.0, f64::min);
        axes.into_iter().max_by(|one, other| worst(one).total_cmp(&worst(other))).unwrap_or_else(Vector3::y)
    }
}

fn is_beside(y: &Vector3<f64>, along: &Vector3<f64>) -> bool {
    y.cross(along).norm() > BESIDE
}

/// Stiffness in the axes that a component's y gives an element; none where its principal axes are others.
fn fitted(member: &Member, y: &Vector3<f64>, along: &Vector3<f64>) -> Option<Stiffness> {
    if !is_beside(y, along) {
        return None;
    }
    if member.stiffness.is_round() {
        return Some(member.stiffness);
    }
    let y = across(along, y)?;
    let sine = y.cross(&member.y_axis).norm();
    let cosine = y.dot(&member.y_axis).abs();
    if sine < ALIGNED {
        Some(member.stiffness)
    } else if cosine < ALIGNED {
        Some(member.stiffness.quarter_turned())
    } else {
        None
    }
}

/// Of a link of a length, m, among elements with a greatest stiffness by length.
fn rigid(stiffest: &Stiffness, length: f64) -> Stiffness {
    let times = |by_length: f64| (RIGID * by_length * length).clamp(1e-6, STIFFEST);
    let bending = stiffest.ei_y.max(stiffest.ei_z).max(stiffest.gj);
    Stiffness { ea: times(stiffest.ea), gj: times(bending), ei_y: times(bending), ei_z: times(bending) }
}

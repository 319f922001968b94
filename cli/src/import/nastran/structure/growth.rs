//! From a tree of elements to components: chains that run on, each with one y axis, from the root out.
//!
//! A component is a chain of elements and of the rigid links between their ends. It ends where elements turn by more than 60°, at pinned
//! ends and where nothing follows.

use std::collections::VecDeque;

use nalgebra::Vector3;

use super::super::members::{Member, across};
use super::super::stiffness::Stiffness;
use super::hinges::Hinges;
use super::rigid::rigid;
use super::tree::Tree;
use super::{Component, ComponentElement, NodeRef};

/// A chain goes on where directions have at least this cosine.
const ONWARD: f64 = 0.5;

/// Elements of a component, rigid links with them: the format takes no more.
const LONGEST: usize = 1000;

/// The same beyond a rigid link, 30°: what a link carries is most often another beam.
const ONWARD_BEYOND_LINK: f64 = 0.866;

/// Sine of the least angle between an element and the y axis of its component.
const BESIDE: f64 = 0.05;

/// Ends nearer than this share of the next element's length are one place: a rigid link there would be as stiff as rounding is fine.
pub const NEAR_BY_LENGTH: f64 = 1e-3;

/// Ends that are nearer, m, are apart by rounding: of what is moved so far nothing is said.
const ROUNDING: f64 = 1e-9;

/// The shortest element of the format, m.
const SHORTEST: f64 = 1e-6;

/// What has grown.
pub struct Growth<'a> {
    members: &'a [Member],
    tree: &'a Tree,
    hinges: &'a Hinges,
    /// Of each body the stiffest element on it.
    pub stiffest: Vec<Stiffness>,
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
        (origin, hinges): (Vector3<f64>, &'a Hinges),
        stiffest: Vec<Stiffness>,
    ) -> Self {
        let ports = vec![Vec::new(); tree.outward.len()];
        let mut growth =
            Growth { members, tree, hinges, stiffest, components: Vec::new(), ports, moved: Vec::new() };
        let root = match &hinges.before_root {
            None => NodeRef::Origin,
            Some(component) => {
                growth.components.push(component.clone());
                NodeRef::Node { component: 0, node: component.elements.len() }
            }
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
        let Some((start, parent)) =
            self.port(body, &beginning, NEAR_BY_LENGTH * self.members[element].length())
        else {
            return;
        };
        let mut chain = Chain::new(parent, start);
        let hinge = self.hinges.of(element);
        loop {
            let member = &self.members[element];
            let from = self.end_at(element, body);
            let far = self.tree.other_end(element, body);
            let to = self.end_at(element, far);
            let here = chain.end();
            let gap = (from - here).norm();
            let is_apart = gap > (NEAR_BY_LENGTH * member.length()).max(SHORTEST);
            let reach = if is_apart { from } else { here };
            let mut longer = chain.clone();
            let begins_hinged = chain.elements.is_empty() && hinge.is_some();
            if let Some(hinge) = hinge.filter(|_| begins_hinged) {
                longer.y_axis = Some(hinge.y_axis);
            }
            let is_shared = chain.elements.is_empty() && self.begins_with_others(body, &from);
            let fits = chain.elements.len() + 2 <= LONGEST
                && (!is_apart || (longer.add_link(from, body) && !begins_hinged && !is_shared))
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
            if !is_apart && gap > ROUNDING {
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
            let next = self.next(far, &to, &along);
            let others = self.tree.outward[far].iter().filter(|other| Some(**other) != next);
            waiting.extend(others.map(|&other| (far, other)));
            let Some(next) = next else { break };
            (body, element) = (far, next);
        }
        if !chain.elements.is_empty() {
            let is_hinged = chain.elements.first().is_some_and(Result::is_ok);
            let hinge = hinge.filter(|_| is_hinged).cloned();
            let component = chain.component(&self.stiffest, self.members);
            self.components.push(Component { hinge, ..component });
        }
    }

    /// Whether several elements leave a body at one of its places: a link there belongs to all of them.
    fn begins_with_others(&self, body: usize, place: &Vector3<f64>) -> bool {
        let is_here = |element: &&usize| (self.end_at(**element, body) - place).norm() <= SHORTEST;
        self.tree.outward[body].iter().filter(is_here).count() > 1
    }

    /// The element that goes on most straight.
    fn next(&self, body: usize, place: &Vector3<f64>, along: &Vector3<f64>) -> Option<usize> {
        let cosine = |element: &usize| {
            let away =
                self.end_at(*element, self.tree.other_end(*element, body)) - self.end_at(*element, body);
            away.normalize().dot(along)
        };
        let best = self.tree.outward[body]
            .iter()
            .copied()
            .filter(|element| self.hinges.of(*element).is_none())
            .max_by(|one, other| cosine(one).total_cmp(&cosine(other)));
        best.filter(|&element| {
            let gap = (self.end_at(element, body) - place).norm();
            let is_apart = gap > NEAR_BY_LENGTH * self.members[element].length();
            cosine(&element) >= if is_apart { ONWARD_BEYOND_LINK } else { ONWARD }
        })
    }

    fn end_at(&self, element: usize, body: usize) -> Vector3<f64> {
        self.members[element].ends[self.tree.end_at(element, body)]
    }

    /// The node of a body at a place, else the one by which the tree leads to the body: which of the others is nearest, left or right, says
    /// nothing.
    pub fn port(&self, body: usize, place: &Vector3<f64>, slack: f64) -> Option<(Vector3<f64>, NodeRef)> {
        let ports = &self.ports[body];
        ports.iter().find(|port| (port.0 - place).norm() <= slack).or(ports.first()).copied()
    }

    /// A rigid link between a node and a place beside it, as a component.
    pub fn add_link(
        &mut self,
        (from, parent): (Vector3<f64>, NodeRef),
        to: Vector3<f64>,
        body: usize,
    ) -> NodeRef {
        let mut chain = Chain::new(parent, from);
        chain.add_link(to, body);
        let component = self.components.len();
        self.components.push(chain.component(&self.stiffest, self.members));
        self.ports[body].push((to, NodeRef::Node { component, node: 1 }));
        NodeRef::Node { component, node: 1 }
    }
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
                fitted(member, &y, &along).filter(|_| self.directions().all(|along| is_beside(&y, &along)))
            }
        };
        self.points.push(to);
        self.elements.push(Ok(element));
        self.stiffness.push(fitted);
        fitted.is_some()
    }

    fn component(self, stiffest: &[Stiffness], members: &[Member]) -> Component {
        let y_axis = self.y_axis.unwrap_or_else(|| across_all(&self.points));
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
        let Chain { parent, points, .. } = self;
        Component { parent, points, elements, y_axis, hinge: None, is_strut: false, made_for: None }
    }
}

/// Of round sections: the one of the body's axes that is most across all elements between some points.
pub fn across_all(points: &[Vector3<f64>]) -> Vector3<f64> {
    let directions = || points.windows(2).map(|ends| (ends[1] - ends[0]).normalize());
    let worst = |axis: &Vector3<f64>| directions().map(|along| along.cross(axis).norm()).fold(1.0, f64::min);
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    axes.into_iter().max_by(|one, other| worst(one).total_cmp(&worst(other))).unwrap_or_else(Vector3::y)
}

fn is_beside(y: &Vector3<f64>, along: &Vector3<f64>) -> bool {
    y.cross(along).norm() > BESIDE
}

/// Stiffness in the axes that a component's y gives an element; none where that is along it.
fn fitted(member: &Member, y: &Vector3<f64>, along: &Vector3<f64>) -> Option<Stiffness> {
    if !is_beside(y, along) {
        return None;
    }
    let y = across(along, y)?;
    let z = member.span().normalize().cross(&member.y_axis);
    Some(member.stiffness.in_axes([y.dot(&member.y_axis), y.dot(&z)], along.dot(&member.span()) < 0.0))
}

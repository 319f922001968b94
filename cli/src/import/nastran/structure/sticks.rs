//! Rigid beams that the deck has not, for panels that no beam of it runs along.

use nalgebra::Vector3;

use super::growth::across_all;
use super::rigid::rigid;
use super::{Component, ComponentElement, MadeFor, NodeRef, Structure};
use crate::import::nastran::stiffness::Stiffness;

impl Structure {
    /// Where a node is, m from O.
    pub fn place_of(&self, node: NodeRef) -> Vector3<f64> {
        match node {
            NodeRef::Origin => Vector3::zeros(),
            NodeRef::Node { component, node } => self.components[component].points[node],
        }
    }

    /// All nodes of the deck's own beams, O first.
    pub fn nodes_of_deck(&self) -> impl Iterator<Item = NodeRef> + '_ {
        let of_deck =
            self.components.iter().enumerate().filter(|(_, component)| component.made_for.is_none());
        let nodes = of_deck.flat_map(|(component, found)| {
            (1..found.points.len()).map(move |node| NodeRef::Node { component, node })
        });
        std::iter::once(NodeRef::Origin).chain(nodes)
    }

    /// A rigid beam from a node through some points, m from O.
    pub fn add_stick(
        &mut self,
        parent: NodeRef,
        through: impl Iterator<Item = Vector3<f64>>,
        made_for: MadeFor,
    ) {
        let points: Vec<Vector3<f64>> = std::iter::once(self.place_of(parent)).chain(through).collect();
        let stiffest = self.stiffest_at(parent);
        let element = |ends: &[Vector3<f64>]| ComponentElement {
            member: None,
            stiffness: rigid(&stiffest, (ends[1] - ends[0]).norm()),
        };
        let elements = points.windows(2).map(element).collect();
        let y_axis = across_all(&points);
        let made_for = Some(made_for);
        self.components.push(Component {
            parent,
            points,
            elements,
            y_axis,
            hinge: None,
            is_strut: false,
            made_for,
        });
    }

    /// The greatest stiffness by length of the elements on the body of a node; where it has none, of all.
    fn stiffest_at(&self, node: NodeRef) -> Stiffness {
        let has_node = |ports: &Vec<(Vector3<f64>, NodeRef)>| ports.iter().any(|(_, port)| *port == node);
        let of_body = self.ports.iter().position(has_node).and_then(|body| self.stiffest.get(body));
        let all = || {
            self.stiffest
                .iter()
                .max_by(|one, other| one.ei_y.max(one.ei_z).total_cmp(&other.ei_y.max(other.ei_z)))
        };
        of_body.filter(|stiffest| stiffest.ea > 0.0).or_else(all).copied().unwrap_or_default()
    }
}

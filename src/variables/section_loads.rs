//! Section loads as outputs: six of each cut [theory: section-loads.components].

use crate::structure::{ReducedCut, ReducedModel};

use super::load_component::LoadComponent;
use super::output_slot::OutputSlot;
use super::row::output;
use super::variable::Variable;

/// The rows of all cuts.
pub(super) fn rows(model: &ReducedModel) -> Vec<Variable> {
    let of_cut = |(cut, ReducedCut { name, component: beam, .. }): (usize, &ReducedCut)| {
        LoadComponent::ALL.map(|component| {
            let text = format!(
                "{} of all that acts outboard of the cut {name} through {beam}",
                description(component)
            );
            let slot = OutputSlot::SectionLoad { cut, component };
            output(format!("loads.{name}.{}", component.name()), component.unit(), slot, text)
        })
    };
    model.cuts.iter().enumerate().flat_map(of_cut).collect()
}

/// What it does, for people.
fn description(component: LoadComponent) -> &'static str {
    match component {
        LoadComponent::Shear => "Shear force, positive upwards (on a fin to the left),",
        LoadComponent::ShearChordwise => "Chordwise shear force, positive forwards (on a body to the right),",
        LoadComponent::Axial => "Force along the beam, positive outboard,",
        LoadComponent::Torsion => {
            "Torsion, positive nose-up (on a fin nose-left, of a body about its forward axis),"
        }
        LoadComponent::Bending => "Bending moment, positive where it raises the tip,",
        LoadComponent::BendingChordwise => {
            "Chordwise bending moment, positive where it moves the tip forwards,"
        }
    }
}

//! Section loads as outputs: six of each cut [theory: section-loads.components].

use crate::structure::{ReducedCut, ReducedModel};

use super::load_component::LoadComponent;
use super::output_slot::OutputSlot;
use super::row::output;
use super::variable::Variable;

/// The rows of all cuts.
pub(super) fn rows(model: &ReducedModel) -> Vec<Variable> {
    let of_cut = |(number, cut): (usize, &ReducedCut)| {
        let (ReducedCut { name, .. }, place) = (cut, place(cut));
        LoadComponent::ALL.map(|component| {
            let text =
                format!("{} of all that acts outboard of the cut {name} {place}", description(component));
            let slot = OutputSlot::SectionLoad { cut: number, component };
            output(format!("loads.{name}.{}", component.name()), component.unit(), slot, text)
        })
    };
    model.cuts.iter().enumerate().flat_map(of_cut).collect()
}

/// Where a cut was asked for and where it stands.
fn place(ReducedCut { component, at, asked, .. }: &ReducedCut) -> String {
    let at = (at * 1e6).round() / 1e6;
    if (at - asked).abs() < 1e-6 {
        format!("through {component} at {at} of its length")
    } else {
        format!("through {component} at {at} of its length, the node nearest to {asked}")
    }
}

/// What it does, for people.
fn description(component: LoadComponent) -> &'static str {
    match component {
        LoadComponent::Shear => {
            "Shear force, positive upwards (on a fin to the left, on an upright body forwards),"
        }
        LoadComponent::ShearChordwise => {
            "Chordwise shear force, positive forwards (on a body that is lengthwise or upright to the right),"
        }
        LoadComponent::Axial => "Force along the beam, positive outboard,",
        LoadComponent::Torsion => {
            "Torsion, positive nose-up (on a fin or an upright body nose-left, of a lengthwise body about its forward axis),"
        }
        LoadComponent::Bending => {
            "Bending moment, positive where it moves the tip as positive shear does (a wing's upwards),"
        }
        LoadComponent::BendingChordwise => {
            "Chordwise bending moment, positive where it moves the tip as positive chordwise shear does (a wing's forwards),"
        }
    }
}

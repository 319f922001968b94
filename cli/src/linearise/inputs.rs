//! Which inputs a linear model has, as the command line asks for them.

use clap::ValueEnum;
use flexible_aircraft::LinearModel;

/// The unit of what the air does: no other input has it.
const OF_AIR: &str = "m/s";

/// Inputs that stay.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Chosen {
    /// Controls, thrusts and the air
    All,
    /// Controls and thrusts
    Controls,
}

impl Chosen {
    /// Takes the others out of a model.
    pub fn choose(self, model: &mut LinearModel) {
        if self == Chosen::All {
            return;
        }
        let stays: Vec<bool> = model.inputs.iter().map(|name| name.unit != OF_AIR).collect();
        let columns: Vec<usize> = (0..stays.len()).filter(|&column| stays[column]).collect();
        for matrix in [&mut model.b, &mut model.d, &mut model.bd, &mut model.dd] {
            *matrix = matrix.select_columns(&columns);
        }
        model.u0 = columns.iter().map(|&column| model.u0[column]).collect();
        model.inputs = columns.iter().map(|&column| model.inputs[column].clone()).collect();
    }
}

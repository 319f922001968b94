//! Mutated bytes of saved states.

use super::*;
use crate::fmi2::tests::mutated::mutated_states_are_refused_or_go_on;

#[test]
fn a_mutated_state_of_co_simulation_is_refused_or_goes_on() {
    mutated_states_are_refused_or_go_on::<Fmu>(Kind::CoSimulation);
}

#[test]
fn a_mutated_state_of_model_exchange_is_refused_or_goes_on() {
    mutated_states_are_refused_or_go_on::<Fmu>(Kind::ModelExchange);
}

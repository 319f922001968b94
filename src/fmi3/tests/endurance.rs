//! Many instances and much integration: no leak, no growth.

use super::*;
use crate::fmi2::tests::endurance::{
    a_thousand_instances_come_and_go, twenty_thousand_evaluations_allocate_nothing,
};

#[test]
fn a_thousand_instances_for_co_simulation_come_and_go_without_a_leak() {
    a_thousand_instances_come_and_go::<Fmu>(Kind::CoSimulation);
}

#[test]
fn a_thousand_instances_for_model_exchange_come_and_go_without_a_leak() {
    a_thousand_instances_come_and_go::<Fmu>(Kind::ModelExchange);
}

#[test]
fn integrating_for_a_minute_allocates_nothing() {
    twenty_thousand_evaluations_allocate_nothing::<Fmu>();
}

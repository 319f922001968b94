//! Nonlinear flight dynamics of a flexible aircraft, exported as an FMI 2.0 co-simulation unit.
//!
//! The science is B. C. B. Tse, *Effects of Inertial and Geometric Nonlinearities in the Simulation of
//! Flexible Aircraft Dynamics*, MASc thesis, University of Toronto, 2013; section numbers in brackets in
//! the module comments are the thesis'. SI units and radians everywhere; body frame x forward, y right,
//! z down; inertial frame north-east-down.
//!
//! Data flows one way, and a layer never looks up:
//!
//! | module | takes | gives |
//! | --- | --- | --- |
//! | [`aircraft`] | an aircraft file (TOML) | [`aircraft::Aircraft`], every element, bay, strip and engine |
//! | [`structure`] | `Aircraft` | [`structure::ReducedModel`], all that the flight needs |
//! | [`aerodynamics`] | a strip's local flow | its inflow, lift, moment, drag |
//! | [`dynamics`] | `ReducedModel`, state, inputs | accelerations, trim |
//! | [`simulation`] | `ReducedModel`, settings | a flight in time |
//! | [`stability`] | `ReducedModel`, settings | flutter and divergence over a range of airspeeds |
//! | [`variables`] | `ReducedModel` | the table of FMI variables |
//! | `fmi2` | everything above | the C ABI (feature `fmi`) |

pub mod aerodynamics;
pub mod aircraft;
mod arithmetic;
mod columns;
pub mod dynamics;
#[cfg(feature = "fmi")]
pub mod fmi2;
mod lane_vectors;
mod lanes;
pub mod simulation;
pub mod stability;
pub mod structure;
pub mod variables;

//! Nonlinear flight dynamics of a flexible aircraft, exported as a unit of FMI 2.0 and 3.0, for co-simulation and model exchange.
//!
//! The science is B. C. B. Tse, *Effects of Inertial and Geometric Nonlinearities in the Simulation of
//! Flexible Aircraft Dynamics*, MASc thesis, University of Toronto, 2013; its equations, as corrected and
//! as computed here, are in the repository's `docs/theory`, where each has a label. Comments cite labels, and beside them the
//! thesis' equations and sections. SI units and radians everywhere; body frame x forward, y right, z down; inertial
//! frame north-east-down [theory: frames.conventions, frames.axes].
//!
//! In `Cargo.toml`, beside a checkout of the repository; without `fmi` it is the physics alone:
//!
//! ```toml
//! [dependencies]
//! flexible-aircraft = { path = "../flexible-aircraft", default-features = false }
//! ```
//!
//! From a file to a flight, by the [names of variables](Flight::variables) that the FMU has too:
//!
//! ```
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! use flexible_aircraft::{Aircraft, Flight};
//!
//! let mut flight = Flight::new(Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?);
//! flight.set("elevator", -0.02)?; // rad, about the trim; positive nose-down
//! flight.advance(2.0)?; // s
//! println!("pitch {:.4} rad", flight.get("attitude.pitch")?);
//! println!("wing tip {:.3} m up", flight.get("deflection.wing_tip_right.up")?);
//! # Ok(())
//! # }
//! ```
//!
//! [`Flight`] is the face for scripts and programs. Below it, each with its own types: [`flight::Simulation`] is stepped with
//! typed inputs and outputs and never allocates; [`plant::Plant`] gives rates, outputs and linearised motion at any state;
//! [`stability`] finds flutter; `flexair`, the command, packages the FMU. The folder `examples` has a flight, a control law in a
//! loop and many random gusts from one snapshot.
//!
//! Data flows one way, and a layer never looks up:
//!
//! | module | takes | gives |
//! | --- | --- | --- |
//! | [`math`] | numbers | vectors, matrices, rotations |
//! | [`aircraft`] | an aircraft file (TOML) | [`aircraft::Aircraft`], every element, bay, strip and engine |
//! | [`structure`] | `Aircraft` | [`structure::ReducedModel`], all that the flight needs |
//! | [`air`] | an altitude, a section | the state of the air and how it moves there |
//! | [`kinematics`] | q, q̇, the motion of the body axes | where sections are and how they move |
//! | [`strips`] | sections in the air | their inflow, loads, apparent mass |
//! | [`equations`] | `ReducedModel`, state, controls | accelerations at six fidelity levels |
//! | [`plant`] | the equations | rates and outputs at any state under any inputs, the linear part; trims, linearised motion |
//! | [`stability`] | `ReducedModel`, settings | flutter and divergence over a range of airspeeds, modes in flight by their names |
//! | [`symmetry`] | `ReducedModel` | its half, which flies for the whole while motion is symmetric; [`symmetry::Plants`], both |
//! | [`devices`] | commands, settings, time | what acts, and what sampled sensors give |
//! | [`flight`] | `ReducedModel`, settings | a flight in time |
//! | [`variables`] | `ReducedModel` | the table of FMI variables |
//! | [`Flight`], [`LinearModel`], [`flight_modes`], [`HarmonicGusts`] | `ReducedModel` | a flight, a linear model, its modes, and what gusts do to it, by the names of variables |
//! | `fmi` | everything above | an FMU without its C: instance, life cycle, saved states, model description (feature `fmi`) |
//! | `fmi2`, `fmi3` | `fmi` | the C ABI of FMI 2.0 and 3.0 (feature `fmi`) |
//!
//! [`math`], [`air`], [`kinematics`], [`strips`], [`equations`] and [`symmetry`] are the inside: open to those who compare or time
//! parts of the method; a flight, a trim or a linear model needs none of their functions.
//!
//! What the model leaves out [theory: limits-of-validity.aerodynamics, limits-of-validity.structure], how far it holds
//! [theory: limits-of-validity.large-deflections, limits-of-validity.cubic-energy, limits-of-validity.basis],
//! and of the jet in particular [theory: limits-of-validity.suction].

pub mod air;
pub mod aircraft;
mod by_name;
pub mod devices;
pub mod equations;
pub mod flight;
#[cfg(feature = "fmi")]
pub mod fmi;
#[cfg(feature = "fmi")]
pub mod fmi2;
#[cfg(feature = "fmi")]
pub mod fmi3;
pub mod kinematics;
pub mod math;
pub mod plant;
#[cfg_attr(not(feature = "fmi"), expect(dead_code, reason = "the states of instances ask for more"))]
mod sealed;
pub mod stability;
pub mod strips;
pub mod structure;
pub mod symmetry;
pub mod variables;

pub use aircraft::Aircraft;
pub use by_name::{
    Flight, FlightError, HarmonicColumn, HarmonicGusts, InTurbulence, Inflow, LinearContents, LinearModel,
    LinearName, OutputInTurbulence, Setting, flight_modes,
};
pub use structure::ReducedModel;

/// The README's Rust compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

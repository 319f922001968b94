//! Physics: each file holds one claim against a source that is not this program.

mod conservation;
mod eigenvalues;
mod fidelity_levels;
mod flight;
mod frequencies;
mod refusals;
mod trim;
mod wind_tunnel;

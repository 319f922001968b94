//! Physics: each file holds one claim against a source that is not this program.

mod beam;
mod coincident_nodes;
mod conservation;
mod eigenvalues;
mod energy_balance;
mod equations_of_motion;
mod fidelity_levels;
mod flight;
mod flutter;
mod frequencies;
mod inflow;
mod linearisation;
mod modal_integrals;
mod record;
mod refusals;
mod rigid_modes;
mod sensors;
mod spin_up;
mod strain_energy;
mod strip_loads;
mod suction;
mod symmetry;
mod trim;
mod wind_tunnel;

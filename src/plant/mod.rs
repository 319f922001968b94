//! The plant: what everybody above asks of the aircraft. Rates, outputs and the linear part at any state under any
//! inputs, trims, linearised motion, linear models.
//!
//! [theory: equations-of-motion.rows, outputs.sensors, trim.steady-flight, linearisation.state-matrix, linearisation.inputs; thesis §5.1]

mod air_data;
mod amplitudes;
mod course;
mod cut_loads;
mod free_modes;
mod instant_inflow;
mod limits;
mod linear_model;
mod linear_part;
mod linearisation;
mod load_steps;
mod manoeuvre;
mod outputs;
mod placement;
mod point_loads;
mod section_loads;
mod sensors;
mod setting_error;
mod settings;
mod static_stability;
mod system;
mod trim;
mod trim_diagnosis;
mod trim_error;
mod trim_problem;
mod trim_search;
mod trim_tangent;
mod trim_within;
mod wake_blocks;

pub use air_data::{AirData, Path};
pub use course::Course;
pub use cut_loads::CutLoads;
pub use limits::{LimitExceeded, LimitedQuantity};
pub use linear_model::{GustColumns, LinearInput, Linearisation};
pub(crate) use linear_part::Diagonal;
pub use linear_part::{LinearPart, Spectrum};
pub(crate) use linearisation::eigenvalues;
pub use linearisation::{EigenvaluesNotFound, StateMatrix, Unknown, UnknownsKept};
pub use manoeuvre::{ConditionSettings, Lateral, Manoeuvre, ManoeuvreChoice, SteadyFlight};
pub(crate) use manoeuvre::{LARGEST_LOAD_FACTOR, STEEPEST};
pub use outputs::{Deflection, Outputs};
pub use placement::Placement;
pub use point_loads::{PointLoad, PointLoadError};
pub use sensors::{BodyMotion, Sensors};
pub use setting_error::SettingError;
pub use settings::{ModeSelection, PlantSettings};
pub use static_stability::{NoStaticStability, StaticStability};
pub(crate) use system::Packaged;
pub use system::{PackagedStrip, Plant};
pub use trim::{Trim, TrimCondition, TrimPoint};
pub use trim_error::{TrimError, TrimFailure};
pub(crate) use trim_tangent::TrimTangents;
pub use trim_within::{Held, LimitedTrimError, Shortfall, TrimLimits};
pub(crate) use wake_blocks::{WakeBlocks, product};

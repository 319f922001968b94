//! The air: the atmosphere, and how it moves at a point [theory: air.atmosphere, air.tunnel, air.wind, gusts.field].

mod atmosphere;
mod flow;
mod frozen;
mod gust;
mod imposed;
mod out_of_range;
mod turbulence;

pub use atmosphere::{Air, Atmosphere, STANDARD_GRAVITY};
pub(crate) use atmosphere::{SEA_LEVEL_DENSITY, SEA_LEVEL_PRESSURE};
pub use flow::UniformFlow;
pub(crate) use flow::{MetAir, MetAt, UniformlyMet};
pub(crate) use frozen::{AlongTrack, Field};
pub use frozen::{Extent, FrozenGust, Track, TrackSeen};
pub use gust::{CS25_GRADIENTS, GustCriterion, GustSettings, GustShape};
pub(crate) use gust::{GUST_GRADIENTS, GUST_STARTS, MAXIMUM_OPERATING_ALTITUDES};
pub use imposed::{GustWave, ImposedGust};
pub use out_of_range::OutOfRange;
pub(crate) use turbulence::TURBULENCE_SCALES;
pub use turbulence::{Spectrum, TurbulenceComponents, TurbulenceSettings};

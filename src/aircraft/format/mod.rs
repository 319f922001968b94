//! The format of aircraft files as data: which tables there are, which fields each has, what these may hold, what holds where
//! they are left out.
//!
//! Whatever is said of a field stands here once. The reader asks these tables, so that a range or a default is what it is
//! read with; messages, the tables on the format's page and the schema that editors take (`flexair schema`) are written from
//! them. What no table can tell, since it depends on other parts of the aircraft, the reader finds by itself: that lists have
//! as many entries as there are elements, that names exist, that stretches do not overlap, that something has mass.
//!
//! ```
//! use flexible_aircraft::aircraft::format::{Absent, FILE, Kind};
//!
//! let gravity = FILE.fields.iter().find(|field| field.name == "gravity_m_s2").ok_or("it is known")?;
//! let Kind::Number(allowed) = gravity.kind else { return Err("gravity is a number".into()) };
//! assert_eq!(allowed.text(), "an acceleration in m/s² from 0 to 1000 is allowed");
//! assert!(allowed.range.contains(9.81) && !allowed.range.contains(-9.81));
//! assert_eq!(gravity.absent, Absent::Number(9.80665));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub(super) mod allowed;
pub(super) mod component;
pub(super) mod control;
pub(super) mod file;
pub(super) mod joint;
pub(super) mod law;
pub(super) mod limits;
pub(super) mod masses;
pub(super) mod places;
pub(super) mod section;
pub(super) mod surface;
mod table;

pub use allowed::{Allowed, Range};
pub use file::FILE;
pub use table::{Absent, Field, Kind, LEAST_COMPONENT, Rule, Table, Word};

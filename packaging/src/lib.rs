//! Builds the `.fmu` archive of a flexible aircraft.

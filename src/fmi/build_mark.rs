//! What a shared library says of its origin to those who cannot load it: the packager holds libraries for other
//! machines in its hands, and looks for these words among their bytes.

/// What a mark begins with; it ends with a bracket.
pub const BUILD_MARK_BEGINNING: &str = "flexible-aircraft library ";

/// Version and hash of the sources that this is built of.
pub const BUILD_MARK: &str = concat!(
    "flexible-aircraft library ",
    env!("CARGO_PKG_VERSION"),
    " (sources ",
    env!("FLEXIBLE_AIRCRAFT_SOURCES"),
    ")"
);

/// Keeps the words in the library, where nothing reads them.
#[used]
static KEPT: &str = BUILD_MARK;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mark_has_the_version_and_ends_where_a_reader_expects() {
        let rest = BUILD_MARK.strip_prefix(BUILD_MARK_BEGINNING).unwrap();
        assert!(rest.starts_with(env!("CARGO_PKG_VERSION")), "{rest}");
        assert_eq!(rest.find(')'), Some(rest.len() - 1), "{rest}");
    }
}

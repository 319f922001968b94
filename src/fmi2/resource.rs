//! From `fmi2ResourceLocation`, a URI, to the directory that it means.

use std::path::PathBuf;

/// Why a resource location cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ResourceError {
    /// It is not a URI of a file.
    #[error("resource location `{0}`: only URIs of files are supported, such as file:///dir/resources")]
    NotAFile(String),
    /// It names another computer.
    #[error("resource location `{uri}`: the host is `{host}`, allowed are none and localhost")]
    Host {
        /// As given.
        uri: String,
        /// In it.
        host: String,
    },
    /// The percent-encoded bytes are not UTF-8.
    #[error("resource location `{0}`: its percent-encoded bytes are not UTF-8")]
    Encoding(String),
}

/// The directory that a resource location means.
///
/// Importers write `file:///dir`, `file:/dir`, `file://localhost/dir` and, from a path with a leading
/// slash too many, `file:////dir`; all mean `/dir`. A percent sign that encodes nothing stands for itself.
///
/// # Errors
/// When it is not a URI of a local file or not UTF-8.
pub fn directory(uri: &str) -> Result<PathBuf, ResourceError> {
    path(uri, cfg!(windows)).map(PathBuf::from)
}

fn path(uri: &str, windows: bool) -> Result<String, ResourceError> {
    let not_a_file = || ResourceError::NotAFile(uri.to_owned());
    let (scheme, rest) = uri.split_once(':').ok_or_else(not_a_file)?;
    if !scheme.eq_ignore_ascii_case("file") || !rest.starts_with('/') {
        return Err(not_a_file());
    }
    let local = match rest.strip_prefix("//") {
        None => rest,
        Some(authority) => {
            let (host, _) = authority.split_once('/').ok_or_else(not_a_file)?;
            if !host.is_empty() && !host.eq_ignore_ascii_case("localhost") {
                return Err(ResourceError::Host { uri: uri.to_owned(), host: host.to_owned() });
            }
            &authority[host.len()..]
        }
    };
    let decoded = percent_decoded(local).ok_or_else(|| ResourceError::Encoding(uri.to_owned()))?;
    let relative = decoded.trim_start_matches('/');
    let is_drive = relative.as_bytes().get(1) == Some(&b':');
    Ok(if windows && is_drive { relative.to_owned() } else { format!("/{relative}") })
}

fn percent_decoded(text: &str) -> Option<String> {
    let bytes = text.as_bytes();
    let mut decoded = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while i < bytes.len() {
        match encoded_byte(&bytes[i..]) {
            Some(byte) => {
                decoded.push(byte);
                i += 3;
            }
            None => {
                decoded.push(bytes[i]);
                i += 1;
            }
        }
    }
    String::from_utf8(decoded).ok()
}

/// The byte that `%XY` at the beginning of `text` stands for.
fn encoded_byte(text: &[u8]) -> Option<u8> {
    let [b'%', high, low, ..] = text else { return None };
    let digit = |c: &u8| char::from(*c).to_digit(16);
    u8::try_from(16 * digit(high)? + digit(low)?).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unix(uri: &str) -> String {
        path(uri, false).unwrap()
    }

    #[test]
    fn every_way_to_write_a_local_directory_means_the_same() {
        for uri in [
            "file:///tmp/a/resources",
            "file:/tmp/a/resources",
            "file://localhost/tmp/a/resources",
            "file:////tmp/a/resources",
            "FILE:///tmp/a/resources",
        ] {
            assert_eq!(unix(uri), "/tmp/a/resources", "{uri}");
        }
        assert_eq!(unix("file:///tmp/a/resources/"), "/tmp/a/resources/");
    }

    #[test]
    fn percent_encoding_is_utf8_and_a_lone_percent_sign_stands_for_itself() {
        assert_eq!(unix("file:///tmp/caf%C3%A9%20x/%7b%7D"), "/tmp/café x/{}");
        assert_eq!(unix("file:///tmp/{x}/100%/r"), "/tmp/{x}/100%/r");
        assert_eq!(path("file:///tmp/%FF", false), Err(ResourceError::Encoding("file:///tmp/%FF".into())));
    }

    #[test]
    fn windows_drives_lose_the_slash_only_on_windows() {
        assert_eq!(path("file:///C:/fmu/resources", true).unwrap(), "C:/fmu/resources");
        assert_eq!(path("file:/C:/fmu", true).unwrap(), "C:/fmu");
        assert_eq!(path("file:///C%3A/fmu", true).unwrap(), "C:/fmu");
        assert_eq!(unix("file:///C:/fmu"), "/C:/fmu");
    }

    #[test]
    fn other_schemes_hosts_and_relative_paths_are_refused() {
        for uri in ["http://x/y", "/tmp/a", "", "file:", "file:tmp", "file://"] {
            assert_eq!(path(uri, false), Err(ResourceError::NotAFile(uri.into())), "{uri}");
        }
        let host = path("file://server/x", false).unwrap_err();
        assert!(host.to_string().contains("server"), "{host}");
    }
}

//! From the URI of the FMU's resources to the directory that it means.

use std::path::PathBuf;

/// Name of the reduced model's file in the FMU's `resources/`.
pub const RESOURCE_FILE: &str = "model.bin";

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
    /// Its bytes are not UTF-8, where paths have to be.
    #[error("resource location `{0}`: its bytes are not UTF-8, as paths of this system are")]
    Encoding(String),
}

/// The directory that a resource location means.
///
/// Importers write `file:///dir`, `file:/dir`, `file://localhost/dir` and, from a path with a leading
/// slash too many, `file:////dir`; all mean `/dir`. A percent sign that encodes nothing stands for itself.
/// On Unix a path is bytes, whether they are percent-encoded or stand there as they are; elsewhere it is UTF-8.
///
/// # Errors
/// When it is not a URI of a local file, or not UTF-8 where paths are.
pub fn directory(uri: &[u8]) -> Result<PathBuf, ResourceError> {
    native(path(uri, cfg!(windows))?).ok_or_else(|| ResourceError::Encoding(shown(uri)))
}

#[cfg(unix)]
pub(crate) fn native(path: Vec<u8>) -> Option<PathBuf> {
    Some(<std::ffi::OsString as std::os::unix::ffi::OsStringExt>::from_vec(path).into())
}

#[cfg(not(unix))]
pub(crate) fn native(path: Vec<u8>) -> Option<PathBuf> {
    String::from_utf8(path).ok().map(PathBuf::from)
}

fn path(uri: &[u8], windows: bool) -> Result<Vec<u8>, ResourceError> {
    let not_a_file = || ResourceError::NotAFile(shown(uri));
    let (scheme, rest) = split_once(uri, b':').ok_or_else(not_a_file)?;
    if !scheme.eq_ignore_ascii_case(b"file") || !rest.starts_with(b"/") {
        return Err(not_a_file());
    }
    let local = match rest.strip_prefix(b"//") {
        None => rest,
        Some(authority) => {
            let (host, _) = split_once(authority, b'/').ok_or_else(not_a_file)?;
            if !host.is_empty() && !host.eq_ignore_ascii_case(b"localhost") {
                return Err(ResourceError::Host { uri: shown(uri), host: shown(host) });
            }
            &authority[host.len()..]
        }
    };
    let decoded = percent_decoded(local);
    let slashes = decoded.iter().take_while(|byte| **byte == b'/').count();
    let relative = &decoded[slashes..];
    let is_drive = relative.get(1) == Some(&b':');
    Ok(if windows && is_drive { relative.to_owned() } else { [b"/", relative].concat() })
}

/// For people.
fn shown(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn split_once(bytes: &[u8], at: u8) -> Option<(&[u8], &[u8])> {
    let place = bytes.iter().position(|byte| *byte == at)?;
    Some((&bytes[..place], &bytes[place + 1..]))
}

fn percent_decoded(bytes: &[u8]) -> Vec<u8> {
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
    decoded
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

    fn on(windows: bool, uri: &str) -> Result<String, ResourceError> {
        path(uri.as_bytes(), windows).map(|path| String::from_utf8(path).unwrap())
    }

    fn unix(uri: &str) -> String {
        on(false, uri).unwrap()
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
    }

    #[test]
    #[cfg(unix)]
    fn bytes_that_are_not_utf8_are_a_path_encoded_or_not() {
        use std::os::unix::ffi::OsStrExt;
        for uri in [&b"file:///tmp/caf%E9/r"[..], b"file:///tmp/caf\xE9/r", b"file://localhost/tmp/caf%e9/r"]
        {
            assert_eq!(directory(uri).unwrap().as_os_str().as_bytes(), b"/tmp/caf\xE9/r");
        }
    }

    #[test]
    #[cfg(not(unix))]
    fn bytes_that_are_not_utf8_are_no_path() {
        let uri = "file:///tmp/%FF";
        assert_eq!(directory(uri.as_bytes()), Err(ResourceError::Encoding(uri.into())));
    }

    #[test]
    fn windows_drives_lose_the_slash_only_on_windows() {
        assert_eq!(on(true, "file:///C:/fmu/resources").unwrap(), "C:/fmu/resources");
        assert_eq!(on(true, "file:/C:/fmu").unwrap(), "C:/fmu");
        assert_eq!(on(true, "file:///C%3A/fmu").unwrap(), "C:/fmu");
        assert_eq!(unix("file:///C:/fmu"), "/C:/fmu");
    }

    #[test]
    fn other_schemes_hosts_and_relative_paths_are_refused() {
        for uri in ["http://x/y", "/tmp/a", "", "file:", "file:tmp", "file://"] {
            assert_eq!(on(false, uri), Err(ResourceError::NotAFile(uri.into())), "{uri}");
        }
        let host = on(false, "file://server/x").unwrap_err();
        assert!(host.to_string().contains("server"), "{host}");
    }
}

//! The page: the template with what it shows put where its markers are, and how large it may be.

use std::io::{self, Write};

use flate2::Compression;
use flate2::write::ZlibEncoder;
use serde_json::Value;

/// Page, style and script, without anything to show.
const TEMPLATE: &str = include_str!("../../../web/dist/view.html");

/// Bytes of a page that is not told to be large: with one flight, and for each further level.
const USUAL: usize = 3_000_000;
const FURTHER: usize = 2_000_000;

/// Bytes of the largest page.
const MOST: usize = 50_000_000;

/// Part of what would just fit that is proposed.
const PROPOSED: f64 = 0.9;

/// What a page shows.
pub struct Content<'c> {
    pub title: &'c str,
    /// SVG.
    pub plan: &'c str,
    pub scene: &'c Value,
    pub data: &'c [u8],
}

/// A page that is too large.
#[derive(Debug, PartialEq, thiserror::Error)]
#[error(
    "found a page of {:.1} MB with --rate {rate}, allowed are {} MB; it would fit with --rate {fits}, or a shorter flight",
    *bytes as f64 / 1e6,
    MOST / 1_000_000
)]
pub struct TooLarge {
    bytes: usize,
    rate: f64,
    fits: f64,
}

impl Content<'_> {
    /// The whole page.
    ///
    /// # Errors
    /// None but for the compressor's, which writes to memory.
    pub fn page(&self) -> io::Result<String> {
        let compressed = base64(&compressed(self.data)?);
        // Within a script element nothing but `<` could end it.
        let scene = self.scene.to_string().replace('<', "\\u003c");
        let title = escaped(self.title);
        let values =
            [("title", title.as_str()), ("plan", self.plan), ("scene", &scene), ("data", &compressed)];
        Ok(filled(TEMPLATE, &values))
    }
}

/// A line about a page that is larger than usual, where flights have so many levels.
///
/// # Errors
/// When it is too large; flights have so many frames a second.
pub fn check(bytes: usize, levels: usize, rate: f64) -> Result<Option<String>, TooLarge> {
    if bytes > MOST {
        let fits = (rate * MOST as f64 / bytes as f64 * PROPOSED).max(0.1);
        return Err(TooLarge { bytes, rate, fits: (fits * 10.0).floor() / 10.0 });
    }
    let usual = USUAL + FURTHER * levels.saturating_sub(1);
    Ok((bytes > usual).then(|| {
        format!(
            "note: the page has {:.1} MB, more than the usual {:.0} MB: a lower --rate, a shorter flight or fewer --output-name make it smaller",
            bytes as f64 / 1e6,
            usual as f64 / 1e6
        )
    }))
}

/// A template with each `{{name}}` replaced in one pass, so that what stands in a value stays as it is.
fn filled(template: &str, values: &[(&str, &str)]) -> String {
    let mut page = String::new();
    let mut rest = template;
    while let Some((before, behind)) = rest.split_once("{{") {
        page.push_str(before);
        let value = behind
            .split_once("}}")
            .and_then(|(name, rest)| Some((values.iter().find(|(other, _)| *other == name)?.1, rest)));
        rest = match value {
            Some((value, rest)) => {
                page.push_str(value);
                rest
            }
            None => {
                page.push_str("{{");
                behind
            }
        };
    }
    page + rest
}

/// Text as it stands in HTML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A zlib stream.
fn compressed(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    encoder.finish()
}

/// Base64 with padding (RFC 4648).
pub fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |place: usize| u32::from(three.get(place).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let is_there = digit <= three.len();
            let value = bits >> (18 - 6 * digit) & 63;
            text.push(if is_there { char::from(DIGITS[value as usize]) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use serde_json::json;

    use super::*;

    #[test]
    fn bytes_are_written_as_base64() {
        for (bytes, text) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
        assert_eq!(base64(&[0xff, 0xef, 0xbe]), "/+++");
    }

    #[test]
    fn markers_are_replaced_once_and_nothing_in_a_value_is() {
        let values = [("a", "{{b}}"), ("b", "x")];
        assert_eq!(filled("1 {{a}} 2 {{b}} {{a}} {{c}} {{", &values), "1 {{b}} 2 x {{b}} {{c}} {{");
        for marker in ["title", "plan", "scene", "data"] {
            assert!(TEMPLATE.contains(&format!("{{{{{marker}}}}}")), "{marker}");
        }
    }

    #[test]
    fn names_stay_text_and_data_are_a_zlib_stream() {
        let title = "</script><img onerror=alert(1)>";
        let (scene, data) = (json!({ "title": title }), [7_u8; 1000]);
        let page = Content { title, plan: "<svg/>", scene: &scene, data: &data }.page().unwrap();
        assert!(!page.contains("<img"), "{page}");
        assert!(page.contains("&lt;/script&gt;&lt;img onerror=alert(1)&gt;"));
        assert!(page.contains("\\u003c/script>\\u003cimg"));
        let stream = compressed(&data).unwrap();
        assert_eq!(stream[0] & 0x0f, 8);
        let mut back = Vec::new();
        flate2::read::ZlibDecoder::new(stream.as_slice()).read_to_end(&mut back).unwrap();
        assert_eq!(back, data);
    }

    #[test]
    fn large_pages_are_told_and_too_large_ones_refused_with_a_rate_that_fits() {
        assert_eq!(check(2_900_000, 1, 50.0), Ok(None));
        assert_eq!(check(4_900_000, 2, 50.0), Ok(None));
        assert!(check(4_900_000, 1, 50.0).unwrap().unwrap().contains("4.9 MB"));
        let error = check(100_000_000, 1, 50.0).unwrap_err();
        assert_eq!(error.fits, 22.5);
        assert!(error.to_string().contains("--rate 22.5"), "{error}");
    }
}

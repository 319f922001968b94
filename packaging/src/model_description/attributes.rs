//! Attributes of elements.

use quick_xml::XmlVersion;
use quick_xml::events::BytesStart;

pub(super) fn required(element: &BytesStart<'_>, name: &str) -> Result<String, String> {
    let value = optional(element, name)?;
    value.ok_or_else(|| format!("<{}> has no attribute {name}", element.local_name().as_ref()))
}

pub(super) fn optional(element: &BytesStart<'_>, name: &str) -> Result<Option<String>, String> {
    let Some(attribute) = element.try_get_attribute(name).map_err(|error| error.to_string())? else {
        return Ok(None);
    };
    let value = attribute.normalized_value(XmlVersion::Explicit1_0).map_err(|error| error.to_string())?;
    Ok(Some(value.into_owned()))
}

/// Empty where there is none.
pub(super) fn text(element: &BytesStart<'_>, name: &str) -> Result<String, String> {
    Ok(optional(element, name)?.unwrap_or_default())
}

/// A number, if there is one.
pub(super) fn number<T: std::str::FromStr>(
    element: &BytesStart<'_>,
    name: &str,
) -> Result<Option<T>, String> {
    let Some(text) = optional(element, name)? else { return Ok(None) };
    let wrong = |_| format!("<{} {name}=\"{text}\">: not a number", element.local_name().as_ref());
    text.trim().parse().map(Some).map_err(wrong)
}

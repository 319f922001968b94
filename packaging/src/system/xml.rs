//! XML documents of nested elements.

use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

pub(super) type Xml = Writer<Vec<u8>>;

/// Names and values.
type Attributes<'a> = &'a [(&'a str, &'a str)];

/// A document with the content that a function writes.
pub(super) fn document(content: impl FnOnce(&mut Xml) -> io::Result<()>) -> Vec<u8> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    let declaration = xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)));
    // PROOF: memory takes every byte.
    declaration.and_then(|()| content(&mut xml)).expect("writing to memory succeeds");
    let mut bytes = xml.into_inner();
    bytes.push(b'\n');
    bytes
}

/// An element around what a function writes.
pub(super) fn element(
    xml: &mut Xml,
    name: &str,
    attributes: Attributes<'_>,
    content: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    let element = xml.create_element(name).with_attributes(attributes.iter().copied());
    element.write_inner_content(content).map(|_| ())
}

/// An element with attributes alone.
pub(super) fn leaf(xml: &mut Xml, name: &str, attributes: Attributes<'_>) -> io::Result<()> {
    xml.create_element(name).with_attributes(attributes.iter().copied()).write_empty().map(|_| ())
}

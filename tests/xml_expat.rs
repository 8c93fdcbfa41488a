//! The first syntax error is the one CPython's expat reports: same words, same line, same column.
//!
//! `tests/xml/expat.txt` holds, per line, a document as a JSON string, a TAB, and what
//! `xml.dom.minidom.parse` of CPython 3.11 (expat 2.5.0) says to it: `line:column message` or `ok`.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use xacro_lsp::base::Encoding;
use xacro_lsp::xml::Document;

fn verdict(document: &Document) -> String {
    match document.errors().first() {
        None => "ok".to_owned(),
        Some(error) => {
            let place = document.line_col(error.expat_offset, Encoding::Utf32);
            format!("{}:{} {}", place.line + 1, place.col, error.expat)
        }
    }
}

#[test]
fn the_first_error_is_expats() {
    let table = include_str!("xml/expat.txt");
    let mut count = 0;
    for line in table.lines() {
        let (text, expected) = line.split_once('\t').expect("two columns");
        let text: String = serde_json::from_str(text).expect("a JSON string");
        assert_eq!(verdict(&Document::parse(&text)), expected, "{text:?}");
        count += 1;
    }
    assert!(count > 450, "only {count} cases");
}

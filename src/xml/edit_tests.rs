//! An edited document equals the document parsed from scratch, and keeps what the edit did not touch.

use std::borrow::Cow;
use std::sync::Arc;

use proptest::prelude::*;
use proptest::test_runner::Config;

use super::*;
use base::{Encoding, LineCol, TextRange};

/// Text that edits insert: whole elements, and what breaks them.
const PIECES: &[&str] = &[
    "<",
    ">",
    "/",
    "\"",
    "'",
    "=",
    "&",
    ";",
    "-->",
    "<!--",
    "--",
    "<![CDATA[",
    "]]>",
    "</",
    "/>",
    "<?",
    "?>",
    " ",
    "\n",
    "\r\n",
    "\r",
    "\t",
    "x",
    "a:",
    "${",
    "}",
    "é",
    "😀",
    "\u{0}",
    "&amp;",
    "&zz;",
    "<b>",
    "</b>",
    "<link name=\"n\"/>",
    "\n<joint name='j'>\n</joint>",
    "\n  <xacro:m p=\"${a}\">",
    "</xacro:m>",
    "</robot>",
    "<robot>",
    "<robot ",
    "<<<<<<< HEAD\n",
    "<!DOCTYPE r [<!ENTITY zz \"q\">]>",
    "<?xml version=\"1.0\"?>",
    " name=\"x\"",
    " xmlns:a=\"u\"",
    "text",
    "<a:b/>",
    "<",
    "\n<",
    "\"\n<x/>\n",
];

/// Documents edits begin with.
const SEEDS: &[&str] = &[
    "",
    "<robot name=\"r\"/>",
    "<?xml version=\"1.0\"?>\n<!-- p -->\n<robot name=\"r\" xmlns:xacro=\"u\">\n  <!-- c -->\n  <xacro:property name=\"p\" \
     value=\"1\"/>\n  <link name=\"a\">\n    <visual><origin xyz=\"0 0 0\"/></visual>\n  </link>\n  text &amp; more\n  \
     <joint name=\"j\" type=\"fixed\"/>\n  <link name='b'/>\n  <link name='c'/>\n</robot>\n<!-- e -->\n",
    "\u{feff}<r>\r\n  <a:b c='😀'/>\r\n  <d>é\r\n\r\n</d><e/><f/>\r\n</r>",
    "<robot>\n  <link name=\"x\">\n  <link name=\"y\"/>\n  <link name=\"z\"/>\n  <!-- open\n  <a/>\n</robot>",
];

/// One edit: where (in thousandths of the text), how much to delete, what to insert.
type Edit = (u16, u8, Vec<usize>);

fn edits() -> impl Strategy<Value = (usize, Vec<Edit>)> {
    let piece = prop::collection::vec(0..PIECES.len(), 0..3);
    let delete = prop_oneof![3 => 0u8..1, 3 => 1u8..4, 1 => 1u8..120];
    (
        0..SEEDS.len(),
        prop::collection::vec((0u16..1000, delete, piece), 1..12),
    )
}

fn assert_same(edited: &Document, fresh: &Document) {
    let parts = |document: &Document| {
        document
            .parts()
            .map(|(_, item)| Arc::clone(item))
            .collect::<Vec<_>>()
    };
    let texts: Vec<String> = parts(edited)
        .iter()
        .map(|item| item.text().to_owned())
        .collect();
    let fresh_texts: Vec<String> = parts(fresh)
        .iter()
        .map(|item| item.text().to_owned())
        .collect();
    assert_eq!(texts, fresh_texts);
    for (one, two) in parts(edited).iter().zip(parts(fresh)) {
        assert_eq!(
            (&one.nodes, &one.attrs, one.lines),
            (&two.nodes, &two.attrs, two.lines),
            "{one:?}"
        );
        let errors = |item: &Item| item.errors().map(Cow::into_owned).collect::<Vec<_>>();
        assert_eq!(errors(one), errors(&two), "{one:?}");
        assert_eq!(
            (one.lookahead(), one.entity_uses()),
            (two.lookahead(), two.entity_uses()),
            "{one:?}"
        );
    }
    assert_eq!(edited.errors(), fresh.errors());
    assert_eq!(edited.root_end_tag(), fresh.root_end_tag());
    assert_eq!(
        edited.footer_content().count(),
        fresh.footer_content().count()
    );
    assert_eq!(edited.entities(), fresh.entities());
    assert_eq!(edited.len(), fresh.len());
}

/// The slow and simple way to a position.
fn reference_line_col(text: &str, offset: usize, encoding: Encoding) -> LineCol {
    let normal = text[..offset].replace("\r\n", "\n").replace('\r', "\n");
    let line = normal.matches('\n').count() as u32;
    let tail = normal.rsplit('\n').next().unwrap_or("");
    LineCol {
        line,
        col: encoding.width(tail),
    }
}

fn check_positions(document: &Document, text: &str) {
    for (offset, _) in text.char_indices().chain([(text.len(), ' ')]) {
        if text[..offset].ends_with('\r') && text[offset..].starts_with('\n') {
            continue;
        }
        for encoding in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32] {
            let expected = reference_line_col(text, offset, encoding);
            assert_eq!(
                document.line_col(offset as u32, encoding),
                expected,
                "{offset} of {text:?}"
            );
            assert_eq!(
                document.offset(expected, encoding),
                offset as u32,
                "{expected:?} of {text:?}"
            );
        }
    }
}

proptest! {
    #![proptest_config(Config { cases: 400, failure_persistence: None, ..Config::default() })]

    #[test]
    fn edited_equals_fresh((seed, script) in edits()) {
        let mut text = SEEDS[seed].to_owned();
        let mut document = Document::parse(&text);
        for (place, delete, pieces) in script {
            let mut start = text.len() * usize::from(place) / 1000;
            while !text.is_char_boundary(start) { start -= 1; }
            let mut end = (start + usize::from(delete)).min(text.len());
            while !text.is_char_boundary(end) { end += 1; }
            let insert: String = pieces.iter().map(|&at| PIECES[at]).collect();
            text.replace_range(start..end, &insert);
            document.edit(TextRange::new(start as u32, end as u32), &insert);
            prop_assert_eq!(&document.text(), &text);
            assert_same(&document, &Document::parse(&text));
        }
        check_positions(&document, &text);
    }
}

#[test]
fn a_merge_conflict_in_front_of_an_unclosed_tag() {
    let before = "<robot>\n\n<<<<<<<< \n<HEAD\n  ";
    let after = "<robot>\n\n<<<<<<<b><< \n<HEAD\n  ";
    let mut document = Document::parse(before);
    document.edit(TextRange::empty(15), "<b>");
    let fresh = Document::parse(after);
    assert_same(&document, &fresh);
    let last = fresh.items().last().expect("an item").1;
    assert!(last.text().ends_with("<HEAD\n  "), "{last:?}");
}

fn many_links(count: usize) -> String {
    let links: String = (0..count)
        .map(|n| format!("  <link name=\"l{n}\">\n    <visual/>\n  </link>\n"))
        .collect();
    format!("<robot name=\"r\">\n{links}</robot>\n")
}

/// How many items of `before` are no longer in `after`.
fn lost(before: &Document, after: &Document) -> usize {
    let kept: std::collections::HashSet<_> =
        after.items().map(|(_, item)| Arc::as_ptr(item)).collect();
    before
        .items()
        .filter(|(_, item)| !kept.contains(&Arc::as_ptr(item)))
        .count()
}

#[test]
fn an_edit_keeps_the_other_items() {
    let text = many_links(300);
    let original = Document::parse(&text);
    assert_eq!(original.item_count(), 300);
    let at = |needle: &str| text.find(needle).expect("in the text") as u32;
    for (name, range, insert, expected_lost, expected_count) in [
        (
            "a letter in a value",
            TextRange::empty(at("l150")),
            "x",
            1,
            300,
        ),
        (
            "a new element between two",
            TextRange::empty(at("  <link name=\"l150\"") - 1),
            "\n  <link/>",
            0,
            301,
        ),
        (
            "an element deleted",
            TextRange::new(at("  <link name=\"l7\"") - 1, at("  <link name=\"l8\"") - 1),
            "",
            1,
            299,
        ),
        (
            "an attribute of the root",
            TextRange::empty(at(" name=\"r\"")),
            " xmlns:a=\"u\"",
            0,
            300,
        ),
        (
            "the name of the root",
            TextRange::empty(at(" name=\"r\"")),
            "s",
            0,
            300,
        ),
        (
            "a half-typed tag",
            TextRange::empty(at("  <link name=\"l9\"")),
            "  <joint na\n",
            1,
            301,
        ),
        (
            "a start tag without end",
            TextRange::empty(at("  <link name=\"l9\"")),
            "  <link name=\"q\">\n",
            1,
            301,
        ),
        (
            "a half-typed comment",
            TextRange::empty(at("  <link name=\"l9\"")),
            "  <!-- half\n",
            1,
            300,
        ),
        (
            "text behind the root",
            TextRange::empty(text.len() as u32),
            "x",
            0,
            300,
        ),
        (
            "a change of the last item",
            TextRange::empty(at("</robot>") - 2),
            "x",
            1,
            300,
        ),
    ] {
        let mut document = original.clone();
        document.edit(range, insert);
        assert_eq!(
            (lost(&original, &document), document.item_count()),
            (expected_lost, expected_count),
            "{name}"
        );
    }
}

#[test]
fn ranges_that_do_not_fit_are_cut() {
    let mut document = Document::parse("<a>é</a>");
    document.edit(TextRange { start: 4, end: 900 }, "x");
    assert_eq!(document.text(), "<a>x");
    document.edit(TextRange { start: 700, end: 2 }, "y");
    assert_eq!(document.text(), "<a>xy");
}

#[test]
fn positions_outside_of_the_text_are_moved_into_it() {
    let document = Document::parse("<a>\r\n😀b</a>\n");
    let offset = |line, col| document.offset(LineCol { line, col }, Encoding::Utf16);
    assert_eq!(offset(0, 99), 3);
    assert_eq!(offset(1, 1), 5);
    assert_eq!(offset(1, 2), 9);
    assert_eq!(offset(2, 5), 15);
    assert_eq!(offset(9, 0), 15);
    let place = |offset| document.line_col(offset, Encoding::Utf16);
    assert_eq!(place(4), LineCol { line: 0, col: 3 });
    assert_eq!(place(7), LineCol { line: 1, col: 0 });
    assert_eq!(place(99), LineCol { line: 2, col: 0 });
    assert_eq!(document.line_text(0), "<a>");
    assert_eq!(document.line_text(1), "😀b</a>");
    assert_eq!(document.line_text(7), "");
}

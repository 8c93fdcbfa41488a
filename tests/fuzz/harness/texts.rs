//! XML, its edits and its formatter.

use xacro_lsp::analysis::apply;
use xacro_lsp::base::{Encoding, TextRange};
use xacro_lsp::ide::{Indent, format};
use xacro_lsp::workspace::config::{AttributeLayout, Format};
use xacro_lsp::xml::{Document, NodeKind};

use super::choice_and_text;

/// The parser loses nothing, every place lies in the text, and two parses agree.
pub fn xml(data: &[u8]) {
    let text = xacro_lsp::vfs::text_of(data.to_vec());
    let document = Document::parse(&text);
    assert_eq!(document.text(), text);
    assert_eq!(document.len() as usize, text.len());
    let mut at = 0;
    for (start, item) in document.parts() {
        assert_eq!(start, at, "parts follow each other");
        assert_eq!(
            TextRange::new(start, start + item.len()).slice(&text),
            item.text()
        );
        at += item.len();
        for node in item.all_nodes() {
            let range = node.range();
            assert!(
                range.end <= item.len() && range.start <= range.end,
                "{node:?}"
            );
            assert!(
                item.text().is_char_boundary(range.start as usize),
                "{node:?}"
            );
            assert!(item.text().is_char_boundary(range.end as usize), "{node:?}");
            for attribute in node.attrs() {
                assert!(range.contains_range(attribute.range()), "{attribute:?}");
                assert!(
                    attribute.range().contains_range(attribute.value_range()),
                    "{attribute:?}"
                );
                attribute.value(document.entities());
            }
            if node.kind() != NodeKind::Element {
                node.text(document.entities());
            }
        }
    }
    assert_eq!(at as usize, text.len());
    for error in document.errors() {
        assert!(error.range.end as usize <= text.len(), "{error:?}");
        document.line_col(error.range.start, Encoding::Utf16);
    }
    if std::str::from_utf8(data).is_ok() {
        let accepted = document.errors().is_empty();
        let options = roxmltree::ParsingOptions {
            allow_dtd: true,
            ..Default::default()
        };
        // the second parser knows no limit of depth and few entities, so it may only confirm plain documents
        if accepted && !text.contains('&') && !text.contains("<!DOCTYPE") && !text.contains("<?xml")
        {
            let second = roxmltree::Document::parse_with_options(&text, options);
            if let Err(error) = second {
                assert!(
                    is_known_difference(&text, &error.to_string()),
                    "{error}: {text:?}"
                );
            }
        }
    }
}

/// What roxmltree refuses although expat does not.
fn is_known_difference(text: &str, error: &str) -> bool {
    let names_prefix = text.contains("xml:") || text.contains("xmlns");
    let quoting = error.contains("namespace") || error.contains("prefix") || error.contains("URI");
    // `]]>` in text, names of other editions of XML, and the mark at the start
    (names_prefix && quoting) || !text.is_ascii() || text.contains("]]>") || text.contains("<?")
}

/// A document after edits is the one parsed from the text after them.
///
/// The input is a text, a zero byte, and four bytes an edit: where, how much to delete, which piece to insert.
pub fn edits(data: &[u8]) {
    let cut = data
        .iter()
        .position(|&byte| byte == 0)
        .unwrap_or(data.len());
    let mut text = xacro_lsp::vfs::text_of(data.get(..cut).unwrap_or_default().to_vec());
    let mut document = Document::parse(&text);
    for edit in data
        .get(cut + 1..)
        .unwrap_or_default()
        .chunks_exact(4)
        .take(64)
    {
        let place = usize::from(edit[0]) << 8 | usize::from(edit[1]);
        let start = boundary(&text, place * (text.len() + 1) / (1 << 16));
        let end = boundary(&text, (start + usize::from(edit[2]) / 4).min(text.len()));
        let piece = PIECES[usize::from(edit[3]) % PIECES.len()];
        document.edit(TextRange::new(start as u32, end.max(start) as u32), piece);
        text.replace_range(start..end.max(start), piece);
        assert_eq!(document.text(), text);
        let fresh = Document::parse(&text);
        assert_eq!(summary(&document), summary(&fresh), "{text:?}");
    }
}

const PIECES: &[&str] = &[
    "",
    "<",
    ">",
    "/",
    "\"",
    "'",
    "=",
    "&",
    "-->",
    "<!--",
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
    "x",
    "a:",
    "${",
    "}",
    "é",
    "😀",
    "&amp;",
    "&zz;",
    "<b>",
    "</b>",
    "<link name=\"n\"/>",
    "\n<joint name='j'>",
    "</robot>",
    "<robot>",
    "<robot ",
    "<!DOCTYPE r [<!ENTITY zz \"q\">]>",
    "<?xml version=\"1.0\"?>",
    " name=\"x\"",
    " xmlns:a=\"u\"",
    "<a:b/>",
    "\n<",
    "\"\n<x/>\n",
];

fn boundary(text: &str, mut at: usize) -> usize {
    at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// All that two documents with the same text must agree on.
fn summary(document: &Document) -> (Vec<String>, Vec<String>, Vec<(u32, String)>) {
    let nodes = document.parts().flat_map(|(start, item)| {
        item.all_nodes()
            .map(move |node| {
                let attributes: Vec<_> = node
                    .attrs()
                    .map(|a| (a.name().to_owned(), a.range()))
                    .collect();
                format!(
                    "{start} {:?} {:?} {:?} {attributes:?}",
                    node.kind(),
                    node.range(),
                    node.name()
                )
            })
            .collect::<Vec<_>>()
    });
    let errors = document
        .errors()
        .iter()
        .map(|error| format!("{error:?}"))
        .collect();
    let items = document
        .parts()
        .map(|(start, item)| (start, item.text().to_owned()))
        .collect();
    (nodes.collect(), errors, items)
}

/// Formatting twice is formatting once, and changes neither elements nor attributes nor text.
pub fn formatter(data: &[u8]) {
    let (choice, text) = choice_and_text(data);
    let document = Document::parse(&text);
    let options = Format {
        attributes: if choice & 1 == 0 {
            AttributeLayout::Keep
        } else {
            AttributeLayout::Auto
        },
        line_width: if choice & 2 == 0 { 120 } else { 40 },
        self_close: choice & 4 != 0,
    };
    let indent = if choice & 8 == 0 {
        Indent::blanks(2)
    } else {
        Indent::tabs(4)
    };
    let edits = format(&document, &indent, &options);
    if !document.errors().is_empty() {
        assert!(edits.is_empty(), "a broken text is left alone: {text:?}");
        return;
    }
    let once = apply(&text, &edits);
    let formatted = Document::parse(&once);
    let errors = formatted.errors();
    assert!(errors.is_empty(), "{text:?} became {once:?}: {errors:?}");
    assert_eq!(
        apply(&once, &format(&formatted, &indent, &options)),
        once,
        "twice is not once: {text:?}"
    );
    assert_eq!(
        infoset(&formatted),
        infoset(&document),
        "{text:?} became {once:?}"
    );
}

/// Elements, attributes, comments and text that is not blank, as they are written.
fn infoset(document: &Document) -> Vec<String> {
    let mut found = Vec::new();
    for (_, item) in document.parts() {
        for node in item.all_nodes() {
            match node.kind() {
                NodeKind::Element => {
                    let attributes: Vec<_> = node
                        .attrs()
                        .map(|a| format!("{}={}", a.name(), a.raw()))
                        .collect();
                    let depth = std::iter::successors(node.parent(), |node| node.parent()).count();
                    found.push(format!("{depth} {} {attributes:?}", node.name()));
                }
                NodeKind::Text if node.raw().trim_matches([' ', '\t', '\r', '\n']).is_empty() => {}
                kind => found.push(format!("{kind:?} {}", node.raw())),
            }
        }
    }
    found
}

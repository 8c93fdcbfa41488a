//! How large, how deep and how wrong XML may be.

use xacro_lsp::base::limits::*;
use xacro_lsp::xml::Document;

use super::{folder, run, write};

#[test]
fn xml_bytes() {
    // no input gets there: the largest file, the largest message and standard input are smaller
    let largest = [FILE_MB_MOST * 1_000_000, MESSAGE_BYTES, STDIN_BYTES]
        .into_iter()
        .max();
    assert!(largest < Some(XML_BYTES as u64), "{largest:?}");
}

/// A document whose root has entities: `a` of 1000 bytes, the others made of those before.
fn entities(declarations: &str, body: &str) -> String {
    let a = "x".repeat(1000);
    format!(
        "<!DOCTYPE robot [<!ENTITY a \"{a}\">{declarations}]>\n<robot name=\"r\">\n{body}\n</robot>"
    )
}

fn first_error(text: &str) -> String {
    let errors = Document::parse(text).errors();
    errors
        .first()
        .map(|error| error.message.clone())
        .unwrap_or_default()
}

#[test]
fn entity_bytes() {
    let (one, nine) = ("&a;".repeat(1000), "&b;".repeat(9));
    let text = entities(
        &format!("<!ENTITY b \"{one}\"><!ENTITY c \"{nine}\">"),
        "<link name=\"&c;\"/>",
    );
    assert!(
        first_error(&text).contains("entity `c` exceeds a limit: 8 MB"),
        "{}",
        first_error(&text)
    );
    let folder = folder();
    write(&folder, "r.urdf", text);
    let said = run(&folder, &["check", "r.urdf"], &mut std::io::empty());
    assert!(
        said.contains("r.urdf:3:") && said.contains("8 MB for one entity"),
        "{said}"
    );
}

#[test]
fn entities_bytes() {
    let one = "&a;".repeat(7000);
    let declarations: String = (0..6)
        .map(|n| format!("<!ENTITY b{n} \"{one}\">"))
        .collect();
    let uses: String = (0..6).map(|n| format!("&b{n};")).collect();
    // a long file, so that it is not the share of the entities that is too large
    let text = entities(
        &declarations,
        &format!("<!--{}-->{uses}", " ".repeat(600_000)),
    );
    assert!(
        first_error(&text).contains("32 MB for all"),
        "{}",
        first_error(&text)
    );
}

#[test]
fn entity_depth() {
    // the deepest one is asked for first
    let declarations = |count: u32| -> String {
        let nested = (1..count)
            .rev()
            .map(|n| format!("<!ENTITY d{n} \"&d{};\">", n - 1));
        nested.collect::<String>() + "<!ENTITY d0 \"x\">"
    };
    let text = entities(&declarations(5000), "&d4999;");
    assert!(
        first_error(&text).contains("256 levels"),
        "{}",
        first_error(&text)
    );
    assert_eq!(first_error(&entities(&declarations(200), "&d199;")), "");
}

#[test]
fn entity_growth() {
    let thousand = "&a;".repeat(1000);
    let text = entities(&format!("<!ENTITY b \"{thousand}\">"), &"&b;".repeat(9));
    assert!(
        first_error(&text).contains("more than 100 times the size of the file"),
        "{}",
        first_error(&text)
    );
}

#[test]
fn value_bytes() {
    let thousand = "&a;".repeat(1000);
    let uses = "&b;".repeat(20);
    let text = entities(
        &format!("<!ENTITY b \"{thousand}\">"),
        &format!("<link name=\"{uses}\"/>"),
    );
    let document = Document::parse(&text);
    let (_, item) = document.items().next().unwrap();
    let value = item
        .element()
        .unwrap()
        .attr("name")
        .unwrap()
        .value(document.entities())
        .len();
    assert!(
        value > VALUE_BYTES && value <= VALUE_BYTES + 1_000_000,
        "{value}"
    );
}

#[test]
fn item_errors() {
    let text = format!("<robot>\n<a>{}</a>\n</robot>", "&;".repeat(300));
    assert_eq!(Document::parse(&text).errors().len(), ITEM_ERRORS);
}

#[test]
fn xml_errors() {
    let item = format!("<a>{}</a>\n", "&;".repeat(300));
    let text = format!(
        "<robot>\n{}</robot>",
        item.repeat(XML_ERRORS_SEEN / ITEM_ERRORS + 10)
    );
    assert_eq!(Document::parse(&text).errors().len(), XML_ERRORS);
}

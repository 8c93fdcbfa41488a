//! What is typed, at offsets marked by `|`.

use super::{Typing, typed};
use xml::Document;

fn told(marked: &str) -> String {
    let offset = marked.find('|').unwrap();
    let document = Document::parse(&marked.replacen('|', "", 1));
    let typed = typed(&document, offset as u32);
    let open: Vec<&str> = typed.open.iter().map(|open| open.name()).collect();
    let before = typed.before;
    let what = match typed.what {
        Typing::Nothing => "nothing".to_owned(),
        Typing::Comment => format!("comment {before}"),
        Typing::Content => format!("content {before}"),
        Typing::Tag => format!("tag {before}"),
        Typing::EndTag => format!("end {before}"),
        Typing::Attribute(tag) => format!("attribute of {} {before}", tag.name()),
        Typing::Value(tag, name) => format!("{}.{name} {before}", tag.name()),
    };
    format!("{} | {what}", open.join(" "))
}

/// Texts that end at the offset, and the same with more behind it.
#[test]
fn texts_may_end_anywhere() {
    for (text, expected) in [
        ("<a><b x=\"1\"/> te|", "a | content  te"),
        ("<a><b x=\"1\"></b><c|", "a | tag c"),
        ("<a></|", "a | end "),
        ("<a><b x='1' |", "a | attribute of b "),
        ("<a><b x='1'|", "a | nothing"),
        ("<a><b x='1' y=\"2 ${|", "a | b.y 2 ${"),
        ("<a><b x=\"half\n<c y=\"|", "a | c.y "),
        ("<a><!-- <b |", "a | comment  <b "),
        ("<a><![CDATA[ <b |", "a | nothing"),
        (
            "<?xml version='1.0'?><!DOCTYPE a [<!ENTITY x 'y'>]><a |",
            " | attribute of a ",
        ),
        ("<a><b><c></b>|", "a | content "),
    ] {
        assert_eq!(told(text), expected, "{text}");
        let more = format!("{text}\n<d/>\n</a>");
        assert_eq!(told(&more), expected, "{more}");
    }
}

/// Where the text in front of the offset alone says something else than the tree, the tree is right.
#[test]
fn what_follows_is_seen() {
    for (text, expected) in [
        // the quote ends with its line; what follows is an attribute again
        ("<a><b x=\"1 |\n   y=\"2\"/></a>", "a | b.x 1 "),
        ("<a>\n <b x=\"1\n   y|\n <c/></a>", "a | attribute of b y"),
        ("<a><b x=\"1 | y=\"2\"/></a>", "a | b.x 1 "),
        // a tag without an end holds what is indented deeper, and nothing else
        ("<a>\n  <b\n  <c |/>\n</a>", "a | attribute of c "),
        ("<a>\n  <b\n    <c |/>\n</a>", "a b | attribute of c "),
        // an end tag of another name closes the element at its own indentation
        ("<a>\n  <b>\n  </bb>\n  <c|\n</a>", "a | tag c"),
        // a `<` in a value that is closed on the same line
        ("<a><b x=\"1 < |\"/></a>", "a | b.x 1 < "),
        ("<a><b></b|></a>", "a b | end b"),
        ("<a>\n</a|", "a | end a"),
        ("<a/>\n|", " | nothing"),
        ("<a/>\n<!-- x|", " | comment  x"),
    ] {
        assert_eq!(told(text), expected, "{text}");
    }
}

/// A `>` directly behind a value without its closing quote may belong to the value: `${a > b}` is being typed.
#[test]
fn a_bracket_in_an_open_value() {
    assert_eq!(told("<a><b x=\"${1 >|"), "a | b.x ${1 >");
    assert_eq!(told("<a>\n<b x=\"${1 >|\n<c/>\n</a>"), "a | b.x ${1 >");
    assert_eq!(
        told("<a>\n<b x=\"1>\n  |\n</b>\n</a>"),
        "a b | content \n  "
    );
}

#[test]
fn blanks_behind_what_has_no_end() {
    for (text, expected) in [
        (
            "<a>\n  <!-- xacro-lint: |\n  <b/>\n</a>",
            "a | comment  xacro-lint: ",
        ),
        ("<a>\n  <b |\n  <c/>\n</a>", "a | attribute of b "),
        ("<a>\n  <b x |\n  <c/>\n</a>", "a | nothing"),
        ("<a |\n  <c/>\n</a>", " | attribute of a "),
        ("<!-- x |\n<a/>", " | comment  x "),
        ("<a>\n  < |\n</a>", "a | content  "),
    ] {
        assert_eq!(told(text), expected, "{text}");
    }
}

#[test]
fn what_stands_beside() {
    let at = |marked: &str| {
        let offset = marked.find('|').unwrap() as u32;
        let document = Document::parse(&marked.replacen('|', "", 1));
        let typed = typed(&document, offset);
        let siblings = typed.siblings().join(" ");
        let given: Vec<bool> = ["x", "y"].map(|name| typed.has_attr(name)).to_vec();
        format!("{siblings} {given:?} {}", typed.tag_ends())
    };
    for (text, expected) in [
        ("<r><a><b/><c|<d/></a></r>", "b d [false, false] false"),
        ("<r><a><b/><c|><d/></a></r>", "b d [false, false] true"),
        (
            "<r><a><b/><| x=\"1\"/><d/></a></r>",
            "b d [false, false] true",
        ),
        ("<r><a x|=\"1\" y=\"1\"/></r>", " [false, true] true"),
        ("<r><a x=\"1\" |\n<b/></r>", " [true, false] false"),
    ] {
        assert_eq!(at(text), expected, "{text}");
    }
}

/// What a completion of all of a value replaces.
#[test]
fn the_rest_of_a_value() {
    for (text, expected) in [
        ("<a><b x=\"1|23\" y=\"4\"/></a>", 2),
        // any quote closes the value that it opened
        ("<a><b x='1|23' y=\"4\"/></a>", 2),
        // the quote that follows begins the next value
        ("<a><b x=\"1| y=\"4\"/></a>", 0),
        ("<a><b x=\"1|\n  2\"/></a>", 0),
        ("<a><b x=\"1|", 0),
    ] {
        let offset = text.find('|').unwrap() as u32;
        let document = Document::parse(&text.replacen('|', "", 1));
        assert_eq!(typed(&document, offset).rest_of_value(), expected, "{text}");
    }
}

//! Trees, errors and losslessness over tables of inputs.

use std::fmt::Write;

use super::*;
use base::TextRange;

/// The tree on one line: `name[attributes](children)`; `/` self-closing, `…` without end tag, `?` junk.
/// White space between the nodes is left out.
fn compact(document: &Document) -> String {
    let mut out = String::new();
    document
        .header()
        .nodes()
        .for_each(|node| compact_node(node, &mut out));
    out.push_str("{ ");
    for (_, item) in document.items() {
        item.nodes().for_each(|node| compact_node(node, &mut out));
        out.push_str("; ");
    }
    document
        .footer_content()
        .for_each(|node| compact_node(node, &mut out));
    out.push_str(if document.root_end_tag().is_some() {
        "}"
    } else {
        ""
    });
    document
        .epilog()
        .for_each(|node| compact_node(node, &mut out));
    out.trim_end().to_owned()
}

fn compact_node(node: Node<'_>, out: &mut String) {
    let raw = node.raw().trim();
    match node.kind() {
        NodeKind::Text if raw.is_empty() => return,
        NodeKind::Text => drop(write!(out, "{raw:?}")),
        NodeKind::Element => compact_element(node, out),
        NodeKind::Junk => drop(write!(out, "?{raw:?}")),
        kind => drop(write!(out, "{kind:?}{raw:?}")),
    }
    out.push(' ');
}

fn compact_element(node: Node<'_>, out: &mut String) {
    out.push_str(node.name());
    if node.attrs().len() > 0 {
        let attrs: Vec<String> = node
            .attrs()
            .map(|attr| format!("{}={}", attr.name(), attr.raw()))
            .collect();
        let _ = write!(out, "[{}]", attrs.join(" "));
    }
    if node.is_self_closing() {
        out.push('/');
    } else if node.end_tag().is_none() {
        out.push('…');
    }
    let mut inner = String::new();
    node.children()
        .for_each(|child| compact_node(child, &mut inner));
    if !inner.is_empty() {
        let _ = write!(out, "({})", inner.trim_end());
    }
}

fn kinds(document: &Document) -> String {
    let kinds: Vec<String> = document
        .errors()
        .iter()
        .map(|e| format!("{:?}", e.kind))
        .collect();
    kinds.join(" ")
}

/// Invariants of every tree: no text lost, ranges inside each other and in order.
fn check_invariants(text: &str) {
    let document = Document::parse(text);
    assert_eq!(document.text(), text);
    for (_, item) in document.parts() {
        let mut end = 0;
        for node in item.nodes() {
            assert!(node.range().start >= end, "{node:?} overlaps in {text:?}");
            end = node.range().end;
        }
        for node in item.all_nodes() {
            let range = node.range();
            assert!(
                item.text()
                    .get(range.start as usize..range.end as usize)
                    .is_some(),
                "{node:?} in {text:?}"
            );
            let mut inner = node.start_tag_range().end.max(range.start);
            for child in node.children() {
                assert!(
                    range.contains_range(child.range()),
                    "{child:?} outside of {node:?} in {text:?}"
                );
                assert!(
                    child.range().start >= inner,
                    "{child:?} overlaps in {text:?}"
                );
                assert_eq!(child.parent(), Some(node));
                inner = child.range().end;
            }
            for attr in node.attrs() {
                assert!(
                    node.start_tag_range().contains_range(attr.range()),
                    "{attr:?} in {text:?}"
                );
                assert!(
                    attr.range().contains_range(attr.value_range()),
                    "{attr:?} in {text:?}"
                );
            }
        }
    }
    for error in document.errors() {
        let whole = TextRange::new(0, document.len());
        assert!(
            whole.contains_range(error.range) && error.expat_offset <= document.len(),
            "{error:?} in {text:?}"
        );
        assert!(!error.message.is_empty(), "{error:?}");
    }
}

#[test]
fn a_sound_document_has_the_expected_shape() {
    let document = Document::parse(
        "<?xml version=\"1.0\"?>\n<!-- c -->\n<robot name='r' xmlns:xacro=\"u\">\n  <!-- d -->\n  \
         <xacro:property name=\"p\" value=\"${1 &lt; 2}\"/>\n  <link name=\"a\">x &amp; y<b/><![CDATA[<]]><?p q?></link>\n\
         \n  tail</robot>\n<!-- e -->",
    );
    assert_eq!(document.errors(), []);
    assert_eq!(
        compact(&document),
        "Declaration\"version=\\\"1.0\\\"\" Comment\"c\" robot[name=r xmlns:xacro=u]… { \
         Comment\"d\" xacro:property[name=p value=${1 &lt; 2}]/ ; \
         link[name=a](\"x &amp; y\" b/ CData\"<\" Pi\"q\") ; \"tail\" }Comment\"e\""
    );
}

/// What stands alone on a line between two good links, as an author types it.
#[test]
fn half_typed_lines_leave_their_neighbors_alone() {
    const A: &str = "link[name=a]/ ; ";
    const Z: &str = "link[name=z]/ ; }";
    for (typed, tree, errors) in [
        ("<", "?\"<\" ", "StrayLt"),
        ("<l", "l… ; ", "UnclosedTag"),
        ("<joint na", "joint[na=]… ; ", "BadAttribute UnclosedTag"),
        (
            "<joint name=",
            "joint[name=]… ; ",
            "BadAttribute UnclosedTag",
        ),
        (
            "<joint name=\"",
            "joint[name=]… ; ",
            "UnclosedValue UnclosedTag",
        ),
        (
            "<link name=\"b",
            "link[name=b]… ; ",
            "UnclosedValue UnclosedTag",
        ),
        ("<link name=\"b/>", "link[name=b]/ ; ", "UnclosedValue"),
        (
            "<link name=\"b>",
            "link[name=b]… ; ",
            "UnclosedValue UnclosedElement",
        ),
        (
            "<link name=\"b type=\"c\"/>",
            "link[name=b type=c]/ ; ",
            "UnclosedValue",
        ),
        (
            "<link name=\"b\n    type=\"c\"/>",
            "link[name=b type=c]/ ; ",
            "UnclosedValue",
        ),
        (
            "<link name=\"b\" type=",
            "link[name=b type=]… ; ",
            "BadAttribute UnclosedTag",
        ),
        (
            "<origin xyz=\"${",
            "origin[xyz=${]… ; ",
            "UnclosedValue UnclosedTag",
        ),
        ("<link name=\"b\">", "link[name=b]… ; ", "UnclosedElement"),
        (
            "<link name=\"b\">\n    <visual/>",
            "link[name=b]…(visual/) ; ",
            "UnclosedElement",
        ),
        ("<xacro:", "xacro:… ; ", "BadName UnclosedTag"),
        ("<xacro:m", "xacro:m… ; ", "UnclosedTag"),
        (
            "<link name=\"b\"><visual></link>",
            "link[name=b](visual…) ; ",
            "UnclosedElement",
        ),
        ("<link name=b/>", "link[name=b]/ ; ", "BadAttribute"),
        (
            "<link name=b type='c'/>",
            "link[name=b type=c]/ ; ",
            "BadAttribute",
        ),
        ("<link name=/>", "link[name=]/ ; ", "BadAttribute"),
        ("<link name/>", "link[name=]/ ; ", "BadAttribute"),
        ("<link name=\"b\" / >", "link[name=b]/ ; ", "BadAttribute"),
        (
            "<link name=\"b\"type=\"c\"/>",
            "link[name=b type=c]/ ; ",
            "BadAttribute",
        ),
        (
            "<link name=\"b\" name=\"c\"/>",
            "link[name=b name=c]/ ; ",
            "DuplicateAttribute",
        ),
        (
            "<link name=\"${a < b}\"/>",
            "link[name=${a < b}]/ ; ",
            "LtInValue",
        ),
        (
            "<link name=\"${a < b and c > d}\" type=\"e\"/>",
            "link[name=${a < b and c > d} type=e]/ ; ",
            "LtInValue",
        ),
        (
            "<link name=\"b\n    <visual/>\n  </link>",
            "link[name=b](visual/) ; ",
            "UnclosedValue UnclosedTag",
        ),
        (
            "<link name=\"b\"\n    <visual/>\n  </link>",
            "link[name=b](visual/) ; ",
            "UnclosedTag",
        ),
        ("<link name=\"b\"</link>", "link[name=b] ; ", "UnclosedTag"),
        (
            "<link name=\"b\"></joint>",
            "link[name=b] ; ",
            "MismatchedEndTag",
        ),
        (
            "<link name=\"b\">\n  </joint>",
            "link[name=b] ; ",
            "MismatchedEndTag",
        ),
        ("<link name=\"b\"></", "link[name=b] ; ", "UnclosedTag"),
        ("<link name=\"b\"></li", "link[name=b] ; ", "UnclosedTag"),
        ("<link name=\"b\"></link", "link[name=b] ; ", "UnclosedTag"),
        (
            "<link name=\"b\">\n    </\n  </link>",
            "link[name=b](?\"</\") ; ",
            "UnclosedTag MismatchedEndTag",
        ),
        ("</", "?\"</\" ", "UnclosedTag MismatchedEndTag"),
        ("</link>", "?\"</link>\" ", "MismatchedEndTag"),
        ("<!", "?\"<!\" ", "UnclosedMarkup"),
        ("<!-", "?\"<!-\" ", "UnclosedMarkup"),
        ("<!-- half", "Comment\"half\" ", "UnclosedMarkup"),
        ("<!-- a -- b -->", "Comment\"a -- b\" ", "BadComment"),
        ("<!-- a\n  <b/>\n  -->", "Comment\"a\\n  <b/>\" ", ""),
        ("<![CDATA[ half", "CData\"half\" ", "UnclosedMarkup"),
        ("<![CDA", "?\"<![CDA\" ", "UnclosedMarkup"),
        ("<?half", "Pi\"\" ", "UnclosedMarkup"),
        ("<?", "Pi\"\" ", "UnclosedMarkup"),
        ("<>", "?\"<\" \">\" ", "StrayLt"),
        ("< link/>", "?\"<\" \"link/>\" ", "StrayLt"),
        ("text & more", "\"text & more\" ", "BadReference"),
        ("&undefined;", "\"&undefined;\" ", "UndefinedEntity"),
        ("&#0;", "\"&#0;\" ", "BadCharacterReference"),
        ("a ]]> b", "\"a ]]> b\" ", "CDataEndInText"),
        ("\u{1}", "\"\\u{1}\" ", "IllegalCharacter"),
        ("<1/>", "?\"<\" \"1/>\" ", "StrayLt"),
        ("<a:b:c/>", "a:b:c/ ; ", "BadName"),
        ("<q:b/>", "q:b/ ; ", "UnboundPrefix"),
    ] {
        let text = format!(
            "<robot xmlns:xacro=\"x\">\n  <link name=\"a\"/>\n  {typed}\n  <link name=\"z\"/>\n</robot>\n"
        );
        let document = Document::parse(&text);
        assert_eq!(
            compact(&document),
            format!("robot[xmlns:xacro=x]… {{ {A}{tree}{Z}"),
            "{typed}"
        );
        assert_eq!(kinds(&document), errors, "{typed}");
        check_invariants(&text);
    }
}

#[test]
fn conflict_markers_keep_both_versions() {
    let text = "<r>\n<<<<<<< HEAD\n  <link name=\"a\"/>\n=======\n  <link name=\"b\"/>\n>>>>>>> topic\n</r>\n";
    let document = Document::parse(text);
    assert_eq!(
        compact(&document),
        "r… { ?\"<<<<<<< HEAD\" link[name=a]/ ; \"=======\" link[name=b]/ ; \">>>>>>> topic\" }"
    );
    assert_eq!(kinds(&document), "MergeConflict");
}

#[test]
fn a_broken_root_keeps_its_content() {
    for (text, tree) in [
        (
            "<robot name=\"r\"\n<link/>\n</robot>",
            "robot[name=r]… { link/ ; }",
        ),
        ("<robot na\n  <link/>\n</robot>", "robot[na=]… { link/ ; }"),
        (
            "<?xml version=\"1.0\"\n<robot>\n<a/></robot>",
            "Pi\"version=\\\"1.0\\\"\" robot… { a/ ; }",
        ),
        (
            "<!DOCTYPE robot [\n<robot>\n<a/></robot>",
            "Doctype\"<!DOCTYPE robot [\" robot… { a/ ; }",
        ),
        (
            "<!-- x\n<robot>\n<a/></robot>",
            "Comment\"x\" robot… { a/ ; }",
        ),
        ("oops\n<robot><a/></robot>", "?\"oops\" robot… { a/ ; }"),
        ("<robot><a/>", "robot… { a/ ;"),
        ("<robot></robot><b><c/></b>t", "robot… { }b(c/) ?\"t\""),
        ("<robot/>", "robot/ {"),
        ("<a/><b>", "a/ { b…"),
    ] {
        assert_eq!(compact(&Document::parse(text)), tree, "{text}");
        check_invariants(text);
    }
}

#[test]
fn errors_name_the_thing_and_the_remedy() {
    for (text, message) in [
        (
            "<r><link name=\"a\"></r>",
            "unclosed element `<link>` before `</r>`\nadd `</link>`",
        ),
        (
            "<r><x:a/></r>",
            "undeclared prefix `x`\nadd xmlns:x=\"...\" to the root element",
        ),
        (
            "<r a='1' a='2'/>",
            "duplicate attribute `a`\nremove one of them",
        ),
        ("<r>a & b</r>", "unescaped `&`\nwrite `&amp;`"),
        (
            "<r>&nbsp;</r>",
            "undefined entity `nbsp`\nuse `amp`, `lt`, `gt`, `quot` or `apos`, or write `&amp;` for a literal `&`",
        ),
        (
            "<r><a></b></r>",
            "end tag `</b>` does not match start tag `<a>`\nwrite `</a>`, or rename the start tag",
        ),
        ("", "no root element\nadd <robot name=\"...\">"),
    ] {
        assert_eq!(Document::parse(text).errors()[0].message, message, "{text}");
    }
}

#[test]
fn a_missing_prefix_is_reported_once() {
    let document =
        Document::parse("<r>\n<xacro:a/>\n<xacro:b xacro:c=''/>\n<d><xacro:e/></d>\n</r>");
    assert_eq!(kinds(&document), "UnboundPrefix");
}

#[test]
fn namespaces_of_the_header_reach_all_items() {
    let mut document = Document::parse("<r xmlns:a='u' xmlns:b='u'>\n<x a:p='1' b:p='2'/>\n</r>");
    assert_eq!(kinds(&document), "DuplicateAttribute");
    document.edit(TextRange::new(24, 25), "v");
    assert_eq!(
        document.text(),
        "<r xmlns:a='u' xmlns:b='v'>\n<x a:p='1' b:p='2'/>\n</r>"
    );
    assert_eq!(document.errors(), []);
}

#[test]
fn depth_and_width_are_no_danger() {
    const N: usize = 1_000_000;
    let nested = format!("<r>{}{}</r>", "<a>".repeat(N), "</a>".repeat(N));
    assert_eq!(Document::parse(&nested).errors(), []);
    let open = format!("<r>{}", "<a>\n".repeat(N));
    assert_eq!(Document::parse(&open).errors()[0].expat, "no element found");
    let crossed = format!("<r>{}{}", "<a>".repeat(N), "</b>".repeat(N));
    assert_eq!(
        Document::parse(&crossed).errors()[0].expat,
        "mismatched tag"
    );
    let attributes: String = (0..N).map(|n| format!(" a{n}=''")).collect();
    assert_eq!(
        Document::parse(&format!("<r><a{attributes}/></r>")).errors(),
        []
    );
    let lines = format!("<r>\n{}</r>", "<!-- \n<a>\n".repeat(20_000));
    assert_eq!(Document::parse(&lines).text(), lines);
    let quotes = format!("<r>\n{}</r>", "<a b=\"\n".repeat(100_000));
    assert_eq!(Document::parse(&quotes).text(), quotes);
}

#[test]
fn entities_are_resolved_within_limits() {
    let text = |body: &str| {
        let entities: String = (1..11)
            .map(|n| format!("<!ENTITY l{n} \"{}\">", format!("&l{};", n - 1).repeat(10)))
            .collect();
        format!(
            "<!DOCTYPE r [<!ENTITY l0 \"lol\">{entities}<!ENTITY e \"x&#65;\"><!ENTITY m \"<b/>\"><!ENTITY s SYSTEM \"f\">]>\n<r a=\"&e;\">{body}</r>"
        )
    };
    let document = Document::parse(&text("&e;&l1;&s;"));
    assert_eq!(document.errors(), []);
    let root = document.root().expect("a root");
    assert_eq!(
        root.attr("a")
            .expect("an attribute")
            .value(document.entities()),
        "xA"
    );
    let body = document.footer_content().next().expect("text");
    assert_eq!(
        body.text(document.entities()),
        format!("xA{}", "lol".repeat(10))
    );
    assert_eq!(document.entities().markup_entity("a &e; &m;"), Some("m"));
    assert_eq!(kinds(&Document::parse(&text("&l10;"))), "BadEntity");
    assert_eq!(
        kinds(&Document::parse(&text(&"&l6;".repeat(400)))),
        "BadEntity"
    );
    assert_eq!(kinds(&Document::parse(&text("&l3;"))), "");
}

//! Facts of small documents, printed.

use super::{Marks, facts, facts_of, may_hold, parts_where};
use base::TextRange;
use xml::Document;

#[track_caller]
fn check(text: &str, expected: &[&str]) {
    let document = Document::parse(text);
    let mut found = Vec::new();
    for (base, facts) in facts(&document) {
        for fact in &facts.named {
            let inside = if fact.in_macro { " in a macro" } else { "" };
            assert_eq!(document.slice(fact.range.shift(base)), fact.name.as_str());
            found.push(format!("{:?} {}{inside}", fact.kind, fact.name));
        }
        for mention in facts.mentions() {
            assert_eq!(
                document.slice(mention.range.shift(base)),
                mention.name.as_str()
            );
            found.push(format!("  {:?} {}", mention.kind, mention.name));
        }
    }
    assert_eq!(found, expected);
}

#[test]
fn marks_say_what_an_item_may_hold() {
    let table = [
        ("<link name='a'><visual/></link>", Marks::default()),
        (
            "<xacro:if value='1'><link/></xacro:if>",
            Marks {
                condition: true,
                ..Marks::default()
            },
        ),
        (
            "<!-- Xacro-Lint: disable-file x --><link/>",
            Marks {
                lint: true,
                ..Marks::default()
            },
        ),
        (
            "<mesh filename='$(find arm)/a.stl'/>",
            Marks {
                package: true,
                file_tag: true,
                ..Marks::default()
            },
        ),
        (
            "<gazebo><a>package://arm/a.stl</a></gazebo>",
            Marks {
                package: true,
                other_tag: true,
                ..Marks::default()
            },
        ),
        (
            "<property name='lint' value='1'/>",
            Marks {
                other_tag: true,
                ..Marks::default()
            },
        ),
        (
            "<xacro:macro name='m'><a x='${n == True} {n}'/><include/></xacro:macro>",
            Marks {
                macro_tag: true,
                other_tag: true,
                include: true,
                bare_brace: true,
                truth: true,
                ..Marks::default()
            },
        ),
        (
            "<parameters>a ${b} ($c)</parameters>",
            Marks {
                parameters: true,
                other_tag: true,
                bare_brace: true,
                ..Marks::default()
            },
        ),
    ];
    for (text, expected) in table {
        let document = Document::parse(&format!("<robot>{text}</robot>"));
        let (_, item) = document.items().next().unwrap();
        assert_eq!(facts_of(item).marks, expected, "{text}");
    }
}

/// Items in a row are asked together, also after edits that change one of them, or how many there are.
#[test]
fn parts_that_hold_something_are_found_after_edits() {
    let text = format!("<robot>{}</robot>", "<link name='a'/>".repeat(300));
    let mut document = Document::parse(&text);
    let starts = |document: &Document| -> Vec<u32> {
        parts_where(document, |marks| marks.condition)
            .map(|(start, _)| start)
            .collect()
    };
    assert_eq!(starts(&document), []);
    let before = document.clone();
    let at = 7 + 16 * 200;
    document.edit(TextRange::new(at, at + 16), "<xacro:if value='1'/>");
    assert_eq!(starts(&document), [at]);
    assert_eq!(starts(&before), []);
    document.edit(TextRange::empty(7), "<xacro:unless value='1'/>");
    assert_eq!(starts(&document), [7, at + 25]);
    document.edit(TextRange::new(at + 25, at + 25 + 21), "");
    assert_eq!(starts(&document), [7]);
    assert!(may_hold(&document, |marks| marks.condition));
    assert!(!may_hold(&document, |marks| marks.include));
}

#[test]
fn names_given_and_names_mentioned() {
    check(
        r#"<robot><xacro:arg name="side" default="left"/>
  <xacro:include filename="$(find pkg)/a.xacro"/>
  <xacro:macro name="leg" params="p"><link name="${p}_link"/></xacro:macro>
  <xacro:leg p="${len(side) &gt; 0 and $(arg side)}"/><xacro:ns.leg/>
  <joint name="j" type="fixed"/><joint name="of a transmission"/>
  text ${a + [b for b in c][0]} $(eval x + 1)</robot>"#,
        &[
            "Argument side",
            "Include $(find pkg)/a.xacro",
            "  Package pkg",
            "Macro leg",
            "Link ${p}_link in a macro",
            "  Name p",
            "Call leg",
            "  Argument side",
            "Call ns.leg",
            "Joint j",
            "  Name a",
            "  Name c",
            "  Argument x",
        ],
    );
}

#[test]
fn half_typed_text_loses_nothing_in_front_of_it() {
    check(
        r#"<robot><xacro:property name="a" value="${b"/><link name="l" <xacro:macro name="m">${x + "#,
        &["Property a", "Link l", "Macro m"],
    );
}

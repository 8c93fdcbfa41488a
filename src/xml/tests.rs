//! Trees, errors and losslessness over tables of inputs.

use std::fmt::Write;

use super::*;

/// One line per node, indented; attributes in brackets.
fn dump(document: &Document) -> String {
    let mut out = String::new();
    for node in document.header().nodes() {
        dump_node(node, 0, &mut out);
    }
    for (_, item) in document.items() {
        out.push_str("item\n");
        for node in item.nodes() {
            dump_node(node, 1, &mut out);
        }
    }
    for node in document.footer_content() {
        dump_node(node, 1, &mut out);
    }
    out.push_str(if document.root_end_tag().is_some() { "end\n" } else { "open end\n" });
    for node in document.epilog() {
        dump_node(node, 0, &mut out);
    }
    out
}

fn dump_node(node: Node<'_>, depth: usize, out: &mut String) {
    let _ = write!(out, "{}", "  ".repeat(depth));
    match node.kind() {
        NodeKind::Element => {
            out.push_str(node.name());
            for attr in node.attrs() {
                let _ = write!(out, " {:?}", attr);
            }
            if node.is_self_closing() {
                out.push('/');
            } else if node.end_tag().is_none() {
                out.push('…');
            }
            out.push('\n');
            node.children().for_each(|child| dump_node(child, depth + 1, out));
        }
        kind => {
            let _ = writeln!(out, "{kind:?} {:?}", node.raw());
        }
    }
}

#[test]
fn a_sound_document_has_the_expected_shape() {
    let text = "<?xml version=\"1.0\"?>\n<!-- c -->\n<robot name='r' xmlns:xacro=\"u\">\n  <!-- d -->\n  \
                <xacro:property name=\"p\" value=\"${1 < 2}\"/>\n  <link name=\"a\">x &amp; y<b/></link>\n</robot>\n<!-- e -->";
    let document = Document::parse(&text.replace("1 < 2", "1 &lt; 2"));
    assert_eq!(document.errors(), []);
    insta::assert_snapshot!(dump(&document), @r#"
    Declaration "version=\"1.0\""
    Comment " c "
    robot name="r" xmlns:xacro="u"…
    item
      Text "\n  "
      Comment " d "
      Text "\n  "
      xacro:property name="p" value="${1 &lt; 2}"/
    item
      Text "\n  "
      link name="a"
        Text "x &amp; y"
        b/
      Text "\n"
    end
    Comment " e "
    "#);
}

//! What formatting must keep, tried on the examples and on generated documents: the elements with their attributes
//! and text, every comment and every value byte by byte, the line ends, and the robots that come out.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use proptest::test_runner::Config;
use xacro_lsp::analysis::apply;
use xacro_lsp::cli::{self, Io};
use xacro_lsp::ide::{Indent, format, format_range, indentation};
use xacro_lsp::vfs::Environment;
use xacro_lsp::workspace::config::{AttributeLayout, Format};
use xacro_lsp::xml::{Document, NodeKind};

fn formatted(text: &str, indent: &Indent, options: &Format) -> String {
    let document = Document::parse(text);
    apply(text, &format(&document, indent, options))
}

fn plain(text: &str) -> String {
    formatted(text, &Indent::blanks(2), &Format::default())
}

/// Elements, attributes and text of a document, one a line; white space between elements left away.
fn infoset(text: &str) -> Vec<String> {
    let options = roxmltree::ParsingOptions {
        allow_dtd: true,
        ..Default::default()
    };
    let document = roxmltree::Document::parse_with_options(text, options).unwrap();
    let mut lines = Vec::new();
    for node in document.descendants() {
        let depth = node.ancestors().count();
        if node.is_element() {
            let attributes = node
                .attributes()
                .map(|a| format!("{:?}={}", a.namespace(), a.value()));
            let attributes: Vec<_> = attributes.collect();
            lines.push(format!("{depth} {:?} {attributes:?}", node.tag_name()));
        } else if node.is_comment() || node.is_pi() {
            lines.push(format!("{depth} {:?} {:?}", node.text(), node.pi()));
        } else if node.is_text() {
            let text = node.text().unwrap();
            if !text.trim_matches([' ', '\t', '\r', '\n']).is_empty() {
                lines.push(format!("{depth} {text:?}"));
            }
        }
    }
    lines
}

/// All comments, values, instructions and texts as they are written.
fn verbatim(text: &str) -> Vec<String> {
    let document = Document::parse(text);
    let mut found = Vec::new();
    for (_, item) in document.parts() {
        for node in item.all_nodes() {
            match node.kind() {
                NodeKind::Element => {
                    found.extend(node.attrs().map(|a| format!("{}={}", a.name(), a.raw())))
                }
                NodeKind::Text if node.raw().trim().is_empty() => {}
                _ => found.push(node.raw().to_owned()),
            }
        }
    }
    found
}

/// Formatting once changes nothing but white space, formatting twice nothing more.
fn keeps_everything(text: &str, indent: &Indent, options: &Format) {
    let once = formatted(text, indent, options);
    assert_eq!(
        formatted(&once, indent, options),
        once,
        "twice is not once: {text:?}"
    );
    assert_eq!(infoset(&once), infoset(text), "{text:?} became {once:?}");
    assert_eq!(verbatim(&once), verbatim(text), "{text:?} became {once:?}");
    if !text.contains('\n') || text.matches('\n').count() == text.matches("\r\n").count() {
        return;
    }
    if !text.contains('\r') {
        assert!(!once.contains('\r'), "{text:?} became {once:?}");
    }
}

fn all_options() -> Vec<(Indent, Format)> {
    let auto = |width| Format {
        attributes: AttributeLayout::Auto,
        line_width: width,
        self_close: false,
    };
    vec![
        (Indent::blanks(2), Format::default()),
        (
            Indent::blanks(4),
            Format {
                self_close: true,
                ..Format::default()
            },
        ),
        (Indent::tabs(4), Format::default()),
        (Indent::tabs(8), auto(40)),
        (Indent::blanks(3), auto(120)),
    ]
}

fn descriptions(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            descriptions(&path, found);
        } else if path
            .extension()
            .is_some_and(|ending| ending == "xacro" || ending == "urdf")
        {
            found.push(path);
        }
    }
    found.sort();
}

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples")
}

#[test]
fn examples_keep_everything() {
    let mut files = Vec::new();
    descriptions(&examples(), &mut files);
    assert!(files.len() > 5, "{files:?}");
    for path in files {
        let text = fs::read_to_string(&path).unwrap();
        if !Document::parse(&text).errors().is_empty() {
            continue;
        }
        for (indent, options) in all_options() {
            keeps_everything(&text, &indent, &options);
            keeps_everything(&text.replace('\n', "\r\n"), &indent, &options);
        }
    }
}

fn expanded(file: &Path) -> String {
    let vars = BTreeMap::from([("AMENT_PREFIX_PATH".to_owned(), "/none".to_owned())]);
    let env = Environment {
        vars,
        cwd: file.parent().unwrap().to_owned(),
        ..Environment::default()
    };
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let mut input = std::io::empty();
    let mut io = Io::plain(&mut out, &mut err, &mut input);
    let code = cli::run(
        &["expand".to_owned(), file.display().to_string()],
        &env,
        &mut io,
    );
    format!("{code}\n{}", String::from_utf8(out).unwrap())
}

#[test]
fn robots_come_out_the_same() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("formatting");
    for (number, (indent, options)) in all_options().into_iter().enumerate() {
        let copy = folder.join(number.to_string());
        let _ = fs::remove_dir_all(&copy);
        copy_into(&examples(), &copy);
        let mut files = Vec::new();
        descriptions(&copy, &mut files);
        let before: Vec<String> = files.iter().map(|file| expanded(file)).collect();
        for file in &files {
            let text = fs::read_to_string(file).unwrap();
            fs::write(file, formatted(&text, &indent, &options)).unwrap();
        }
        for (file, before) in files.iter().zip(before) {
            assert_eq!(expanded(file), before, "{}", file.display());
        }
    }
}

fn copy_into(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let new = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy_into(&path, &new);
        } else {
            fs::copy(&path, &new).unwrap();
        }
    }
}

fn blank() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec!["", " ", "\n", "\n\n\n", "  \n\t", "\t", " \n  "])
}

fn attribute() -> impl Strategy<Value = String> {
    let gap = prop::sample::select(vec![" ", "  ", "\n", "\n    ", " \n\t\t"]);
    let equals = prop::sample::select(vec!["=", " = ", "=\n"]);
    let value = prop::sample::select(vec![
        "\"1  2\"",
        "'a\n  b'",
        "\"${ x  <\"",
        "\"&lt; é 🤖\"",
        "''",
    ]);
    (gap, equals, value).prop_map(|(gap, equals, value)| {
        let value = value.replace('<', "&lt;");
        format!("{gap}NAME{equals}{value}")
    })
}

fn start_tag(name: String, attributes: Vec<String>, end: &str) -> String {
    let names = attributes
        .iter()
        .enumerate()
        .map(|(i, text)| text.replacen("NAME", &format!("a{i}"), 1));
    format!("<{name}{}{end}", names.collect::<String>())
}

fn element() -> impl Strategy<Value = String> {
    let name = prop::sample::select(vec!["link", "joint", "xacro:if", "é"]).prop_map(str::to_owned);
    let end = prop::sample::select(vec![">", " >", "\n>"]);
    let attributes = prop::collection::vec(attribute(), 0..4).boxed();
    let leaf = (
        name.clone(),
        attributes.clone(),
        prop::sample::select(vec!["/>", " />", "\n  />"]),
    )
        .prop_map(|(name, attributes, end)| start_tag(name, attributes, end));
    let other = prop::sample::select(vec![
        "<!-- one\n   two  -->",
        "<!--x-->",
        "<?pi  a?>",
        "text",
        "<![CDATA[ < ]]>",
        "&#10;",
        "<s xml:space=\"preserve\"> <b/>\n </s>",
        "<e></e>",
        "<e>\n\n\n</e>",
    ])
    .prop_map(str::to_owned);
    let simple = prop_oneof![3 => leaf, 2 => other];
    simple.prop_recursive(4, 30, 5, move |inner| {
        let children = prop::collection::vec((blank(), inner), 0..5);
        (
            name.clone(),
            attributes.clone(),
            end.clone(),
            children,
            blank(),
        )
            .prop_map(|(name, attributes, end, children, last)| {
                let children: String = children
                    .into_iter()
                    .map(|(gap, child)| format!("{gap}{child}"))
                    .collect();
                let tag = start_tag(name.clone(), attributes, end);
                format!("{tag}{children}{last}</{name} >")
            })
    })
}

proptest! {
    #![proptest_config(Config { cases: 600, failure_persistence: None, ..Config::default() })]

    #[test]
    fn generated_documents_keep_everything(
        parts in prop::collection::vec((blank(), element()), 0..6),
        last in blank(),
        head in prop::sample::select(vec!["", "<?xml version='1.0'?>", "<!-- head -->\n\n\n", "<!DOCTYPE robot>"]),
        option in 0..5_usize,
        windows in any::<bool>(),
    ) {
        let children: String = parts.into_iter().map(|(gap, child)| format!("{gap}{child}")).collect();
        let mut text = format!("{head}<robot xmlns:xacro=\"x\">{children}{last}</robot>{last}");
        if windows {
            text = text.replace('\n', "\r\n");
        }
        prop_assume!(Document::parse(&text).errors().is_empty());
        let (indent, options) = &all_options()[option];
        keeps_everything(&text, indent, options);
        let own = indentation(&Document::parse(&text));
        keeps_everything(&text, &own, options);
    }
}

#[test]
fn elements_stand_on_lines_of_their_own() {
    for (text, expected) in [
        ("<a><b/><c/></a>", "<a>\n  <b/>\n  <c/>\n</a>"),
        (
            "<a>\n<b>text</b>\n\n\n\n</a>\n\n",
            "<a>\n  <b>text</b>\n\n</a>\n",
        ),
        (
            "<a>\n<b> <!-- c -->\n</b> <!-- d --></a>",
            "<a>\n  <b> <!-- c -->\n  </b> <!-- d -->\n</a>",
        ),
        (
            "<a>\n<!-- c\n d --><b/></a>",
            "<a>\n  <!-- c\n d --><b/>\n</a>",
        ),
        (
            "<a   x = '1'\ty=\"2\"  >\n</a >",
            "<a x='1' y=\"2\" >\n</a>",
        ),
        (
            "<a>\n<b x=\"1\"\n y=\"2\"/></a>",
            "<a>\n  <b x=\"1\"\n   y=\"2\"/>\n</a>",
        ),
        (
            "<a>\n<b x=\"1\"\ny=\"2\"/></a>",
            "<a>\n  <b x=\"1\"\n     y=\"2\"/>\n</a>",
        ),
        (
            "<a>\n<b x=\"1\"\n   y=\"2\"\n z=\"3\" /></a>",
            "<a>\n  <b x=\"1\"\n     y=\"2\"\n     z=\"3\" />\n</a>",
        ),
        (
            "<a>\n<b\n   x=\"1\"\n   y=\"2\"\n/></a>",
            "<a>\n  <b\n     x=\"1\"\n     y=\"2\"\n  />\n</a>",
        ),
        (
            "<a>\n <p> x <b/>  <c/>\n</p></a>",
            "<a>\n  <p> x <b/>  <c/>\n</p>\n</a>",
        ),
    ] {
        assert_eq!(plain(text), expected, "{text}");
    }
}

#[test]
fn long_tags_are_wrapped_where_that_is_wished() {
    let auto = Format {
        attributes: AttributeLayout::Auto,
        line_width: 30,
        self_close: true,
    };
    let text =
        "<a>\n  <limit lower=\"-1\"\n upper=\"1\" effort=\"3\" velocity=\"2\"></limit>\n</a>\n";
    let expected = "<a>\n  <limit lower=\"-1\" upper=\"1\"\n         effort=\"3\"\n         velocity=\"2\"/>\n</a>\n";
    assert_eq!(formatted(text, &Indent::blanks(2), &auto), expected);
}

#[test]
fn broken_files_are_left_alone() {
    for text in ["<a><b></a>", "<a", "", "<a/><b/>", "<x:a/>"] {
        assert_eq!(plain(text), text);
    }
}

#[test]
fn a_range_changes_its_lines_only() {
    let text = "<a>\n<b/>\n<c/>\n<d/>\n</a>\n";
    let document = Document::parse(text);
    let start = text.find("<c").unwrap() as u32;
    let range = xacro_lsp::base::TextRange::new(start, start + 4);
    let edits = format_range(&document, range, &Indent::blanks(2), &Format::default());
    assert_eq!(apply(text, &edits), "<a>\n<b/>\n  <c/>\n<d/>\n</a>\n");
}

#[test]
fn the_step_of_indentation_is_read_off_the_file() {
    for (text, unit) in [
        ("<a>\n    <b>\n        <c/>\n    </b>\n  <d/>\n</a>", "    "),
        ("<a>\n\t<b/>\n</a>", "\t"),
        ("<a><b/></a>", "  "),
    ] {
        assert_eq!(indentation(&Document::parse(text)).unit, unit, "{text}");
    }
}

#[test]
fn long_lines_and_deep_documents_take_no_time() {
    let many: String = (0..30_000)
        .map(|i| format!("<link name=\"l{i}\" a=\"1\"/>"))
        .collect();
    let one_line = format!("<robot>{many}</robot>");
    let formatted = plain(&one_line);
    assert_eq!(formatted.lines().count(), 30_002);
    assert_eq!(plain(&formatted), formatted);
    let deep = format!(
        "<robot>{}{}</robot>",
        "<link>".repeat(5_000),
        "</link>".repeat(5_000)
    );
    let formatted = plain(&deep);
    assert_eq!(plain(&formatted), formatted);
}

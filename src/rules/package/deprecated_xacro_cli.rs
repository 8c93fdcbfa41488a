//! A launch file that calls xacro in a way of the past.
use std::path::Path;

use super::super::context::{DocumentCx, RootKind};
use super::super::finding::Edit;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::launch::{self, is_launch};
use base::{Span, TextRange};

pub(super) static RULE: Rule = Rule {
    code: "PKG007",
    name: "deprecated-xacro-cli",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::Off,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("deprecated-xacro-cli"),
    check: Check::Document(check),
};

/// The words to replace, and by what.
const WORDS: [(&str, &str, &str); 2] = [
    ("xacro.py", "xacro", "call the program `xacro`"),
    (
        "--inorder",
        "",
        "remove the option; it is the default since ROS Melodic",
    ),
];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(root) = cx
        .expansion
        .files
        .first()
        .map(|file| file.source.path.clone())
    else {
        return;
    };
    if is_launch(&root) {
        return check_file(cx, &root, out);
    }
    if cx.kind == RootKind::Robot {
        launch::files(cx.world, &root)
            .iter()
            .for_each(|path| check_file(cx, path, out));
    }
}

fn check_file(cx: &DocumentCx<'_>, path: &Path, out: &mut Sink<'_>) {
    let Ok(file) = cx.world.vfs.text(path) else {
        return;
    };
    for (word, replacement, help) in WORDS {
        for (at, _) in file.text.match_indices(word) {
            let range = TextRange::new(at as u32, (at + word.len()) as u32);
            let span = Span {
                file: cx.world.vfs.file_id(path),
                range,
            };
            let blank = replacement.is_empty()
                && file.text.get(..at).is_some_and(|text| text.ends_with(' '));
            let range = TextRange::new(range.start - u32::from(blank), range.end);
            let edit = Edit {
                span: Span { range, ..span },
                content: replacement.to_owned(),
            };
            out.report_span(span, format!("`{word}` is deprecated"))
                .help(help)
                .edits(Safety::Safe, "update the command", vec![edit])
                .done();
        }
    }
}

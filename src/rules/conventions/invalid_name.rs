//! A name with characters that other tools do not take.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::xml::with_dollars;
use super::names;
use model::Text;

pub(super) const RULE: Rule = Rule {
    code: "CNV001",
    name: "invalid-name",
    category: Category::Conventions,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("invalid-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (named, name) in cx.robot.into_iter().flat_map(names::names) {
        let Some(bad) = name.value.chars().find(|&c| !is_admitted(c)) else { continue };
        let what = named.word();
        let shown = if bad.is_whitespace() { "white space".to_owned() } else { format!("`{bad}`") };
        if let Some(new) = with_dollars(cx, &name.value).filter(|_| name.is_literal()) {
            out.report(name.origin, format!("the name of {what} {}has {shown} in it", quoted(name)))
                .help(format!("an expression needs a `$` in front: write `{new}`"))
                .replace_with(Safety::Unsafe, format!("write `{new}`"), new)
                .done();
            continue;
        }
        let report = out
            .report(name.origin, format!("the name of {what} {}has {shown} in it", quoted(name)))
            .help("use letters, digits, `_`, `-`, `.` and `/`");
        let new: String = name.value.trim().chars().map(|c| if is_admitted(c) { c } else { '_' }).collect();
        match names::rename(cx, named, &name.value, &new).filter(|_| !new.is_empty()) {
            Some(edits) => {
                report.edits(Safety::Unsafe, format!("rename it to `{new}` everywhere"), edits).done();
            }
            None => report.done(),
        }
    }
}

/// The name, unless it is so long that it cannot be meant as one: then it may be the text of some file.
fn quoted(name: &Text) -> String {
    const MOST: usize = 100;
    if name.value.len() > MOST { String::new() } else { format!("`{}` ", name.value) }
}

fn is_admitted(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '/' | '-')
}

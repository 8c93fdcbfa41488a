//! A comment for the linter that it does not understand.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::suppression::Suppressions;

pub(in super::super) static RULE: Rule = Rule {
    code: "LNT003",
    name: "malformed-suppression",
    category: Category::Linter,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("malformed-suppression"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    for malformed in Suppressions::of(&cx.source.document).malformed {
        out.report_in(cx.file, malformed.comment, malformed.message)
            .help(malformed.help)
            .done();
    }
}

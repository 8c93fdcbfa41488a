//! The name of a package that tools do not take.
use super::super::context::FileCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::mentions;
use base::FastSet;

pub(super) static RULE: Rule = Rule {
    code: "PKG004",
    name: "invalid-package-name",
    category: Category::Package,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("invalid-package-name"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let mut said: FastSet<String> = FastSet::default();
    for mention in mentions::packages(cx) {
        if !is_valid(&mention.name) && said.insert(mention.name.clone()) {
            out.report_in(
                cx.file,
                mention.range,
                format!("invalid package name `{}`", mention.name),
            )
            .group(Group::Value(mention.name.as_str().into()))
            .help("use at least two of a-z, 0-9 and `_`; start with a letter and do not use `__`")
            .done();
        }
    }
}

fn is_valid(name: &str) -> bool {
    let admitted = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    let begins = name.starts_with(|c: char| c.is_ascii_lowercase());
    begins && name.len() > 1 && name.chars().all(admitted) && !name.contains("__")
}

//! A launch file that names a file which the build of its package does not install.
use super::super::finding::Finding;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG022",
    name: "launched-file-not-installed",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("launched-file-not-installed"),
    check: Check::Analysis,
};

/// The finding about a file of a package. `inside`: its path in the package. `build`: the name of the file whose rules say what is
/// installed.
pub fn launched_file_not_installed(
    span: Span,
    package: &str,
    inside: &str,
    build: &str,
) -> Finding {
    let message = format!("package `{package}` does not install `{inside}`");
    let mut finding = Finding::new(&RULE, span, message);
    let folder = inside.rsplit_once('/').map_or(inside, |(folder, _)| folder);
    // a folder that is left out is one mistake
    finding.group = Some(Group::Thing(format!("{package}/{folder}").into()));
    finding.help = Some(format!(
        "add `{folder}` to the install rules in {build}: once the package is built, the launch file does not find it"
    ));
    finding
}

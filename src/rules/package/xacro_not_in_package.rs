//! A package with xacro files that does not depend on xacro.
use super::super::context::DocumentCx;
use super::super::finding::Edit;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::dependencies;
use expand::FileIdx;

pub(super) static RULE: Rule = Rule {
    code: "PKG005",
    name: "xacro-not-in-package",
    category: Category::Package,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("xacro-not-in-package"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let file = cx
        .expansion
        .files
        .first()
        .map(|file| file.source.path.clone());
    if file.is_none_or(|path| {
        path.extension()
            .is_none_or(|ending| !ending.eq_ignore_ascii_case("xacro"))
    }) {
        return;
    }
    let Some(manifest) = dependencies::of_file(cx.world, cx.expansion, FileIdx(0)) else {
        return;
    };
    if manifest.name != "xacro" && !manifest.runtime.iter().any(|name| name == "xacro") {
        let (span, content) = manifest.addition("xacro");
        let message = format!(
            "package `{}` has xacro files but does not depend on `xacro`",
            manifest.name
        );
        out.report_span(manifest.start(), message)
            .help("add <exec_depend>xacro</exec_depend> to package.xml")
            .edits(
                Safety::Safe,
                "add the dependency to package.xml",
                vec![Edit { span, content }],
            )
            .done();
    }
}

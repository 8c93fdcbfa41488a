//! The name of a package that holds a description.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::dependencies;
use expand::FileIdx;

pub(super) static RULE: Rule = Rule {
    code: "PKG006",
    name: "description-package-name",
    category: Category::Package,
    severity: Severity::Info,
    default: Activation::Profiles(&["ros-industrial"]),
    since: "0.1",
    fix: None,
    docs: page("description-package-name"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let Some(manifest) = dependencies::of_file(cx.world, cx.expansion, FileIdx(0)) else {
        return;
    };
    if !manifest.name.ends_with("_description") && !manifest.name.ends_with("_support") {
        let message = format!(
            "package `{}` contains a robot description, but its name does not end in `_description`",
            manifest.name
        );
        out.report_span(manifest.name_span(), message)
            .help("end the name in `_description`, or in `_support` for vendor packages")
            .done();
    }
}

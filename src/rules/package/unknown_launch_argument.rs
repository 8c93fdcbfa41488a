//! An argument that a launch file passes and the robot does not know.
use std::path::Path;

use super::super::finding::{Finding, Help};
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(in super::super) static RULE: Rule = Rule {
    code: "PKG009",
    name: "unknown-launch-argument",
    category: Category::Package,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("unknown-launch-argument"),
    check: Check::Analysis,
};

/// The finding about an argument that a call passes and the description does not know; `certain` when all that may read
/// the argument was seen.
pub fn unknown_launch_argument(
    span: Span,
    name: &str,
    file: &Path,
    near: Option<&str>,
    certain: bool,
) -> Finding {
    let file = file.file_name().unwrap_or_default().to_string_lossy();
    let help = match near {
        Some(near) => Help::did_you_mean(near),
        None => Help::from(format!(
            "remove it, or declare it in `{file}` with <xacro:arg name=\"{name}\" default=\"\"/>; xacro ignores an unknown argument"
        )),
    };
    let mut finding = Finding::new(
        &RULE,
        span,
        format!("unknown argument `{name}` of `{file}`"),
    )
    .advised(help);
    if near.is_none() {
        // what a call passes in vain was written for another robot
        finding.group = Some(Group::Name(file.into()));
    }
    finding.severity = match near {
        _ if !certain => Severity::Info,
        Some(_) => Severity::Error,
        // the robot is the same without it
        None => Severity::Warning,
    };
    finding
}

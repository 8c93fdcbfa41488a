//! An argument that the robot reads and a launch file does not pass.
use std::path::Path;

use super::super::finding::{Finding, Related};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG012",
    name: "missing-launch-argument",
    category: Category::Package,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("missing-launch-argument"),
    check: Check::Analysis,
};

/// The finding about an argument that a robot reads at `used` and this call does not pass.
pub fn missing_launch_argument(call: Span, name: &str, file: &Path, used: Span) -> Finding {
    let file = file.file_name().unwrap_or_default().to_string_lossy();
    let mut finding = Finding::new(
        &RULE,
        call,
        format!("missing argument `{name}` of `{file}`"),
    );
    finding.help = Some(format!(
        "pass it in this call: `{name}:=...`; it has no default, and xacro fails"
    ));
    finding.related.push(Related {
        span: used,
        message: "used here".to_owned(),
        is_call: false,
    });
    finding
}

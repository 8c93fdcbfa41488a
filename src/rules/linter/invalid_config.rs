//! Something in the configuration that has no effect.
use super::super::finding::{Finding, Help};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::{FileId, Span};
use workspace::config::ConfigWarning;

pub(in super::super) static RULE: Rule = Rule {
    code: "LNT004",
    name: "invalid-config",
    category: Category::Linter,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("invalid-config"),
    check: Check::Analysis,
};

/// The finding about a warning of the configuration in `file`.
pub fn invalid_config(file: FileId, warning: &ConfigWarning) -> Finding {
    let span = Span {
        file,
        range: warning.place.range,
    };
    let help = match &warning.nearest {
        Some(near) => Help::did_you_mean(near),
        None => advice(&warning.message).into(),
    };
    Finding::new(&RULE, span, warning.message.clone()).advised(help)
}

/// What to do about a setting that resembles no valid one.
fn advice(message: &str) -> &'static str {
    if message.contains("is not a folder") || message.contains("no file matches") {
        "correct the path; paths are relative to the folder of the configuration file"
    } else if message.contains("unknown argument") {
        "remove it, or declare it with <xacro:arg> in a file of the root"
    } else if message.contains("unknown rule") {
        "run `xacro-lint rules` to list all rules"
    } else {
        "run `xacro-lint config --schema` to list all settings and their values"
    }
}

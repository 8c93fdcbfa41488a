//! A URI of a mesh or texture that cannot be resolved.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::shapes::resource_names;

pub(super) const RULE: Rule = Rule {
    code: "GEO021",
    name: "malformed-resource-uri",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page!("malformed-resource-uri"),
    check: Check::Document(check),
};

/// What is wrong with a URI, and how it was meant.
pub(super) struct UriDefect {
    message: &'static str,
    meant: Option<String>,
}

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for name in resource_names(cx).into_iter().filter(|name| name.known) {
        let Some(UriDefect { message, meant }) = defect(&name.value) else { continue };
        let report = out
            .report(name.origin, format!("`{}`: {message}", shortened(&name.value)))
            .help("URIs are written package://PACKAGE/PATH, with slashes and without spaces");
        match meant.filter(|_| name.literal) {
            Some(meant) => report.replace_with(Safety::Safe, format!("write `{meant}`"), meant).done(),
            None => report.done(),
        }
    }
}

/// What is wrong with a URI or path.
pub(super) fn defect(value: &str) -> Option<UriDefect> {
    let found = |message, meant| Some(UriDefect { message, meant });
    let slashed = value.replace('\\', "/");
    if let Some(rest) = slashed.strip_prefix("package:") {
        let path = rest.trim_start_matches('/');
        let slashes = rest.len() - path.len();
        let meant = path.contains('/').then(|| format!("package://{path}"));
        return match path.split_once('/') {
            _ if slashes == 2 && slashed != value => found("backslashes in a URI", meant),
            _ if slashes < 2 => found("two slashes belong behind `package:`", meant),
            // whether the first name is a package or a folder of it is not certain
            _ if slashes > 2 => found("the package name is missing behind `package://`", None),
            None | Some((_, "")) => found("a path is missing behind the package name", None),
            _ if has_space(value) => found("spaces in a URI", None),
            _ => None,
        };
    }
    match value {
        _ if slashed != value => {
            let drive = value.get(1..2) == Some(":") || value.starts_with("\\\\");
            found("backslashes in a path", (!drive).then_some(slashed))
        }
        _ if value.contains("://") && has_space(value) => found("spaces in a URI", None),
        _ if value.trim() != value => {
            found("spaces around a path", Some(value.trim().to_owned()).filter(|path| !path.is_empty()))
        }
        _ => None,
    }
}

fn has_space(value: &str) -> bool {
    value.contains(|c: char| c.is_ascii_whitespace())
}

fn shortened(value: &str) -> String {
    let mut short: String = value.chars().map(|c| if c.is_control() { ' ' } else { c }).take(80).collect();
    if value.chars().count() > 80 {
        short.push_str("...");
    }
    short
}

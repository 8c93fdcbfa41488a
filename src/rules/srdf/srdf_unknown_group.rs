//! A group in an SRDF that it does not define.
use super::super::beside::{BesideCx, unknown};
use super::super::context::is_whole;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use project::ProjectNameKind;

pub(in super::super) static RULE: Rule = Rule::semantic(
    "SRD004",
    "srdf-unknown-group",
    Category::Srdf,
    Severity::Error,
    page("srdf-unknown-group"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf().filter(|_| is_whole(cx.expansion)) else {
        return;
    };
    for (text, kind, is_given) in srdf.names() {
        let name = text
            .name()
            .filter(|_| kind == ProjectNameKind::Group && !is_given);
        let Some(name) = name.filter(|name| srdf.group(name).is_none()) else {
            continue;
        };
        unknown(
            cx,
            out,
            (text, kind),
            RULE.severity,
            format!("SRDF refers to unknown group `{name}`"),
        );
    }
}

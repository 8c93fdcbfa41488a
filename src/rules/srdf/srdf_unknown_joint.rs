//! A joint in an SRDF that the robot does not have.
use super::super::beside::{BesideCx, unknown};
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use project::ProjectNameKind;

pub(super) static RULE: Rule = Rule::beside(
    "SRD003",
    "srdf-unknown-joint",
    Category::Srdf,
    Severity::Error,
    page("srdf-unknown-joint"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf() else { return };
    for (text, kind, _) in srdf.names() {
        let Some(name) = text
            .name()
            .filter(|name| kind == ProjectNameKind::Joint && cx.lacks(kind, name))
        else {
            continue;
        };
        unknown(
            cx,
            out,
            (text, kind),
            RULE.severity,
            format!("SRDF refers to unknown joint `{name}`"),
        );
    }
}

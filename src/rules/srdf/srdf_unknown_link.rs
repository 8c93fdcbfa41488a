//! A link in an SRDF that the robot does not have.
use super::super::beside::{BesideCx, unknown};
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use project::Kind;

pub(in super::super) static RULE: Rule = Rule::beside(
    "SRD002",
    "srdf-unknown-link",
    Category::Srdf,
    Severity::Error,
    page("srdf-unknown-link"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf() else { return };
    for (text, kind, _) in srdf.names() {
        let Some(name) = text
            .name()
            .filter(|name| kind == Kind::Link && cx.lacks(kind, name))
        else {
            continue;
        };
        // MoveIt warns, and passes over the pair: one for another variant of the robot, unless the name is misspelled
        let pairs = srdf
            .disabled
            .iter()
            .flat_map(|pair| [&pair.link1, &pair.link2])
            .flatten();
        let is_of_pair = pairs.into_iter().any(|link| std::ptr::eq(link, text));
        let severity = match is_of_pair {
            true if cx.is_misspelled(kind, name) => Severity::Warning,
            true => Severity::Info,
            false => RULE.severity,
        };
        unknown(
            cx,
            out,
            (text, kind),
            severity,
            format!("SRDF refers to unknown link `{name}`"),
        );
    }
}

//! A link in an SRDF that the robot does not have.
use super::super::beside::{BesideCx, unknown};
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use model::AttrValue;
use project::ProjectNameKind;

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
    let of_pairs: Vec<&AttrValue> = srdf
        .disabled
        .iter()
        .flat_map(|pair| [&pair.link1, &pair.link2])
        .flatten()
        .collect();
    for (text, kind, _) in srdf.names() {
        let Some(name) = text
            .name()
            .filter(|name| kind == ProjectNameKind::Link && cx.lacks(kind, name))
        else {
            continue;
        };
        // MoveIt warns, and passes over the pair: the link was taken away, or is one of another variant of the robot
        let is_of_pair = of_pairs.iter().any(|link| std::ptr::eq(*link, text));
        let severity = match is_of_pair {
            false => RULE.severity,
            true if cx.is_misspelled(kind, name) => Severity::Warning,
            true => Severity::Info,
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

//! A link in an SRDF that the robot does not have.
use super::super::beside::{BesideCx, unknown};
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastSet;
use ecow::EcoString;
use model::AttrValue;
use project::ProjectNameKind;
use std::cell::OnceCell;

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
    let is_variant = OnceCell::new();
    for (text, kind, _) in srdf.names() {
        let Some(name) = text
            .name()
            .filter(|name| kind == ProjectNameKind::Link && cx.lacks(kind, name))
        else {
            continue;
        };
        // MoveIt warns, and passes over the pair: one for another variant of the robot, unless the name is misspelled
        let is_of_pair = of_pairs.iter().any(|link| std::ptr::eq(*link, text));
        let severity = if !is_of_pair {
            RULE.severity
        } else if !cx.is_misspelled(kind, name)
            && *is_variant.get_or_init(|| is_for_variants(cx, &of_pairs))
        {
            Severity::Info
        } else {
            Severity::Warning
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

/// Of the links in pairs, a part of a robot that another variant has is more than these; fewer were renamed or removed.
const MOST_RENAMED: usize = 2;

/// Whether the pairs are for several variants of the robot: they name many links that this one does not have.
fn is_for_variants(cx: &BesideCx<'_>, of_pairs: &[&AttrValue]) -> bool {
    let names: FastSet<&EcoString> = of_pairs.iter().filter_map(|text| text.name()).collect();
    let unknown = names
        .iter()
        .filter(|name| cx.lacks(ProjectNameKind::Link, name))
        .count();
    unknown > MOST_RENAMED || unknown * 2 > names.len()
}

//! Adjacent links whose collisions are not disabled, while those of others are.
use super::super::beside::BesideCx;
use super::super::context::is_whole;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::adjacent::touching;
use base::FastSet;
use model::tag_start;
use project::CollisionPair;

pub(super) static RULE: Rule = Rule::beside(
    "SRD012",
    "srdf-adjacent-pair-missing",
    Category::Srdf,
    Severity::Warning,
    page("srdf-adjacent-pair-missing"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf() else { return };
    let ([paired], true) = (
        cx.robots,
        srdf.default_disabled.is_empty() && !cx.has_variants && is_whole(cx.expansion),
    ) else {
        return;
    };
    let is_adjacent = |pair: &&CollisionPair| {
        pair.reason
            .as_ref()
            .is_some_and(|reason| reason.value == "Adjacent")
    };
    // where the pairs are not computed by the setup assistant, nothing says that all are there
    let Some(first) = srdf.disabled.iter().find(is_adjacent) else {
        return;
    };
    if srdf.disabled.iter().any(|pair| pair.links().is_none()) {
        return;
    }
    let disabled: FastSet<(&str, &str)> = srdf
        .disabled
        .iter()
        .filter_map(CollisionPair::links)
        .collect();
    for (joint, links) in touching(paired)
        .into_iter()
        .filter(|(_, links)| !disabled.contains(links))
    {
        let (one, two) = links;
        let message = format!("collisions between adjacent links `{one}` and `{two}` are checked");
        let help = format!(
            "add <disable_collisions link1=\"{one}\" link2=\"{two}\" reason=\"Adjacent\"/>"
        );
        let joint = joint
            .name
            .as_ref()
            .and_then(|name| paired.span(name.origin));
        let place = tag_start(cx.expansion, first.element);
        let place = srdf.name.as_ref().map_or(place, |name| name.origin);
        out.report(place, message)
            .help(help)
            .also_span(joint, "joint between them")
            .done();
    }
}

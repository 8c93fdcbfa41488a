//! A pair of links whose collisions are disabled twice.
use super::super::beside::BesideCx;
use super::super::grouping::Group;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use model::tag_start;
use project::CollisionPair;

pub(super) static RULE: Rule = Rule::semantic(
    "SRD010",
    "srdf-duplicate-pair",
    Category::Srdf,
    Severity::Info,
    page("srdf-duplicate-pair"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf() else { return };
    let mut first: FastMap<(&str, &str), &CollisionPair> = FastMap::default();
    for pair in &srdf.disabled {
        let Some(links) = pair.links() else { continue };
        let known = *first.entry(links).or_insert(pair);
        if std::ptr::eq(known, pair) {
            continue;
        }
        let message = format!(
            "collisions between `{}` and `{}` are disabled twice",
            links.0, links.1
        );
        let report = out
            .report(tag_start(cx.expansion, pair.element), message)
            .group(Group::File);
        let known = tag_start(cx.expansion, known.element);
        report
            .also(known, "first disabled here")
            .help("remove this element")
            .done();
    }
}

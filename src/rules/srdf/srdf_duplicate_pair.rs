//! A pair of links whose collisions are disabled twice.
use super::super::beside::BesideCx;
use super::super::grouping::Group;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use expand::FileIdx;
use model::tag_start;
use project::CollisionPair;

pub(super) static RULE: Rule = Rule::semantic(
    "SRD010",
    "srdf-duplicate-pair",
    Category::Srdf,
    Severity::Warning,
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
        // a full matrix has each pair both ways
        let [own_reason, known_reason] =
            [pair, known].map(|pair| pair.reason.as_ref().map(|reason| &reason.value));
        // nobody looks through the lists of a file that is included
        let is_same = own_reason == known_reason || file(cx, pair) != file(cx, known);
        let report = report.severity(if is_same {
            Severity::Info
        } else {
            RULE.severity
        });
        let known = tag_start(cx.expansion, known.element);
        report
            .also(known, "first disabled here")
            .help("remove this element")
            .done();
    }
}

/// The file that a pair stands in.
fn file(cx: &BesideCx<'_>, pair: &CollisionPair) -> Option<FileIdx> {
    let place = cx.expansion.place(tag_start(cx.expansion, pair.element));
    place.map(|place| place.file)
}

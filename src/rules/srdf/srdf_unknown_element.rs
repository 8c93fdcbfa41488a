//! An element that SRDF does not know, and that resembles one.
use super::super::beside::BesideCx;
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use super::super::schema::{ElementSpec, semantic_robot};
use super::super::sink::Sink;
use super::super::xml::{meant, tag_names};
use expand::XId;
use model::tag_start;

pub(super) static RULE: Rule = Rule::semantic(
    "SRD013",
    "srdf-unknown-element",
    Category::Srdf,
    Severity::Warning,
    page("srdf-unknown-element"),
    check,
)
.fixed(Safety::Safe);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    if let Some(srdf) = cx.srdf() {
        check_children(cx, srdf.element, semantic_robot(), out);
    }
}

fn check_children(cx: &BesideCx<'_>, parent: XId, spec: &ElementSpec, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for id in tree.elements(parent) {
        let name = tree.get(id).text.as_str();
        if let Some(known) = spec.child(name) {
            check_children(cx, id, known, out);
            continue;
        }
        // other names are for other programs
        let near = meant(name, spec.children().map(|child| child.name));
        let Some((near, is_sure)) = near.filter(|_| !name.contains(':')) else {
            continue;
        };
        let report = out
            .report(
                tag_start(cx.expansion, id),
                format!("unknown element `{name}` in SRDF"),
            )
            .group(Group::Name(name.into()))
            .help(Help::did_you_mean(near).and(&format!("MoveIt silently ignores `{name}`")));
        let safety = if is_sure {
            Safety::Safe
        } else {
            Safety::Unsafe
        };
        match tag_names(cx.expansion, id) {
            Some((file, ranges)) => {
                let edits = ranges.into_iter().map(|range| (range, near.to_owned()));
                report
                    .fix(safety, format!("rename to `{near}`"), file, edits)
                    .done();
            }
            None => report.done(),
        }
    }
}

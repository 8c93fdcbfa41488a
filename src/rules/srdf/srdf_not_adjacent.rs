//! A pair of links with the reason `Adjacent` that are not adjacent.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::adjacent::are_adjacent;

pub(super) static RULE: Rule = Rule::beside(
    "SRD011",
    "srdf-not-adjacent",
    Category::Srdf,
    // MoveIt does not read the reason
    Severity::Info,
    page("srdf-not-adjacent"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf() else { return };
    for pair in &srdf.disabled {
        let Some(reason) = pair
            .reason
            .as_ref()
            .filter(|reason| reason.value == "Adjacent")
        else {
            continue;
        };
        let Some((one, two)) = pair.links() else {
            continue;
        };
        if cx
            .robots
            .iter()
            .any(|paired| are_adjacent(paired, one, two) != Some(false))
        {
            continue;
        }
        let message = format!("links `{one}` and `{two}` are not adjacent");
        let help = "check whether they can collide: remove the element, or write `Never` or `User` as reason";
        out.report(reason.origin, message).help(help).done();
    }
}

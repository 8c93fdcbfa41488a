//! A group state that sets a joint of another group.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::joints::Members;

pub(super) static RULE: Rule = Rule::beside(
    "SRD007",
    "srdf-state-joint-not-in-group",
    Category::Srdf,
    Severity::Warning,
    page("srdf-state-joint-not-in-group"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf() else { return };
    let mut members = Members::new(cx, srdf);
    for state in &srdf.states {
        let Some(group) = state.group.as_ref().and_then(|group| group.name()) else {
            continue;
        };
        let Some(joints) = members.of(group) else {
            continue;
        };
        for (joint, _) in &state.joints {
            let name = joint.name().filter(|name| !joints.contains(name.as_str()));
            let Some(name) = name.filter(|name| cx.joints(name).next().is_some()) else {
                continue;
            };
            let message = format!("joint `{name}` is not in group `{group}`");
            let help = format!("remove it, or add it to group `{group}`; MoveIt ignores it");
            out.report(joint.origin, message).help(help).done();
        }
    }
}

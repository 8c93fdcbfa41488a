//! A group state that says nothing of some joints of its group.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::joints::{Members, is_planned};
use model::{AttrValue, tag_start};
use project::ProjectNameKind;

pub(super) static RULE: Rule = Rule::beside(
    "SRD008",
    "srdf-incomplete-group-state",
    Category::Srdf,
    Severity::Warning,
    page("srdf-incomplete-group-state"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf() else { return };
    let mut members = Members::new(cx, srdf);
    for state in &srdf.states {
        let Some(group) = state.group.as_ref().and_then(AttrValue::name) else {
            continue;
        };
        // an unknown joint most likely is the one that is missing
        let is_known = state.joints.iter().all(|(joint, _)| {
            joint
                .name()
                .is_some_and(|name| !cx.lacks(ProjectNameKind::Joint, name))
        });
        let Some(joints) = members.of(group).filter(|_| is_known) else {
            continue;
        };
        let mut missing: Vec<&str> = joints
            .iter()
            .copied()
            .filter(|name| !state.joints.iter().any(|(joint, _)| joint.value == *name))
            .collect();
        missing.retain(|name| is_planned(cx, srdf, name));
        missing.sort_unstable();
        let Some(first) = missing.first() else {
            continue;
        };
        let shown = state.name.as_ref().map_or("", |name| name.value.as_str());
        let message =
            format!("group state `{shown}` has no value for joint `{first}` of group `{group}`");
        let message = match missing.len() {
            1 => message,
            count => format!("{message} and {} more", count - 1),
        };
        let place = state
            .name
            .as_ref()
            .map_or(tag_start(cx.expansion, state.element), |name| name.origin);
        let help = format!("add <joint name=\"{first}\" value=\"0\"/>");
        out.report(place, message).help(help).done();
    }
}

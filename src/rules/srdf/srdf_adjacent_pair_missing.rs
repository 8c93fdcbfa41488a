//! Adjacent links whose collisions are not disabled, while those of others are.
use std::cell::LazyCell;

use super::super::beside::{BesideCx, PairedRobot};
use super::super::context::is_whole;
use super::super::geometry::shapes_of;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::adjacent::{are_apart, touching};
use super::joints::Members;
use base::FastSet;
use model::{JointType, tag_start};
use project::{CollisionPair, Srdf};

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
    let planned = planned_joints(cx, srdf);
    let shapes = LazyCell::new(|| shapes_of(paired.expansion, paired.robot, cx.world));
    for (joint, links) in touching(paired)
        .into_iter()
        .filter(|(_, links)| !disabled.contains(links))
    {
        let (one, two) = links;
        let is_planned = planned.as_ref().is_none_or(|planned| {
            [one, two]
                .into_iter()
                .any(|link| is_moved(paired, link, planned))
        });
        let severity = if is_planned && !are_apart(&shapes, paired, joint) {
            RULE.severity
        } else {
            Severity::Info
        };
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
            .severity(severity)
            .help(help)
            .also_span(joint, "joint between them")
            .done();
    }
}

/// The joints of all groups; none when there are no groups, or not all joints of them are known.
fn planned_joints<'a>(cx: &BesideCx<'a>, srdf: &'a Srdf) -> Option<FastSet<&'a str>> {
    let mut members = Members::new(cx, srdf);
    let mut planned = FastSet::default();
    for group in &srdf.groups {
        planned.extend(members.of(group.name.as_ref()?.name()?)?.iter().copied());
    }
    (!srdf.groups.is_empty()).then_some(planned)
}

/// Whether a link moves when one of these joints does. Of two links that no group moves, MoveIt checks no collisions: a request
/// is for a group, and only pairs with a link of it are tested.
/// Source: `PlanningScene::checkCollision` and `JointModelGroup::getUpdatedLinkModelsSet` of moveit_core.
fn is_moved(paired: &PairedRobot<'_>, link: &str, joints: &FastSet<&str>) -> bool {
    let kinematics = paired.kinematics;
    let Some(link) = kinematics.link(link) else {
        return true;
    };
    let mut above = kinematics
        .ancestor_joints(link)
        .filter_map(|joint| paired.robot.joints.get(joint));
    above.any(|joint| {
        let name = joint.name.as_ref().map(|name| name.value.as_str());
        !joint.is(&[JointType::Fixed]) && name.is_some_and(|name| joints.contains(name))
    })
}

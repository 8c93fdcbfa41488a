//! A link in no joint.
use std::cell::OnceCell;

use ecow::EcoString;

use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::missing_links::{joined_elsewhere, lost_links, missing_ends};
use base::FastSet;
use model::{AttrValue, Link};

pub(in super::super) static RULE: Rule = Rule {
    code: "STR008",
    name: "orphan-link",
    category: Category::Structure,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("orphan-link"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let kinematics = cx.kinematics;
    let is_alone = |&(number, _): &(usize, &Link)| {
        kinematics.parent_joints(number).is_empty() && kinematics.child_joints(number).is_empty()
    };
    let links = || cx.robot.links.iter().enumerate().filter(is_alone);
    if cx.robot.links.len() < 2 || links().next().is_none() {
        return;
    }
    let ends = cx
        .robot
        .joints
        .iter()
        .flat_map(|joint| [&joint.parent, &joint.child]);
    let joined: FastSet<&EcoString> = ends.flatten().map(|end| &end.value).collect();
    let lost = lost_links(cx);
    let misplaced = ends_of_misplaced_joints(cx);
    let mut seen: FastSet<&EcoString> = FastSet::default();
    let names = links().filter_map(|(_, link)| link.name.as_ref());
    let named = names.filter_map(|name| Some((name, name.name()?)));
    let orphans: Vec<_> = named
        .filter(|(_, text)| {
            // spaces in a name have their own finding
            let is_joined = joined.contains(text) || joined.contains(&EcoString::from(text.trim()));
            !is_joined && !lost.contains(*text) && !misplaced.contains(*text) && seen.insert(text)
        })
        .collect();
    // each joint without a parent or a child leaves a link over, and has its own finding
    if orphans.len() <= missing_ends(cx.robot) {
        return;
    }
    // by a joint below a condition that does not hold, or in a macro that nothing calls; read when it is asked for
    let elsewhere = OnceCell::new();
    for (name, text) in orphans {
        let elsewhere = elsewhere.get_or_init(|| joined_elsewhere(cx, &["parent", "child"]));
        out.report(
            name.origin,
            format!("link `{text}` is not connected to any joint"),
        )
        .severity(if elsewhere.contains(text) {
            Severity::Info
        } else {
            RULE.severity
        })
        .help(format!("add a joint whose child is `{text}`"))
        .done();
    }
}

/// The links that joints inside of links connect: what is wrong is said at these joints.
fn ends_of_misplaced_joints(cx: &RobotCx<'_>) -> FastSet<EcoString> {
    let tree = &cx.expansion.tree;
    let joints = cx
        .robot
        .links
        .iter()
        .flat_map(|link| tree.elements(link.element));
    let ends = joints
        .filter(|&id| tree.get(id).text == "joint")
        .flat_map(|joint| tree.elements(joint));
    let links = ends.filter(|&end| matches!(tree.get(end).text.as_str(), "parent" | "child"));
    links
        .filter_map(|end| Some(AttrValue::attr(tree, end, "link")?.name()?.clone()))
        .collect()
}

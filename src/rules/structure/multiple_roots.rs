//! Several links that nothing holds.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::missing_links::{incomplete_joints, joined_elsewhere, lost_links};
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "STR007",
    name: "multiple-roots",
    category: Category::Structure,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("multiple-roots"),
    check: Check::Whole(check),
};

/// Links that are the root of a robot by convention, the usual one first.
const USUAL_ROOTS: [&str; 3] = ["world", "base_footprint", "base_link"];

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    // the other end of a joint from a link to itself is the root that is too many
    if cx.robot.naming().has_loop {
        return;
    }
    let lost = lost_links(cx);
    let mut roots: Vec<&AttrValue> = Vec::new();
    for root in cx.kinematics.roots(cx.robot) {
        let name = cx.robot.links.get(root).and_then(|link| link.name.as_ref());
        roots.extend(name.filter(|name| {
            !cx.kinematics.child_joints(root).is_empty()
                && !lost.contains(&name.value)
                && !is_end_of_reversed_joint(cx, root)
        }));
    }
    let usual = USUAL_ROOTS
        .iter()
        .find_map(|usual| roots.iter().position(|root| root.value == *usual));
    // each joint without a parent gives a root, and has its own finding
    if roots.len() < 2 || roots.len() <= 1 + incomplete_joints(cx.robot) {
        return;
    }
    let first = roots.remove(usual.unwrap_or(0));
    let elsewhere = joined_elsewhere(cx, &["child"]);
    for root in roots {
        out.report(
            root.origin,
            format!(
                "more than one root link: `{}` and `{}`",
                root.value, first.value
            ),
        )
        .severity(if elsewhere.contains(&root.value) {
            Severity::Info
        } else {
            RULE.severity
        })
        .also(first.origin, "first root link")
        .help(format!("add a joint whose child is `{}`", root.value))
        .done();
    }
}

/// Whether the child of a joint of a root has another parent already: the joint looks reversed, which `multiple-parents` reports.
fn is_end_of_reversed_joint(cx: &RobotCx<'_>, root: usize) -> bool {
    let children = cx
        .kinematics
        .child_joints(root)
        .iter()
        .filter_map(|&joint| Some(cx.kinematics.ends(joint)?.1));
    children
        .into_iter()
        .any(|child| cx.kinematics.parent_joints(child).len() > 1)
}

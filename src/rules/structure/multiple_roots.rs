//! Several links that nothing holds.

use super::super::context::RobotCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::missing_links::{is_joined_elsewhere, lost_links};
use model::Text;

pub(super) const RULE: Rule = Rule {
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
    let lost = lost_links(cx);
    let mut roots: Vec<&Text> = Vec::new();
    for root in cx.kinematics.roots(cx.robot) {
        let name = cx.robot.links.get(root).and_then(|link| link.name.as_ref());
        roots.extend(name.filter(|name| !cx.kinematics.down(root).is_empty() && !lost.contains(&name.value)));
    }
    let usual = USUAL_ROOTS.iter().find_map(|usual| roots.iter().position(|root| root.value == *usual));
    if roots.len() < 2 {
        return;
    }
    let first = roots.remove(usual.unwrap_or(0));
    for root in roots {
        let has_branch = is_joined_elsewhere(cx, &root.value, &["child"]);
        out.report(root.origin, format!("link `{}` is a second root beside `{}`", root.value, first.value))
            .severity(if has_branch { Severity::Info } else { RULE.severity })
            .also(first.origin, "the first root")
            .help(format!("join it to the rest: a joint with child `{}`", root.value))
            .done();
    }
}

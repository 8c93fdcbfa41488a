//! A link in no joint.

use ecow::EcoString;

use super::super::context::RobotCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::missing_links::{is_joined_elsewhere, lost_links};
use base::FastSet;

pub(super) const RULE: Rule = Rule {
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
    if cx.robot.links.len() < 2 {
        return;
    }
    let ends = cx.robot.joints.iter().flat_map(|joint| [&joint.parent, &joint.child]);
    let joined: FastSet<&EcoString> = ends.flatten().map(|end| &end.value).collect();
    let lost = lost_links(cx);
    let mut said: FastSet<&EcoString> = FastSet::default();
    for name in cx.robot.links.iter().filter_map(|link| link.name.as_ref()) {
        let Some(text) = name.name() else { continue };
        if !joined.contains(text) && !lost.contains(text) && said.insert(text) {
            // a joint below a condition that does not hold, or in a macro that nothing calls
            let has_branch = is_joined_elsewhere(cx, text, &["parent", "child"]);
            out.report(name.origin, format!("link `{text}` is in no joint"))
                .severity(if has_branch { Severity::Info } else { RULE.severity })
                .help(format!("join it to the rest: a joint with child `{text}`"))
                .done();
        }
    }
}

//! A gazebo element about nothing.

use super::super::context::RobotCx;
use super::super::edits::rename;
use super::super::grouping::Group;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use base::FastSet;
use facts::{Fact, FactKind, facts};
use model::Gazebo;
use workspace::nearest;

pub(super) const RULE: Rule = Rule {
    code: "CTL014",
    name: "gazebo-unknown-reference",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("gazebo-unknown-reference"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let joints: FastSet<&str> = cx.robot.joints.iter().map(|joint| joint.shown()).collect();
    for block in &cx.robot.gazebo {
        let Some(text) = &block.reference else { continue };
        let Some(name) = text.name() else { continue };
        if cx.kinematics.link(name).is_some() || joints.contains(name.as_str()) {
            continue;
        }
        let links = cx.robot.links.iter().map(|link| link.shown());
        let names = links.chain(cx.robot.joints.iter().map(|joint| joint.shown()));
        let report = out
            .report(text.origin, format!("no link or joint is named `{name}`"))
            .group(Group::Name(name.clone()));
        match nearest(name, names) {
            Some(near) => {
                let report =
                    report.help(format!("SDFormat drops the element; a similar name exists: `{near}`"));
                rename(report, cx.expansion, text, near).done();
            }
            None => report
                .severity(if is_colour(cx, block) || is_written(cx, name) {
                    Severity::Info
                } else {
                    Severity::Warning
                })
                .help("SDFormat drops the element: name a link or a joint of this robot")
                .done(),
        }
    }
}

/// Whether a text that the robot is made of names a link or joint so, in a branch that is not taken this time.
fn is_written(cx: &RobotCx<'_>, name: &str) -> bool {
    let is_it = |fact: &Fact| matches!(fact.kind, FactKind::Link | FactKind::Joint) && fact.name == name;
    let mut files = cx.expansion.files.iter();
    files.any(|file| facts(&file.source.document).any(|(_, facts)| facts.named.iter().any(is_it)))
}

/// Whether an element gives a colour and nothing else: without it, nothing behaves differently.
fn is_colour(cx: &RobotCx<'_>, block: &Gazebo) -> bool {
    let tree = &cx.expansion.tree;
    tree.elements(block.element).all(|child| tree.get(child).text == "material")
}

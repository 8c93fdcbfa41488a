//! An element that ros2_control does not know.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::tag_start;

pub(super) const RULE: Rule = Rule {
    code: "CTL019",
    name: "ros2-control-unknown-tag",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-unknown-tag"),
    check: Check::Document(check),
};

/// The elements that ros2_control reads; `properties` only in its later versions.
const KNOWN: [&str; 6] = ["hardware", "joint", "sensor", "gpio", "transmission", "properties"];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for control in cx.robot.into_iter().flat_map(|robot| &robot.controls) {
        for id in tree.elements(control.element) {
            let name = tree.get(id).text.as_str();
            // tags of xacro that stayed have their own finding
            if !KNOWN.contains(&name) && !name.contains(':') {
                out.report(
                    tag_start(cx.expansion, id),
                    format!("<{name}> is nothing that ros2_control knows"),
                )
                .help("inside of <ros2_control>, write hardware, joint, sensor, gpio or transmission")
                .done();
            }
        }
    }
}

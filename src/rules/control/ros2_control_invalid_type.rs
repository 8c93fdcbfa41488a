//! A ros2_control of an unknown type.
use super::super::context::DocumentCx;
use super::super::finding::Help;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::is_simulator_plugin;
use model::{AttrValue, Ros2Control, tag_start};
use packages::nearest;

pub(super) static RULE: Rule = Rule {
    code: "CTL005",
    name: "ros2-control-invalid-type",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-invalid-type"),
    check: Check::Document(check),
};

/// The types that ros2_control knows.
const KNOWN: [&str; 3] = ["system", "actuator", "sensor"];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for control in cx.robot.into_iter().flat_map(|robot| &robot.controls) {
        let name = control.name.as_ref().map_or("", |name| name.value.as_str());
        let Some(kind) = &control.kind else {
            out.report(
                tag_start(cx.expansion, control.element),
                format!("ros2_control `{name}` has no `type`"),
            )
            .help("write type=\"system\", type=\"actuator\" or type=\"sensor\"")
            .done();
            continue;
        };
        if kind.is_known() && !KNOWN.contains(&kind.value.as_str()) {
            let near = nearest(&kind.value, KNOWN).map(Help::did_you_mean);
            let is_known = KNOWN.contains(&kind.value.to_lowercase().as_str());
            let severity = if is_known && is_simulated(cx, control) {
                Severity::Info
            } else {
                RULE.severity
            };
            out.report(
                kind.origin,
                format!("ros2_control `{name}` has unknown type `{}`", kind.value),
            )
            .severity(severity)
            .help(near.unwrap_or_else(|| {
                "write type=\"system\", type=\"actuator\" or type=\"sensor\"".into()
            }))
            .done();
        }
    }
}

/// Whether a simulator is the hardware: those for Gazebo never look at the type, but the same block on a robot fails.
/// Source: `gz_system.cpp` and `gz_ros2_control_plugin.cpp` of gz_ros2_control 1.2.
fn is_simulated(cx: &DocumentCx<'_>, control: &Ros2Control) -> bool {
    let tree = &cx.expansion.tree;
    let plugin = control
        .plugin(tree)
        .and_then(|element| AttrValue::content(tree, element));
    plugin.is_some_and(|plugin| is_simulator_plugin(&plugin.value))
}

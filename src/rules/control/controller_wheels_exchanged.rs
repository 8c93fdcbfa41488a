//! A controller of a drive whose wheels are on the wrong sides.
use super::super::beside::{BesideCx, PairedRobot};
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::is_simulator_plugin;
use super::controller_unknown_interface::class_of;
use super::controller_wheel_mismatch::{CLASS, first_joint, wheels};
use base::Span;
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule::beside(
    "CTL038",
    "controller-wheels-exchanged",
    Category::Control,
    Severity::Warning,
    page("controller-wheels-exchanged"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    for controller in cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.controllers)
        .filter(|controller| class_of(cx, controller) == Some(CLASS))
    {
        // where the file is for several robots, one of them may fit
        let pairs = wheels(cx, controller);
        let found: Option<Vec<_>> = pairs.iter().map(|pair| pair.exchanged()).collect();
        let found = found.and_then(|found| found.into_iter().next());
        let (Some((message, help)), Some(joint)) = (found, first_joint(controller)) else {
            continue;
        };
        let span = Span {
            file: cx.file,
            range: joint.range,
        };
        // motors turn the wheels of a real robot, wherever its description has them
        let is_simulated = cx.robots.iter().any(simulates);
        out.report_span(span, message)
            .severity(if is_simulated {
                RULE.severity
            } else {
                Severity::Info
            })
            .help(help)
            .done();
    }
}

/// Whether a robot has the hardware of a simulator.
fn simulates(paired: &PairedRobot<'_>) -> bool {
    let tree = &paired.expansion.tree;
    let controls = paired.robot.controls.iter();
    let mut plugins =
        controls.filter_map(|control| AttrValue::content(tree, control.plugin(tree)?));
    plugins.any(|plugin| is_simulator_plugin(&plugin.value))
}

//! Links that hang on each other in a circle.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;

pub(in super::super) static RULE: Rule = Rule {
    code: "STR005",
    name: "link-cycle",
    category: Category::Structure,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("link-cycle"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    for cycle in &cx.robot.naming().cycles {
        let Some(&last) = cycle.iter().max() else {
            continue;
        };
        let joint = |joint: &usize| cx.robot.joints.get(*joint);
        let names: Vec<&str> = cycle
            .iter()
            .filter_map(joint)
            .filter_map(|j| Some(j.ends()?.0.as_str()))
            .collect();
        let Some(child) = joint(&last).and_then(|joint| joint.child.as_ref()) else {
            continue;
        };
        let message = format!("kinematic loop: `{}`", names.join("` -> `"));
        let mut report = out.report(child.origin, message);
        for other in cycle.iter().filter(|&&i| i != last).filter_map(joint) {
            if let Some(child) = &other.child {
                report = report.also(
                    child.origin,
                    format!("joint `{}` is part of the loop", other.shown()),
                );
            }
        }
        report
            .help("swap parent and child of one joint, or correct the link it refers to")
            .done();
    }
}

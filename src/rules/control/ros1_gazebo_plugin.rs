//! A plugin of Gazebo that ROS 2 does not have.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::gazebo_ros::{is_for_several, plugins_for_ros2, successor};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL030",
    name: "ros1-gazebo-plugin",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros1-gazebo-plugin"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let severity = || {
        if is_for_several(cx) {
            Severity::Info
        } else {
            RULE.severity
        }
    };
    for (_, library) in plugins_for_ros2(cx) {
        if let Some(new) = successor(&library.value) {
            let message = format!("ROS 2 has no plugin `{}`", library.value);
            out.report(library.origin, message)
                .severity(severity())
                .help(format!("use `{new}`, which has other parameters"))
                .done();
        }
    }
}

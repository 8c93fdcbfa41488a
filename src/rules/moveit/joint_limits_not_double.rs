//! A limit that is written as an integer.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use base::Span;

pub(super) static RULE: Rule = Rule::beside(
    "MOV003",
    "joint-limits-not-double",
    Category::Moveit,
    Severity::Error,
    page("joint-limits-not-double"),
    check,
);

/// The limits that MoveIt 2 declares as doubles, with the switch that makes it read each.
/// Source: `JointLimits` of `moveit_ros_planning`.
const DOUBLES: [(&str, &str); 6] = [
    ("max_velocity", "has_velocity_limits"),
    ("max_acceleration", "has_acceleration_limits"),
    ("max_jerk", "has_jerk_limits"),
    ("max_position", "has_position_limits"),
    ("min_position", "has_position_limits"),
    ("max_effort", "has_effort_limits"),
];

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    if !cx.is_ros2 {
        return;
    }
    // of a joint that the robot does not have, nothing is read
    let limits = cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.limits);
    for limit in limits.filter(|limit| cx.joints(&limit.joint.name).next().is_some()) {
        for (key, value, is_integer, range) in &limit.values {
            let read = DOUBLES
                .iter()
                .any(|(name, switch)| *name == key.name && limit.has(switch));
            if !is_integer || !read {
                continue;
            }
            let message = format!(
                "`{}` of joint `{}` is not a double",
                key.name, limit.joint.name
            );
            let report = out.report_span(
                Span {
                    file: cx.file,
                    range: *range,
                },
                message,
            );
            let help = format!("write `{value:.1}`; MoveIt 2 stops at a parameter of another type");
            report.help(help).done();
        }
    }
}

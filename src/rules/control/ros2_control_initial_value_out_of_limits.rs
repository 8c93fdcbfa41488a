//! An initial position that the joint cannot have.
use super::super::context::DocumentCx;
use super::super::numbers::short;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joints::{controlled, range, value_place};
use base::FastSet;
use model::AttrValue;

pub(super) static RULE: Rule = Rule {
    code: "CTL009",
    name: "ros2-control-initial-value-out-of-limits",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-initial-value-out-of-limits"),
    check: Check::Document(check),
};

/// What calculation may lose.
const ROUNDING: f64 = 1e-6;

/// What nobody sees.
const NOTHING: f64 = 1e-3;

/// Parts of the names of hardware that starts where the description says: mocks, simulators and bridges to them. Hardware of a real
/// robot starts where the robot is.
const READERS: [&str; 10] = [
    "mock",
    "fake",
    "sim",
    "gz",
    "gazebo",
    "ign_",
    "mujoco",
    "isaac",
    "webots",
    "topic_based",
];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let real = joints_of_real_hardware(cx);
    for (control, joint) in controlled(cx) {
        let Some((lower, upper)) = range(joint) else {
            continue;
        };
        for interface in control
            .interfaces()
            .filter(|interface| interface.is("position"))
        {
            let Some(text) = interface.param("initial_value") else {
                continue;
            };
            let beyond = text
                .number()
                .map(|value| (lower - value).max(value - upper));
            if let Some(beyond) = beyond.filter(|&beyond| beyond > ROUNDING) {
                let is_real = control
                    .name
                    .as_ref()
                    .is_some_and(|name| real.contains(name.value.as_str()));
                let is_limit = [lower, upper].iter().any(|&end| is_rounded(text, end));
                let severity = if is_real || beyond <= NOTHING || is_limit {
                    Severity::Info
                } else {
                    RULE.severity
                };
                let message = format!(
                    "initial value of joint `{}` is {}, outside its limits",
                    joint.shown(),
                    text.value
                );
                out.report(value_place(cx.expansion, text), message)
                    .severity(severity)
                    .help(format!(
                        "write a value from {} to {}",
                        short(lower),
                        short(upper)
                    ))
                    .done();
            }
        }
    }
}

/// Whether a number is another one, written with fewer digits.
fn is_rounded(text: &AttrValue, exact: f64) -> bool {
    let written = text.value.trim();
    let digits = written.split_once('.').map(|(_, digits)| digits.len());
    let rounded = digits.map(|digits| format!("{exact:.digits$}"));
    rounded.is_some_and(|rounded| rounded == written)
}

/// The joints of hardware whose plugin is none of those that read initial values.
fn joints_of_real_hardware<'a>(cx: &DocumentCx<'a>) -> FastSet<&'a str> {
    let tree = &cx.expansion.tree;
    let controls = cx.robot.into_iter().flat_map(|robot| &robot.controls);
    let real = controls.filter(|control| {
        let class = control
            .plugin(tree)
            .and_then(|plugin| AttrValue::content(tree, plugin));
        class.is_some_and(|class| is_real(&class))
    });
    real.flat_map(|control| &control.joints)
        .filter_map(|joint| Some(joint.name.as_ref()?.value.as_str()))
        .collect()
}

/// Whether a plugin is none of those that read initial values.
fn is_real(class: &AttrValue) -> bool {
    let name = class.value.to_ascii_lowercase();
    class.is_known() && !READERS.iter().any(|part| name.contains(part))
}

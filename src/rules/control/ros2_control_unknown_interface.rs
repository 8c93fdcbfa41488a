//! An interface whose name looks misspelled.
use super::super::context::DocumentCx;
use super::super::finding::Help;
use super::super::numbers::rewrite;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use packages::{misspelled, nearest};

pub(super) static RULE: Rule = Rule {
    code: "CTL003",
    name: "ros2-control-unknown-interface",
    category: Category::Control,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("ros2-control-unknown-interface"),
    check: Check::Document(check),
};

/// The interfaces that controllers know by name.
/// The interfaces of joints.
pub(super) const KNOWN: [&str; 4] = ["position", "velocity", "acceleration", "effort"];

/// Whether a name is most likely meant for one of these.
pub(super) fn is_misspelled(name: &str) -> bool {
    !KNOWN.contains(&name) && misspelled(name, KNOWN).is_some()
}

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let joints = cx
        .robot
        .into_iter()
        .flat_map(|robot| &robot.controls)
        .flat_map(|control| &control.joints);
    for (joint, interface) in
        joints.flat_map(|joint| joint.interfaces().map(move |interface| (joint, interface)))
    {
        let Some((text, name)) = interface
            .name
            .as_ref()
            .and_then(|text| Some((text, text.name()?)))
        else {
            continue;
        };
        if KNOWN.contains(&name.as_str()) {
            continue;
        }
        if let Some(near) = nearest(name, KNOWN) {
            let message = format!("joint `{}` has unknown interface `{name}`", joint.shown());
            let severity = if misspelled(name, KNOWN).is_some() {
                Severity::Warning
            } else {
                RULE.severity
            };
            let report = out
                .report(text.origin, message)
                .severity(severity)
                .help(Help::did_you_mean(near));
            rewrite(report, Safety::Unsafe, text, near.to_owned()).done();
        }
    }
}

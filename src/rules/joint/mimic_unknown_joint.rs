//! A joint that follows one which does not exist.
use std::cell::LazyCell;

use super::super::context::RobotCx;
use super::super::edits::rename;
use super::super::finding::Help;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use base::FastSet;
use packages::Suggestions;

pub(super) static RULE: Rule = Rule {
    code: "JNT021",
    name: "mimic-unknown-joint",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("mimic-unknown-joint"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let joints = || cx.robot.joints.iter().map(|joint| joint.shown());
    let known: LazyCell<FastSet<&str>, _> = LazyCell::new(|| joints().collect());
    let mut suggestions = Suggestions::default();
    for joint in &cx.robot.joints {
        let Some(text) = joint.mimic.as_ref().and_then(|mimic| mimic.joint.as_ref()) else {
            continue;
        };
        let Some(target) = text.name().filter(|name| !known.contains(name.as_str())) else {
            continue;
        };
        let message = format!("joint `{}` mimics unknown joint `{target}`", joint.shown());
        let report = out.report(text.origin, message);
        let names = cx
            .robot
            .joints
            .iter()
            .map(|joint| joint.shown())
            .filter(|name| *name != joint.shown());
        match suggestions.nearest(target, names) {
            Some(near) => {
                let report = report.help(Help::did_you_mean(near));
                rename(report, cx.expansion, text, near).done();
            }
            None => report.help("use the name of a joint of this robot").done(),
        }
    }
}

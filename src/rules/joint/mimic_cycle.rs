//! Joints that mimic each other in a circle.

use super::super::context::RobotCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::mimics::targets;
use crate::base::FastSet;

pub(super) const RULE: Rule = Rule {
    code: "JNT022",
    name: "mimic-cycle",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page!("mimic-cycle"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let targets = targets(cx.robot);
    let mut said: FastSet<usize> = FastSet::default();
    for start in 0..cx.robot.joints.len() {
        let next = |&joint: &usize| targets.get(joint).copied().flatten();
        let way: Vec<usize> = std::iter::successors(next(&start), next).take(targets.len()).collect();
        let Some(end) = way.iter().position(|&joint| joint == start) else { continue };
        let circle = way.get(..=end).unwrap_or_default();
        if circle.iter().any(|&joint| !said.insert(joint)) {
            continue;
        }
        let Some(&last) = circle.iter().max() else { continue };
        let joint = |i: usize| cx.robot.joints.get(i);
        let value = |i: usize| joint(i)?.mimic.as_ref()?.joint.as_ref();
        let (Some(at), Some(own)) = (value(last), joint(last)) else { continue };
        let message = match circle.len() {
            1 => format!("joint `{}` mimics itself", own.shown()),
            _ => format!("joint `{}` mimics `{}`, which in the end mimics it", own.shown(), at.value),
        };
        let mut report = out.report(at.origin, message).help("one joint of a circle has to move by itself");
        for &other in circle.iter().filter(|&&other| other != last) {
            if let (Some(at), Some(other)) = (value(other), joint(other)) {
                report = report.also(at.origin, format!("joint `{}` mimics `{}`", other.shown(), at.value));
            }
        }
        report.done();
    }
}

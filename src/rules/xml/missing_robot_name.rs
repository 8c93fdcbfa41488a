//! A robot without name.

use super::super::context::{DocumentCx, RootKind};
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use crate::model::tag_start;

pub(super) const RULE: Rule = Rule {
    code: "XML014",
    name: "missing-robot-name",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page!("missing-robot-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot.filter(|_| cx.kind == RootKind::Robot) else { return };
    let message = match &robot.name {
        None => "the robot has no name",
        Some(name) if name.known && name.value.is_empty() => "the name of the robot is empty",
        Some(_) => return,
    };
    out.report(tag_start(cx.expansion, robot.element), message)
        .help("urdfdom refuses a robot without name: add name=\"...\"")
        .done();
}

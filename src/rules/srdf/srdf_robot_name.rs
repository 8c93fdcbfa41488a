//! An SRDF that is for a robot of another name.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;

pub(in super::super) static RULE: Rule = Rule::beside(
    "SRD001",
    "srdf-robot-name",
    Category::Srdf,
    Severity::Warning,
    page("srdf-robot-name"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(name) = cx.srdf().and_then(|srdf| srdf.name.as_ref()) else {
        return;
    };
    let mut names = cx
        .robots
        .iter()
        .map(|paired| paired.robot.name.as_ref().and_then(|name| name.name()));
    let (Some(own), Some(Some(first))) = (name.name(), names.next()) else {
        return;
    };
    if own == first || names.any(|other| other.is_none_or(|other| other == own)) {
        return;
    }
    let message = format!("SRDF is for robot `{own}`, but the robot is named `{first}`");
    let help = format!("write `{first}`; MoveIt expects the name of the URDF");
    out.report(name.origin, message).help(help).done();
}

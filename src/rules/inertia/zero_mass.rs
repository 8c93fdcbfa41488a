//! A mass of zero.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joined::{body_inertia, is_joined};
use super::moments::{InertiaClass, judged};
use model::{Link, Robot, element_range};

pub(in super::super) static RULE: Rule = Rule {
    code: "INR002",
    name: "zero-mass",
    category: Category::Inertia,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("zero-mass"),
    check: Check::Link(check),
};

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    let Some(text) = inertial
        .mass
        .as_ref()
        .filter(|text| text.number() == Some(0.0))
    else {
        return;
    };
    // a frame that says that it weighs nothing is harmless, as is an object that simulators take for static
    let no_inertia = judged(inertial)
        .class
        .is_none_or(|class| class == InertiaClass::Zero);
    let is_frame = !link.has_geometry() && no_inertia;
    let is_object = no_inertia && cx.robot.is_some_and(Robot::is_rigid);
    // simulators take the link for the world, and do not read it
    let is_world = link.shown() == "world" && cx.joints_above("world").next().is_none();
    // what is fixed to it has the mass
    let is_part =
        || is_joined(cx, link) || body_inertia(cx, link).is_some_and(|(mass, _)| mass > 0.0);
    let harmless =
        is_world || is_frame || is_object || no_inertia && !is_simulated(cx) || is_part();
    let severity = if harmless {
        Severity::Info
    } else {
        Severity::Warning
    };
    let message = format!("link `{}` has zero mass", link.shown());
    let report = out.report(text.origin, message).severity(severity).help(
        "write a mass greater than 0, or remove <inertial>; simulators ignore a link without mass",
    );
    match cx
        .expansion
        .place(element_range(cx.expansion, inertial.element))
    {
        Some(place) => {
            let edit = [(place.range, String::new())];
            report
                .fix(Safety::Unsafe, "remove `inertial`", place.file, edit)
                .done();
        }
        None => report.done(),
    }
}

/// Whether the robot has something for a simulator or for controllers.
fn is_simulated(cx: &DocumentCx<'_>) -> bool {
    cx.look_beyond();
    cx.robot
        .is_some_and(|robot| !robot.gazebo.is_empty() || !robot.controls.is_empty())
}

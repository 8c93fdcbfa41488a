//! A joint moves between base_link and base.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names::prefix_of;
use model::JointType;

pub(super) static RULE: Rule = Rule {
    code: "FRM007",
    name: "base-not-fixed",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("base-not-fixed"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    for link in &cx.robot.links {
        let Some(name) = link.name.as_ref().and_then(|name| name.name()) else {
            continue;
        };
        let Some(prefix) = prefix_of(name, "base_link") else {
            continue;
        };
        let base = cx.kinematics.link(&format!("{prefix}base"));
        let (Some(base), Some(base_link)) = (base, cx.kinematics.link(name)) else {
            continue;
        };
        let path = cx.kinematics.path(base_link, base).unwrap_or_default();
        let mut joints = path
            .into_iter()
            .filter_map(|joint| cx.robot.joints.get(joint));
        let moving = joints.find(|joint| {
            joint
                .joint_type()
                .is_some_and(|kind| kind != JointType::Fixed)
        });
        let Some((joint, kind)) = moving.and_then(|joint| Some((joint, joint.kind.as_ref()?)))
        else {
            continue;
        };
        let own = cx.robot.joints.iter().find(|joint| {
            joint.is(&[JointType::Fixed])
                && joint
                    .child
                    .as_ref()
                    .is_some_and(|child| child.value == format!("{prefix}base"))
        });
        // with a shape or a mass, `base` is a part of its own, such as a turntable
        let is_body = cx
            .robot
            .links
            .get(base)
            .is_some_and(|link| link.has_geometry() || link.inertial.is_some());
        let severity = if is_body {
            Severity::Info
        } else {
            Severity::Warning
        };
        let message = format!(
            "joint `{}` between `{name}` and `{prefix}base` is not fixed",
            joint.shown()
        );
        match own.and_then(|own| Some((own, own.parent.as_ref()?))) {
            Some((own, parent)) => out
                .report(parent.origin, message)
                .also(kind.origin, "this joint moves")
                .severity(severity)
                .help(format!(
                    "write `{name}` as the parent of joint `{}`; both frames belong to the same body",
                    own.shown()
                ))
                .done(),
            None => out
                .report(kind.origin, message)
                .severity(severity)
                .help("write type=\"fixed\"; both frames belong to the same body")
                .done(),
        }
    }
}

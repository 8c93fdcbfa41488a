//! Wheels that drive backwards when they turn forwards.
use nalgebra::Vector3;

use super::super::context::RobotCx;
use super::super::numbers::{rewrite, vector};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use model::{Joint, JointType, Kinematics, Robot, transform};

pub(super) static RULE: Rule = Rule {
    code: "JNT015",
    name: "wheel-axis-direction",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("wheel-axis-direction"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let mut backward = Vec::new();
    for (i, joint) in cx.robot.joints.iter().enumerate() {
        if !joint.is(&[JointType::Continuous]) || !is_wheel(joint) {
            continue;
        }
        let Some(y) = axis_in_base(cx.robot, cx.kinematics, i).map(|axis| axis.y) else {
            return;
        };
        if y >= 0.9 {
            return;
        }
        if y <= -0.9 {
            backward.push(joint);
        }
    }
    for joint in backward {
        let Some(text) = joint.axis.as_ref().and_then(|axis| axis.xyz.as_ref()) else {
            continue;
        };
        let message = format!(
            "axis of wheel `{}` points to the right of the robot",
            joint.shown()
        );
        let mut report = out.report(text.origin, message).help(
            "use an axis that points to the left (+y), so that a positive velocity drives forward",
        );
        if let Some(axis) = text.numbers::<3>() {
            report = rewrite(
                report,
                Safety::Unsafe,
                text,
                vector(&axis.map(|part| 0.0 - part)),
            );
        }
        report.done();
    }
}

/// Whether a joint is that of a wheel, by its name or that of the link it carries.
fn is_wheel(joint: &Joint) -> bool {
    let child = joint
        .child
        .as_ref()
        .map_or("", |child| child.value.as_str());
    [joint.shown(), child]
        .iter()
        .any(|name| name.to_lowercase().contains("wheel"))
}

/// The axis of a joint in the frame of the robot's base at position zero; none when a value is not known.
fn axis_in_base(robot: &Robot, kinematics: &Kinematics, joint: usize) -> Option<Vector3<f64>> {
    let own = robot.joints.get(joint)?;
    let mut axis = Vector3::from(own.axis()?).try_normalize(1e-9)?;
    axis = transform(own.origin.as_ref())?.rotation * axis;
    let (mut link, _) = kinematics.ends(joint)?;
    for above in kinematics.ancestor_joints(link).collect::<Vec<_>>() {
        if robot
            .links
            .get(link)
            .is_some_and(|link| link.shown().ends_with("base_link"))
        {
            break;
        }
        axis = transform(robot.joints.get(above)?.origin.as_ref())?.rotation * axis;
        link = kinematics.ends(above)?.0;
    }
    Some(axis)
}

//! A velocity of a joint that looks like degrees per second.
use super::super::context::DocumentCx;
use super::super::numbers::{UNLIMITED, from_degrees, whole};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::thresholds::MAX_JOINT_VELOCITY;
use model::{AttrValue, Joint, JointType, Limit, SharedList};

pub(super) static RULE: Rule = Rule {
    code: "JNT007",
    name: "joint-velocity-degrees",
    category: Category::Joint,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("joint-velocity-degrees"),
    check: Check::Joint(check),
};

/// Velocities that are round in degrees per second. Others are as likely those of a fast motor.
const IN_DEGREES: [f64; 4] = [90.0, 120.0, 180.0, 360.0];

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some(limit) = joint
        .limit
        .as_ref()
        .filter(|_| joint.is(&[JointType::Revolute]))
    else {
        return;
    };
    let Some(text) = &limit.velocity else { return };
    let most = MAX_JOINT_VELOCITY.value(cx.world.config);
    let in_degrees = text
        .number()
        .filter(|value| *value > most && IN_DEGREES.contains(value));
    if is_made_up(limit) || in_degrees.is_none_or(|value| is_everywhere(cx.joints(), value)) {
        return;
    }
    let message = format!(
        "velocity limit of joint `{}` is {} rad/s; this looks like degrees per second",
        joint.shown(),
        text.value
    );
    let report = out
        .report(text.origin, message)
        .help("write the velocity in rad/s");
    from_degrees(report, cx.expansion, text, whole(text)).done();
}

fn velocity(joint: &Joint) -> Option<&AttrValue> {
    joint.limit.as_ref()?.velocity.as_ref()
}

/// Whether many joints have the same velocity: nobody measured that, it only means "enough".
fn is_everywhere(joints: &SharedList<Joint>, value: f64) -> bool {
    const MANY: usize = 8;
    let same = |joint: &&Joint| {
        joint.is(&[JointType::Revolute])
            && velocity(joint).and_then(AttrValue::number) == Some(value)
    };
    joints.iter().filter(same).take(MANY).count() == MANY
}

/// Whether effort and velocity are round numbers that only mean "enough", such as 1000 and 100.
fn is_made_up(limit: &Limit) -> bool {
    [&limit.effort, &limit.velocity].into_iter().all(|text| {
        let value = text.as_ref().and_then(AttrValue::number);
        value.is_some_and(|value| [1.0, 10.0, 100.0].contains(&value) || value >= UNLIMITED)
    })
}

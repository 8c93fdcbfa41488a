//! A joint that follows another beyond its own limits.
use super::super::context::RobotCx;
use super::super::numbers::short;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::mimics::targets;
use model::JointType::{Prismatic, Revolute};
use model::{AttrValue, Joint, SharedList, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT024",
    name: "mimic-range-exceeds-limits",
    category: Category::Joint,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("mimic-range-exceeds-limits"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let (joints, targets) = (&cx.robot.joints, targets(cx.robot));
    for (number, joint) in joints.iter().enumerate() {
        let target = targets.get(number).copied().flatten();
        let target = target.and_then(|target| joints.get(target));
        let (Some(mimic), Some(target)) = (&joint.mimic, target) else {
            continue;
        };
        let (Some(own), Some((low, high))) = (range(joint), followed(joints, &targets, number))
        else {
            continue;
        };
        let room = 1e-6 + 0.01 * (own.1 - own.0).abs();
        if low >= own.0 - room && high <= own.1 + room {
            continue;
        }
        let at = mimic.multiplier.as_ref().map_or_else(
            || tag_start(cx.expansion, mimic.element),
            |text| text.origin,
        );
        let message = format!(
            "joint `{}` mimics `{}` from {} to {}, but its limits are {} to {}",
            joint.shown(),
            target.shown(),
            short(low),
            short(high),
            short(own.0),
            short(own.1)
        );
        out.report(at, message)
            .help("change the multiplier, the offset or the limits of one joint")
            .done();
    }
}

/// From where to where a joint follows another one, which may follow a third.
fn followed(
    joints: &SharedList<Joint>,
    targets: &[Option<usize>],
    joint: usize,
) -> Option<(f64, f64)> {
    let value =
        |text: &Option<AttrValue>, default| text.as_ref().map_or(Some(default), AttrValue::number);
    let (mut factor, mut offset, mut last) = (1.0, 0.0, joint);
    for _ in 0..=joints.len() {
        let Some(mimic) = &joints.get(last)?.mimic else {
            let (a, b) = range(joints.get(last)?)?;
            let (a, b) = (factor * a + offset, factor * b + offset);
            return Some((a.min(b), a.max(b)));
        };
        offset += factor * value(&mimic.offset, 0.0)?;
        factor *= value(&mimic.multiplier, 1.0)?;
        last = (*targets.get(last)?)?;
    }
    None
}

/// The limits of a joint that has some.
fn range(joint: &Joint) -> Option<(f64, f64)> {
    let range = joint
        .limit
        .as_ref()
        .filter(|_| joint.is(&[Revolute, Prismatic]))?
        .range()?;
    (range.0 <= range.1).then_some(range)
}

//! A joint that follows another beyond its own limits.
use super::super::context::RobotCx;
use super::super::numbers::short;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::mimics::targets;
use base::FastMap;
use model::JointType::{Prismatic, Revolute};
use model::{AttrValue, Joint, Mimic, Robot, SharedList, tag_start};

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
    let joints = &cx.robot.joints;
    let mut ranges = Ranges::of(cx.robot);
    for (number, joint) in joints.iter().enumerate() {
        let target = ranges.target(number);
        let target = target.and_then(|target| joints.get(target));
        let (Some(mimic), Some(target)) = (&joint.mimic, target) else {
            continue;
        };
        let (Some(own), Some((low, high))) = (range(joint), ranges.followed(number)) else {
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

/// From where to where joints go, radians or meters: by their own limits, or by those of the joint that they follow.
struct Ranges<'a> {
    joints: &'a SharedList<Joint>,
    targets: Vec<Option<usize>>,
    /// Of the joints that were asked about, and of those that they follow: long chains are followed once.
    known: FastMap<usize, Option<(f64, f64)>>,
}

impl<'a> Ranges<'a> {
    fn of(robot: &'a Robot) -> Self {
        Self {
            joints: &robot.joints,
            targets: targets(robot),
            known: FastMap::default(),
        }
    }

    /// The joint that a joint mimics.
    fn target(&self, joint: usize) -> Option<usize> {
        self.targets.get(joint).copied().flatten()
    }

    /// From where to where a joint follows another one, which may follow a third.
    fn followed(&mut self, joint: usize) -> Option<(f64, f64)> {
        let mut chain = Vec::new();
        let mut last = joint;
        let mut range = loop {
            if let Some(known) = self.known.get(&last) {
                break *known;
            }
            // until it is known, a joint that follows itself leads nowhere
            self.known.insert(last, None);
            let Some(mimic) = self.joints.get(last).and_then(|joint| joint.mimic.as_ref()) else {
                let own = self.joints.get(last).and_then(range);
                self.known.insert(last, own);
                break own;
            };
            chain.push((last, mimic));
            let Some(target) = self.target(last) else {
                break None;
            };
            last = target;
        };
        for (joint, mimic) in chain.into_iter().rev() {
            range = range.and_then(|range| led(mimic, range));
            self.known.insert(joint, range);
        }
        range
    }
}

/// From where to where a joint is led that mimics one with a range.
fn led(mimic: &Mimic, (low, high): (f64, f64)) -> Option<(f64, f64)> {
    let value =
        |text: &Option<AttrValue>, default| text.as_ref().map_or(Some(default), AttrValue::number);
    let (factor, offset) = (value(&mimic.multiplier, 1.0)?, value(&mimic.offset, 0.0)?);
    let (a, b) = (factor * low + offset, factor * high + offset);
    Some((a.min(b), a.max(b)))
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

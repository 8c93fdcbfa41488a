//! A link that is the child of several joints.
use std::cell::LazyCell;

use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use ecow::EcoString;
use model::{Joint, JointType, Link};

pub(in super::super) static RULE: Rule = Rule {
    code: "STR004",
    name: "multiple-parents",
    category: Category::Structure,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("multiple-parents"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let has_several = |link: usize| cx.kinematics.parent_joints(link).len() > 1;
    if !(0..cx.robot.links.len()).any(has_several) {
        return;
    }
    let are_several = LazyCell::new(|| cx.kinematics.roots(cx.robot).len() > 1);
    let mut count: FastMap<&str, usize> = FastMap::default();
    for name in cx.robot.links.iter().filter_map(|link| link.name.as_ref()) {
        *count.entry(&name.value).or_default() += 1;
    }
    for (link, name) in cx
        .robot
        .links
        .iter()
        .map(|link| link.name.as_ref())
        .enumerate()
    {
        // of two links of one name, each may hang on its own joint
        if name.is_none_or(|name| count.get(name.value.as_str()) != Some(&1)) {
            continue;
        }
        let joints = cx
            .kinematics
            .parent_joints(link)
            .iter()
            .filter_map(|&joint| cx.robot.joints.get(joint));
        // loops and doubled joints are said elsewhere
        let mut joints =
            joints.filter(|joint| joint.ends().is_some_and(|(parent, child)| parent != child));
        let Some(first) = joints.next() else { continue };
        for joint in joints.filter(|joint| joint.shown() != first.shown()) {
            let (Some(child), Some(earlier)) = (&joint.child, &first.child) else {
                continue;
            };
            let message = format!(
                "link `{}` has more than one parent joint: `{}` and `{}`",
                child.value,
                first.shown(),
                joint.shown()
            );
            let help = match reversed(cx, [first, joint]).filter(|_| *are_several) {
                Some(joint) => format!(
                    "swap the parent and the child of joint `{}`, or remove one joint; a link can have only one parent joint",
                    joint.shown()
                ),
                None => {
                    "remove one joint, or swap its parent and child; a link can have only one parent joint"
                        .to_owned()
                }
            };
            // parsers take the tree that the links make, in which joints beside each other are one
            let is_beside = joint.ends().map(|ends| ends.0) == first.ends().map(|ends| ends.0)
                && !joint.is(&[JointType::Fixed])
                && !first.is(&[JointType::Fixed]);
            let severity = match joint.ends() {
                Some(ends) if is_beside && is_frame(cx, [ends.0, ends.1]) => Severity::Info,
                _ if is_beside => Severity::Warning,
                _ => RULE.severity,
            };
            out.report(child.origin, message)
                .severity(severity)
                .also(
                    earlier.origin,
                    format!("joint `{}` is the first parent joint", first.shown()),
                )
                .help(help)
                .done();
        }
    }
}

/// Whether one of the links that a joint holds together is a frame: between frames, several joints are values with names.
fn is_frame(cx: &RobotCx<'_>, ends: [&EcoString; 2]) -> bool {
    let link = |name: &EcoString| cx.robot.links.get(cx.kinematics.link(name)?);
    let is_bare = |link: &Link| !link.has_geometry() && link.inertial.is_none();
    ends.into_iter().filter_map(link).any(is_bare)
}

/// The joint that looks reversed, in a robot with several roots: the only one of the two whose parent link no joint holds.
fn reversed<'j>(cx: &RobotCx<'_>, joints: [&'j Joint; 2]) -> Option<&'j Joint> {
    let is_loose = |joint: &&Joint| {
        let parent = joint
            .parent
            .as_ref()
            .and_then(|parent| cx.kinematics.link(parent.name()?));
        parent.is_some_and(|link| cx.kinematics.parent_joints(link).is_empty())
    };
    let mut loose = joints.into_iter().filter(is_loose);
    loose.next().filter(|_| loose.next().is_none())
}

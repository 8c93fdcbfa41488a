//! A base that is tilted against its footprint.
use nalgebra::UnitQuaternion;

use super::super::context::RobotCx;
use super::super::numbers::{comes_from_a_name, short};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names::prefix_of;
use model::{AttrValue, transform};

pub(super) static RULE: Rule = Rule {
    code: "FRM010",
    name: "base-footprint-tilted",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("base-footprint-tilted"),
    check: Check::Robot(check),
};

/// More than rounding, radians.
const LEVEL: f64 = 1e-3;

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    for link in &cx.robot.links {
        let Some(name) = link.name.as_ref().and_then(|name| name.name()) else {
            continue;
        };
        let Some(prefix) = prefix_of(name, "base_link") else {
            continue;
        };
        let footprint = cx.kinematics.link(&format!("{prefix}base_footprint"));
        let (Some(footprint), Some(base)) = (footprint, cx.kinematics.link(name)) else {
            continue;
        };
        let Some(path) = cx.kinematics.path(footprint, base) else {
            continue;
        };
        let joints: Vec<_> = path
            .iter()
            .filter_map(|&joint| cx.robot.joints.get(joint))
            .collect();
        let mut rotation = UnitQuaternion::identity();
        for (&i, joint) in path.iter().zip(&joints) {
            let Some(step) = transform(joint.origin.as_ref()) else {
                return;
            };
            // a joint that is walked from child to parent turns the other way
            let down = cx.kinematics.ancestor_joints(base).any(|above| above == i);
            rotation *= if down {
                step.rotation
            } else {
                step.rotation.inverse()
            };
        }
        let (roll, pitch, _) = rotation.euler_angles();
        if roll.abs() <= LEVEL && pitch.abs() <= LEVEL {
            continue;
        }
        let mut tilts = joints
            .iter()
            .filter_map(|joint| joint.origin.as_ref()?.rpy.as_ref());
        let tilted = |text: &&AttrValue| {
            text.numbers::<3>()
                .is_some_and(|[roll, pitch, _]| roll.abs().max(pitch.abs()) > LEVEL)
        };
        let Some(at) = tilts.find(tilted) else {
            continue;
        };
        // a tilt that has a name is meant
        let is_named = at
            .words()
            .zip(at.numbers::<3>().unwrap_or_default())
            .take(2)
            .any(|(range, angle)| {
                angle.abs() > LEVEL && comes_from_a_name(cx.expansion, at, range)
            });
        let message = format!(
            "`{name}` is tilted relative to `{prefix}base_footprint` (roll {}, pitch {})",
            short(roll),
            short(pitch)
        );
        out.report(at.origin, message)
            .severity(if is_named {
                Severity::Info
            } else {
                Severity::Warning
            })
            .help("set roll and pitch to 0; `base_footprint` is the base projected onto the floor")
            .done();
    }
}

//! base_link lies on its side.
use super::super::context::RobotCx;
use super::super::numbers::comes_from_a_name;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::is_surroundings;
use super::names::{can_move, prefix_of};
use model::{AttrValue, Joint, JointType};

pub(super) static RULE: Rule = Rule {
    code: "FRM019",
    name: "base-link-tilted",
    category: Category::Frames,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("base-link-tilted"),
    check: Check::Robot(check),
};

/// How near to a quarter of a turn, radians.
const NEAR: f64 = 0.01;

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    if !can_move(cx.robot) {
        return;
    }
    for joint in cx
        .robot
        .joints
        .iter()
        .filter(|joint| joint.is(&[JointType::Fixed]))
    {
        let (Some(parent), Some(child)) = (&joint.parent, &joint.child) else {
            continue;
        };
        let is_base = child
            .name()
            .is_some_and(|name| prefix_of(name, "base_link").is_some());
        if !is_base || !parent.name().is_some_and(|name| is_surroundings(name)) {
            continue;
        }
        let Some(rotation) = tilt(cx, joint) else {
            continue;
        };
        out.report(
            rotation.origin,
            format!(
                "`{}` is tilted by 90 degrees in `{}`",
                child.value, parent.value
            ),
        )
        .help("set roll and pitch to 0; `base_link` has z up unless the robot is mounted on a wall")
        .done();
    }
}

/// The rotation of a joint, when roll or pitch is a quarter of a turn and no name says that it is meant.
fn tilt<'a>(cx: &RobotCx<'_>, joint: &'a Joint) -> Option<&'a AttrValue> {
    let text = joint.origin.as_ref()?.rpy.as_ref()?;
    let [roll, pitch, _] = text.numbers::<3>()?;
    let is_named = text
        .words()
        .take(2)
        .any(|word| comes_from_a_name(cx.expansion, text, word));
    ((is_quarter(roll) || is_quarter(pitch)) && !is_named).then_some(text)
}

/// Whether an angle is a quarter of a turn, either way.
fn is_quarter(angle: f64) -> bool {
    (angle.abs() - std::f64::consts::FRAC_PI_2).abs() < NEAR
}

//! Wheels left and right that turn against each other.
use super::super::context::DocumentCx;
use super::super::numbers::{rewrite, vector};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::wheels::{axis_in_parent, other_side};
use base::FastMap;
use expand::Origin;
use model::{Joint, JointType, Robot, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "JNT014",
    name: "wheel-axis-opposed",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("wheel-axis-opposed"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot else { return };
    let mut seen: FastMap<(&str, String), &Joint> = FastMap::default();
    for joint in robot.joints.iter().filter(|joint| is_wheel(robot, joint)) {
        let Some((parent, _)) = joint.ends() else {
            continue;
        };
        let other =
            other_side(joint.shown()).and_then(|name| seen.get(&(parent.as_str(), name)).copied());
        seen.insert((parent.as_str(), joint.shown().to_lowercase()), joint);
        let Some(first) = other else { continue };
        let (Some(a), Some(b)) = (axis_in_parent(first), axis_in_parent(joint)) else {
            continue;
        };
        if a.dot(&b) > -0.9 {
            continue;
        }
        let message = format!(
            "wheel joints `{}` and `{}` have opposite axes",
            first.shown(),
            joint.shown()
        );
        let mut report = out
            .report(axis_place(cx, joint), message)
            .also(axis_place(cx, first), format!("axis of joint `{}`", first.shown()))
            .help("make both axes point in the same direction; drive controllers use the same sign for both sides");
        if let Some(text) = joint.axis.as_ref().and_then(|axis| axis.xyz.as_ref())
            && let Some(axis) = text.numbers::<3>()
        {
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

/// Where the axis of a joint is written, or where a joint without one begins.
fn axis_place(cx: &DocumentCx<'_>, joint: &Joint) -> Origin {
    let xyz = joint.axis.as_ref().and_then(|axis| axis.xyz.as_ref());
    xyz.map_or_else(
        || tag_start(cx.expansion, joint.element),
        |text| text.origin,
    )
}

/// Whether a joint turns freely, by itself, and carries nothing that moves: an arm may well be mirrored.
fn is_wheel(robot: &Robot, joint: &Joint) -> bool {
    if !joint.is(&[JointType::Continuous]) || joint.mimic.is_some() {
        return false;
    }
    let Some((_, child)) = joint.ends() else {
        return false;
    };
    let carries = robot
        .joints_below(child)
        .any(|other| !other.is(&[JointType::Fixed]));
    let names = format!("{} {child}", joint.shown()).to_lowercase();
    let is_rotor = ["rotor", "propeller", "prop_"]
        .iter()
        .any(|word| names.contains(word));
    !carries && !is_rotor
}

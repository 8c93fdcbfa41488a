//! An optical frame that is not turned as cameras expect.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{UnitQuaternion, Vector3};

use super::super::context::DocumentCx;
use super::super::edits::speaks_xacro;
use super::super::numbers::rewrite;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use model::{Joint, tag_start};

pub(super) const RULE: Rule = Rule {
    code: "FRM004",
    name: "optical-frame-orientation",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("optical-frame-orientation"),
    check: Check::Document(check),
};

/// Rounding of what people write for half of pi.
const TOLERANCE: f64 = 0.01;
/// The part of a direction along x up to which it is across.
const ASIDE: f64 = 0.1;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let usual = UnitQuaternion::from_euler_angles(-FRAC_PI_2, 0.0, -FRAC_PI_2);
    for joint in cx.joints() {
        let Some((parent, child)) = joint.ends() else { continue };
        // between two optical frames, there is no turn; a projector has no image
        if !is_optical(child)
            || child.contains("projector")
            || holds_block(cx, joint)
            || parent.to_lowercase().contains("optical")
        {
            continue;
        }
        let [roll, pitch, yaw] = match joint.origin.as_ref().map(|origin| origin.angles()) {
            Some(Some(angles)) => angles,
            Some(None) => continue,
            None => [0.0; 3],
        };
        let turned = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
        // on a part that is no camera, the joint holds the pose of the camera as well
        let is_mounted = turned.angle() > TOLERANCE && first_word(parent) != first_word(child);
        if turned.angle_to(&usual) > TOLERANCE && !is_mounted {
            let severity = if looks_aside(&turned) { Severity::Info } else { Severity::Warning };
            report(cx, out, joint, child, severity);
        }
    }
}

/// Whether a frame is turned on purpose so that it does not look along x of its parent, nor against it: the parent is no
/// camera frame of the usual kind, but a plate or a flange.
fn looks_aside(turned: &UnitQuaternion<f64>) -> bool {
    let forward = turned * Vector3::z();
    turned.angle() > TOLERANCE && forward.x.abs() < ASIDE
}

/// Whether an `insert_block` without its prefix is in a joint: the origin that it would insert is not known.
fn holds_block(cx: &DocumentCx<'_>, joint: &Joint) -> bool {
    let tree = &cx.expansion.tree;
    tree.elements(joint.element).any(|child| tree.get(child).text == "insert_block")
}

fn report(cx: &DocumentCx<'_>, out: &mut Sink<'_>, joint: &Joint, child: &str, severity: Severity) {
    let rpy = joint.origin.as_ref().and_then(|origin| origin.rpy.as_ref());
    let at = rpy.map_or_else(|| tag_start(cx.expansion, joint.element), |text| text.origin);
    let report = out
        .report(at, format!("optical frame `{child}` is not turned by -pi/2 0 -pi/2"))
        .severity(severity)
        .help("an optical frame looks along z, with x to the right and y down; its camera looks along x");
    let Some(text) = rpy else { return report.done() };
    let xacro = speaks_xacro(cx.expansion, text.origin);
    let new = if xacro { "${-pi/2} 0 ${-pi/2}" } else { "-1.5707963267948966 0 -1.5707963267948966" };
    rewrite(report, Safety::Unsafe, text, new.to_owned()).done();
}

/// What a link is called after.
fn first_word(name: &str) -> &str {
    name.split('_').find(|word| !word.is_empty()).unwrap_or_default()
}

/// Whether a link is an optical frame by its name.
fn is_optical(name: &str) -> bool {
    name.ends_with("_optical_frame") || name.ends_with("_optical")
}

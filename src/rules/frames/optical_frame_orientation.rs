//! An optical frame that is not turned as cameras expect.
use std::f64::consts::FRAC_PI_2;

use nalgebra::{UnitQuaternion, Vector3};

use super::super::context::DocumentCx;
use super::super::edits::speaks_xacro;
use super::super::numbers::rewrite;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use expand::XId;
use model::{AttrValue, Gazebo, Joint, JointType, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "FRM004",
    name: "optical-frame-orientation",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("optical-frame-orientation"),
    check: Check::Joint(check),
};

/// Rounding of what people write for half of pi.
const TOLERANCE: f64 = 0.01;
/// Rounding of no turn: what is turned by more than this was measured.
const UNTURNED: f64 = 1e-6;
/// How far a camera may be off by what was measured.
const CALIBRATED: f64 = 0.2;
/// The part of a direction along x up to which it is across.
const ASIDE: f64 = 0.1;

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let usual = UnitQuaternion::from_euler_angles(-FRAC_PI_2, 0.0, -FRAC_PI_2);
    let Some((parent, child)) = joint.ends() else {
        return;
    };
    // between two optical frames, there is no turn; a projector has no image
    if !is_optical(child)
        || child.contains("projector")
        || holds_block(cx, joint)
        || parent.to_lowercase().contains("optical")
    {
        return;
    }
    let [roll, pitch, yaw] = match joint.origin.as_ref().map(|origin| origin.angles()) {
        Some(Some(angles)) => angles,
        Some(None) => return,
        None => [0.0; 3],
    };
    let turned = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
    // on a part that is no camera, the joint holds the pose of the camera as well
    let is_mounted = turned.angle() > UNTURNED && first_word(parent) != first_word(child);
    let is_off = |turned: &UnitQuaternion<f64>| turned.angle_to(&usual) > CALIBRATED;
    if is_off(&turned)
        && !is_mounted
        && !is_of_no_pictures(cx, parent, child)
        && turns_above(cx, parent, turned).iter().all(is_off)
    {
        let is_meant = looks_aside(&turned) || looks_back(&turned);
        let severity = if is_meant || holds_points_of_gazebo(cx, child) {
            Severity::Info
        } else {
            Severity::Warning
        };
        report(cx, out, joint, child, severity);
    }
}

/// Whether a frame is that of a sensor that takes no pictures: by its name, or by the sensor that a simulator has there.
fn is_of_no_pictures(cx: &DocumentCx<'_>, parent: &str, child: &str) -> bool {
    const NAMES: [&str; 7] = ["accel", "gyro", "imu", "laser", "lidar", "radar", "sonar"];
    const SENSORS: [&str; 5] = ["ray", "gpu_ray", "lidar", "gpu_lidar", "sonar"];
    cx.look_beyond();
    let tree = &cx.expansion.tree;
    let is_named = child
        .to_lowercase()
        .split('_')
        .any(|word| NAMES.contains(&word));
    let is_ranging = |id| {
        tree.get(id).text == "sensor"
            && tree
                .attr(id, "type")
                .is_some_and(|kind| SENSORS.contains(&kind.value.as_str()))
    };
    let is_there = |block: &&Gazebo| {
        let reference = block.reference.as_ref().and_then(|text| text.name());
        reference.is_some_and(|name| name == child || name == parent)
    };
    let mut blocks = cx
        .robot
        .into_iter()
        .flat_map(|robot| &robot.gazebo)
        .filter(is_there);
    is_named || blocks.any(|block| tree.elements(block.element).any(is_ranging))
}

/// Whether the points of a camera of Gazebo are in a frame: x is forward in them, whatever the frame is called. The camera is
/// in the link itself, or names it.
/// Source: `RgbdCameraSensor` of gz-sensors.
fn holds_points_of_gazebo(cx: &DocumentCx<'_>, child: &str) -> bool {
    const FRAMES: [&str; 3] = ["gz_frame_id", "ignition_frame_id", "optical_frame_id"];
    cx.look_beyond();
    let tree = &cx.expansion.tree;
    let is_camera = |id: XId| {
        let kind = tree.attr(id, "type");
        tree.get(id).text == "sensor" && kind.is_some_and(|kind| kind.value == "rgbd_camera")
    };
    let names_frame = |id: XId| {
        FRAMES.contains(&tree.get(id).text.as_str())
            && AttrValue::content(tree, id).is_some_and(|frame| frame.value == child)
    };
    let mut blocks = cx.robot.into_iter().flat_map(|robot| &robot.gazebo);
    blocks.any(|block| {
        let mut cameras = tree.elements(block.element).filter(|&id| is_camera(id));
        let reference = block.reference.as_ref().and_then(|text| text.name());
        let is_there = reference.is_some_and(|name| name == child);
        cameras.any(|camera| is_there || tree.below(camera).any(names_frame))
    })
}

/// How a frame is turned in the links above it that are fixed to it, `turned` in `parent`: a camera may be turned itself,
/// and its frame not.
fn turns_above(
    cx: &DocumentCx<'_>,
    parent: &str,
    turned: UnitQuaternion<f64>,
) -> Vec<UnitQuaternion<f64>> {
    /// Links above that are looked at.
    const MOST_LINKS: usize = 10;
    let (mut parent, mut turned, mut found) = (parent, turned, Vec::new());
    while found.len() < MOST_LINKS {
        let Some(joint) = cx.joints_above(parent).find(|joint| joint.ends().is_some()) else {
            break;
        };
        let angles = joint
            .origin
            .as_ref()
            .map_or(Some([0.0; 3]), |origin| origin.angles());
        let is_fixed = joint.joint_type() == Some(JointType::Fixed);
        let (Some([roll, pitch, yaw]), Some((above, _)), true) = (angles, joint.ends(), is_fixed)
        else {
            break;
        };
        turned = UnitQuaternion::from_euler_angles(roll, pitch, yaw) * turned;
        found.push(turned);
        parent = above;
    }
    found
}

/// Whether a frame is turned on purpose so that it does not look along x of its parent, nor against it: the parent is no
/// camera frame of the usual kind, but a plate or a flange.
fn looks_aside(turned: &UnitQuaternion<f64>) -> bool {
    let forward = turned * Vector3::z();
    turned.angle() > TOLERANCE && forward.x.abs() < ASIDE
}

/// Whether a frame is the optical one of a camera that looks against x of its frame.
fn looks_back(turned: &UnitQuaternion<f64>) -> bool {
    let reversed = UnitQuaternion::from_euler_angles(-FRAC_PI_2, 0.0, FRAC_PI_2);
    turned.angle_to(&reversed) < TOLERANCE
}

/// Whether an `insert_block` without its prefix is in a joint: the origin that it would insert is not known.
fn holds_block(cx: &DocumentCx<'_>, joint: &Joint) -> bool {
    let tree = &cx.expansion.tree;
    tree.elements(joint.element)
        .any(|child| tree.get(child).text == "insert_block")
}

fn report(cx: &DocumentCx<'_>, out: &mut Sink<'_>, joint: &Joint, child: &str, severity: Severity) {
    let rpy = joint.origin.as_ref().and_then(|origin| origin.rpy.as_ref());
    let at = rpy.map_or_else(
        || tag_start(cx.expansion, joint.element),
        |text| text.origin,
    );
    let xacro = speaks_xacro(cx.expansion, at);
    let new = if xacro {
        "${-pi/2} 0 ${-pi/2}"
    } else {
        "-1.5707963267948966 0 -1.5707963267948966"
    };
    let report = out
        .report(
            at,
            format!("optical frame `{child}` is not rotated by -pi/2 0 -pi/2"),
        )
        .severity(severity)
        .help(format!(
            "write rpy=\"{new}\"; an optical frame has z forward, x right and y down"
        ));
    let Some(text) = rpy else {
        return report.done();
    };
    rewrite(report, Safety::Unsafe, text, new.to_owned()).done();
}

/// What a link is called after.
fn first_word(name: &str) -> &str {
    name.split('_')
        .find(|word| !word.is_empty())
        .unwrap_or_default()
}

/// Whether a link is an optical frame by its name.
fn is_optical(name: &str) -> bool {
    name.ends_with("_optical_frame") || name.ends_with("_optical")
}

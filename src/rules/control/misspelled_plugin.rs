//! A plugin whose name is almost that of a well-known one.
use super::super::context::DocumentCx;
use super::super::finding::Help;
use super::super::numbers::rewrite;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::plugins::plugins;
use model::AttrValue;
use packages::misspelled;

pub(super) static RULE: Rule = Rule {
    code: "CTL024",
    name: "misspelled-plugin",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("misspelled-plugin"),
    check: Check::Document(check),
};

/// Hardware of ros2_control.
pub(super) const HARDWARE: [&str; 6] = [
    "mock_components/GenericSystem",
    "fake_components/GenericSystem",
    "gazebo_ros2_control/GazeboSystem",
    "gz_ros2_control/GazeboSimSystem",
    "ign_ros2_control/IgnitionSystem",
    "topic_based_ros2_control/TopicBasedSystem",
];

/// Libraries of Gazebo's plugins.
const LIBRARIES: [&str; 22] = [
    "libgazebo_ros_control.so",
    "libgazebo_ros2_control.so",
    "libgz_ros2_control-system.so",
    "libign_ros2_control-system.so",
    "libgazebo_ros_diff_drive.so",
    "libgazebo_ros_skid_steer_drive.so",
    "libgazebo_ros_planar_move.so",
    "libgazebo_ros_joint_state_publisher.so",
    "libgazebo_ros_camera.so",
    "libgazebo_ros_depth_camera.so",
    "libgazebo_ros_multicamera.so",
    "libgazebo_ros_openni_kinect.so",
    "libgazebo_ros_laser.so",
    "libgazebo_ros_gpu_laser.so",
    "libgazebo_ros_block_laser.so",
    "libgazebo_ros_ray_sensor.so",
    "libgazebo_ros_imu.so",
    "libgazebo_ros_imu_sensor.so",
    "libgazebo_ros_bumper.so",
    "libgazebo_ros_p3d.so",
    "libgazebo_ros_f3d.so",
    "libgazebo_grasp_fix.so",
];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for file in plugins(cx)
        .into_iter()
        .filter_map(|plugin| AttrValue::attr(tree, plugin, "filename"))
    {
        report(&file, &LIBRARIES, out);
    }
    let controls = cx.robot.into_iter().flat_map(|robot| &robot.controls);
    for plugin in controls.filter_map(|control| control.plugin(tree)) {
        if let Some(class) = AttrValue::content(tree, plugin) {
            report(&class, &HARDWARE, out);
        }
    }
}

/// A name with one letter too many, too few, other or swapped. What differs in a digit is another version.
fn report(text: &AttrValue, known: &[&'static str], out: &mut Sink<'_>) {
    let Some(name) = text.name().filter(|name| !known.contains(&name.as_str())) else {
        return;
    };
    let near = misspelled(name, known.iter().copied());
    let Some(near) = near.filter(|near| !letters(near).eq(letters(name))) else {
        return;
    };
    let report = out
        .report(text.origin, format!("unknown plugin `{name}`"))
        .help(Help::did_you_mean(near));
    rewrite(report, Safety::Unsafe, text, near.to_owned()).done();
}

/// A name without its digits.
fn letters(name: &str) -> impl Iterator<Item = char> {
    name.chars().filter(|c| !c.is_ascii_digit())
}

//! The plugins of `gazebo_ros_pkgs` in ROS 1 and in ROS 2.
//!
//! Source: `gazebo_plugins/src` on the branches `noetic-devel` and `ros2`, and the guide "ROS 2 Migration" of `gazebo_ros_pkgs`.
use super::super::context::DocumentCx;
use super::plugins::plugins;
use expand::XId;
use model::AttrValue;
use packages::RosVersion;

/// Libraries that ROS 2 does not have, each with what took its place there.
const ROS1_LIBRARIES: [(&str, &str); 16] = [
    ("libgazebo_ros_block_laser.so", RAY_SENSOR),
    ("libgazebo_ros_control.so", "libgazebo_ros2_control.so"),
    ("libgazebo_ros_depth_camera.so", CAMERA),
    ("libgazebo_ros_f3d.so", "libgazebo_ros_ft_sensor.so"),
    ("libgazebo_ros_gpu_laser.so", RAY_SENSOR),
    ("libgazebo_ros_imu.so", "libgazebo_ros_imu_sensor.so"),
    ("libgazebo_ros_laser.so", RAY_SENSOR),
    ("libgazebo_ros_multicamera.so", CAMERA),
    ("libgazebo_ros_openni_kinect.so", CAMERA),
    ("libgazebo_ros_paths_plugin.so", "libgazebo_ros_init.so"),
    ("libgazebo_ros_api_plugin.so", "libgazebo_ros_init.so"),
    ("libgazebo_ros_prosilica.so", CAMERA),
    ("libgazebo_ros_range.so", RAY_SENSOR),
    (
        "libgazebo_ros_skid_steer_drive.so",
        "libgazebo_ros_diff_drive.so",
    ),
    ("libgazebo_ros_triggered_camera.so", CAMERA),
    ("libgazebo_ros_triggered_multicamera.so", CAMERA),
];

const RAY_SENSOR: &str = "libgazebo_ros_ray_sensor.so";
const CAMERA: &str = "libgazebo_ros_camera.so";

/// What names the topic of a plugin in ROS 2.
pub(super) const REMAPPING: &str = "<ros><remapping>old:=new</remapping></ros>";
pub(super) const NAMESPACE: &str = "<ros><namespace>name</namespace></ros>";

/// Parameters that the plugins of ROS 1 read and those of ROS 2 do not, each with what took its place there.
const ROS1_PARAMETERS: [(&str, &str); 20] = [
    ("bodyName", "body_name"),
    ("bumperTopicName", REMAPPING),
    ("cameraInfoTopicName", REMAPPING),
    ("cameraName", "camera_name"),
    ("commandTopic", REMAPPING),
    ("frameName", "frame_name"),
    ("imageTopicName", REMAPPING),
    ("jointName", "joint_name"),
    ("leftJoint", "left_joint"),
    ("odometryFrame", "odometry_frame"),
    ("odometryTopic", REMAPPING),
    ("publishWheelTF", "publish_wheel_tf"),
    ("rightJoint", "right_joint"),
    ("robotBaseFrame", "robot_base_frame"),
    ("robotNamespace", NAMESPACE),
    ("topicName", REMAPPING),
    ("wheelAcceleration", "max_wheel_acceleration"),
    ("wheelDiameter", "wheel_diameter"),
    ("wheelSeparation", "wheel_separation"),
    ("wheelTorque", "max_wheel_torque"),
];

/// Plugins that both have, by the ending of their names, and the parameters that had another name in ROS 1.
const IN_BOTH: [(&str, &[&str]); 9] = [
    ("bumper", &["bumperTopicName", "frameName"]),
    (
        "camera",
        &[
            "cameraInfoTopicName",
            "cameraName",
            "frameName",
            "imageTopicName",
        ],
    ),
    (
        "diff_drive",
        &[
            "commandTopic",
            "leftJoint",
            "odometryFrame",
            "odometryTopic",
            "publishWheelTF",
            "rightJoint",
            "robotBaseFrame",
            "wheelAcceleration",
            "wheelDiameter",
            "wheelSeparation",
            "wheelTorque",
        ],
    ),
    (
        "ft_sensor",
        &["bodyName", "frameName", "jointName", "topicName"],
    ),
    ("imu_sensor", &["frameName", "topicName"]),
    ("joint_state_publisher", &["jointName"]),
    ("p3d", &["bodyName", "frameName", "topicName"]),
    (
        "planar_move",
        &[
            "commandTopic",
            "odometryFrame",
            "odometryTopic",
            "robotBaseFrame",
        ],
    ),
    ("ray_sensor", &["frameName", "topicName"]),
];

/// The parameter that all had.
const OF_ALL: &str = "robotNamespace";

/// What took the place of a library of ROS 1.
pub(super) fn successor(library: &str) -> Option<&'static str> {
    let mut all = ROS1_LIBRARIES.iter();
    all.find(|(old, _)| *old == library).map(|(_, new)| *new)
}

/// What took the place of a parameter of ROS 1, in a plugin that both have.
pub(super) fn renamed(library: &str, parameter: &str) -> Option<&'static str> {
    let name = library
        .strip_prefix("libgazebo_ros_")?
        .strip_suffix(".so")?;
    let (_, own) = IN_BOTH.iter().find(|(known, _)| *known == name)?;
    if parameter != OF_ALL && !own.contains(&parameter) {
        return None;
    }
    let mut all = ROS1_PARAMETERS.iter();
    all.find(|(old, _)| *old == parameter).map(|(_, new)| *new)
}

/// The plugins of Gazebo in files of packages for ROS 2, each with the name of its library.
pub(super) fn plugins_for_ros2(cx: &DocumentCx<'_>) -> Vec<(XId, AttrValue)> {
    if cx.world.config.target == RosVersion::Ros1 {
        return Vec::new();
    }
    let tree = &cx.expansion.tree;
    let with_library = |plugin: XId| {
        let library = AttrValue::attr(tree, plugin, "filename")?;
        let is_wanted = library.is_known() && library.value.starts_with("libgazebo_ros");
        is_wanted.then_some((plugin, library))
    };
    let is_for_ros2 = |(_, library): &(XId, AttrValue)| {
        let place = cx.expansion.place(library.origin);
        let file = place.and_then(|place| cx.expansion.files.get(place.file));
        file.is_some_and(|file| cx.world.packages.is_for_ament(&file.source.path))
    };
    let all = plugins(cx).into_iter().filter_map(with_library);
    all.filter(is_for_ros2).collect()
}

/// Whether a robot also has plugins that only ROS 2 or the new Gazebo can load: those of ROS 1 are for another use of it.
pub(super) fn is_for_several(cx: &DocumentCx<'_>) -> bool {
    const NEWER: [&str; 5] = [
        "gz-",
        "ignition-",
        "libgz_",
        "libign_",
        "libgazebo_ros2_control",
    ];
    let tree = &cx.expansion.tree;
    let mut libraries = plugins(cx)
        .into_iter()
        .filter_map(|plugin| AttrValue::attr(tree, plugin, "filename"));
    libraries.any(|library| {
        let name = library.value.as_str();
        let name = name
            .strip_prefix("lib")
            .filter(|_| name.contains('-'))
            .unwrap_or(name);
        NEWER.iter().any(|start| name.starts_with(start))
    })
}

//! The parameters that plugins of Gazebo read.
//!
//! Source: `gazebo_plugins` of `gazebo_ros_pkgs` on the branches `hydro-devel` to `noetic-devel` and `dashing` to `ros2`, and
//! `src/systems` of gz-sim from `ign-gazebo3` to `gz-sim10`.

use packages::RosVersion;

/// The parameters of systems of gz-sim, by the middle of the names of their libraries.
const SYSTEMS: [(&str, &str); 14] = [
    (
        "ackermann-steering",
        "actuator_number child_frame_id frame_id kingpin_width left_joint left_steering_joint max_acceleration max_jerk max_velocity \
         min_acceleration min_jerk min_velocity odom_publish_frequency odom_topic right_joint right_steering_joint steer_p_gain \
         steering_limit steering_only sub_topic tf_topic topic use_actuator_msg wheel_base wheel_radius wheel_separation",
    ),
    (
        "detachable-joint",
        "attach_topic child_link child_model detach_topic output_topic parent_link suppress_child_warning topic",
    ),
    (
        "diff-drive",
        "child_frame_id frame_id left_joint max_acceleration max_angular_acceleration max_angular_jerk max_angular_velocity max_jerk \
         max_linear_acceleration max_linear_jerk max_linear_velocity max_velocity min_acceleration min_angular_acceleration \
         min_angular_jerk min_angular_velocity min_jerk min_linear_acceleration min_linear_jerk min_linear_velocity min_velocity \
         odom_publish_frequency odom_topic right_joint tf_topic topic wheel_radius wheel_separation",
    ),
    (
        "joint-controller",
        "actuator_number cmd_max cmd_min cmd_offset d_gain disable_braking i_gain i_max i_min initial_velocity joint_name p_gain \
         sub_topic topic use_actuator_msg use_force_commands",
    ),
    (
        "joint-position-controller",
        "actuator_number cmd_max cmd_min cmd_offset d_gain i_gain i_max i_min initial_position joint_index joint_name p_gain sub_topic \
         topic use_actuator_msg use_velocity_commands",
    ),
    ("joint-state-publisher", "joint_name topic update_rate"),
    (
        "mecanum-drive",
        "back_left_joint back_right_joint child_frame_id frame_id front_left_joint front_right_joint max_acceleration max_jerk \
         max_velocity min_acceleration min_jerk min_velocity odom_publish_frequency odom_topic tf_topic topic wheel_radius \
         wheel_separation wheelbase",
    ),
    (
        "multicopter-motor-model",
        "actuator_number commandSubTopic jointName linkName maxRotVelocity momentConstant motorConstant motorNumber motorType \
         robotNamespace rollingMomentCoefficient rotorDragCoefficient rotorVelocitySlowdownSim timeConstantDown timeConstantUp \
         turningDirection",
    ),
    (
        "odometry-publisher",
        "dimensions gaussian_noise odom_covariance_topic odom_frame odom_publish_frequency odom_topic robot_base_frame \
         rpy_global_offset rpy_offset tf_topic xyz_global_offset xyz_offset",
    ),
    (
        "pose-publisher",
        "publish_collision_pose publish_link_pose publish_model_pose publish_nested_model_pose publish_sensor_pose \
         publish_visual_pose static_publisher static_update_frequency topic update_frequency use_pose_vector_msg",
    ),
    (
        "thruster",
        "alpha_1 alpha_2 battery_name d_gain deadband fluid_density i_gain joint_name max_thrust_cmd min_thrust_cmd namespace p_gain \
         power_load propeller_diameter thrust_coefficient topic use_angvel_cmd velocity_control wake_fraction",
    ),
    (
        "track-controller",
        "center_of_rotation_topic debug link max_acceleration max_command_age max_jerk max_velocity min_acceleration min_jerk \
         min_velocity odometry_publish_frequency odometry_topic track_orientation velocity_topic",
    ),
    (
        "tracked-vehicle",
        "body_link center_of_rotation_topic child_frame_id debug frame_id left_track link max_acceleration max_jerk max_velocity \
         min_acceleration min_jerk min_velocity odom_publish_frequency odom_topic right_track steering_efficiency \
         steering_efficiency_topic tf_topic topic tracks_separation velocity_topic",
    ),
    (
        "velocity-control",
        "initial_angular initial_linear link_name topic",
    ),
];

/// What drives of Gazebo Classic call otherwise than those of gz-sim. Half of a diameter is a radius: these two have no fix.
const CLASSIC_NAMES: [(&str, &str); 12] = [
    ("base_frame", "child_frame_id"),
    ("commandTopic", "topic"),
    ("command_topic", "topic"),
    ("odom_frame", "frame_id"),
    ("odometryFrame", "frame_id"),
    ("odometryTopic", "odom_topic"),
    ("odometry_frame", "frame_id"),
    ("odometry_topic", "odom_topic"),
    ("robotBaseFrame", "child_frame_id"),
    ("robot_base_frame", "child_frame_id"),
    ("wheelDiameter", "wheel_radius"),
    ("wheel_diameter", "wheel_radius"),
];

/// The parameters of plugins of `gazebo_ros_pkgs` by the ending of the names of their libraries: in ROS 1, and in ROS 2.
const CLASSIC: [(&str, &str, &str); 8] = [
    (
        "ackermann_drive",
        "",
        "front_left_joint front_right_joint left_steering_i_range left_steering_joint left_steering_pid_gain linear_velocity_i_range \
         linear_velocity_pid_gain max_speed max_steer max_steering_angle odometry_frame publish_distance publish_odom publish_odom_tf \
         publish_steerangle publish_wheel_tf rear_left_joint rear_right_joint right_steering_i_range right_steering_joint \
         right_steering_pid_gain robot_base_frame steering_wheel_joint update_rate",
    ),
    (
        "camera",
        "autoDistortion borderCrop cameraInfoTopicName cameraName distortionK1 distortionK2 distortionK3 distortionT1 distortionT2 \
         focalLength frameName hackBaseline imageTopicName triggerTopicName updateRate",
        "border_crop camera_name focal_length frame_name hack_baseline max_depth min_depth triggered update_rate",
    ),
    (
        "diff_drive",
        "commandTopic leftJoint legacyMode odometryFrame odometrySource odometryTopic publishOdomTF publishTf publishWheelJointState \
         publishWheelTF rightJoint robotBaseFrame updateRate wheelAcceleration wheelDiameter wheelSeparation wheelTorque",
        "covariance_x covariance_y covariance_yaw left_joint max_wheel_acceleration max_wheel_torque num_wheel_pairs odometry_frame \
         odometry_source publish_odom publish_odom_tf publish_wheel_tf right_joint robot_base_frame update_rate wheel_diameter \
         wheel_separation",
    ),
    (
        "imu_sensor",
        "frameName gaussianNoise initialOrientationAsReference rpyOffset topicName updateRateHZ xyzOffset",
        "frame_name initial_orientation_as_reference",
    ),
    (
        "joint_state_publisher",
        "jointName updateRate",
        "joint_name update_rate",
    ),
    (
        "planar_move",
        "cmdTimeout commandTopic enableYAxis odometryFrame odometryRate odometryTopic robotBaseFrame",
        "covariance_x covariance_y covariance_yaw odometry_frame publish_odom publish_odom_tf publish_rate robot_base_frame update_rate",
    ),
    (
        "skid_steer_drive",
        "broadcastTF commandTopic covariance_x covariance_y covariance_yaw leftFrontJoint leftRearJoint odometryFrame odometryTopic \
         rightFrontJoint rightRearJoint robotBaseFrame torque updateRate wheelDiameter wheelSeparation",
        "",
    ),
    (
        "tricycle_drive",
        "actuatedWheelDiameter actuatedWheelJoint commandTopic encoderWheelDiameter encoderWheelLeftJoint encoderWheelRightJoint \
         encoderWheelSeparation odometryFrame odometrySource odometryTopic publishWheelJointState publishWheelTF robotBaseFrame \
         steeringAngleTolerance steeringJoint steeringSpeed updateRate wheelAcceleration wheelDeceleration wheelSpeedTolerance \
         wheelTorque",
        "actuated_wheel_diameter actuated_wheel_joint encoder_wheel_diameter encoder_wheel_left_joint encoder_wheel_right_joint \
         max_steering_angle_tolerance max_steering_speed max_wheel_acceleration max_wheel_deceleration max_wheel_speed_tolerance \
         max_wheel_torque odometry_frame odometry_source publish_odom publish_wheel_joint_state publish_wheel_tf robot_base_frame \
         steering_joint update_rate wheel_separation",
    ),
];

/// What the plugins take for a parameter that they are not given: a wrong name with this value does no harm.
const DEFAULTS: [(&str, &str); 17] = [
    ("broadcastTF", "true"),
    ("commandTopic", "cmd_vel"),
    ("initial_position", "0"),
    ("joint_index", "0"),
    ("legacyMode", "true"),
    ("odom_publish_frequency", "50"),
    ("odometryFrame", "odom"),
    ("odometryTopic", "odom"),
    ("odometry_frame", "odom"),
    ("publishOdomTF", "true"),
    ("publishTf", "true"),
    ("publishWheelJointState", "false"),
    ("publishWheelTF", "false"),
    ("publish_odom", "false"),
    ("publish_odom_tf", "false"),
    ("publish_wheel_tf", "false"),
    ("robotBaseFrame", "base_footprint"),
];

/// A plugin that is known, with what it reads.
pub(super) struct KnownPlugin {
    /// The parameters in ROS 1 and in ROS 2, or of a system of gz-sim.
    names: [&'static str; 2],
    /// The ROS that it is for, where that is known.
    version: Option<RosVersion>,
    /// Whether it is a system of gz-sim.
    is_system: bool,
}

impl KnownPlugin {
    /// The plugin of a library, in a package for a version of ROS.
    pub(super) fn of(library: &str, version: Option<RosVersion>) -> Option<Self> {
        let name = library.strip_prefix("lib").unwrap_or(library);
        let name = name.strip_suffix(".so").unwrap_or(name);
        if let Some(ending) = name.strip_prefix("gazebo_ros_") {
            let (_, ros1, ros2) = CLASSIC.iter().find(|(known, ..)| *known == ending)?;
            return Some(Self {
                names: [ros1, ros2],
                version,
                is_system: false,
            });
        }
        let rest = ["gz-sim", "ignition-gazebo"]
            .into_iter()
            .find_map(|start| name.strip_prefix(start))?;
        let system = rest.trim_start_matches(|c: char| c.is_ascii_digit());
        let system = system.strip_prefix('-')?.strip_suffix("-system")?;
        let (_, names) = SYSTEMS.iter().find(|(known, _)| *known == system)?;
        Some(Self {
            names: [names, ""],
            version: None,
            is_system: true,
        })
    }

    /// What it reads that a name may be meant for: of a plugin for no ROS in particular, those that are written in the same way.
    pub(super) fn names_like(&self, name: &str) -> impl Iterator<Item = &'static str> {
        let is_any = self.version.is_some() || self.is_system;
        let is_of_ros1 = name.contains(char::is_uppercase);
        self.names()
            .filter(move |known| is_any || known.contains(char::is_uppercase) == is_of_ros1)
    }

    /// What it reads.
    pub(super) fn names(&self) -> impl Iterator<Item = &'static str> + Clone + use<> {
        let [ros1, ros2] = self.names;
        let (first, second) = match self.version {
            Some(RosVersion::Ros1) => (ros1, ""),
            Some(RosVersion::Ros2) => (ros2, ""),
            None => (ros1, ros2),
        };
        first.split_whitespace().chain(second.split_whitespace())
    }

    /// Whether it reads a parameter, in any release: another rule is about those of ROS 1.
    pub(super) fn may_read(&self, name: &str) -> bool {
        const OF_ALL: [&str; 9] = [
            "alwaysOn",
            "always_on",
            "namespace",
            "robotNamespace",
            "ros",
            "rosDebugLevel",
            "updateRate",
            "update_rate",
            "visualize",
        ];
        let mut all = self.names.iter().flat_map(|names| names.split_whitespace());
        OF_ALL.contains(&name) || all.any(|known| known == name)
    }

    /// What a system calls a parameter that the plugin for Gazebo Classic calls otherwise.
    pub(super) fn instead_of(&self, name: &str) -> Option<&'static str> {
        let mut all = CLASSIC_NAMES.iter().filter(|_| self.is_system);
        let (_, new) = all.find(|(old, _)| *old == name)?;
        self.names().find(|known| known == new)
    }
}

/// Whether a parameter has this value where it is not given.
pub(super) fn is_default(parameter: &str, value: &str) -> bool {
    let mut defaults = DEFAULTS.iter().filter(|(name, _)| *name == parameter);
    let default = defaults.next().map(|(_, default)| *default);
    let is_same = |default: &str| {
        let numbers = (default.parse::<f64>(), value.parse::<f64>());
        let is_flag = matches!((default, value), ("true", "1") | ("false", "0"));
        is_flag
            || default.eq_ignore_ascii_case(value)
            || matches!(numbers, (Ok(default), Ok(value)) if default == value)
    };
    default.is_some_and(is_same)
}

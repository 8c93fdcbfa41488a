//! Rules that others than the rules themselves speak about.
use super::rule::Rule;
use super::{
    control, conventions, frames, geometry, inertia, joint, linter, moveit, package, srdf,
    structure, xacro, xml,
};

/// `gazebo-unknown-reference`
pub const GAZEBO_UNKNOWN_REFERENCE: &Rule = &control::gazebo_unknown_reference::RULE;
/// `sensor-without-frame`
pub const SENSOR_WITHOUT_FRAME: &Rule = &control::sensor_without_frame::RULE;
/// `controller-without-parameters`
pub const CONTROLLER_WITHOUT_PARAMETERS: &Rule = &control::controller_without_parameters::RULE;
/// `kinematics-unknown-group`
pub const KINEMATICS_UNKNOWN_GROUP: &Rule = &moveit::kinematics_unknown_group::RULE;
/// `moveit-unknown-controller`
pub const MOVEIT_UNKNOWN_CONTROLLER: &Rule = &moveit::moveit_unknown_controller::RULE;
/// `srdf-unknown-group`
pub const SRDF_UNKNOWN_GROUP: &Rule = &srdf::srdf_unknown_group::RULE;
/// `safety-limits-outside-limits`
pub const SAFETY_LIMITS_OUTSIDE_LIMITS: &Rule = &joint::safety_limits_outside_limits::RULE;
/// `unknown-root-element`
pub const UNKNOWN_ROOT_ELEMENT: &Rule = &xml::unknown_root_element::RULE;
/// `srdf-robot-name`
pub const SRDF_ROBOT_NAME: &Rule = &srdf::srdf_robot_name::RULE;
/// `srdf-unknown-link`
pub const SRDF_UNKNOWN_LINK: &Rule = &srdf::srdf_unknown_link::RULE;
/// `transmission-unknown-joint`
pub const TRANSMISSION_UNKNOWN_JOINT: &Rule = &control::transmission_unknown_joint::RULE;
/// `ascii-stl`
pub const ASCII_STL: &Rule = &geometry::ascii_stl::RULE;
/// `binary-stl-solid-header`
pub const BINARY_STL_SOLID_HEADER: &Rule = &geometry::binary_stl_solid_header::RULE;
/// `undefined-material`
pub const UNDEFINED_MATERIAL: &Rule = &geometry::undefined_material::RULE;
/// `unknown-geometry-type`
pub const UNKNOWN_GEOMETRY_TYPE: &Rule = &geometry::unknown_geometry_type::RULE;
/// `inertia-not-positive-definite`
pub const INERTIA_NOT_POSITIVE_DEFINITE: &Rule = &inertia::inertia_not_positive_definite::RULE;
/// `missing-xacro-namespace`
pub const MISSING_XACRO_NAMESPACE: &Rule = &xml::missing_xacro_namespace::RULE;
/// `leading-slash-name`
pub const LEADING_SLASH_NAME: &Rule = &conventions::leading_slash_name::RULE;
/// `missing-element`
pub const MISSING_ELEMENT: &Rule = &xml::missing_element::RULE;
/// `inertia-triangle-inequality`
pub const INERTIA_TRIANGLE_INEQUALITY: &Rule = &inertia::inertia_triangle_inequality::RULE;
/// `missing-joint-limit`
pub const MISSING_JOINT_LIMIT: &Rule = &joint::missing_joint_limit::RULE;
/// `missing-limit-attribute`
pub const MISSING_LIMIT_ATTRIBUTE: &Rule = &joint::missing_limit_attribute::RULE;
/// `joint-limit-negative`
pub const JOINT_LIMIT_NEGATIVE: &Rule = &joint::joint_limit_negative::RULE;
/// `missing-robot-name`
pub const MISSING_ROBOT_NAME: &Rule = &xml::missing_robot_name::RULE;
/// `reserved-frame-name`
pub const RESERVED_FRAME_NAME: &Rule = &frames::reserved_frame_name::RULE;
/// `invalid-name`
pub const INVALID_NAME: &Rule = &conventions::invalid_name::RULE;
/// `ros2-control-duplicate-joint`
pub const ROS2_CONTROL_DUPLICATE_JOINT: &Rule = &control::ros2_control_duplicate_joint::RULE;
/// `mimic-range-exceeds-limits`
pub const MIMIC_RANGE_EXCEEDS_LIMITS: &Rule = &joint::mimic_range_exceeds_limits::RULE;
/// `zero-axis`
pub const ZERO_AXIS: &Rule = &joint::zero_axis::RULE;
/// `invalid-config`
pub const INVALID_CONFIG: &Rule = &linter::invalid_config::RULE;
/// `unused-suppression`
pub const UNUSED_SUPPRESSION: &Rule = &linter::unused_suppression::RULE;
/// `generated-urdf-out-of-date`
pub const GENERATED_URDF_OUT_OF_DATE: &Rule = &package::generated_urdf_out_of_date::RULE;
/// `duplicate-joint-name`
pub const DUPLICATE_JOINT_NAME: &Rule = &structure::duplicate_joint_name::RULE;
/// `undefined-link`
pub const UNDEFINED_LINK: &Rule = &structure::undefined_link::RULE;
/// `undefined-arg`
pub const UNDEFINED_ARG: &Rule = &xacro::found::UNDEFINED_ARG;
/// `undefined-macro`
pub const UNDEFINED_MACRO: &Rule = &xacro::found::UNDEFINED_MACRO;
/// `undefined-property`
pub const UNDEFINED_PROPERTY: &Rule = &xacro::found::UNDEFINED_PROPERTY;
/// `unknown-macro-param`
pub const UNKNOWN_MACRO_PARAM: &Rule = &xacro::unknown_macro_param::RULE;
/// `unknown-xacro-attribute`
pub const UNKNOWN_XACRO_ATTRIBUTE: &Rule = &xacro::unknown_xacro_attribute::RULE;
/// `unprefixed-macro-call`
pub const UNPREFIXED_MACRO_CALL: &Rule = &xacro::unprefixed_macro_call::RULE;
/// `unprefixed-xacro-tag`
pub const UNPREFIXED_XACRO_TAG: &Rule = &xacro::unprefixed_xacro_tag::RULE;
/// `description-read-as-yaml`
pub const DESCRIPTION_READ_AS_YAML: &Rule = &package::description_read_as_yaml::RULE;
/// `missing-package-dependency`
pub const MISSING_PACKAGE_DEPENDENCY: &Rule = &package::missing_package_dependency::RULE;
/// `package-not-found`
pub const PACKAGE_NOT_FOUND: &Rule = &package::package_not_found::RULE;
/// `unknown-launch-argument`
pub const UNKNOWN_LAUNCH_ARGUMENT: &Rule = &package::unknown_launch_argument::RULE;
/// `missing-dollar`
pub const MISSING_DOLLAR: &Rule = &xacro::missing_dollar::RULE;
/// `invalid-number`
pub const INVALID_NUMBER: &Rule = &xml::invalid_number::RULE;
/// `absolute-mesh-path`
pub const ABSOLUTE_MESH_PATH: &Rule = &geometry::absolute_mesh_path::RULE;
/// `dropped-root-element`
pub const DROPPED_ROOT_ELEMENT: &Rule = &xacro::dropped_root_element::RULE;
/// `plugin-unknown-frame`
pub const PLUGIN_UNKNOWN_FRAME: &Rule = &control::plugin_unknown_frame::RULE;
/// `plugin-file-not-found`
pub const PLUGIN_FILE_NOT_FOUND: &Rule = &control::plugin_file_not_found::RULE;
/// `mesh-path-without-scheme`
pub const MESH_PATH_WITHOUT_SCHEME: &Rule = &geometry::mesh_path_without_scheme::RULE;
/// `mesh-not-found`
pub const MESH_NOT_FOUND: &Rule = &geometry::mesh_not_found::RULE;
/// `missing-attribute`
pub const MISSING_ATTRIBUTE: &Rule = &xml::missing_attribute::RULE;
/// `unknown-attribute`
pub const UNKNOWN_ATTRIBUTE: &Rule = &xml::unknown_attribute::RULE;
/// `unknown-element`
pub const UNKNOWN_ELEMENT: &Rule = &xml::unknown_element::RULE;
/// `wrong-vector-length`
pub const WRONG_VECTOR_LENGTH: &Rule = &xml::wrong_vector_length::RULE;
/// `xacro-tags-in-urdf`
pub const XACRO_TAGS_IN_URDF: &Rule = &xml::xacro_tags_in_urdf::RULE;
/// `xml-encoding-mismatch`
pub const XML_ENCODING_MISMATCH: &Rule = &xml::XML_ENCODING_MISMATCH;
/// `xml-syntax-error`
pub const XML_SYNTAX_ERROR: &Rule = &xml::xml_syntax_error::RULE;

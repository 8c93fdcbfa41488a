//! Blocks beside the links and joints: Gazebo, ros2_control, transmissions. Other tools read these; the table
//! lists what is usual.
use super::spec::AttributeKind::{Choice, Joint, LinkOrJoint, Name, Number, Text, Uri};
use super::spec::ContentModel::{Elements, Free, Text as Characters};
use super::spec::{AttributeKind, AttributeSpec, ElementSpec};

const fn el(
    name: &'static str,
    parents: &'static [&'static str],
    docs: &'static str,
) -> ElementSpec {
    ElementSpec::new(name, parents, docs).holding(Free)
}

const fn at(name: &'static str, kind: AttributeKind, docs: &'static str) -> AttributeSpec {
    AttributeSpec::new(name, kind, docs)
}

/// The kinds of hardware of ros2_control.
const HARDWARE: &[&str] = &["system", "actuator", "sensor"];

const INTERFACES: &[&str] = &["ros2_control/joint", "ros2_control/sensor", "gpio"];

const PARAMETERS: &[&str] = &[
    "hardware",
    "ros2_control/joint",
    "ros2_control/sensor",
    "gpio",
    "command_interface",
    "state_interface",
];

const GEARS: &[&str] = &["transmission/joint", "actuator"];

const TRUTH: &[&str] = &["true", "false"];

/// The elements, parents before children.
pub(super) static ELEMENTS: &[ElementSpec] = &[
    el(
        "gazebo",
        &["robot"],
        "Extensions for Gazebo; its content is SDF",
    )
    .with(&[at(
        "reference",
        LinkOrJoint,
        "The link or joint the content applies to; the whole robot if missing",
    )])
    .many(),
    el("mujoco", &["robot"], "Settings for MuJoCo's compiler").many(),
    el(
        "ros2_control",
        &["robot"],
        "A hardware component and its interfaces",
    )
    .with(&[
        at("name", Name, "The name of the component").required(),
        at("type", Choice(HARDWARE), "The type of the component").required(),
        at("rw_rate", Number, "Update rate").unit("Hz"),
        at(
            "is_async",
            Choice(TRUTH),
            "Whether it runs in a separate thread",
        )
        .default("false"),
        at("thread_priority", Number, "The priority of that thread"),
    ])
    .many()
    .holding(Elements),
    el(
        "transmission",
        &["robot", "ros2_control"],
        "A transmission between actuator and joint",
    )
    .with(&[at("name", Name, "The name of the transmission")])
    .many(),
    el("plugin", &["gazebo"], "A library that Gazebo loads")
        .with(&[
            at("name", Name, "The name of the plugin").required(),
            at("filename", Uri, "The library").required(),
        ])
        .many(),
    el("sensor", &["gazebo"], "A simulated sensor")
        .with(&[
            at("name", Name, "The name of the sensor").required(),
            at("type", Text, "The kind of sensor").required(),
        ])
        .many(),
    el(
        "hardware",
        &["ros2_control"],
        "The hardware plugin and its parameters",
    ),
    el("joint", &["ros2_control"], "The interfaces of a joint")
        .keyed("ros2_control/joint")
        .with(&[
            at("name", Joint, "The joint of the robot").required(),
            at(
                "mimic",
                Choice(TRUTH),
                "Whether the joint mimics another one",
            ),
        ])
        .many(),
    el("sensor", &["ros2_control"], "The interfaces of a sensor")
        .keyed("ros2_control/sensor")
        .with(&[at("name", Name, "The name of the sensor").required()])
        .many(),
    el(
        "gpio",
        &["ros2_control"],
        "The interfaces of inputs and outputs",
    )
    .with(&[at("name", Name, "The name of the group").required()])
    .many(),
    el("plugin", &["hardware"], "The class of the driver").holding(Characters),
    el(
        "group",
        &["hardware"],
        "A group of components with a common error state",
    )
    .holding(Characters),
    el("param", PARAMETERS, "A parameter")
        .with(&[at("name", Name, "The name of the parameter").required()])
        .many()
        .holding(Characters),
    el(
        "command_interface",
        INTERFACES,
        "A value that controllers write",
    )
    .with(INTERFACE)
    .many(),
    el(
        "state_interface",
        INTERFACES,
        "A value that controllers read",
    )
    .with(INTERFACE)
    .many(),
    el(
        "type",
        &["transmission"],
        "The class of a transmission of ROS 1",
    )
    .holding(Characters),
    el(
        "plugin",
        &["transmission"],
        "The class of a transmission of ROS 2",
    )
    .holding(Characters),
    el("joint", &["transmission"], "The driven joint")
        .keyed("transmission/joint")
        .with(&[
            at("name", Joint, "The joint of the robot").required(),
            at("role", Text, "The role of the joint in the transmission"),
        ])
        .many(),
    el("actuator", &["transmission"], "The driving actuator")
        .with(&[
            at("name", Name, "The name of the actuator").required(),
            at("role", Text, "The role of the actuator in the transmission"),
        ])
        .many(),
    el("hardwareInterface", GEARS, "Its ROS 1 hardware interface")
        .many()
        .holding(Characters),
    el(
        "mechanicalReduction",
        GEARS,
        "Rotations of the actuator per rotation of the joint",
    )
    .holding(Characters),
    el("offset", GEARS, "The position at the actuator's zero").holding(Characters),
];

/// The attributes of an interface.
const INTERFACE: &[AttributeSpec] = &[
    at(
        "name",
        Name,
        "position, velocity, acceleration, effort, or a custom name",
    )
    .required(),
    at("data_type", Text, "The type of the value").default("double"),
    at("size", Number, "How many values of this kind there are").default("1"),
];

//! The elements of SRDF, which MoveIt reads beside the URDF.
//! Source: the parser of `srdfdom`.
use super::spec::AttributeKind::{Choice, Group, Joint, Link, Name, Number, Text, Vector};
use super::spec::{AttributeKind, AttributeSpec, ElementSpec};

const fn el(
    name: &'static str,
    parents: &'static [&'static str],
    docs: &'static str,
) -> ElementSpec {
    ElementSpec::new(name, parents, docs).many()
}

const fn at(name: &'static str, kind: AttributeKind, docs: &'static str) -> AttributeSpec {
    AttributeSpec::new(name, kind, docs)
}

const TOP: &[&str] = &["srdf"];
const IN_GROUP: &[&str] = &["srdf/group"];

/// Why the collisions of two links are not checked, as the setup assistant of MoveIt writes it.
const REASONS: &[&str] = &["Adjacent", "Never", "Default", "Always", "User"];

/// The types of virtual joints.
const VIRTUAL: &[&str] = &["fixed", "planar", "floating"];

const PAIR: &[AttributeSpec] = &[
    at("link1", Link, "One of the links").required(),
    at("link2", Link, "The other link").required(),
    at("reason", Choice(REASONS), "Why; MoveIt ignores it"),
];

/// The root.
pub(super) static ROBOT: ElementSpec = ElementSpec::new(
    "robot",
    &[],
    "The semantic description of a robot: groups, states and collisions",
)
.keyed("srdf")
.with(&[at("name", Name, "The name of the robot, as in the URDF").required()]);

/// The elements inside of it, parents before children.
pub(super) static ELEMENTS: &[ElementSpec] = &[
    el(
        "group",
        TOP,
        "A planning group: joints that are planned together",
    )
    .keyed("srdf/group")
    .with(&[at("name", Name, "The name of the group").required()]),
    el(
        "link",
        IN_GROUP,
        "A link of the group, with its parent joint",
    )
    .keyed("srdf/link")
    .with(&[at("name", Link, "The link").required()]),
    el(
        "joint",
        IN_GROUP,
        "A joint of the group, with its child link",
    )
    .keyed("srdf/joint")
    .with(&[at("name", Joint, "The joint").required()]),
    el("chain", IN_GROUP, "All joints between two links")
        .keyed("srdf/chain")
        .with(&[
            at("base_link", Link, "The link that the chain begins at").required(),
            at("tip_link", Link, "The link below it that the chain ends at").required(),
        ]),
    el(
        "group",
        IN_GROUP,
        "Another group; its joints belong to this one, too",
    )
    .keyed("srdf/subgroup")
    .with(&[at("name", Group, "The other group").required()]),
    el("group_state", TOP, "A named state of a group")
        .keyed("srdf/group_state")
        .with(&[
            at("name", Name, "The name of the state").required(),
            at("group", Group, "The group").required(),
        ]),
    el("joint", &["srdf/group_state"], "The position of a joint")
        .keyed("srdf/group_state/joint")
        .with(&[
            at("name", Joint, "The joint").required(),
            at("value", Number, "Its position")
                .required()
                .unit("rad or m"),
        ]),
    el(
        "end_effector",
        TOP,
        "A group that is mounted on another one, such as a gripper",
    )
    .keyed("srdf/end_effector")
    .with(&[
        at("name", Name, "The name of the end effector").required(),
        at("parent_link", Link, "The link that it is mounted on").required(),
        at("group", Group, "The group of its own joints").required(),
        at("parent_group", Group, "The group that it is mounted on"),
    ]),
    el("virtual_joint", TOP, "How the root link moves in the world")
        .keyed("srdf/virtual_joint")
        .with(&[
            at("name", Name, "The name of the joint").required(),
            at("type", Choice(VIRTUAL), "The type of motion").required(),
            at("parent_frame", Text, "The frame of the world").required(),
            at("child_link", Link, "The root link of the robot").required(),
        ]),
    el("passive_joint", TOP, "A joint that nothing drives")
        .keyed("srdf/passive_joint")
        .with(&[at("name", Joint, "The joint").required()]),
    el(
        "disable_collisions",
        TOP,
        "Two links whose collisions are not checked",
    )
    .keyed("srdf/disable_collisions")
    .with(PAIR),
    el(
        "enable_collisions",
        TOP,
        "Two links whose collisions are checked, whatever the default",
    )
    .keyed("srdf/enable_collisions")
    .with(PAIR),
    el(
        "disable_default_collisions",
        TOP,
        "A link whose collisions are checked only where they are enabled",
    )
    .keyed("srdf/disable_default_collisions")
    .with(&[at("link", Link, "The link").required()]),
    el(
        "link_sphere_approximation",
        TOP,
        "Spheres that stand for the shape of a link",
    )
    .keyed("srdf/link_sphere_approximation")
    .with(&[at("link", Link, "The link").required()]),
    el(
        "sphere",
        &["srdf/link_sphere_approximation"],
        "One of the spheres",
    )
    .keyed("srdf/sphere")
    .with(&[
        at("center", Vector(3), "Its center in the frame of the link")
            .required()
            .unit("m"),
        at("radius", Number, "Its radius").required().unit("m"),
    ]),
    el(
        "joint_property",
        TOP,
        "A property of a joint that planners read",
    )
    .keyed("srdf/joint_property")
    .with(&[
        at("joint_name", Joint, "The joint").required(),
        at("property_name", Text, "The name of the property").required(),
        at("value", Text, "Its value").required(),
    ]),
];

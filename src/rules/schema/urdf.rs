//! The elements that every reader of URDF knows.
use super::spec::AttributeKind::{Choice, Joint, Link, Name, Number, Text, Uri, Vector};
use super::spec::ContentModel::Free;
use super::spec::{AttributeKind, AttributeSpec, ElementSpec};
use model::Version;

const fn el(
    name: &'static str,
    parents: &'static [&'static str],
    docs: &'static str,
) -> ElementSpec {
    ElementSpec::new(name, parents, docs)
}

const fn at(name: &'static str, kind: AttributeKind, docs: &'static str) -> AttributeSpec {
    AttributeSpec::new(name, kind, docs)
}

/// The types of joints.
const JOINT_TYPES: &[&str] = &[
    "revolute",
    "continuous",
    "prismatic",
    "fixed",
    "floating",
    "planar",
];

/// The versions that urdfdom 6 reads.
const VERSIONS: &[&str] = &["1.0", "1.1", "1.2"];

const SHAPES: &[&str] = &["geometry"];

/// The root.
pub(super) static ROBOT: ElementSpec = el(
    "robot",
    &[],
    "The description of a robot: links, and the joints between them",
)
.with(&[
    at("name", Name, "The name of the robot").required(),
    at(
        "version",
        Choice(VERSIONS),
        "The URDF version; urdfdom before 5.1 accepts only 1.0",
    )
    .default("1.0"),
]);

/// The elements inside of it, parents before children.
pub(super) static ELEMENTS: &[ElementSpec] = &[
    el("link", &["robot"], "A rigid body with its own frame")
        .with(&[
            at("name", Name, "The name of the link and of its frame").required(),
            at("type", Text, "A kind of link; parsers ignore it"),
        ])
        .many(),
    el(
        "joint",
        &["robot"],
        "How a child link moves relative to a parent link",
    )
    .with(&[
        at("name", Name, "The name of the joint").required(),
        at("type", Choice(JOINT_TYPES), "The type of motion").required(),
    ])
    .needs(&["parent", "child"])
    .many(),
    el(
        "material",
        &["robot"],
        "A color or texture that visuals refer to by name",
    )
    .with(&[at("name", Name, "The name that visuals refer to").required()])
    .many(),
    el("parent", &["joint"], "The parent link of the joint").with(&[at(
        "link",
        Link,
        "The name of the parent link",
    )
    .required()]),
    el("child", &["joint"], "The child link of the joint").with(&[at(
        "link",
        Link,
        "The name of the child link",
    )
    .required()]),
    el(
        "origin",
        &["joint"],
        "The pose of the child frame in the parent frame at position zero",
    )
    .with(POSE),
    el(
        "axis",
        &["joint"],
        "The axis of rotation or translation, in the joint's frame",
    )
    .with(&[at("xyz", Vector(3), "The direction, of length 1").default("1 0 0")]),
    el(
        "limit",
        &["joint"],
        "Position, velocity and effort limits of the joint",
    )
    .with(&[
        at("lower", Number, "The lowest position")
            .unit("rad or m")
            .default("0"),
        at("upper", Number, "The highest position")
            .unit("rad or m")
            .default("0"),
        at(
            "effort",
            Number,
            "Maximum torque or force; required before URDF 1.2",
        )
        .unit("N m or N"),
        at(
            "velocity",
            Number,
            "Maximum velocity; required before URDF 1.2",
        )
        .unit("rad/s or m/s"),
        at(
            "acceleration",
            Number,
            "Maximum acceleration; since URDF 1.2",
        )
        .unit("rad/s² or m/s²")
        .since(Version::V1_2),
        at(
            "deceleration",
            Number,
            "Maximum deceleration; since URDF 1.2",
        )
        .unit("rad/s² or m/s²")
        .since(Version::V1_2),
        at("jerk", Number, "Maximum jerk; since URDF 1.2")
            .unit("rad/s³ or m/s³")
            .since(Version::V1_2),
    ]),
    el(
        "dynamics",
        &["joint"],
        "Damping and friction of the joint, for simulators",
    )
    .with(&[
        at("damping", Number, "Viscous damping")
            .unit("N m s/rad or N s/m")
            .default("0"),
        at("friction", Number, "Static friction")
            .unit("N m or N")
            .default("0"),
    ]),
    el(
        "mimic",
        &["joint"],
        "The joint mimics another one: multiplier * position + offset",
    )
    .with(&[
        at("joint", Joint, "The joint to mimic").required(),
        at(
            "multiplier",
            Number,
            "Factor on the position of the other joint",
        )
        .default("1"),
        at("offset", Number, "Added to the product")
            .unit("rad or m")
            .default("0"),
    ]),
    el(
        "calibration",
        &["joint"],
        "Reference positions that the joint is calibrated with",
    )
    .with(&[
        at(
            "rising",
            Number,
            "Position of a rising edge when moving in positive direction",
        )
        .unit("rad or m"),
        at(
            "falling",
            Number,
            "Position of a falling edge when moving in positive direction",
        )
        .unit("rad or m"),
        at(
            "reference_position",
            Number,
            "Older name of the position of the edge",
        )
        .unit("rad or m"),
    ]),
    el(
        "safety_controller",
        &["joint"],
        "Soft limits inside the hard limits",
    )
    .with(&[
        at(
            "soft_lower_limit",
            Number,
            "Position at which the controller starts to limit the joint",
        )
        .unit("rad or m")
        .default("0"),
        at(
            "soft_upper_limit",
            Number,
            "Position at which the controller starts to limit the joint",
        )
        .unit("rad or m")
        .default("0"),
        at(
            "k_position",
            Number,
            "Gain from position to the limits of speed",
        )
        .unit("1/s")
        .default("0"),
        at(
            "k_velocity",
            Number,
            "Gain from speed to the limits of effort",
        )
        .unit("N m s/rad or N s/m")
        .required(),
    ]),
    el(
        "inertial",
        &["link"],
        "Mass, center of mass and moments of inertia of the link",
    )
    .needs(&["mass", "inertia"]),
    el(
        "visual",
        &["link"],
        "Visual geometry; a link can have several",
    )
    .with(&[at("name", Name, "A name of this part of the geometry")])
    .needs(&["geometry"])
    .many(),
    el(
        "collision",
        &["link"],
        "Collision geometry; a link can have several",
    )
    .with(&[at("name", Name, "A name of this part of the geometry")])
    .needs(&["geometry"])
    .many(),
    el(
        "origin",
        &["inertial"],
        "The pose of the center of mass in the link frame",
    )
    .with(POSE),
    el("mass", &["inertial"], "The mass of the link")
        .with(&[at("value", Number, "The mass").unit("kg").required()]),
    el(
        "inertia",
        &["inertial"],
        "Moments of inertia about the center of mass",
    )
    .with(&[
        at("ixx", Number, "Moment about x").unit("kg m²").required(),
        at("ixy", Number, "Product of x and y")
            .unit("kg m²")
            .required(),
        at("ixz", Number, "Product of x and z")
            .unit("kg m²")
            .required(),
        at("iyy", Number, "Moment about y").unit("kg m²").required(),
        at("iyz", Number, "Product of y and z")
            .unit("kg m²")
            .required(),
        at("izz", Number, "Moment about z").unit("kg m²").required(),
    ]),
    el(
        "origin",
        &["visual", "collision"],
        "The pose of the geometry in the link frame",
    )
    .with(POSE),
    el(
        "geometry",
        &["visual", "collision"],
        "The shape: one of box, cylinder, sphere or mesh; capsule since URDF 1.1",
    ),
    el(
        "material",
        &["visual"],
        "Color or texture of the visual; if empty, the material of the robot with this name",
    )
    .with(&[at("name", Name, "The name of the material").required()]),
    el("box", SHAPES, "A box around the origin").with(&[at(
        "size",
        Vector(3),
        "Full lengths along x, y and z",
    )
    .unit("m")
    .required()]),
    el("cylinder", SHAPES, "A cylinder around the origin, along z").with(&[
        at("radius", Number, "Its radius").unit("m").required(),
        at("length", Number, "Its full length").unit("m").required(),
    ]),
    el("sphere", SHAPES, "A sphere around the origin")
        .with(&[at("radius", Number, "Its radius").unit("m").required()]),
    el(
        "capsule",
        SHAPES,
        "A cylinder along z with half spheres at its ends; since URDF 1.1",
    )
    .with(&[
        at("radius", Number, "Its radius").unit("m").required(),
        at("length", Number, "The length of the cylinder")
            .unit("m")
            .required(),
    ]),
    el("mesh", SHAPES, "A triangle mesh: STL, Collada, OBJ").with(&[
        at(
            "filename",
            Uri,
            "The mesh file, preferably package://PACKAGE/PATH",
        )
        .required(),
        at("scale", Vector(3), "Factors along x, y and z").default("1 1 1"),
    ]),
    el("color", &["material"], "A color").with(&[at(
        "rgba",
        Vector(4),
        "Red, green, blue and opacity, each from 0 to 1",
    )]),
    el("texture", &["material"], "An image on the surface").with(&[at(
        "filename",
        Uri,
        "The image file, preferably package://PACKAGE/PATH",
    )]),
    el(
        "sensor",
        &["robot", "link"],
        "A sensor; URDF parsers ignore it",
    )
    .with(&[
        at("name", Name, "The name of the sensor"),
        at("type", Text, "The kind of sensor"),
        at("update_rate", Number, "Measurements per second").unit("Hz"),
    ])
    .many()
    .holding(Free),
];

/// The attributes of an `origin`.
const POSE: &[AttributeSpec] = &[
    at("xyz", Vector(3), "Translation along x, y and z")
        .unit("m")
        .default("0 0 0"),
    at(
        "rpy",
        Vector(3),
        "Roll, pitch and yaw about the fixed axes x, y and z",
    )
    .unit("rad")
    .default("0 0 0"),
    at(
        "quat_xyzw",
        Vector(4),
        "Rotation as a quaternion x y z w, instead of rpy; since URDF 1.1",
    )
    .since(Version::V1_1),
];

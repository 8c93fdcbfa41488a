//! The robot as a viewer needs it: plain numbers and names, each with the place it comes from.

use std::collections::BTreeMap;

use serde::Serialize;

use super::files::MeshFile;
use super::locations::{Location, LocationMapper};
use super::shapes::{ShapeModel, Shapes};
use expand::XId;
use model::{self, Robot, tag_start};

/// Meters, and radians about fixed axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PoseModel {
    /// The translation.
    pub xyz: [f64; 3],
    /// Roll, pitch and yaw.
    pub rpy: [f64; 3],
}

impl PoseModel {
    /// The pose of an origin; what is absent or unknown is zero.
    pub(super) fn of(origin: Option<&model::Pose>) -> Self {
        let Some(origin) = origin else {
            return Self::default();
        };
        Self {
            xyz: origin.translation().unwrap_or_default(),
            rpy: origin.angles().unwrap_or_default(),
        }
    }
}

/// A robot.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Model {
    /// Its name.
    pub robot: String,
    /// Its links in document order.
    pub links: Vec<LinkModel>,
    /// Its joints in document order.
    pub joints: Vec<JointModel>,
    /// The files of its meshes and textures, by opaque id.
    pub meshes: BTreeMap<String, MeshFile>,
}

/// A link with what is drawn of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LinkModel {
    /// Its name.
    pub name: String,
    /// Its inertia.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inertial: Option<InertialModel>,
    /// What is seen of it.
    pub visuals: Vec<BodyModel>,
    /// What it collides with.
    pub collisions: Vec<BodyModel>,
    /// Where its element starts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Location>,
    /// The outermost macro call that made it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub call: Option<Location>,
}

/// A visual or a collision.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodyModel {
    /// Its name, which most visuals do not have.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Where it stands in its link.
    pub pose: PoseModel,
    /// Its shape, in the frame of `pose`.
    pub shape: ShapeModel,
    /// Red, green, blue and opacity, 0 to 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub color: Option<[f64; 4]>,
    /// Id of the file of its texture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub texture: Option<String>,
    /// Where its element starts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Location>,
}

/// An inertia, about the center of mass.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InertialModel {
    /// The frame of the inertia in the link; its translation is the center of mass.
    pub pose: PoseModel,
    /// kg
    pub mass: f64,
    /// `ixx ixy ixz iyy iyz izz`, kg m^2.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inertia: Option<[f64; 6]>,
}

/// A joint, as far as it moves what is drawn.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JointModel {
    /// Its name.
    pub name: String,
    /// Its type; `fixed` where it is not one of URDF's.
    #[serde(rename = "type")]
    pub kind: String,
    /// The link it hangs on.
    pub parent: String,
    /// The link that hangs on it.
    pub child: String,
    /// Where the child stands in the parent at position zero.
    pub pose: PoseModel,
    /// Its axis, in the frame of the joint.
    pub axis: [f64; 3],
    /// How far it goes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<LimitModel>,
    /// Which joint it goes with.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mimic: Option<MimicModel>,
    /// Where its element starts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Location>,
    /// The outermost macro call that made it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub call: Option<Location>,
}

/// Radians or meters, N m or N, rad/s or m/s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[allow(missing_docs)]
pub struct LimitModel {
    pub lower: f64,
    pub upper: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub effort: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity: Option<f64>,
}

/// Position = multiplier * position of the joint + offset.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[allow(missing_docs)]
pub struct MimicModel {
    pub joint: String,
    pub multiplier: f64,
    pub offset: f64,
}

/// Make the model of a robot. Links without a name and joints without known ends are left out.
pub(super) fn model(robot: &Robot, places: &LocationMapper<'_>, shapes: &mut Shapes<'_>) -> Model {
    let links = robot
        .links
        .iter()
        .filter_map(|link| one_link(link, places, shapes))
        .collect();
    let joints = robot
        .joints
        .iter()
        .filter_map(|joint| one_joint(joint, places))
        .collect();
    let name = robot.name.as_ref().map_or("", |name| name.value.as_str());
    Model {
        robot: name.to_owned(),
        links,
        joints,
        meshes: shapes.take_files(),
    }
}

fn start(places: &LocationMapper<'_>, element: XId) -> Option<Location> {
    places.of(tag_start(places.expansion, element))
}

fn call(places: &LocationMapper<'_>, element: XId) -> Option<Location> {
    places.call(places.expansion.tree.get(element).origin)
}

fn one_link(
    link: &model::Link,
    places: &LocationMapper<'_>,
    shapes: &mut Shapes<'_>,
) -> Option<LinkModel> {
    let inertial = link.inertial.as_ref().and_then(|inertial| {
        let pose = PoseModel::of(inertial.origin.as_ref());
        Some(InertialModel {
            pose,
            mass: inertial.mass()?,
            inertia: inertial.entries(),
        })
    });
    Some(LinkModel {
        name: link.name.as_ref()?.name()?.to_string(),
        inertial,
        visuals: bodies(&link.visuals, true, places, shapes),
        collisions: bodies(&link.collisions, false, places, shapes),
        origin: start(places, link.element),
        call: call(places, link.element),
    })
}

fn bodies(
    list: &[model::Body],
    seen: bool,
    places: &LocationMapper<'_>,
    shapes: &mut Shapes<'_>,
) -> Vec<BodyModel> {
    list.iter()
        .map(|body| one_body(body, seen, places, shapes))
        .collect()
}

fn one_body(
    body: &model::Body,
    seen: bool,
    places: &LocationMapper<'_>,
    shapes: &mut Shapes<'_>,
) -> BodyModel {
    let look = if seen {
        shapes.look(body.material.as_deref())
    } else {
        Default::default()
    };
    BodyModel {
        name: body
            .name
            .as_ref()
            .and_then(|name| Some(name.name()?.to_string())),
        pose: PoseModel::of(body.origin.as_ref()),
        shape: shapes.shape(body),
        color: look.color,
        texture: look.texture,
        origin: start(places, body.element),
    }
}

fn one_joint(joint: &model::Joint, places: &LocationMapper<'_>) -> Option<JointModel> {
    let (parent, child) = joint.ends()?;
    let limit = joint.limit.as_ref().and_then(|limit| {
        let (lower, upper) = limit.range()?;
        Some(LimitModel {
            lower,
            upper,
            effort: number(&limit.effort),
            velocity: number(&limit.velocity),
        })
    });
    let mimic = joint.mimic.as_ref().and_then(|mimic| {
        let leader = mimic.joint.as_ref()?.name()?.to_string();
        Some(MimicModel {
            joint: leader,
            multiplier: number(&mimic.multiplier).unwrap_or(1.0),
            offset: number(&mimic.offset).unwrap_or(0.0),
        })
    });
    let kind = joint.joint_type().and_then(|kind| {
        let mut known = model::JointType::ALL.iter();
        known.find(|(_, one)| *one == kind).map(|(name, _)| *name)
    });
    Some(JointModel {
        name: joint.name.as_ref()?.name()?.to_string(),
        kind: kind.unwrap_or("fixed").to_owned(),
        parent: parent.to_string(),
        child: child.to_string(),
        pose: PoseModel::of(joint.origin.as_ref()),
        axis: joint.axis().unwrap_or([1.0, 0.0, 0.0]),
        limit,
        mimic,
        origin: start(places, joint.element),
        call: call(places, joint.element),
    })
}

fn number(text: &Option<model::AttrValue>) -> Option<f64> {
    text.as_ref().and_then(model::AttrValue::number)
}

//! Where joints put the links.

use nalgebra::{Isometry3, Translation3, Unit, UnitQuaternion, Vector3};

use base::FastMap;
use preview::{JointModel, Model, PoseModel};

/// Joints that follow others, one after the other, at most.
const LONGEST_CHAIN: usize = 64;

/// Positions of joints that are not at zero, by name; radians or meters.
pub type Positions = FastMap<String, f64>;

/// Whether a joint has a position of its own.
pub fn movable(joint: &JointModel) -> bool {
    has_position(joint) && joint.mimic.is_none()
}

fn has_position(joint: &JointModel) -> bool {
    matches!(joint.kind.as_str(), "revolute" | "continuous" | "prismatic")
}

/// The position nearest to zero that a joint can have.
fn rest(joint: &JointModel) -> f64 {
    match &joint.limit {
        Some(limit) if joint.kind != "continuous" => 0.0f64
            .max(limit.lower.min(limit.upper))
            .min(limit.upper.max(limit.lower)),
        _ => 0.0,
    }
}

/// The position of a joint, which may follow others.
fn position(joint: &JointModel, joints: &FastMap<&str, &JointModel>, set: &Positions) -> f64 {
    let (mut factor, mut offset, mut at) = (1.0, 0.0, joint);
    for _ in 0..LONGEST_CHAIN {
        let Some(mimic) = &at.mimic else { break };
        offset += factor * mimic.offset;
        factor *= mimic.multiplier;
        let Some(leader) = joints.get(mimic.joint.as_str()) else {
            return offset;
        };
        at = leader;
    }
    offset + factor * set.get(&at.name).copied().unwrap_or_else(|| rest(at))
}

/// A pose as a transform.
pub(super) fn transform(pose: &PoseModel) -> Isometry3<f64> {
    let ([x, y, z], [roll, pitch, yaw]) = (pose.xyz, pose.rpy);
    Isometry3::from_parts(
        Translation3::new(x, y, z),
        UnitQuaternion::from_euler_angles(roll, pitch, yaw),
    )
}

/// What a joint adds to its pose at a position.
fn motion(joint: &JointModel, position: f64) -> Isometry3<f64> {
    let Some(axis) = Unit::try_new(Vector3::from(joint.axis), 1e-9) else {
        return Isometry3::identity();
    };
    match joint.kind.as_str() {
        "prismatic" => Isometry3::from_parts(
            (axis.into_inner() * position).into(),
            UnitQuaternion::identity(),
        ),
        "revolute" | "continuous" => Isometry3::from_parts(
            Translation3::identity(),
            UnitQuaternion::from_axis_angle(&axis, position),
        ),
        _ => Isometry3::identity(),
    }
}

/// A link in the world.
#[derive(Clone, Debug)]
pub(super) struct LinkTransform {
    /// Its frame.
    pub at: Isometry3<f64>,
    /// The link it hangs on and the joint between, by number.
    pub by: Option<(usize, usize)>,
}

/// Place the links of a robot. Links that hang on nothing stand at the origin; of several joints to a link the first
/// counts, and of links in a circle the first one stands at the origin.
pub(super) fn place(model: &Model, set: &Positions) -> Vec<LinkTransform> {
    let mut links: FastMap<&str, usize> = FastMap::default();
    for (number, link) in model.links.iter().enumerate() {
        links.entry(link.name.as_str()).or_insert(number);
    }
    let named: FastMap<&str, &JointModel> = model
        .joints
        .iter()
        .rev()
        .map(|j| (j.name.as_str(), j))
        .collect();
    let mut up: Vec<Option<(usize, usize)>> = vec![None; model.links.len()];
    let mut down: Vec<Vec<usize>> = vec![Vec::new(); model.links.len()];
    for (number, joint) in model.joints.iter().enumerate() {
        let ends = links
            .get(joint.parent.as_str())
            .zip(links.get(joint.child.as_str()));
        let Some((&parent, &child)) = ends.filter(|(parent, child)| parent != child) else {
            continue;
        };
        if let Some(slot @ None) = up.get_mut(child) {
            *slot = Some((parent, number));
            down.get_mut(parent)
                .into_iter()
                .for_each(|list| list.push(child));
        }
    }
    let mut placed: Vec<Option<LinkTransform>> = vec![None; model.links.len()];
    let tops = (0..up.len()).filter(|&link| up.get(link).is_some_and(Option::is_none));
    for top in tops.chain(0..up.len()) {
        let mut open = vec![(top, Isometry3::identity(), None)];
        while let Some((link, at, by)) = open.pop() {
            let Some(slot @ None) = placed.get_mut(link) else {
                continue;
            };
            *slot = Some(LinkTransform { at, by });
            for &child in down.get(link).into_iter().flatten() {
                let Some(&Some((_, number))) = up.get(child) else {
                    continue;
                };
                let Some(joint) = model.joints.get(number) else {
                    continue;
                };
                let here =
                    at * transform(&joint.pose) * motion(joint, position(joint, &named, set));
                open.push((child, here, Some((link, number))));
            }
        }
    }
    let origin = || LinkTransform {
        at: Isometry3::identity(),
        by: None,
    };
    placed
        .into_iter()
        .map(|placed| placed.unwrap_or_else(origin))
        .collect()
}

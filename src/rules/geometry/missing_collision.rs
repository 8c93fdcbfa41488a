//! A link that is seen but not felt.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::{Body, JointType, ShapeKind};

pub(super) static RULE: Rule = Rule {
    code: "GEO032",
    name: "missing-collision",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("missing-collision"),
    check: Check::Whole(check),
};

/// Links called so carry nothing that others should keep away from.
const DECORATION: [&str; 9] = [
    "camera", "sensor", "lidar", "laser", "imu", "logo", "decal", "marker", "optical",
];

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    for (index, link) in cx.robot.links.iter().enumerate() {
        let has_mesh = link
            .visuals
            .iter()
            .filter_map(Body::shape)
            .any(|shape| matches!(shape.kind, ShapeKind::Mesh { .. }));
        let Some(name) = link
            .name
            .as_ref()
            .filter(|_| has_mesh && link.collisions.is_empty())
        else {
            continue;
        };
        let lower = name.value.to_lowercase();
        let above = cx
            .kinematics
            .parent_joints(index)
            .first()
            .and_then(|&joint| cx.robot.joints.get(joint)?.joint_type());
        // what is fixed and weighs nothing is decoration
        let is_part = above == Some(JointType::Fixed) && link.inertial.is_none();
        if is_part || DECORATION.iter().any(|word| lower.contains(word)) {
            continue;
        }
        let message = format!("link `{}` has a visual mesh but no collision", name.value);
        out.report(name.origin, message)
            .help("add a <collision>; planners and simulators ignore a link without one")
            .done();
    }
}

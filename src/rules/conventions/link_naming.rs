//! Links of an arm that are not called `link_1`, `link_2` and so on.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::JointType;

pub(super) static RULE: Rule = Rule {
    code: "CNV007",
    name: "link-naming",
    category: Category::Conventions,
    severity: Severity::Info,
    default: Activation::Profiles(&["ros-industrial"]),
    since: "0.1",
    fix: None,
    docs: page("link-naming"),
    check: Check::Robot(check),
};

/// An arm has at least so many moving joints in a row.
const ARM: usize = 4;

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let chain = cx
        .kinematics
        .roots(cx.robot)
        .into_iter()
        .map(|root| chain(cx, root))
        .max_by_key(Vec::len);
    let chain = chain
        .filter(|chain| cx.whole && chain.len() >= ARM)
        .unwrap_or_default();
    for (number, link) in (1..).zip(chain) {
        let Some(name) = cx.robot.links.get(link).and_then(|link| link.name.as_ref()) else {
            continue;
        };
        let expected = format!("link_{number}");
        let behind_prefix = name.value.strip_suffix(&expected);
        if name.is_known()
            && behind_prefix.is_none_or(|prefix| prefix.ends_with(|c: char| c.is_ascii_digit()))
        {
            let message = format!(
                "link `{}` is link {number} of the arm but is not named `{expected}`",
                name.value
            );
            out.report(name.origin, message)
                .help(format!(
                    "rename it to `{expected}` (after the prefix); ROS-Industrial numbers links from the base"
                ))
                .done();
        }
    }
}

/// The links that the moving joints of the longest chain below `root` move, in order.
fn chain(cx: &RobotCx<'_>, root: usize) -> Vec<usize> {
    let mut open = vec![(root, Vec::new())];
    let mut longest = Vec::new();
    let mut seen = base::FastSet::default();
    while let Some((link, moved)) = open.pop() {
        if !seen.insert(link) {
            continue;
        }
        for &joint in cx.kinematics.child_joints(link) {
            let Some((_, child)) = cx.kinematics.ends(joint) else {
                continue;
            };
            let kind = cx
                .robot
                .joints
                .get(joint)
                .and_then(|joint| joint.joint_type());
            let mut moved = moved.clone();
            // what slides is a gripper or a rail
            if matches!(kind, Some(JointType::Revolute | JointType::Continuous)) {
                moved.push(child);
            }
            open.push((child, moved));
        }
        if moved.len() > longest.len() {
            longest = moved;
        }
    }
    longest
}

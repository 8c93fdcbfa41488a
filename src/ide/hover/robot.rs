//! Links and joints of the expanded robot.

use super::super::beside::BesideName;
use super::super::context::Cx;
use super::super::locate::{LocatedNode, NodePart};
use super::super::robot_names::{RobotNameKind, named_at, robot_names};
use super::expression::call_label;
use super::files::{lengths, three_digits};
use super::numbers::{degrees, rounded};
use super::page::{Page, code};
use base::{FastSet, TextRange};
use expand::{BindingId, BindingKind};
use expr::Value;
use model::{AttrValue, Joint, JointType, Kinematics, Link, Pose, Robot};
use rules::{RuleEnv, link_bounds};

/// Most links or joints that are shown for one text.
const MOST: usize = 3;

/// The links and joints that a text names.
pub(super) fn about(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    at: &LocatedNode<'_>,
) -> Option<(TextRange, Page)> {
    if let Some(group) = cx
        .beside
        .iter()
        .find(|name| name.kind == RobotNameKind::Group && name.is_at(cx, at.offset))
    {
        return Some((group.place.range, group_page(cx, group)));
    }
    let (robot, kinematics) = (cx.robot?, cx.kinematics?);
    let (range, names) = match (named_at(cx, at.offset), at.part) {
        (Some((_, names)), NodePart::AttrValue(attr)) => (at.shift(attr.value_range()), names),
        // in YAML
        (Some(found), _) if cx.beside.iter().any(|name| name.is_at(cx, at.offset)) => found,
        (None, NodePart::AttrValue(attr)) => {
            let range = at.shift(attr.value_range());
            (range, passed(cx, range)?)
        }
        _ => return None,
    };
    let mut shown = FastSet::default();
    let names: Vec<&str> = names
        .iter()
        .filter_map(|text| text.name())
        .map(|name| name.as_str())
        .collect();
    let names: Vec<&str> = names
        .into_iter()
        .filter(|name| shown.insert(*name))
        .collect();
    let mut page = Page::default();
    let mut known = 0;
    for name in names.iter().take(MOST) {
        if let Some(joint) = robot.joint(name).filter(|_| is_joint_name(cx, at)) {
            joint_page(cx, joint, &mut page);
        } else if let Some(link) = kinematics
            .link(name)
            .and_then(|index| robot.links.get(index))
        {
            link_page(cx, world, (robot, kinematics), link, &mut page);
        } else if let Some(joint) = robot.joint(name) {
            joint_page(cx, joint, &mut page);
        } else {
            continue;
        }
        known += 1;
    }
    if names.len() > MOST {
        page.add(format!("… ({} names)", names.len()));
    }
    (known > 0).then_some((range, page))
}

/// A planning group: what the SRDF says it holds.
fn group_page(cx: &Cx<'_>, group: &BesideName) -> Page {
    let mut page = Page::titled(format!("**group** {}", code(&group.value)));
    let is_it = |name: &&BesideName| {
        name.kind == RobotNameKind::Group && name.is_definition && name.value == group.value
    };
    match cx.beside.iter().find(is_it) {
        Some(given) => page.add(given.content.clone()),
        None => page.add("not defined in an SRDF of the robot"),
    }
    page
}

/// Whether a text is meant for a joint, should a link and a joint have one name.
fn is_joint_name(cx: &Cx<'_>, at: &LocatedNode<'_>) -> bool {
    if let Some(name) = cx.beside.iter().find(|name| name.is_at(cx, at.offset)) {
        return name.kind == RobotNameKind::Joint;
    }
    let (NodePart::AttrValue(attr), Some(node)) = (at.part, at.node) else {
        return false;
    };
    matches!(
        (node.name(), attr.name()),
        ("joint", "name") | ("mimic", "joint")
    )
}

/// The names that an argument of a call becomes as it is, when its text stands at `range`.
fn passed(cx: &Cx<'_>, range: TextRange) -> Option<Vec<AttrValue>> {
    let place = cx.source_range(range)?;
    let mut given: FastSet<BindingId> = FastSet::default();
    let mut values: Vec<&str> = Vec::new();
    // a binding is made after those that it reads
    for (id, info) in cx.expansion.index.bindings.iter_ids() {
        let is_here =
            info.kind == BindingKind::Parameter && info.origin.is_some_and(|at| place == at.into());
        if let (true, Some(Value::Str(value))) = (is_here, &info.value) {
            values.push(value);
            given.insert(id);
        } else if cx
            .expansion
            .index
            .read_in(info.reads)
            .iter()
            .any(|read| given.contains(read))
        {
            given.insert(id);
        }
    }
    if given.is_empty() {
        return None;
    }
    let mut names: Vec<AttrValue> = robot_names(cx).into_iter().map(|(text, _)| text).collect();
    names.retain(|text| {
        values.contains(&text.value.as_str())
            && text
                .reads(cx.expansion, 0..text.value.len())
                .any(|read| given.contains(&read))
    });
    Some(names)
}

fn link_page(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    (robot, kinematics): (&Robot, &Kinematics),
    link: &Link,
    page: &mut Page,
) {
    page.add(format!("**link** {}", code(link.shown())));
    let Some(index) = kinematics.link(link.shown()) else {
        return;
    };
    page.add(code(&chain(robot, kinematics, index)));
    let mass = match (
        &link.inertial,
        link.inertial.as_ref().and_then(|inertial| inertial.mass()),
    ) {
        (_, Some(mass)) => format!("mass {} kg", super::super::values::number_text(mass)),
        (Some(_), None) => "mass ? kg".to_owned(),
        (None, None) => "no inertia".to_owned(),
    };
    let space = link_bounds(cx.expansion, robot, world, link);
    let space = space
        .map(|bounds| format!(", {} m", lengths(bounds.size())))
        .unwrap_or_default();
    page.add(format!("{mass}{space}"));
    let children: Vec<String> = kinematics
        .child_joints(index)
        .iter()
        .filter_map(|&joint| {
            let child = robot.links.get(kinematics.ends(joint)?.1)?;
            Some(format!(
                "{} by {}",
                code(child.shown()),
                code(robot.joints.get(joint)?.shown())
            ))
        })
        .collect();
    match children.as_slice() {
        [] => page.add("no children"),
        few => {
            let more = if few.len() > 4 { ", …" } else { "" };
            let listed = few.iter().take(4).cloned().collect::<Vec<_>>().join(", ");
            page.add(format!("children: {listed}{more}"));
        }
    }
    made_by(cx, cx.expansion.tree.get(link.element).origin.frame, page);
}

fn made_by(cx: &Cx<'_>, frame: expand::FrameId, page: &mut Page) {
    page.add(
        call_label(cx, frame)
            .map(|label| format!("from {label}"))
            .unwrap_or_default(),
    );
}

/// `desk → pan → pan_body`
fn chain(robot: &Robot, kinematics: &Kinematics, link: usize) -> String {
    const MOST_STEPS: usize = 8;
    let mut parts = vec![link_name(robot, link)];
    let joints: Vec<usize> = kinematics.ancestor_joints(link).collect();
    for joint in joints.iter().take(MOST_STEPS) {
        parts.push(robot.joints.get(*joint).map_or("?", |joint| joint.shown()));
        parts.push(
            kinematics
                .ends(*joint)
                .map_or("?", |(parent, _)| link_name(robot, parent)),
        );
    }
    if joints.len() > MOST_STEPS {
        parts.push("…");
    }
    parts.reverse();
    parts.join(" → ")
}

fn link_name(robot: &Robot, link: usize) -> &str {
    robot.links.get(link).map_or("?", |link| link.shown())
}

fn joint_page(cx: &Cx<'_>, joint: &Joint, page: &mut Page) {
    let kind = joint.kind.as_ref().map_or("?", |kind| kind.value.as_str());
    page.add(format!("**joint** {} ({kind})", code(joint.shown())));
    let [parent, child] = [&joint.parent, &joint.child].map(|text| {
        text.as_ref()
            .and_then(|text| text.name())
            .map_or("?".to_owned(), ToString::to_string)
    });
    page.add(code(&format!("{parent} → {child}")));
    let known = JointType::of(kind);
    if known.is_some_and(JointType::has_axis) {
        page.add(axis(joint).map_or("axis ?".to_owned(), |axis| {
            format!("axis {} of {}", code(&axis), code(&parent))
        }));
    }
    page.add(limits(joint, known).unwrap_or_default());
    if let Some(followed) = joint.mimic.as_ref().and_then(|mimic| mimic.joint.as_ref()) {
        page.add(format!("mimics {}", code(&followed.value)));
    }
    made_by(cx, cx.expansion.tree.get(joint.element).origin.frame, page);
}

/// The axis in the frame of the parent link: `+Z`, or three numbers.
fn axis(joint: &Joint) -> Option<String> {
    let written = joint.axis.as_ref().and_then(|axis| axis.xyz.as_ref());
    let [x, y, z] = written.map_or(Some([1.0, 0.0, 0.0]), AttrValue::numbers)?;
    let turn = joint
        .origin
        .as_ref()
        .map_or(Some(nalgebra::Isometry3::identity()), Pose::transform)?;
    let axis = turn.rotation * nalgebra::Vector3::new(x, y, z).try_normalize(1e-9)?;
    let names = ["X", "Y", "Z"];
    let along = axis
        .iter()
        .zip(names)
        .find(|(part, _)| part.abs() > 0.99999);
    Some(match along {
        Some((part, name)) => format!("{}{name}", if *part > 0.0 { '+' } else { '-' }),
        None => format!(
            "({})",
            [axis.x, axis.y, axis.z]
                .map(|part| three_digits((part * 1e6).round() / 1e6))
                .join(", ")
        ),
    })
}

/// The range, effort and velocity of a joint in one line.
pub(in super::super) fn limits(joint: &Joint, kind: Option<JointType>) -> Option<String> {
    let limit = joint.limit.as_ref()?;
    let turns = !matches!(kind, Some(JointType::Prismatic));
    let range = match (kind, limit.range()) {
        (Some(JointType::Continuous), _) => Some("unlimited".to_owned()),
        (Some(JointType::Revolute), Some((lower, upper))) => {
            let (from, to) = (rounded(lower, 1e4), rounded(upper, 1e4));
            Some(format!(
                "{from} … {to} rad ({}° … {}°)",
                degrees(lower),
                degrees(upper)
            ))
        }
        (Some(JointType::Prismatic), Some((lower, upper))) => Some(format!(
            "{} … {} m",
            rounded(lower, 1e6),
            rounded(upper, 1e6)
        )),
        _ => None,
    };
    let effort = quantity(&limit.effort, if turns { "N·m" } else { "N" });
    let velocity = quantity(&limit.velocity, if turns { "rad/s" } else { "m/s" });
    let parts: Vec<String> = [range, effort, velocity].into_iter().flatten().collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// A number with its unit.
fn quantity(text: &Option<AttrValue>, unit: &str) -> Option<String> {
    let text = text.as_ref()?;
    let number = text
        .number()
        .map_or("?".to_owned(), super::super::values::number_text);
    Some(format!("{number} {unit}"))
}

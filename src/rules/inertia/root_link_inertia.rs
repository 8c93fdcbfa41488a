//! A root link with inertia.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use base::TextRange;
use expand::{Expansion, FileRange};
use model::{Link, Robot, tag_start};
use workspace::config::Profile;

pub(super) static RULE: Rule = Rule {
    code: "INR010",
    name: "root-link-inertia",
    category: Category::Inertia,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("root-link-inertia"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let profiles = &cx.world.config.profiles;
    let without_ros = profiles.contains(&Profile::Gazebo) && profiles.len() == 1;
    let &[root] = cx.kinematics.roots(cx.robot).as_slice() else {
        return;
    };
    let Some(link) = cx
        .robot
        .links
        .get(root)
        .filter(|_| cx.whole && !without_ros)
    else {
        return;
    };
    let (Some(name), Some(_)) = (&link.name, &link.inertial) else {
        return;
    };
    let message = format!(
        "root link `{}` has an inertia, which KDL ignores",
        name.value
    );
    let report = out
        .report(name.origin, message)
        .help("add a root link without inertia and a fixed joint to this link");
    match massless_root(cx.expansion, cx.robot, link) {
        Some((place, text)) => {
            let edit = [(TextRange::empty(place.range.start), text)];
            report
                .fix(Safety::Unsafe, ADD_ROOT, place.file, edit)
                .done();
        }
        None => report.done(),
    }
}

/// What the fix does.
pub(in super::super) const ADD_ROOT: &str = "add a root link without inertia";

/// A root link without inertia for a link of the robot, with the joint between them: where it goes, and its text.
pub(in super::super) fn massless_root(
    expansion: &Expansion,
    robot: &Robot,
    link: &Link,
) -> Option<(FileRange, String)> {
    let name = link.name.as_ref()?;
    let is_plain = name.is_literal() && !name.value.contains(['&', '<', '"']);
    let place = expansion.place(tag_start(expansion, link.element))?;
    let is_free = robot.link("base_footprint").is_none();
    (is_plain && is_free).then(|| (place, root_above(&name.value)))
}

/// A root link without inertia in front of the link of a name, and the joint between them.
fn root_above(name: &str) -> String {
    format!(
        r#"<link name="base_footprint"/>
  <joint name="base_footprint_joint" type="fixed">
    <parent link="base_footprint"/>
    <child link="{name}"/>
  </joint>
  "#
    )
}

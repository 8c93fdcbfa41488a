//! An IMU in a frame of an unusual name.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names::prefix_of;
use expand::{XId, XTree};

pub(super) static RULE: Rule = Rule {
    code: "FRM016",
    name: "imu-frame-name",
    category: Category::Frames,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("imu-frame-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot else { return };
    let tree = &cx.expansion.tree;
    for block in robot
        .gazebo
        .iter()
        .filter(|block| has_imu(tree, block.element))
    {
        let Some(name) = block
            .reference
            .as_ref()
            .and_then(|reference| reference.name())
        else {
            continue;
        };
        let link = robot.link(name).and_then(|link| link.name.as_ref());
        if let Some(link) = link.filter(|_| prefix_of(name, "imu_link").is_none()) {
            out.report(
                link.origin,
                format!("IMU frame `{name}` is not named `imu_link`"),
            )
            .help("rename it to `imu_link`, the default frame of IMU drivers")
            .done();
        }
    }
}

/// Whether a `gazebo` element has a sensor of the type IMU.
fn has_imu(tree: &XTree, gazebo: XId) -> bool {
    tree.elements(gazebo)
        .filter(|&id| tree.get(id).text == "sensor")
        .filter_map(|sensor| tree.attr(sensor, "type"))
        .any(|kind| ["imu", "imu_sensor"].contains(&kind.value.as_str()))
}

//! A sensor of Gazebo whose data are in a frame that nothing places.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::plugin_unknown_frame::{OF_SENSORS, sensors};
use super::plugins::plugins_of;
use expand::{XId, XTree};
use model::{AttrValue, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL044",
    name: "sensor-without-frame",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("sensor-without-frame"),
    check: Check::Whole(check),
};

/// Sensors of Gazebo, not of Gazebo Classic, whose data are points.
const OF_POINTS: [&str; 4] = ["gpu_lidar", "lidar", "rgbd_camera", "depth_camera"];
/// What names the frame elsewhere in a sensor: in SDF 1.12, and of the images of a camera.
const OTHERS: [&str; 2] = ["frame_id", "optical_frame_id"];
/// The system of Gazebo that can publish where sensors are.
const PLACES: &str = "pose-publisher";

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    let all = sensors(cx);
    let unnamed: Vec<_> = all
        .iter()
        .filter_map(|(link, sensor)| Some(((*link)?, *sensor)))
        .filter(|(_, sensor)| gives_points(tree, *sensor) && !names_frame(tree, *sensor))
        .collect();
    if unnamed.is_empty() || are_placed(cx) {
        return;
    }
    for (link, sensor) in unnamed {
        let name = AttrValue::attr(tree, sensor, "name");
        let shown = name.map_or_else(
            || "a sensor".to_owned(),
            |name| format!("sensor `{}`", name.value),
        );
        out.report(
            tag_start(cx.expansion, sensor),
            format!("{shown} has no `gz_frame_id`, so no transform places its data"),
        )
        .help(format!(
            "add <gz_frame_id>{link}</gz_frame_id>; Gazebo makes up a frame of the names of robot, link and sensor"
        ))
        .done();
    }
}

/// Whether the data of a sensor are points, and no plugin of Gazebo Classic gives them.
fn gives_points(tree: &XTree, sensor: XId) -> bool {
    let kind = tree.attr(sensor, "type");
    let has_plugin = tree
        .elements(sensor)
        .any(|part| tree.get(part).text == "plugin");
    kind.is_some_and(|kind| OF_POINTS.contains(&kind.value.as_str())) && !has_plugin
}

fn names_frame(tree: &XTree, sensor: XId) -> bool {
    tree.below(sensor).any(|id| {
        let name = tree.get(id).text.as_str();
        OF_SENSORS.contains(&name) || OTHERS.contains(&name)
    })
}

/// Whether Gazebo may say itself where the sensors are.
fn are_placed(cx: &RobotCx<'_>) -> bool {
    let tree = &cx.expansion.tree;
    plugins_of(tree, cx.robot).into_iter().any(|plugin| {
        let file = tree.attr(plugin, "filename");
        file.is_some_and(|file| file.value.contains(PLACES))
    })
}

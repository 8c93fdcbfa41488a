//! Hardware of ros2_control that the simulator of the robot does not load.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::is_simulator_plugin;
use super::plugins::plugins_of;
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL039",
    name: "ros2-control-plugin-mismatch",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-plugin-mismatch"),
    check: Check::Whole(check),
};

/// Plugins of simulators that run ros2_control: a part of the name of the file, the package of its hardware and the class, and
/// the packages of others.
static SIMULATORS: [(&str, &str, &[&str]); 3] = [
    (
        "gazebo_ros2_control",
        "gazebo_ros2_control/GazeboSystem",
        &["gz_ros2_control/", "ign_ros2_control/"],
    ),
    (
        "gz_ros2_control",
        "gz_ros2_control/GazeboSimSystem",
        &["gazebo_ros2_control/"],
    ),
    (
        "ign_ros2_control",
        "ign_ros2_control/IgnitionSystem",
        &["gazebo_ros2_control/"],
    ),
];

/// What the packages are called whose hardware does as it is told, for tests and demos.
const MOCKS: [&str; 2] = ["mock_components/", "fake_components/"];

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    let files = plugins_of(tree, cx.robot)
        .into_iter()
        .filter_map(|plugin| AttrValue::attr(tree, plugin, "filename"));
    let simulator = files.filter(AttrValue::is_known).find_map(|file| {
        let mut all = SIMULATORS.iter();
        let own = all.find(|(part, ..)| file.value.contains(part))?;
        Some((file, own))
    });
    let Some((file, (_, class, others))) = simulator else {
        return;
    };
    for control in &cx.robot.controls {
        let name = control
            .plugin(tree)
            .and_then(|plugin| AttrValue::content(tree, plugin));
        // what an argument chooses is another one in the simulation
        let Some(name) = name.filter(|name| name.is_literal() && !is_chosen(cx, class)) else {
            continue;
        };
        let own = name.value.trim();
        let is_other = others.iter().any(|package| own.starts_with(package));
        if !is_other && (is_simulator_plugin(own) || own.to_lowercase().contains("sim")) {
            continue;
        }
        // the demo of MoveIt has hardware of its own beside the robot for the simulation
        let file_of = |text: &AttrValue| Some(cx.expansion.place(text.origin)?.file);
        if MOCKS.iter().any(|mock| own.starts_with(mock)) && file_of(&name) != file_of(&file) {
            continue;
        }
        let message = format!("`{}` does not load the hardware `{own}`", file.value);
        out.report(name.origin, message)
            .also(file.origin, "the plugin")
            .help(format!("use `{class}` in the simulation, chosen by an argument; nothing moves these joints there"))
            .done();
    }
}

/// Whether a file of the robot has a class, for other arguments.
fn is_chosen(cx: &RobotCx<'_>, class: &str) -> bool {
    let mut files = cx.expansion.files.iter();
    files.any(|file| file.source.document.text().contains(class))
}

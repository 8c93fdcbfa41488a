//! A plugin of Gazebo Classic.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::plugins::plugins;
use model::AttrValue;
use packages::RosVersion;

pub(super) static RULE: Rule = Rule {
    code: "CTL018",
    name: "gazebo-classic-plugin",
    category: Category::Control,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("gazebo-classic-plugin"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if cx.world.config.target != RosVersion::Ros2 {
        return;
    }
    let tree = &cx.expansion.tree;
    for file in plugins(cx)
        .into_iter()
        .filter_map(|plugin| AttrValue::attr(tree, plugin, "filename"))
    {
        if file.is_known() && file.value.starts_with("libgazebo_ros") {
            out.report(file.origin, format!("plugin `{}` works only in Gazebo Classic", file.value))
                .help("use a system of the new Gazebo or gz_ros2_control; ROS 2 Jazzy and later do not support Gazebo Classic")
                .done();
        }
    }
}

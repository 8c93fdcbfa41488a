//! Controllers that are started for a robot in Gazebo which nothing gives a controller manager.
use super::super::finding::{Finding, Related};
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG023",
    name: "missing-controller-manager",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("missing-controller-manager"),
    check: Check::Analysis,
};

/// What a robot lacks to be controlled in Gazebo.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lacking {
    /// A plugin that runs a controller manager.
    Plugin,
    /// An element `ros2_control`, without which the plugin starts none.
    Control,
}

/// The finding about the first controller that a launch file starts. `robot`: where the launch file calls the robot, and the name of
/// its file.
pub fn missing_controller_manager(
    span: Span,
    controller: &str,
    lacking: Lacking,
    robot: (Span, &str),
) -> Finding {
    let message = format!("no controller manager starts `{controller}`");
    let mut finding = Finding::new(&RULE, span, message);
    finding.group = Some(Group::File);
    let (place, file) = robot;
    let (what, help) = match lacking {
        Lacking::Plugin => (
            "no plugin of ros2_control",
            "add the plugin of gz_ros2_control or gazebo_ros2_control, or pass the argument that adds it",
        ),
        Lacking::Control => (
            "no `ros2_control` element",
            "add the element, or include the file that has it: the plugin starts no controller manager without it",
        ),
    };
    finding.help = Some(help.to_owned());
    finding.related.push(Related {
        span: place,
        message: format!("`{file}`, as it is called here, has {what}"),
        is_call: false,
    });
    finding
}

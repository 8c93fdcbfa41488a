//! A node that is started to load hardware which only a simulator can load.
use super::super::finding::{Finding, Related};
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG021",
    name: "unloadable-hardware",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("unloadable-hardware"),
    check: Check::Analysis,
};

/// The finding about a node in a launch file. `plugin`: the hardware of its robot, and where that is named.
pub fn unloadable_hardware(span: Span, plugin: &str, place: Span) -> Finding {
    let message = format!("`ros2_control_node` cannot load `{plugin}`");
    let mut finding = Finding::new(&RULE, span, message);
    finding.group = Some(Group::File);
    finding.help = Some(
        "do not start it for a simulated robot: the plugin of Gazebo loads the hardware, and has a controller manager of its own"
            .to_owned(),
    );
    finding.related.push(Related {
        span: place,
        message: format!("the robot has `{plugin}`"),
        is_call: false,
    });
    finding
}

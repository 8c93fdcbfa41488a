//! A world of Gazebo that runs no sensors, for a robot that has some.
use super::super::finding::{Finding, Related};
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG024",
    name: "missing-sensors-system",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("missing-sensors-system"),
    check: Check::Analysis,
};

/// The finding about a world that a launch file names. `sensor`: one of the robot, its name or kind, and where it is.
pub fn missing_sensors_system(span: Span, world: &str, sensor: (&str, Span)) -> Finding {
    let (name, place) = sensor;
    let message = format!("world `{world}` runs no sensors, so `{name}` gives no data");
    let mut finding = Finding::new(&RULE, span, message);
    finding.group = Some(Group::Thing(format!("world {world}").into()));
    finding.help = Some(
        "add the plugin `gz-sim-sensors-system` to the world, with a <render_engine>".to_owned(),
    );
    finding.related.push(Related {
        span: place,
        message: format!("sensor `{name}` of the robot"),
        is_call: false,
    });
    finding
}

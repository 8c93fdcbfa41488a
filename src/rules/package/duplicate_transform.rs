//! A transform that a launch file publishes, though the robot has it already.
use super::super::finding::{Finding, Related};
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG017",
    name: "duplicate-transform",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("duplicate-transform"),
    check: Check::Analysis,
};

/// The finding about a frame that a joint of the robot places, too. `is_same`: both say the same.
pub fn repeated_transform(span: Span, frame: &str, joint: (&str, Span), is_same: bool) -> Finding {
    let message = format!(
        "frame `{frame}` is placed by joint `{}` of the robot, too",
        joint.0
    );
    let mut finding = Finding::new(&RULE, span, message);
    // launch files of one robot are copied from each other
    finding.group = Some(Group::Value(frame.into()));
    if is_same {
        finding.severity = Severity::Info;
    }
    finding.help =
        Some("remove the publisher: robot_state_publisher publishes this transform".to_owned());
    finding.related.push(Related {
        span: joint.1,
        message: "the joint".to_owned(),
        is_call: false,
    });
    finding
}

/// The finding about a frame that the robot has above the one from which it is placed, with the joint in between.
pub fn looping_transform(span: Span, frame: &str, parent: &str, joint: (&str, Span)) -> Finding {
    let message = format!(
        "transform from `{parent}` to `{frame}` closes a loop: the robot has `{frame}` above `{parent}`"
    );
    let mut finding = Finding::new(&RULE, span, message);
    finding.help = Some("remove the publisher, or place the robot's root link".to_owned());
    finding.related.push(Related {
        span: joint.1,
        message: format!("below joint `{}`", joint.0),
        is_call: false,
    });
    finding
}

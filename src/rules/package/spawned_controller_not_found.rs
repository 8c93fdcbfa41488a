//! A controller that a launch file starts, and that no file of parameters says anything of.
use super::super::finding::{Finding, Related};
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG020",
    name: "spawned-controller-not-found",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("spawned-controller-not-found"),
    check: Check::Analysis,
};

/// The finding about a controller that a launch file starts. `listed`: one that the parameters have, and where; `near`: one of
/// them that it may mean.
pub fn spawned_controller_not_found(
    span: Span,
    name: &str,
    listed: (&str, Span),
    near: Option<&str>,
) -> Finding {
    let message = format!("no parameters give the type of controller `{name}`");
    let mut finding = Finding::new(&RULE, span, message);
    finding.group = Some(Group::File);
    finding.help = Some(match near {
        Some(near) => format!("is it `{near}`? The controller is not started"),
        None => format!(
            "add `{name}` with its `type` to the parameters of the controller manager, or do not start it"
        ),
    });
    finding.related.push(Related {
        span: listed.1,
        message: format!("the parameters have `{}`", listed.0),
        is_call: false,
    });
    finding
}

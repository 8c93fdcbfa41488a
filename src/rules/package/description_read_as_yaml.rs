//! A robot that a launch file passes to a node as YAML, which it is not.
use super::super::finding::{Edit, Finding, Fix, Related};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use base::Span;

pub(in super::super) static RULE: Rule = Rule {
    code: "PKG016",
    name: "description-read-as-yaml",
    category: Category::Package,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("description-read-as-yaml"),
    check: Check::Analysis,
};

/// A launch file that passes a robot to a node as a parameter without a type.
pub struct UntypedParameter {
    /// The name of the launch file.
    pub file: String,
    /// Where it calls xacro.
    pub call: Span,
    /// How to give the parameter a type.
    pub typed: &'static str,
    /// What gives it one.
    pub edits: Vec<Edit>,
}

/// The finding about `sign`, at which YAML stops in the `part` of the robot where it stands.
pub fn description_read_as_yaml(
    at: Span,
    sign: &str,
    part: &str,
    parameter: UntypedParameter,
) -> Finding {
    let UntypedParameter {
        file,
        call,
        typed,
        edits,
    } = parameter;
    let message = format!(
        "{sign} in this {part} makes `{file}` fail, because launch reads the robot as YAML"
    );
    let mut finding = Finding::new(&RULE, at, message);
    finding.help = Some(format!("write {typed} in `{file}`"));
    finding.related.push(Related {
        span: call,
        message: "passed as a parameter here".to_owned(),
        is_call: false,
    });
    if !edits.is_empty() {
        finding.fix = Some(Fix {
            safety: Safety::Unsafe,
            message: format!("give the parameter in `{file}` a type"),
            edits,
        });
    }
    finding
}

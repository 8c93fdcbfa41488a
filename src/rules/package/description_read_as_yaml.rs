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

/// Something that reads the text of a robot as YAML.
pub struct YamlReader {
    /// What it is, as a message names it.
    pub name: String,
    /// Where that is written.
    pub at: Span,
    /// What is written there.
    pub what: &'static str,
    /// Whether all versions of it read YAML.
    pub is_certain: bool,
    /// What to do.
    pub help: String,
    /// What does it.
    pub edits: Vec<Edit>,
}

/// The finding about `sign`, at which YAML stops in the `part` of the robot where it stands.
pub fn description_read_as_yaml(at: Span, sign: &str, part: &str, reader: YamlReader) -> Finding {
    let name = &reader.name;
    let message =
        format!("{sign} in this {part} makes {name} fail, because it reads the robot as YAML");
    let mut finding = Finding::new(&RULE, at, message);
    if !reader.is_certain {
        finding.severity = Severity::Warning;
    }
    if !reader.edits.is_empty() {
        finding.fix = Some(Fix {
            safety: Safety::Unsafe,
            message: format!("give the parameter in {name} a type"),
            edits: reader.edits,
        });
    }
    finding.help = Some(reader.help);
    finding.related.push(Related {
        span: reader.at,
        message: reader.what.to_owned(),
        is_call: false,
    });
    finding
}

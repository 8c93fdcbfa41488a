//! The attributes of xacro's own tags.
use std::borrow::Cow;

use super::expander::Expander;
use super::kind::ProblemKind;
use super::meant;
use super::names::EvalContext;
use super::origin::Origin;
use super::scope::TextOrigin;
use super::tag::Tag;
use base::TextRange;
use expr::{Value, display, literal};

/// Attributes of xacro elements: one of these is no other name for a missing one.
const ATTRIBUTES: &[&str] = &[
    "name", "default", "filename", "value", "params", "macro", "ns", "optional", "scope",
];

impl Expander<'_> {
    /// An attribute as it is written (entities decoded), and where.
    pub fn attr<'a>(
        &self,
        tag: Tag<'a>,
        name: &str,
        cx: EvalContext,
    ) -> Option<(Cow<'a, str>, TextOrigin)> {
        let attr = tag.attr(name)?;
        let origin = Origin {
            src: tag.src,
            range: attr.value_range(),
            frame: cx.frame,
        };
        Some((
            attr.value(self.entities(tag.src)),
            TextOrigin {
                origin,
                is_attr: true,
            },
        ))
    }

    /// An attribute that must be there.
    pub fn required_attr<'a>(
        &mut self,
        tag: Tag<'a>,
        name: &str,
        cx: EvalContext,
    ) -> Option<(Cow<'a, str>, TextOrigin)> {
        let found = self.attr(tag, name, cx);
        if found.is_none() {
            let message = format!("missing attribute `{name}` in `{}`", tag.name);
            let reference = format!("{}: missing attribute '{name}'", tag.name);
            let problem = self
                .problem(
                    ProblemKind::MissingXacroAttribute,
                    self.tag_origin(tag, cx),
                    message,
                )
                .says(reference);
            let mut others = tag.attrs().filter(|attr| !attr.name().starts_with("xmlns"));
            self.push(match (others.next(), others.next()) {
                (Some(other), None) if tag.name == "xacro:property" => {
                    let value = other.value(self.entities(tag.src));
                    problem.help(format!(
                        "write <xacro:property name=\"{}\" value=\"{value}\"/>",
                        other.name()
                    ))
                }
                (Some(other), None) if !ATTRIBUTES.contains(&other.name()) => {
                    problem.help(format!("rename `{}` to `{name}`", other.name()))
                }
                _ => problem.help(format!("add {name}=\"...\"")),
            });
        }
        found
    }

    /// Warn about attributes that mean nothing on this tag.
    pub fn check_attrs(&mut self, tag: Tag<'_>, allowed: &[&str], cx: EvalContext) {
        let extra: Vec<_> = tag
            .attrs()
            .filter(|attr| !allowed.contains(&attr.name()) && !attr.name().starts_with("xmlns:"))
            .collect();
        let names: Vec<&str> = extra.iter().map(|a| a.name()).collect();
        for (i, attr) in extra.iter().enumerate() {
            let at = Origin {
                src: tag.src,
                range: attr.name_range(),
                frame: cx.frame,
            };
            let message = format!("unknown attribute `{}` in `{}`", attr.name(), tag.name);
            let mut problem = self
                .problem(ProblemKind::UnknownXacroAttribute, at, message)
                .warning();
            if i == 0 {
                let list = names.join(", ");
                problem = problem.says(format!("{}: unknown attribute(s): {list}", tag.name));
            }
            if let Some(near) = meant::by_attribute(attr.name(), allowed) {
                problem = problem
                    .help(format!("did you mean `{near}`?"))
                    .replace_with(near);
            }
            self.push(problem);
        }
    }

    /// The truth of an evaluated attribute: `raw` is its text, for the message; what was read for it
    /// follows the first `mark` reads. `None` when it is unknown.
    pub fn truth(&mut self, value: &Value, raw: &str, at: Origin, mark: usize) -> Option<bool> {
        if matches!(value, Value::Unknown) {
            return None;
        }
        let truth = match value {
            Value::Scope(scope) => Some(!self.names.scopes.entries(*scope).is_empty()),
            _ => literal::boolean(value),
        };
        if truth.is_none() {
            let shown = display::to_str(value)?;
            if let Some(problem) = self.condition_slip(&shown, at, mark) {
                self.push(problem);
                return None;
            }
            let message = match (raw.is_empty(), shown.is_empty()) {
                (true, _) => "condition is empty".to_owned(),
                (_, true) => {
                    format!(
                        "condition `{raw}` evaluates to an empty string, which is not a boolean"
                    )
                }
                _ if raw == shown => format!("condition `{raw}` is not a boolean"),
                _ => format!("condition `{raw}` evaluates to `{shown}`, which is not a boolean"),
            };
            let reference = format!(
                "Xacro conditional \"{raw}\" evaluated to \"{shown}\", which is not a boolean expression."
            );
            let mut problem = self
                .problem(ProblemKind::InvalidCondition, at, message)
                .says(reference)
                .help("write `true`, `false`, an integer or an expression such as `${x > 0}`");
            problem.outside = self.outside_of_reads(mark);
            self.push(problem);
        }
        truth
    }

    /// The start of a tag: from `<` to the end of its name.
    pub fn tag_origin(&self, tag: Tag<'_>, cx: EvalContext) -> Origin {
        let name = tag.node.name_range();
        Origin {
            src: tag.src,
            range: TextRange::new(name.start.saturating_sub(1), name.end),
            frame: cx.frame,
        }
    }
}

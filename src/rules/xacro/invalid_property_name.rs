//! A name of a property or parameter that no expression can read.
use super::super::finding::{Edit, Fix};
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use expr::is_identifier;

pub(in super::super) static RULE: Rule = Rule::found(
    "XAC022",
    "invalid-property-name",
    Category::Xacro,
    Severity::Error,
    page("invalid-property-name"),
)
.fixed(Safety::Unsafe);

/// The nearest name that is an identifier.
pub(in super::super) fn fix(cx: &ProblemCx<'_>) -> Option<Fix> {
    let old = cx.document.slice(cx.span.range);
    let admitted = |c: char| if c.is_alphanumeric() { c } else { '_' };
    let mut new: String = old.trim().chars().map(admitted).collect();
    if new.starts_with("__") || new.is_empty() {
        new = new.trim_start_matches('_').to_owned();
    } else if new.starts_with(|c: char| c.is_numeric()) {
        new.insert(0, '_');
    } else if !is_identifier(&new) {
        new.push('_');
    }
    let is_valid = is_identifier(&new) && !old.contains('$');
    is_valid.then(|| Fix {
        safety: Safety::Unsafe,
        message: format!("rename to `{new}`"),
        edits: vec![Edit {
            span: cx.span,
            content: new,
        }],
    })
}

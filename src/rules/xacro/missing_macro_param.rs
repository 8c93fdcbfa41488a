//! A call without a parameter that has no default.
use ecow::EcoString;

use super::super::finding::{Edit, Fix};
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use base::{Span, TextRange};
use expand::{Detail, Problem};

pub(in super::super) static RULE: Rule = Rule::found(
    "XAC005",
    "missing-macro-param",
    Category::Xacro,
    Severity::Error,
    page("missing-macro-param"),
)
.fixed(Safety::Unsafe);

/// Missing parameters, where an empty text is a value that makes sense: only a person knows the values of others.
pub(in super::super) fn fix(cx: &ProblemCx<'_>) -> Option<Fix> {
    let may_be_empty = |name: &EcoString| {
        name == "ns"
            || ["prefix", "suffix", "namespace"]
                .iter()
                .any(|word| name.contains(word))
    };
    let all_empty = missing(cx.problem).iter().all(may_be_empty);
    if missing(cx.problem).is_empty() || !all_empty {
        return None;
    }
    let range = TextRange::empty(cx.span.range.end);
    let content = format!(" {}", attributes(cx.problem));
    let edits = vec![Edit {
        span: Span { range, ..cx.span },
        content,
    }];
    Some(Fix {
        safety: Safety::Unsafe,
        message: "add the missing parameters with empty values".to_owned(),
        edits,
    })
}

/// The parameters that the call does not give.
fn missing(problem: &Problem) -> &[EcoString] {
    match &problem.detail {
        Some(Detail::MissingParams(names)) => names,
        _ => &[],
    }
}

/// The missing parameters as attributes with empty values.
fn attributes(problem: &Problem) -> String {
    let empty: Vec<String> = missing(problem)
        .iter()
        .map(|name| format!("{name}=\"\""))
        .collect();
    empty.join(" ")
}

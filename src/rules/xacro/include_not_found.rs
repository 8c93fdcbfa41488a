//! An include of a file that cannot be read.
use std::path::Path;

use super::super::finding::{Edit, Fix};
use super::super::grouping::Group;
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use base::{Span, TextRange};
use expand::{Detail, Problem};
use packages::nearest;
use xml::Document;

pub(in super::super) static RULE: Rule = Rule::found(
    "XAC008",
    "include-not-found",
    Category::Xacro,
    Severity::Error,
    page("include-not-found"),
)
.fixed(Safety::Unsafe);

/// Whether the path starts in the folder in which somebody will run xacro.
pub(in super::super) fn is_of_caller(problem: &Problem, document: &Document) -> bool {
    document.slice(problem.place.range).contains("$(cwd)")
}

/// Many files that are missing in one folder were moved or renamed together.
pub(in super::super) fn group(problem: &Problem) -> Option<Group> {
    let Some(Detail::LookedFor(path)) = &problem.detail else {
        return None;
    };
    let folder = Path::new(path).parent()?.to_string_lossy();
    Some(Group::Name(folder.into()))
}

/// A file in the same folder may have almost its name.
pub(in super::super) fn fix(cx: &ProblemCx<'_>) -> Option<Fix> {
    let Some(Detail::LookedFor(path)) = &cx.problem.detail else {
        return None;
    };
    let (path, span) = (Path::new(path), cx.span);
    let old = path.file_name()?.to_str()?;
    let written = cx.document.slice(span.range);
    let names = cx.vfs.list_dir(path.parent()?);
    let files = names.iter().filter(|entry| !entry.is_dir);
    let new = nearest(old, files.map(|file| file.name.as_str()))?;
    let start = span.range.end - written.strip_suffix(old).map(|_| old.len() as u32)?;
    Some(Fix {
        safety: Safety::Unsafe,
        message: format!("include `{new}`"),
        edits: vec![Edit {
            span: Span {
                range: TextRange::new(start, span.range.end),
                ..span
            },
            content: new.to_owned(),
        }],
    })
}

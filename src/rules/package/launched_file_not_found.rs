//! A launch file that names a description that is not there, or another file that what it starts reads.
use super::super::finding::Finding;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG010",
    name: "launched-file-not-found",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("launched-file-not-found"),
    check: Check::Analysis,
};

/// Whether a path is that of a recorded map.
fn is_map(path: &str) -> bool {
    let mut folders = path.rsplit('/').skip(1);
    path.ends_with(".yaml") && folders.any(|folder| ["map", "maps"].contains(&folder))
}

/// The finding about a file that a launch file names and that is not there, with the path of one that it may mean.
pub fn launched_file_not_found(span: Span, shown: &str, near: Option<&str>) -> Finding {
    let mut finding = Finding::new(&RULE, span, format!("file `{shown}` does not exist"));
    let is_of_rviz = shown.ends_with(".rviz");
    finding.help = Some(match near {
        Some(near) => format!("correct the path: there is {near}"),
        None if is_of_rviz => "correct the path; RViz starts with its default displays".to_owned(),
        None => "correct the path; the launch file fails".to_owned(),
    });
    // exporters write launch files that name settings which they do not write; whoever has the robot records the map
    if near.is_none() && (is_of_rviz || is_map(shown)) {
        finding.severity = Severity::Info;
    }
    finding
}

//! Comments that hide a finding.

use super::place::{element_at, line_end, margin};
use super::{Action, edit, fix};
use crate::base::TextRange;
use crate::rules;
use crate::vfs::SourceFile;
use crate::xml::NodeKind;

/// Hide a finding of a rule where it stands, or in the whole file.
pub(super) fn suppress(source: &SourceFile, rule: &str, range: TextRange) -> Vec<Action> {
    // only the name of a rule is written into the file
    let Some(rule) = rules::find(rule).find(|known| known.name == rule) else { return Vec::new() };
    here(source, rule.name, range).into_iter().chain([in_file(source, rule.name)]).collect()
}

/// A comment in front of the element whose start tag, or whose text, holds the finding.
fn here(source: &SourceFile, rule: &str, range: TextRange) -> Option<Action> {
    let document = &source.document;
    let (base, element) = element_at(document, range.start)?;
    let tag = element.start_tag_range().shift(base);
    if range.start >= tag.end && element.child_elements().next().is_some() {
        return None;
    }
    let (end, margin) = (line_end(document), margin(document, tag.start));
    let stands_alone = document.slice(TextRange::new(0, tag.start)).ends_with(&format!("\n{margin}"));
    let behind = if stands_alone || tag.start == 0 { format!("{end}{margin}") } else { " ".to_owned() };
    let comment = format!("<!-- xacro-lint: disable-next-line {rule} -->{behind}");
    let edits = vec![edit(source, TextRange::empty(tag.start), comment)];
    Some(fix(format!("hide `{rule}` here by a comment"), edits))
}

/// A comment at the top of the file.
fn in_file(source: &SourceFile, rule: &str) -> Action {
    let document = &source.document;
    let end = line_end(document);
    let mut nodes = document.header().nodes();
    let declaration = nodes.find(|node| node.kind() == NodeKind::Declaration);
    let comment = format!("<!-- xacro-lint: disable-file {rule} -->");
    let (at, text) = match declaration {
        Some(declaration) => (declaration.range().end, format!("{end}{comment}")),
        None => (0, format!("{comment}{end}")),
    };
    fix(format!("hide `{rule}` in this file by a comment"), vec![edit(source, TextRange::empty(at), text)])
}

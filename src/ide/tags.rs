//! The two tags of an element.

use super::locate::{NodePart, locate};
use base::TextRange;
use xml::Document;

/// The names in both tags of the element whose tag name stands at an offset, when they are the same: what can
/// be typed in both at once.
pub fn same_tag_names(document: &Document, offset: u32) -> Option<[TextRange; 2]> {
    let names = matching_tags(document, offset)?;
    let [start, end] = names;
    (document.slice(start) == document.slice(end)).then_some(names)
}

/// The names in the start tag and the end tag of the element whose tag name stands at an offset.
pub fn matching_tags(document: &Document, offset: u32) -> Option<[TextRange; 2]> {
    let at = locate(document, offset);
    if let Some(root) =
        root_tags(document).filter(|tags| tags.iter().any(|tag| holds(*tag, offset)))
    {
        return Some(root);
    }
    let node = at
        .node
        .filter(|_| matches!(at.part, NodePart::StartName | NodePart::EndName))?;
    Some([
        at.shift(node.name_range()),
        at.shift(node.end_name_range()?),
    ])
}

/// The root element's tags stand in two parts of the document.
fn root_tags(document: &Document) -> Option<[TextRange; 2]> {
    let name = document.root()?.name_range();
    let end = document.root_end_tag()?;
    let start = end.start + "</".len() as u32;
    let length = document.root()?.name().len() as u32;
    Some([name, TextRange::new(start, (start + length).min(end.end))])
}

fn holds(range: TextRange, offset: u32) -> bool {
    range.start <= offset && offset <= range.end
}

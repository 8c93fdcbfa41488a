//! The arguments of a robot that a text depends on, and values that they may have.

use std::collections::VecDeque;
use std::path::Path;

use super::context::Cx;
use super::expressions::ExprText;
use super::hover::declared_argument;
use super::locate::{LocatedNode, NodePart, locate};
use super::names::definition_of;
use base::{Span, TextRange};
use expand::{DefinitionId, Read, SourceRange, SymbolKind};
use rules::RuleEnv;
use vfs::Vfs;

/// Properties that are followed from a text, at most.
const MOST_PROPERTIES: usize = 16;
/// Arguments of a text, at most.
const MOST_ARGUMENTS: usize = 3;
/// Values from the paths that were read, at most.
const MOST_VALUES: usize = 20;

/// The arguments that are read for the text at a range of the file, by itself or by the properties in it; the nearest first.
pub fn arguments_behind(cx: &Cx<'_>, range: TextRange) -> Vec<String> {
    let at = locate(&cx.source.document, range.start);
    if let Some(name) = declared_at(&at) {
        return vec![name];
    }
    let mut open = VecDeque::from([Span {
        file: cx.source.id,
        range: whole_text(cx, &at, range),
    }]);
    let mut followed: Vec<DefinitionId> = Vec::new();
    let mut found: Vec<String> = Vec::new();
    while let Some(span) = open.pop_front() {
        let Some(source) = cx.file_of(span.file) else {
            continue;
        };
        for name in named_in(&source.document.slice(span.range)) {
            let is_known = cx
                .expansion
                .arguments
                .iter()
                .any(|(known, _)| *known == name);
            if is_known && !found.contains(&name) {
                found.push(name);
            }
        }
        for id in properties_in(cx, span) {
            if followed.len() < MOST_PROPERTIES && !followed.contains(&id) {
                followed.push(id);
                open.extend(definition_of(cx, id).map(|target| target.whole));
            }
        }
    }
    found.truncate(MOST_ARGUMENTS);
    found
}

/// The argument whose default stands at a place.
fn declared_at(at: &LocatedNode<'_>) -> Option<String> {
    let NodePart::AttrValue(attr) = at.part else {
        return None;
    };
    let node = at.node.filter(|node| node.name() == "xacro:arg")?;
    let name = node.attr("name").filter(|_| attr.name() == "default")?;
    Some(name.raw().to_owned())
}

/// The expression around a range, or all of the text that it stands in.
fn whole_text(cx: &Cx<'_>, at: &LocatedNode<'_>, range: TextRange) -> TextRange {
    let Some(text) = ExprText::at(&cx.source.document, at) else {
        return range;
    };
    let token = text.token_at(range.start);
    let token = token.map(|token| text.range(token.range()));
    token
        .filter(|token| token.contains_range(range))
        .unwrap_or_else(|| text.whole())
}

/// The names in `$(arg ...)`.
fn named_in(text: &str) -> impl Iterator<Item = String> {
    let parts = text.split("$(arg ").skip(1);
    parts.filter_map(|rest| Some(rest.split_once(')')?.0.trim().to_owned()))
}

/// The properties that the text at a span reads.
fn properties_in(cx: &Cx<'_>, span: Span) -> Vec<DefinitionId> {
    let symbols = &cx.expansion.index.symbols;
    let uses = symbols
        .all_uses()
        .filter(|used| is_in(cx, used.place, span));
    uses.map(|used| used.definition)
        .filter(|&id| {
            symbols
                .get(id)
                .is_some_and(|given| given.kind == SymbolKind::Property)
        })
        .collect()
}

/// Whether a place stands in the text at a span.
fn is_in(cx: &Cx<'_>, place: SourceRange, span: Span) -> bool {
    cx.span(place)
        .is_some_and(|place| place.file == span.file && span.range.contains_range(place.range))
}

/// Values that an argument may have: those with which a file is found where one was looked for, then those that the comment
/// at its declaration lists.
pub fn possible_values(cx: &Cx<'_>, world: RuleEnv<'_>, name: &str) -> Vec<String> {
    let mut arguments = cx.expansion.arguments.iter();
    let now = arguments.find(|(known, _)| known == name);
    let mut found = now.map_or(Vec::new(), |(_, now)| by_paths(cx, world.vfs, now));
    found.truncate(MOST_VALUES);
    let comment = declared_argument(cx.expansion, name).and_then(|(_, comment)| comment);
    for value in comment.iter().flat_map(|comment| listed(comment)) {
        if !found.contains(&value) {
            found.push(value);
        }
    }
    found
}

/// The values that lead to another file where the value `now` leads to one, or to none.
fn by_paths(cx: &Cx<'_>, vfs: &Vfs, now: &str) -> Vec<String> {
    const SHORTEST: usize = 2;
    let mut found: Vec<String> = Vec::new();
    if now.len() < SHORTEST {
        return found;
    }
    for read in cx.expansion.record.iter() {
        let path = match read {
            Read::Missing(path) => path,
            // of others than data, the path says little: robots lie beside robots
            Read::File(path, _) if is_data(path) => path,
            _ => continue,
        };
        for value in beside(vfs, &vfs.absolute(path), now) {
            if !found.contains(&value) {
                found.push(value);
            }
        }
    }
    found
}

fn is_data(path: &Path) -> bool {
    path.extension()
        .is_some_and(|ending| ending == "yaml" || ending == "yml")
}

/// What may stand in a path in the place of `now`, so that the path leads to a file.
fn beside(vfs: &Vfs, path: &Path, now: &str) -> Vec<String> {
    let mut found = Vec::new();
    for part in path.ancestors() {
        let name = part.file_name().and_then(|name| name.to_str());
        let (Some((before, after)), Some(folder)) =
            (name.and_then(|name| name.split_once(now)), part.parent())
        else {
            continue;
        };
        let Ok(rest) = path.strip_prefix(part) else {
            continue;
        };
        for entry in vfs.list_dir(folder).iter() {
            let value = entry.name.strip_prefix(before);
            let value = value.and_then(|value| value.strip_suffix(after));
            let Some(value) = value.filter(|value| !value.is_empty()) else {
                continue;
            };
            let whole = if rest.as_os_str().is_empty() {
                folder.join(&entry.name)
            } else {
                folder.join(&entry.name).join(rest)
            };
            if vfs.is_file(&whole) {
                found.push(value.to_owned());
            }
        }
    }
    found
}

/// The values that a comment lists: `one of: red, green`, `a | b`.
fn listed(comment: &str) -> Vec<String> {
    const BEGINNINGS: [&str; 5] = ["one of", "options", "choices", "values", "either"];
    let lower = comment.to_ascii_lowercase();
    let begin = BEGINNINGS
        .iter()
        .find_map(|words| Some(lower.find(words)? + words.len()));
    let list = begin.and_then(|begin| comment.get(begin..));
    let Some(list) = list.or(Some(comment).filter(|comment| comment.contains('|'))) else {
        return Vec::new();
    };
    let end = list.find([')', ']', '\n']).unwrap_or(list.len());
    let list = list.get(..end).unwrap_or("").replace(" or ", ", ");
    let words = list.split([',', '|', ';', ':']).map(|word| {
        let quotes = |c: char| matches!(c, '`' | '"' | '\'' | '.' | '(' | '[') || c.is_whitespace();
        word.trim_matches(quotes)
    });
    words
        .filter(|word| !word.is_empty() && !word.contains(char::is_whitespace))
        .map(str::to_owned)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::listed;

    #[test]
    fn comments_list_values() {
        for (comment, expected) in [
            ("one of: red, green", vec!["red", "green"]),
            (
                "The color (one of `red`, `dark_red` or `green`).",
                vec!["red", "dark_red", "green"],
            ),
            ("small | big", vec!["small", "big"]),
            ("which side the hand is on", vec![]),
            ("Options: arm3, arm5.", vec!["arm3", "arm5"]),
        ] {
            assert_eq!(listed(comment), expected, "{comment}");
        }
    }
}

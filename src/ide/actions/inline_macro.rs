//! A macro call gives way to the text of the macro: comments and what does not depend on the call stay as written.

use std::sync::Arc;

use super::expand::{only_frame, source_node};
use super::place::{element_at, indented};
use super::{Action, ActionKind, edit};
use crate::Cx;
use base::{FastMap, TextRange};
use expand::parse_params;
use facts::{MentionKind, facts_of};
use xml::{Item, Node};

/// Put the body of the macro in the place of the call at an offset, with what the call passes for the parameters.
/// Whether the robot stays the same has to be tried out.
pub fn inline_macro(cx: &Cx<'_>, offset: u32) -> Option<Action> {
    let document = &cx.source.document;
    let (base, call) = element_at(document, offset)?;
    let tag = call.start_tag_range().shift(base);
    if base == 0 || !tag.touches(offset) || !document.errors().is_empty() {
        return None;
    }
    let frame = cx.expansion.frames.get(only_frame(cx, tag)?)?;
    let origin = frame.definition?;
    let (definition, item) = (
        source_node(cx, origin)?,
        &cx.expansion.sources.get(origin.src)?.item,
    );
    let text = MacroBody {
        item,
        definition,
        given: given(definition, call)?,
    }
    .text()?;
    let range = call.range().shift(base);
    let content = indented(document, range, &text)?;
    let title = format!("expand macro call `{}`", frame.name);
    Some(Action {
        title,
        kind: ActionKind::Inline,
        edits: vec![edit(cx.source, range, content)],
    })
}

/// What a call passes, by the name of the parameter as the list of parameters spells it. A parameter that the caller's
/// property of the same name stands for is left out: it reads the same outside.
fn given(definition: Node<'_>, call: Node<'_>) -> Option<FastMap<String, String>> {
    let mut given = FastMap::default();
    let mut blocks = call.child_elements();
    for param in definition
        .attr("params")
        .and_then(|params| parse_params(params.raw()))
        .unwrap_or_default()
    {
        let name = param.name.to_string();
        let value = match name.strip_prefix("**") {
            Some(_) => inside(blocks.next()?),
            None if param.is_block() => text_of(blocks.next()?),
            None => match call.attr(&name) {
                Some(attr) => attr.raw().to_owned(),
                None if param.forward => continue,
                None => unquoted(&param.default?.0),
            },
        };
        given.insert(name, value);
    }
    Some(given)
}

/// A default without the quotes around it.
fn unquoted(text: &str) -> String {
    let inner = ['\'', '"']
        .iter()
        .find_map(|quote| text.strip_prefix(*quote)?.strip_suffix(*quote));
    inner.unwrap_or(text).to_owned()
}

fn text_of(node: Node<'_>) -> String {
    node.range().slice(node.item().text()).to_owned()
}

/// What stands between the tags of an element.
fn inside(node: Node<'_>) -> String {
    let Some(end) = node.end_tag() else {
        return String::new();
    };
    TextRange::new(node.start_tag_range().end, end.start)
        .slice(node.item().text())
        .to_owned()
}

/// The body of a macro, and what is passed to it.
struct MacroBody<'a> {
    item: &'a Arc<Item>,
    definition: Node<'a>,
    given: FastMap<String, String>,
}

impl MacroBody<'_> {
    /// The body with what is passed in the place of the parameters.
    fn text(&self) -> Option<String> {
        let item = self.item;
        let range = TextRange::new(
            self.definition.start_tag_range().end,
            self.definition.end_tag()?.start,
        );
        // what these define would be known to others
        if nodes_in(item, range)
            .any(|node| matches!(node.name(), "xacro:macro" | "xacro:include" | "xacro:arg"))
        {
            return None;
        }
        let mut edits: Vec<(TextRange, String)> = Vec::new();
        for node in nodes_in(item, range).filter(|node| node.name() == "xacro:insert_block") {
            let block = self.block(node.attr("name")?.raw())?;
            edits.push((node.range(), block.trim().to_owned()));
        }
        let facts = facts_of(item);
        let sites = facts
            .sites()
            .iter()
            .filter(|site| range.contains_range(site.range));
        for mention in sites
            .flat_map(|site| &site.mentions)
            .filter(|it| it.kind == MentionKind::Name)
        {
            let Some(value) = self.given.get(mention.name.as_str()) else {
                continue;
            };
            let whole = around(item.text(), mention.range);
            let edit = match whole {
                Some(whole) => (whole, value.clone()),
                None => (mention.range, term(value)?),
            };
            if !edits.iter().any(|(known, _)| known.contains_range(edit.0)) {
                edits.push(edit);
            }
        }
        edits.sort_by_key(|(range, _)| range.start);
        let mut text = String::new();
        let mut at = range.start;
        for (place, new) in edits {
            text.push_str(TextRange::new(at, place.start.max(at)).slice(item.text()));
            text.push_str(&new);
            at = place.end;
        }
        text.push_str(TextRange::new(at, range.end.max(at)).slice(item.text()));
        let text = text.trim();
        (!text.is_empty()).then(|| text.to_owned())
    }

    fn block(&self, name: &str) -> Option<&String> {
        self.given
            .get(&format!("*{name}"))
            .or_else(|| self.given.get(&format!("**{name}")))
    }
}

/// The nodes of an item within a range.
fn nodes_in(item: &Item, range: TextRange) -> impl Iterator<Item = Node<'_>> {
    item.all_nodes()
        .filter(move |node| range.contains_range(node.range()))
}

/// The range of `${name}` when the name at a range is all there is to it.
fn around(text: &str, name: TextRange) -> Option<TextRange> {
    let before = text.get(..name.start as usize)?;
    let behind = text.get(name.end as usize..)?;
    let left = before
        .trim_end_matches(' ')
        .strip_suffix("${")
        .filter(|rest| !rest.ends_with('$'))?;
    let blanks = behind.len() - behind.trim_start_matches(' ').len();
    behind.trim_start_matches(' ').strip_prefix('}')?;
    Some(TextRange::new(
        left.len() as u32,
        name.end + blanks as u32 + 1,
    ))
}

/// A value inside of a longer expression; none where that would mean something else.
fn term(value: &str) -> Option<String> {
    let text = value.trim();
    if text.parse::<f64>().is_ok_and(f64::is_finite) {
        return Some(if text.starts_with(['-', '+']) {
            format!("({text})")
        } else {
            text.to_owned()
        });
    }
    let inner = text
        .strip_prefix("${")
        .and_then(|rest| rest.strip_suffix('}'));
    if let Some(inner) = inner.filter(|inner| !inner.contains(['{', '}', '$'])) {
        return Some(format!("({})", inner.trim()));
    }
    let truth = matches!(text.to_ascii_lowercase().as_str(), "true" | "false");
    let plain = !truth && !value.contains(['$', '\'', '"', '\\', '\n', '&', '<']);
    plain.then(|| format!("'{value}'"))
}

#[cfg(test)]
mod tests {
    use super::{around, term};
    use base::TextRange;

    #[test]
    fn names_that_are_alone_give_way_with_their_brackets() {
        for (text, expected) in [
            ("a ${|x} b", Some("${x}")),
            ("${ |x }_y", Some("${ x }")),
            ("${|x * 2}", None),
            ("$${|x}", None),
            ("${f(|x)}", None),
        ] {
            let at = text.find('|').unwrap() as u32;
            let plain = text.replace('|', "");
            let found = around(&plain, TextRange::new(at, at + 1));
            assert_eq!(
                found.map(|range| range.slice(&plain).to_owned()).as_deref(),
                expected,
                "{text}"
            );
        }
    }

    #[test]
    fn values_become_terms() {
        for (value, expected) in [
            ("2", Some("2")),
            ("-1.5", Some("(-1.5)")),
            ("${a + b}", Some("(a + b)")),
            ("pan", Some("'pan'")),
            ("0 0 1", Some("'0 0 1'")),
            ("true", None),
            ("$(arg x)", None),
            ("${a}_b", None),
            ("it's", None),
        ] {
            assert_eq!(term(value).as_deref(), expected, "{value}");
        }
    }
}

//! What is typed in a start tag.

use super::Typing;
use super::typed_text::{Spot, TypedText};
use xml::{Attr, Node};

/// A start tag that is typed.
#[derive(Clone, Copy, Debug)]
pub(super) struct TypedTag<'a> {
    pub node: Node<'a>,
    /// Where its item begins.
    pub base: u32,
}

impl<'a> Spot<'a> {
    /// What is typed in the start tag of an element, or behind one without an end.
    pub fn in_tag(&self, node: Node<'a>, gap: &str) -> Option<TypedText<'a>> {
        let end = node.start_tag_range().end;
        let is_inside = self.inside < end || self.inside == end && !is_finished(node);
        // where the `>` is taken for that of the tag, the value ends with the line at the latest
        let is_other_line = gap.contains(['\n', '\r']);
        let is_over =
            ends_in_bracket(node) && (is_other_line || node.is_self_closing() && !gap.is_empty());
        if !is_inside || is_over {
            return None;
        }
        let (what, start) = self.part_of_tag(node, gap);
        let (base, tag) = (self.base, node.range().start);
        Some(TypedText {
            tag: Some(TypedTag { node, base }),
            ..self.found(what, start, tag)
        })
    }

    fn part_of_tag(&self, node: Node<'a>, gap: &str) -> (Typing<'a>, u32) {
        let name = node.name_range();
        if self.inside <= name.end && gap.is_empty() {
            return (Typing::Tag, name.start);
        }
        let begun = |attr: &Attr<'_>| attr.name_range().start < self.inside;
        let is_over = match node.attrs().take_while(begun).last() {
            None => true,
            Some(attr) if self.inside <= attr.name_range().end && gap.is_empty() => {
                return (Typing::Attribute(node), attr.name_range().start);
            }
            Some(attr) if self.is_in_value(attr, gap) => {
                return (Typing::Value(node, attr.name()), attr.value_range().start);
            }
            // no other attribute follows one that has no value yet
            Some(attr) => {
                !matches!(value_state(attr), ValueState::Missing)
                    && attr.value_range().start <= self.inside
            }
        };
        let is_behind_blank =
            !gap.is_empty() || self.text(0, self.inside).ends_with(char::is_whitespace);
        if is_over && is_behind_blank {
            (Typing::Attribute(node), self.inside)
        } else {
            (Typing::Nothing, self.inside)
        }
    }

    /// Whether the value of the last attribute in front is typed.
    fn is_in_value(&self, attr: Attr<'_>, gap: &str) -> bool {
        let value = attr.value_range();
        let is_here = match value_state(attr) {
            ValueState::Missing | ValueState::Bare => false,
            ValueState::Quoted => self.inside <= value.end,
            // it ends with its line
            ValueState::Unclosed => {
                let is_other_line = has_line_end(self.text(value.start, self.inside));
                !has_line_end(gap) && (self.inside <= value.end || !is_other_line)
            }
        };
        is_here && value.start <= self.inside
    }
}

/// How far a value is written.
enum ValueState {
    /// No `=`, or nothing behind it.
    Missing,
    /// Without quotes.
    Bare,
    /// With a quote in front only.
    Unclosed,
    Quoted,
}

fn value_state(attr: Attr<'_>) -> ValueState {
    let value = attr.value_range();
    let text = attr.item().text();
    let lead = text.get(attr.name_range().end as usize..value.start as usize);
    let is_opened = lead.is_some_and(|lead| lead.ends_with(['"', '\'']));
    match (attr.is_quoted(), is_opened) {
        (true, _) => ValueState::Quoted,
        (false, true) => ValueState::Unclosed,
        (false, false) if value.is_empty() => ValueState::Missing,
        (false, false) => ValueState::Bare,
    }
}

/// Whether a start tag has its `>`, and that is not a part of a value without its closing quote.
fn is_finished(node: Node<'_>) -> bool {
    has_bracket(node) && !ends_in_bracket(node)
}

/// Whether a start tag ends in `>`.
pub(super) fn has_bracket(node: Node<'_>) -> bool {
    node.start_tag_range()
        .slice(node.item().text())
        .ends_with('>')
}

/// Whether the `>` of a start tag stands directly behind a value without its closing quote, and may be a part of it.
fn ends_in_bracket(node: Node<'_>) -> bool {
    let end = node.start_tag_range().end;
    let Some(last) = node.attrs().last() else {
        return false;
    };
    let rest = node
        .item()
        .text()
        .get(last.range().end as usize..end as usize);
    matches!(value_state(last), ValueState::Unclosed) && matches!(rest, Some(">" | "/>"))
}

fn has_line_end(text: &str) -> bool {
    text.contains(['\n', '\r'])
}

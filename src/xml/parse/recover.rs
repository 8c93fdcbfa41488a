//! Guesses about what an author in the middle of typing means. None of them applies to sound text.
#![allow(clippy::indexing_slicing)] // ids of open elements

use super::ItemParser;
use crate::chars::{is_space, name_char};
use crate::node::NodeKind;
use base::Id;

/// Unclosed elements up to which a whole item is cut at its indentation. A limit, so that a file of
/// nothing but start tags is not read again and again.
const MAX_CUT: usize = 4;
/// Columns an indentation may have, and bytes one line is looked at.
const MAX_LINE: usize = 1024;

impl ItemParser<'_> {
    /// The first `<` from `from` on, before `to`, that begins a line and looks like markup.
    pub(super) fn next_line_markup(&self, from: usize, to: usize) -> Option<usize> {
        let text = self.bytes.get(from..to)?;
        memchr::memchr_iter(b'<', text)
            .map(|at| from + at)
            .find(|&at| {
                self.indent(at).is_some()
                    && (name_char(self.text, at + 1, true) > 0
                        || matches!(self.bytes.get(at + 1), Some(b'/' | b'!' | b'?'))
                        || self.is_conflict_marker(at))
            })
    }

    /// The column of `at` if only blanks are before it on its line and the line begins inside the item (or
    /// the file).
    pub(super) fn indent(&self, at: usize) -> Option<usize> {
        let before = self.bytes.get(self.base..at)?;
        let blanks = before
            .iter()
            .rev()
            .take(MAX_LINE)
            .take_while(|&&b| b == b' ' || b == b'\t')
            .count();
        match before.get(..before.len() - blanks)?.last() {
            Some(b'\n' | b'\r') => Some(blanks),
            None if self.in_header => Some(blanks),
            _ => None,
        }
    }

    /// Whether a version control system left a `<<<<<<<` line here.
    pub(super) fn is_conflict_marker(&self, at: usize) -> bool {
        self.bytes
            .get(at..at + 8)
            .is_some_and(|text| text.starts_with(b"<<<<<<<") && text[7] != b'<')
            && self.indent(at) == Some(0)
    }

    /// The offset where white space before `at` begins.
    pub(super) fn trimmed(&self, at: usize) -> usize {
        let before = self.bytes.get(self.base..at).unwrap_or(&[]);
        at - before.iter().rev().take_while(|&&b| is_space(b)).count()
    }

    /// A start tag at `tag` has no `>`; markup follows at `next`. Whether what follows is its content: it
    /// is indented deeper, or is the end tag.
    pub(super) fn keeps_content(&mut self, tag: usize, name_end: usize, next: usize) -> bool {
        let name = self.slice(tag + 1, name_end);
        self.look(next + name.len() + 3);
        self.look(next + 9);
        if self.is_end_tag_of(next, name) {
            return true;
        }
        match (self.indent(tag), self.indent(next)) {
            (Some(outer), Some(inner)) => inner > outer && !self.is_conflict_marker(next),
            _ => false,
        }
    }

    fn is_end_tag_of(&self, at: usize, name: &str) -> bool {
        let Some(rest) = self.text.get(at..).and_then(|rest| rest.strip_prefix("</")) else {
            return false;
        };
        rest.strip_prefix(name)
            .is_some_and(|rest| !name.is_empty() && rest.starts_with(['>', ' ', '\n', '\r']))
    }

    /// An end tag from `start` names no open element. Whether it is meant for the innermost one all the
    /// same: half-typed, renamed on one side, at the same indentation.
    pub(super) fn closes_innermost(&mut self, start: usize, name: &str, complete: bool) -> bool {
        let Some(&id) = self.open.last() else {
            return false;
        };
        let own = self.name_of(id).to_owned();
        if !complete {
            let after = self.pos
                + self.bytes[self.pos..]
                    .iter()
                    .take_while(|&&b| is_space(b))
                    .count();
            self.look(after + own.len() + 3);
            return own.starts_with(name) && !self.is_end_tag_of(after, &own);
        }
        let tag = self.base + self.nodes.as_slice()[id.index()].start as usize;
        let between = self.bytes.get(tag..start).unwrap_or(&[]);
        (between.len() <= MAX_LINE && memchr::memchr2(b'\n', b'\r', between).is_none())
            || self
                .indent(tag)
                .is_some_and(|indent| self.indent(start) == Some(indent))
    }

    /// The top element of the item is never closed, so it swallowed everything up to here. Give back what
    /// stands at its own indentation: end the item before the first such child.
    pub(super) fn cut_item(&mut self) {
        let Some(&top) = self.open.first().filter(|_| self.open.len() <= MAX_CUT) else {
            return;
        };
        let start = self.base + self.nodes.as_slice()[top.index()].start as usize;
        let Some(indent) = self.indent(start) else {
            return;
        };
        let cut = (top.index() + 1..self.nodes.len()).find(|&id| {
            let node = &self.nodes.as_slice()[id];
            node.parent == top.0
                && node.kind == NodeKind::Element
                && self
                    .indent(self.base + node.start as usize)
                    .is_some_and(|own| own <= indent)
        });
        let Some(mut cut) = cut else { return };
        let node = self.nodes.as_slice()[cut];
        self.attrs.truncate(node.attrs.0 as usize);
        let mut at = node.start;
        // White space and comments before an element belong to its item.
        while let Some(before) = cut.checked_sub(1).filter(|&id| id > top.index()) {
            let node = self.nodes.as_slice()[before];
            if node.parent != top.0 || !matches!(node.kind, NodeKind::Text | NodeKind::Comment) {
                break;
            }
            (cut, at) = (before, node.start);
        }
        self.nodes.truncate(cut);
        self.errors.retain(|e| e.error.range.start < at);
        self.open.truncate(1);
        self.lookahead = self.lookahead.max(self.pos);
        self.pos = self.base + at as usize;
    }
}

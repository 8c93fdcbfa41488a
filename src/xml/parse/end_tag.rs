//! End tags, and elements that end without one.

use super::{ContentEnd, ExpatError, ItemParser};
use crate::chars::{name_char, skip_ascii_name};
use crate::error::{Condition, SyntaxError, SyntaxErrorKind as Kind, expat};
use crate::node::{NodeId, NodeKind};

/// Open elements an end tag looks through for its start tag.
const MAX_LOOK: usize = 64;
/// Unclosed elements reported where one end tag closes many.
const MAX_UNCLOSED: usize = 8;

impl ItemParser<'_> {
    pub(super) fn name_of(&self, id: NodeId) -> &str {
        let Some(node) = self.nodes.get(id) else {
            return "";
        };
        let start = self.base + node.start as usize + 1;
        self.slice(start, start + node.name_len as usize)
    }

    /// Read an end tag.
    pub(super) fn end_tag(&mut self) -> Option<ContentEnd> {
        let start = self.pos;
        let (name_end, expat_error) = self.scan_end_tag();
        let complete = self.bytes.get(self.pos - 1) == Some(&b'>');
        let name = self.slice(start + 2, name_end);
        let mismatch = expat_error.unwrap_or((expat::MISMATCH, start + 2));
        let found = self
            .open
            .iter()
            .rev()
            .take(MAX_LOOK)
            .position(|&id| self.name_of(id) == name);
        if let Some(above) = found {
            self.report_end_tag(start, expat_error);
            let depth = self.open.len() - above;
            let tag_end = std::mem::replace(&mut self.pos, start);
            self.close_unclosed(depth, Some((start, tag_end)), mismatch);
            self.pos = tag_end;
            self.close(Some(start));
            return self.open.is_empty().then_some(ContentEnd::Element);
        }
        self.needs_root_name = true;
        self.look(self.pos + 1);
        if name == self.root_name && !name.is_empty() {
            let tag_end = std::mem::replace(&mut self.pos, start);
            self.cut_item();
            self.close_unclosed(0, Some((start, tag_end)), mismatch);
            return Some(ContentEnd::RootEnd);
        }
        self.report_end_tag(start, expat_error);
        if self.closes_innermost(start, name, complete) {
            if complete {
                self.report_renamed(start, name_end, mismatch);
            }
            self.close(Some(start));
            return self.open.is_empty().then_some(ContentEnd::Element);
        }
        self.push_node(NodeKind::Junk, start, 0);
        let message =
            format!("unmatched end tag `</{name}>`\nremove it, or add the start tag `<{name}>`");
        self.error(Kind::MismatchedEndTag, (start, self.pos), mismatch, message);
        None
    }

    /// An end tag of another name, taken for that of the innermost element.
    fn report_renamed(&mut self, start: usize, name_end: usize, expat_error: ExpatError) {
        let Some(node) = self.open.last().and_then(|&id| self.nodes.get(id)) else {
            return;
        };
        let open = self.base + node.start as usize + 1;
        let open_end = open + node.name_len as usize;
        let (name, own) = (self.slice(start + 2, name_end), self.slice(open, open_end));
        let error = SyntaxError {
            kind: Kind::MismatchedEndTag,
            range: self.range(start + 2, name_end),
            related: Some((self.range(open, open_end), "opened here")),
            message: format!(
                "end tag `</{name}>` does not match start tag `<{own}>`\nwrite `</{own}>`, or rename the start tag"
            ),
            expat: expat_error.0,
            expat_offset: self.rel(expat_error.1),
        };
        self.push_error(Condition::Always, error);
    }

    /// Move behind an end tag. Gives the end of its name and, if the tag is malformed, the error of expat.
    pub(super) fn scan_end_tag(&mut self) -> (usize, Option<ExpatError>) {
        let start = self.pos;
        self.pos += 2;
        if name_char(self.text, self.pos, true) == 0 {
            let at = self.pos;
            let expat_error = if self.peek().is_none() {
                (expat::UNCLOSED_TOKEN, start)
            } else {
                (expat::INVALID, at)
            };
            return (at, Some(expat_error));
        }
        self.pos = skip_ascii_name(self.bytes, self.pos);
        loop {
            match name_char(self.text, self.pos, false) {
                0 if self.bytes.get(self.pos) == Some(&b':') => self.pos += 1,
                0 => break,
                n => self.pos += n,
            }
        }
        let name_end = self.pos;
        self.skip_space();
        self.look(self.pos + 1);
        match self.peek() {
            Some(b'>') => {
                self.pos += 1;
                (name_end, None)
            }
            None => (name_end, Some((expat::UNCLOSED_TOKEN, start))),
            Some(_) => {
                let at = self.pos;
                self.pos = name_end;
                (name_end, Some((expat::INVALID, at)))
            }
        }
    }

    pub(super) fn report_end_tag(&mut self, start: usize, expat_error: Option<ExpatError>) {
        if let Some(expat_error) = expat_error {
            let message = format!(
                "end tag `{}` has no `>`\nadd `>`",
                self.slice(start, self.pos)
            );
            self.error(Kind::UnclosedTag, (start, self.pos), expat_error, message);
        }
    }

    /// Close the elements above `depth` here, without end tags of their own.
    pub(super) fn close_unclosed(
        &mut self,
        depth: usize,
        end_tag: Option<(usize, usize)>,
        expat_error: ExpatError,
    ) {
        let mut reported = 0;
        while self.open.len() > depth {
            let Some(&id) = self.open.last() else { return };
            if reported < MAX_UNCLOSED {
                self.report_unclosed(id, end_tag, expat_error);
                reported += 1;
            }
            self.close(None);
        }
    }

    fn report_unclosed(
        &mut self,
        id: NodeId,
        end_tag: Option<(usize, usize)>,
        expat_error: ExpatError,
    ) {
        let Some(node) = self.nodes.get(id) else {
            return;
        };
        let start = self.base + node.start as usize;
        let end = start + 1 + node.name_len as usize;
        let name = self.slice(start + 1, end);
        let message = match end_tag {
            Some((from, _)) => {
                format!(
                    "unclosed element `<{name}>` before `{}`\nadd `</{name}>`",
                    self.tag_name_text(from)
                )
            }
            None => format!("unclosed element `<{name}>`\nadd `</{name}>`"),
        };
        let error = SyntaxError {
            kind: Kind::UnclosedElement,
            range: self.range(start, end),
            related: end_tag
                .map(|(from, to)| (self.range(from, to), "expected the end tag before this")),
            message,
            expat: expat_error.0,
            expat_offset: self.rel(expat_error.1),
        };
        self.push_error(Condition::Always, error);
    }

    fn tag_name_text(&self, from: usize) -> String {
        let name = self.qname(from + 2);
        format!("{}>", self.slice(from, name.end))
    }

    /// Close the innermost element at the current position.
    fn close(&mut self, end_tag: Option<usize>) {
        let end = self.rel(self.pos);
        let subtree_end = self.nodes.len() as u32;
        let tag = end_tag.map(|at| self.rel(at));
        let Some(node) = self.open.pop().and_then(|id| self.nodes.get_mut(id)) else {
            return;
        };
        node.end = end;
        node.subtree_end = subtree_end;
        if let Some(tag) = tag {
            node.end_tag = tag;
        }
        self.scopes.leave(self.open.len());
    }
}

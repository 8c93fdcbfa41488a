//! Comments, CDATA sections, instructions, and what else begins with `<!`.

use super::Parser;
use crate::xml::chars::{is_space, name_char};
use crate::xml::error::{SyntaxErrorKind as Kind, expat};
use crate::xml::node::{CLOSED, NodeKind};

impl Parser<'_> {
    /// Read what begins with `<!` inside the root.
    pub(super) fn bang(&mut self) {
        if self.starts_with(b"<!--") {
            self.comment();
        } else if self.starts_with(b"<![CDATA[") {
            self.cdata();
        } else {
            self.junk_markup();
        }
    }

    fn find(&self, from: usize, needle: &[u8]) -> Option<usize> {
        memchr::memmem::find(self.bytes.get(from..)?, needle).map(|at| from + at)
    }

    /// Read a comment.
    pub(super) fn comment(&mut self) {
        let start = self.pos;
        let mut from = start + 4;
        loop {
            let Some(dashes) = self.find(from, b"--") else {
                return self.unclosed_markup(start, start + 4, NodeKind::Comment, "comment", "-->");
            };
            self.check_characters(from, dashes);
            if self.bytes.get(dashes + 2) == Some(&b'>') {
                self.pos = dashes + 3;
                self.push_node(NodeKind::Comment, start, CLOSED);
                return;
            }
            if dashes + 2 >= self.bytes.len() {
                return self.unclosed_markup(start, start + 4, NodeKind::Comment, "comment", "-->");
            }
            let message = "`--` may not stand in a comment: write `- -`";
            self.error(Kind::BadComment, (dashes, dashes + 2), (expat::INVALID, dashes + 2), message);
            from = dashes + 1;
        }
    }

    fn cdata(&mut self) {
        let start = self.pos;
        match self.find(start + 9, b"]]>") {
            Some(end) => {
                self.check_characters(start, end);
                self.pos = end + 3;
                self.push_node(NodeKind::CData, start, CLOSED);
            }
            None => self.unclosed_markup(start, start + 9, NodeKind::CData, "CDATA section", "]]>"),
        }
    }

    /// Markup that lacks its end: it takes all the rest.
    fn unclosed_markup(&mut self, start: usize, inner: usize, kind: NodeKind, what: &str, close: &str) {
        self.hit_end = true;
        self.pos = self.bytes.len();
        self.check_characters(inner, self.pos);
        self.push_node(kind, start, 0);
        let message = format!("this {what} needs its `{close}`");
        let verdict = match kind {
            NodeKind::CData => (expat::UNCLOSED_CDATA, self.pos),
            _ => (expat::UNCLOSED_TOKEN, start),
        };
        self.error(Kind::UnclosedMarkup, (start, inner.min(self.pos)), verdict, message);
    }

    /// Read an instruction. An XML declaration has its place at the start of the file only.
    pub(super) fn instruction(&mut self) {
        let start = self.pos;
        let name_end = self.instruction_target();
        let Some(end) = self.find(name_end, b"?>") else {
            return self.unclosed_markup(start, start + 2, NodeKind::Pi, "instruction", "?>");
        };
        let target = self.slice(start + 2, name_end);
        let behind = self.bytes.get(name_end).copied().unwrap_or(b' ');
        let at_fault = if target.is_empty() {
            Some((name_end, "an instruction needs a name directly behind `<?`"))
        } else if target != "xml" && target.eq_ignore_ascii_case("xml") {
            Some((name_end, "`xml` in any case is reserved"))
        } else if !is_space(behind) && end != name_end {
            Some((name_end, "a blank is missing behind the name of the instruction"))
        } else {
            None
        };
        if let Some((at, message)) = at_fault {
            self.error(Kind::BadName, (start, name_end), (expat::INVALID, at), message);
        }
        self.check_characters(name_end, end);
        self.pos = end + 2;
        let id = self.push_node(NodeKind::Pi, start, CLOSED);
        if let Some(node) = self.nodes.get_mut(id as usize) {
            node.name_len = (name_end - start - 2) as u32;
        }
        if target == "xml" {
            let message = "the XML declaration must be the very first thing in the file";
            self.error(
                Kind::BadDeclaration,
                (start, self.pos),
                (expat::MISPLACED_DECLARATION, start),
                message,
            );
        }
    }

    fn instruction_target(&self) -> usize {
        let mut end = self.pos + 2;
        let mut first = true;
        loop {
            match name_char(self.text, end, first) {
                0 => return end,
                n => end += n,
            }
            first = false;
        }
    }

    /// `<!` without a meaning here.
    fn junk_markup(&mut self) {
        let start = self.pos;
        let expected: &[u8] = match self.bytes.get(start + 2) {
            Some(b'-') => b"<!--",
            Some(b'[') => b"<![CDATA[",
            _ => b"<!",
        };
        let same =
            expected.iter().zip(self.bytes.get(start..).unwrap_or(&[])).take_while(|(a, b)| a == b).count();
        let at = start + same;
        let stop = memchr::memchr3(b'>', b'\n', b'<', self.bytes.get(at..).unwrap_or(&[]));
        self.pos = stop.map_or(self.bytes.len(), |n| at + n);
        if self.peek() == Some(b'>') {
            self.pos += 1;
        }
        self.push_node(NodeKind::Junk, start, 0);
        let verdict = match self.bytes.get(at) {
            Some(_) => (expat::INVALID, at),
            None => (expat::UNCLOSED_TOKEN, start),
        };
        self.check_characters(at, self.pos);
        let message = "this is neither a comment nor a CDATA section";
        self.error(Kind::UnclosedMarkup, (start, self.pos), verdict, message);
    }
}

//! Comments, CDATA sections, instructions, and what else begins with `<!`.

use super::{ExpatError, ItemParser};
use crate::chars::{first_illegal, is_space, name_char};
use crate::error::{SyntaxErrorKind as Kind, expat};
use crate::node::{CLOSED, NodeKind};

/// Markup with delimiters and free text between.
struct DelimitedMarkup {
    kind: NodeKind,
    open: usize,
    close: &'static str,
    what: &'static str,
}

const COMMENT: DelimitedMarkup = DelimitedMarkup {
    kind: NodeKind::Comment,
    open: 4,
    close: "-->",
    what: "comment",
};
const CDATA: DelimitedMarkup = DelimitedMarkup {
    kind: NodeKind::CData,
    open: 9,
    close: "]]>",
    what: "CDATA section",
};
const INSTRUCTION: DelimitedMarkup = DelimitedMarkup {
    kind: NodeKind::Pi,
    open: 2,
    close: "?>",
    what: "instruction",
};

impl ItemParser<'_> {
    /// Read what begins with `<!` inside the root.
    pub(super) fn bang(&mut self) {
        self.min_offset = Some(0);
        if self.starts_with(b"<!--") {
            self.comment();
        } else if self.starts_with(b"<![CDATA[") {
            self.cdata();
        } else {
            self.junk_markup();
        }
        self.min_offset = None;
    }

    /// Where `needle` occurs from `from` on. What is nowhere is looked for once only: each piece of unclosed
    /// markup would look through all the rest.
    fn find(&mut self, from: usize, needle: &'static str) -> Option<usize> {
        if self
            .absent
            .iter()
            .any(|&(absent, since)| absent == needle && since <= from)
        {
            return None;
        }
        let found = memchr::memmem::find(self.bytes.get(from..)?, needle.as_bytes());
        if found.is_none() {
            self.absent.push((needle, from));
        }
        found.map(|at| from + at)
    }

    /// The first forbidden character from `from` on.
    fn next_illegal(&mut self, from: usize) -> Option<usize> {
        if self.clean {
            return None;
        }
        if !self
            .illegal
            .is_some_and(|(since, at)| since <= from && at.is_none_or(|at| from <= at))
        {
            let found = first_illegal(self.slice(from, self.bytes.len()));
            self.illegal = Some((from, found.map(|at| from + at)));
        }
        self.illegal.and_then(|(_, at)| at)
    }

    /// Read a comment.
    fn comment(&mut self) {
        let start = self.pos;
        let (mut from, mut searched) = (start + 4, start + 4);
        let first_error = self.errors.len();
        loop {
            let dashes = self
                .find(from, "--")
                .filter(|dashes| dashes + 2 < self.bytes.len());
            let Some(dashes) = dashes else {
                return self.unclosed_markup(&COMMENT, start, first_error);
            };
            self.check_characters(from, dashes);
            if self.bytes.get(dashes + 2) == Some(&b'>') {
                self.pos = dashes + 3;
                self.push_node(NodeKind::Comment, start, CLOSED);
                return;
            }
            // A second `<!--` says that the first one was never closed, if markup stands between them.
            let opens = self
                .bytes
                .get(..dashes)
                .is_some_and(|before| before.ends_with(b"<!"));
            if opens {
                if let Some(next) = self.next_line_markup(searched, dashes + 2) {
                    let expat_error = (expat::INVALID, dashes + 2);
                    self.look(dashes + 3);
                    return self.resume_at(&COMMENT, start, (next, first_error), expat_error);
                }
                searched = dashes;
            }
            if self.errors.len() == first_error {
                let message = if opens {
                    "`<!--` is not allowed in a comment\nremove the inner `<!--` and its `-->`; comments cannot be nested"
                } else {
                    "`--` is not allowed in a comment\nwrite `- -`"
                };
                self.error(
                    Kind::BadComment,
                    (dashes, dashes + 2),
                    (expat::INVALID, dashes + 2),
                    message,
                );
            }
            from = dashes + 1;
        }
    }

    fn cdata(&mut self) {
        let start = self.pos;
        match self.find(start + 9, "]]>") {
            Some(end) => {
                self.check_characters(start, end);
                self.pos = end + 3;
                self.push_node(NodeKind::CData, start, CLOSED);
            }
            None => self.unclosed_markup(&CDATA, start, self.errors.len()),
        }
    }

    /// Markup whose end is nowhere: it ends before the next line that begins with markup.
    fn unclosed_markup(&mut self, shape: &DelimitedMarkup, start: usize, first_error: usize) {
        self.hit_end = true;
        let (inner, end) = (start + shape.open, self.bytes.len());
        let expat_error = match self.next_illegal(inner) {
            Some(at) => (expat::INVALID, at),
            None if shape.kind == NodeKind::CData => {
                (expat::UNCLOSED_CDATA, self.cdata_stop(inner))
            }
            None => (expat::UNCLOSED_TOKEN, start),
        };
        if let Some(next) = self.next_line_markup(inner, end) {
            return self.resume_at(shape, start, (next, first_error), expat_error);
        }
        self.pos = end;
        if self.errors.len() == first_error {
            self.check_characters(inner, end);
        }
        self.push_node(shape.kind, start, 0);
        self.report_unclosed_markup(shape, start, expat_error);
    }

    /// Where expat waits for the rest of an unclosed CDATA section: before what may be half of its end.
    fn cdata_stop(&self, inner: usize) -> usize {
        match self.bytes.get(inner..).unwrap_or(&[]) {
            [.., b']', b']'] => self.bytes.len() - 2,
            [.., b']'] => self.bytes.len() - 1,
            _ => self.bytes.len(),
        }
    }

    /// End unclosed markup before `next`. What was found since `first_error` may lie behind that; there it
    /// will be found again, as something else.
    fn resume_at(
        &mut self,
        shape: &DelimitedMarkup,
        start: usize,
        next: (usize, usize),
        expat_error: ExpatError,
    ) {
        let (next, first_error) = next;
        let found = self.errors.get(first_error);
        let expat_error = found.map_or(expat_error, |e| {
            (e.error.expat, self.base + e.error.expat_offset as usize)
        });
        self.errors.truncate(first_error);
        self.min_offset = Some(0);
        self.pos = self.trimmed(next).max(start + shape.open);
        self.push_node(shape.kind, start, 0);
        self.report_unclosed_markup(shape, start, expat_error);
        self.mark_divergence();
    }

    fn report_unclosed_markup(
        &mut self,
        shape: &DelimitedMarkup,
        start: usize,
        expat_error: ExpatError,
    ) {
        let (what, close) = (shape.what, shape.close);
        let line = self
            .slice(start + shape.open, self.pos)
            .split('\n')
            .next()
            .unwrap_or_default();
        let message = if shape.kind == NodeKind::Comment && line.contains("->") {
            format!("unclosed {what}: `{close}` is missing\nwrite `{close}` instead of `->`")
        } else {
            format!("unclosed {what}: `{close}` is missing\nadd `{close}`")
        };
        let end = (start + shape.open).min(self.pos);
        self.error(Kind::UnclosedMarkup, (start, end), expat_error, message);
    }

    /// Read an instruction. An XML declaration has its place at the start of the file only.
    pub(super) fn instruction(&mut self) {
        let start = self.pos;
        self.min_offset = Some(0);
        let first_error = self.errors.len();
        let name_end = self.instruction_target();
        let target = self.slice(start + 2, name_end);
        let next = self.bytes.get(name_end).copied();
        let fault = match next {
            None => None,
            Some(_) if target.is_empty() => Some((
                name_end,
                "missing name after `<?`\nwrite the name of the processing instruction directly after `<?`",
            )),
            Some(b)
                if (is_space(b) || b == b'?')
                    && target != "xml"
                    && target.eq_ignore_ascii_case("xml") =>
            {
                Some((
                    name_end,
                    "`xml` is reserved in upper and lower case\nuse another name",
                ))
            }
            Some(b'?') if self.bytes.get(name_end + 1).is_some_and(|&b| b != b'>') => Some((
                name_end + 1,
                "missing space after the name of the processing instruction\nadd a space",
            )),
            Some(b) if is_space(b) || b == b'?' => None,
            Some(_) => Some((
                name_end,
                "missing space after the name of the processing instruction\nadd a space",
            )),
        };
        if let Some((at, message)) = fault {
            self.error(
                Kind::BadName,
                (start, name_end),
                (expat::INVALID, at),
                message,
            );
        }
        match self.find(name_end, "?>") {
            Some(end) => {
                self.check_characters(name_end, end);
                self.pos = end + 2;
                self.push_node(NodeKind::Pi, start, CLOSED);
            }
            None => self.unclosed_markup(&INSTRUCTION, start, first_error),
        }
        if let Some(node) = self.nodes.last_mut() {
            node.name_len = (name_end - start - 2) as u32;
        }
        if target == "xml" && self.starts_declaration(start) {
            let message =
                "XML declaration is not at the start of the file\nmove it to the start of the file";
            self.error(
                Kind::BadDeclaration,
                (start, self.pos),
                (expat::MISPLACED_DECLARATION, start),
                message,
            );
        }
        self.min_offset = None;
    }

    fn starts_declaration(&self, start: usize) -> bool {
        self.nodes
            .last()
            .is_some_and(|node| node.flags & CLOSED != 0)
            && self
                .bytes
                .get(start + 5)
                .is_some_and(|&b| is_space(b) || b == b'?')
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
        let text = self.bytes.get(start..).unwrap_or(&[]);
        let at = start
            + expected
                .iter()
                .zip(text)
                .take_while(|(a, b)| a == b)
                .count();
        let stop = self
            .bytes
            .get(at..)
            .unwrap_or(&[])
            .iter()
            .position(|b| b"<>\r\n".contains(b));
        self.pos = stop.map_or(self.bytes.len(), |n| at + n);
        if self.peek() == Some(b'>') {
            self.pos += 1;
        }
        self.push_node(NodeKind::Junk, start, 0);
        let expat_error = match self.bytes.get(at) {
            // expat waits for all of `<![CDATA[` before it looks at it.
            Some(_) if expected.len() < 9 || text.len() >= 9 => (expat::INVALID, at),
            _ => {
                self.hit_end = true;
                (expat::UNCLOSED_TOKEN, start)
            }
        };
        let message = "invalid markup after `<!`\nwrite a comment: <!-- ... -->";
        self.error(
            Kind::UnclosedMarkup,
            (start, self.pos),
            expat_error,
            message,
        );
    }
}

//! The header, with everything before the root's content, and the footer.

use std::sync::Arc;

use super::declaration::check_declaration;
use super::token::DoctypeToken;
use super::{ContentEnd, ExpatError, ItemParser};
use crate::chars::name_char;
use crate::decode::decode;
use crate::entities::Entities;
use crate::error::{SyntaxErrorKind as Kind, expat};
use crate::item::Item;
use crate::node::{CLOSED, NodeKind};
use base::{FastMap, TextRange};

/// The part of a document behind its last item.
#[derive(Clone)]
pub(crate) struct Footer {
    pub(crate) item: Arc<Item>,
    /// How many of its nodes, top-level or not, are inside the root.
    pub(crate) inner: u32,
    /// The root's end tag, relative to the footer.
    pub(crate) root_end: Option<TextRange>,
}

/// How the header leaves the root element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RootState {
    /// There is no root: the header is the whole file.
    Missing,
    /// The root has content.
    Open,
    /// The root is `<robot/>`, or its tag was given up.
    Empty,
}

/// The part of a document before the root's content, and what it says about the rest.
pub(crate) struct Header {
    pub(crate) item: Arc<Item>,
    pub(crate) root_name: Box<str>,
    pub(crate) root: RootState,
    pub(crate) entities: Entities,
    /// The root's namespace declarations.
    pub(crate) namespaces: FastMap<Box<str>, Box<str>>,
}

impl<'t> ItemParser<'t> {
    /// Read everything up to and including the root's start tag.
    pub(crate) fn header(&mut self) -> Header {
        self.begin_item();
        self.in_header = true;
        let mut entities = Entities::default();
        if self.starts_with("\u{FEFF}".as_bytes()) {
            self.pos += 3;
        }
        entities.standalone = self.declaration();
        let mut root = RootState::Missing;
        while self.outside(Some(&mut entities)) {
            if self.at_tag() {
                let name = self.qname(self.pos + 1);
                self.root_name = self.slice(self.pos + 1, name.end);
                self.start_tag();
                root = if self.open.is_empty() {
                    RootState::Empty
                } else {
                    RootState::Open
                };
                break;
            }
        }
        if root == RootState::Missing {
            let at = self.pos;
            let start = self.base + self.text.trim_end().len();
            let message = "no root element\nadd <robot name=\"...\">";
            self.error(
                Kind::NoRoot,
                (start.min(at), at),
                (expat::NO_ELEMENT, at),
                message,
            );
        }
        entities.resolve();
        let namespaces = self.root_namespaces(&entities);
        let item = Arc::new(self.finish_item());
        Header {
            item,
            root_name: self.root_name.into(),
            root,
            entities,
            namespaces,
        }
    }

    fn root_namespaces(&self, entities: &Entities) -> FastMap<Box<str>, Box<str>> {
        let mut bound = FastMap::default();
        for attr in self.nodes.last().map_or(&[][..], |root| {
            self.attrs
                .get(root.attrs.0 as usize..root.attrs.1 as usize)
                .unwrap_or(&[])
        }) {
            let start = self.base + attr.name as usize;
            let name = self.slice(start, start + attr.name_len as usize);
            let Some(prefix) = name.strip_prefix("xmlns:") else {
                continue;
            };
            let raw = self.slice(
                self.base + attr.value as usize,
                self.base + attr.value_end as usize,
            );
            bound
                .entry(prefix.into())
                .or_insert_with(|| decode(raw, entities, true).into());
        }
        bound
    }

    pub(super) fn at_tag(&self) -> bool {
        self.bytes.get(self.pos) == Some(&b'<')
            && (name_char(self.text, self.pos + 1, true) > 0
                || self.bytes.get(self.pos + 1) == Some(&b':'))
    }

    /// Read the XML declaration, if the text begins with one. Gives whether it says `standalone`.
    fn declaration(&mut self) -> bool {
        let start = self.pos;
        if !self.starts_with(b"<?xml") || name_char(self.text, start + 5, false) > 0 {
            return false;
        }
        self.instruction();
        let Some(node) = self
            .nodes
            .last_mut()
            .filter(|node| node.flags & CLOSED != 0)
        else {
            return false;
        };
        node.kind = NodeKind::Declaration;
        // Only its place would have been wrong.
        self.errors
            .retain(|e| e.error.expat != expat::MISPLACED_DECLARATION);
        let standalone = check_declaration(self.slice(0, self.pos - 2), start + 5);
        if let Err(at) = standalone
            && self.errors.is_empty()
        {
            let message = "malformed XML declaration\nwrite <?xml version=\"1.0\"?>";
            self.error(
                Kind::BadDeclaration,
                (start, self.pos),
                (expat::BAD_DECLARATION, at),
                message,
            );
        }
        standalone == Ok(true)
    }

    /// Read one thing outside the root. Gives whether there is more; stops in front of a start tag.
    fn outside(&mut self, entities: Option<&mut Entities>) -> bool {
        let in_prolog = entities.is_some();
        self.skip_space();
        if self.peek().is_none() {
            return false;
        }
        if self.at_tag() {
            return true;
        }
        if self.starts_with(b"<!--") {
            self.bang();
        } else if self.starts_with(b"<?") {
            self.instruction();
            if !in_prolog {
                self.misplaced_behind_root();
            }
        } else if let Some(entities) = entities.filter(|_| self.at_doctype()) {
            self.doctype(entities);
        } else if self.is_conflict_marker(self.pos) {
            self.conflict_marker();
        } else {
            self.junk_outside(in_prolog);
        }
        true
    }

    /// Behind the root, expat has no special word for an XML declaration.
    fn misplaced_behind_root(&mut self) {
        if let Some(last) = self
            .errors
            .last_mut()
            .filter(|e| e.error.expat == expat::MISPLACED_DECLARATION)
        {
            last.error.expat = expat::JUNK;
        }
    }

    /// Text or markup that has no place outside the root.
    fn junk_outside(&mut self, in_prolog: bool) {
        let start = self.pos;
        let expat_error = self.expat_error_outside(
            start,
            if in_prolog {
                expat::SYNTAX
            } else {
                expat::JUNK
            },
        );
        let rest = self.bytes.get(start + 1..).unwrap_or(&[]);
        self.pos = memchr::memchr(b'<', rest).map_or(self.bytes.len(), |n| start + 1 + n);
        let end = start + self.slice(start, self.pos).trim_end().len();
        self.push_node(NodeKind::Junk, start, 0);
        let text = self.slice(start, end);
        let message = if text.starts_with("</") && text.ends_with('>') {
            format!("extra end tag `{text}`\nremove `{text}`")
        } else {
            "text outside the root element\nremove the text, or put it in a comment <!-- ... -->"
                .to_owned()
        };
        self.error(Kind::OutsideRoot, (start, end), expat_error, message);
        self.mark_divergence();
    }

    /// What expat says to the text at `start`, where it expects another kind of token.
    fn expat_error_outside(&mut self, start: usize, unexpected: &'static str) -> ExpatError {
        let (token, end) = self.token(start);
        self.look(end + 1);
        match token {
            DoctypeToken::Invalid(at) => {
                self.look(at + 1);
                (expat::INVALID, at)
            }
            DoctypeToken::Unfinished => {
                self.hit_end = true;
                (expat::UNCLOSED_TOKEN, start)
            }
            DoctypeToken::TagOpen if unexpected == expat::SYNTAX => (expat::INVALID, start + 1),
            DoctypeToken::ParameterReference if unexpected == expat::SYNTAX => {
                (expat::PARAMETER_REFERENCE, start)
            }
            _ => (unexpected, start),
        }
    }

    /// Whether a DOCTYPE begins here; there can be only one.
    fn at_doctype(&self) -> bool {
        let (token, end) = self.token(self.pos);
        !self.has_doctype
            && token == DoctypeToken::DeclarationOpen
            && self.slice(self.pos, end) == "<!DOCTYPE"
    }

    /// The current item has no element: it is the footer. Read the rest of the file.
    pub(super) fn footer(&mut self, stop: ContentEnd) -> Footer {
        let inner = self.nodes.len() as u32;
        let mut root_end = None;
        if stop == ContentEnd::RootEnd {
            let start = self.pos;
            let (_, expat_error) = self.scan_end_tag();
            self.report_end_tag(start, expat_error);
            root_end = Some(self.range(start, self.pos));
            self.epilog();
        } else {
            let (at, root) = (self.pos, self.root_name);
            let message = format!("unclosed root element `<{root}>`\nadd `</{root}>`");
            self.error(
                Kind::UnclosedElement,
                (at, at),
                (expat::NO_ELEMENT, at),
                message,
            );
        }
        self.hit_end = true;
        Footer {
            item: Arc::new(self.finish_item()),
            inner,
            root_end,
        }
    }

    /// Read what follows a root without content.
    pub(crate) fn bare_footer(&mut self) -> Footer {
        self.begin_item();
        self.epilog();
        self.hit_end = true;
        Footer {
            item: Arc::new(self.finish_item()),
            inner: 0,
            root_end: None,
        }
    }

    fn epilog(&mut self) {
        self.root_name = "";
        while self.outside(None) {
            if !self.at_tag() {
                continue;
            }
            let start = self.pos;
            let name = self.qname(start + 1);
            let text = self.slice(start + 1, name.end);
            let message = format!(
                "`<{text}>` is after the end of the root element\nmove it before the end tag of the root element"
            );
            let expat_error = self.expat_error_outside(start, expat::JUNK);
            self.error(Kind::OutsideRoot, (start, name.end), expat_error, message);
            if self.start_tag().is_none() {
                self.content();
            }
        }
    }
}

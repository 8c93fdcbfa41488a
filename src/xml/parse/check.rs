//! What a parser checks once it has a whole start tag: duplicates, references, namespaces.
#![allow(clippy::indexing_slicing)] // attribute numbers this parser made itself

use std::collections::HashSet;

use super::ItemParser;
use crate::decode::{Reference, decode, references};
use crate::entities::Entities;
use crate::error::{Condition, Namespace, SyntaxError, SyntaxErrorKind as Kind, expat};
use crate::node::{AttrData, NEEDS_DECODING, PREFIXED};
use base::limits::ITEM_ERRORS;

/// Attributes compared pair by pair; beyond that a set is used.
const FEW: usize = 12;
const XML_URI: &str = "http://www.w3.org/XML/1998/namespace";
const XMLNS_URI: &str = "http://www.w3.org/2000/xmlns/";

impl<'t> ItemParser<'t> {
    /// Check the tag at `tag` with the attributes from `first` on. `name_end` is the end of its name if it
    /// has a prefix.
    pub(super) fn check_tag(&mut self, tag: usize, name_end: usize, first: usize) {
        if self.attrs.len() > first {
            self.check_attributes(tag, first);
        }
        if name_end > tag {
            self.check_prefix(tag, tag + 1, self.slice(tag + 1, name_end));
        }
    }

    fn check_attributes(&mut self, tag: usize, first: usize) {
        let mut prefixed = false;
        let mut seen = (self.attrs.len() - first > FEW).then(HashSet::new);
        for at in first..self.attrs.len() {
            let attr = self.attrs[at];
            let name = self.attr_name(&attr);
            let twice = match &mut seen {
                Some(seen) => !seen.insert(name),
                None => self.attrs[first..at]
                    .iter()
                    .any(|other| self.attr_name(other) == name),
            };
            if twice {
                self.duplicate(first, at, name);
            }
            if attr.flags & NEEDS_DECODING != 0 {
                self.check_references(tag, &attr);
            }
            prefixed |= attr.flags & PREFIXED != 0;
            if name.starts_with("xmlns") {
                self.check_declaration(tag, &attr, name);
            }
        }
        if prefixed {
            self.check_attribute_prefixes(tag, first);
        }
    }

    fn attr_name(&self, attr: &AttrData) -> &'t str {
        let start = self.base + attr.name as usize;
        self.slice(start, start + attr.name_len as usize)
    }

    fn duplicate(&mut self, first: usize, at: usize, name: &str) {
        if self.errors.len() >= ITEM_ERRORS {
            return;
        }
        let before = self.attrs[first..at]
            .iter()
            .find(|other| self.attr_name(other) == name)
            .copied();
        let attr = self.attrs[at];
        let range = base::TextRange::new(attr.name, attr.name + attr.name_len);
        let error = SyntaxError {
            kind: Kind::DuplicateAttribute,
            range,
            related: before.map(|attr| {
                let range = base::TextRange::new(attr.name, attr.name + attr.name_len);
                (range, "first one here")
            }),
            message: format!("duplicate attribute `{name}`\nremove one of them"),
            expat: expat::DUPLICATE,
            expat_offset: attr.name,
        };
        self.push_error(Condition::Always, error);
    }

    fn check_references(&mut self, tag: usize, attr: &AttrData) {
        let start = self.base + attr.value as usize;
        for (at, reference) in references(self.slice(start, self.base + attr.value_end as usize)) {
            let at = start + at;
            match reference {
                Reference::Bad(_) | Reference::Char(Some(_), _) => {}
                Reference::Char(None, end) => self.bad_character_reference(at, start + end, at),
                Reference::Entity { name, end } => {
                    self.entity_use(name, (at, start + end), tag, true)
                }
            }
        }
    }

    /// A namespace declaration binds its prefix, if it may.
    fn check_declaration(&mut self, tag: usize, attr: &AttrData, name: &'t str) {
        let prefix = match name.strip_prefix("xmlns:") {
            Some(prefix) => prefix,
            None if name == "xmlns" => "",
            None => return,
        };
        let start = self.base + attr.value as usize;
        let raw = self.slice(start, self.base + attr.value_end as usize);
        let uri = match attr.flags & NEEDS_DECODING {
            0 => raw.to_owned(),
            _ => decode(raw, &Entities::default(), true).into_owned(),
        };
        if let Some((expat_error, message)) = declaration_fault(prefix, &uri) {
            let range = (start, start + raw.len());
            self.error(Kind::BadNamespace, range, (expat_error, tag), message);
        }
        if !prefix.is_empty() && prefix != "xml" {
            self.scopes.bind(prefix, uri, self.open.len() + 1);
        }
    }

    /// `name`, at `start` inside the tag at `tag`, has a prefix that must be bound.
    fn check_prefix(&mut self, tag: usize, start: usize, name: &'t str) {
        let Some((prefix, _)) = name.split_once(':') else {
            return;
        };
        if prefix == "xml" || self.scopes.lookup(prefix).is_some() || self.scopes.is_outer(prefix) {
            return;
        }
        // One report per item is plenty: whatever uses the prefix later is wrong for the same reason.
        self.scopes.add_outer(prefix);
        let error = SyntaxError {
            kind: Kind::UnboundPrefix,
            range: self.range(start, start + prefix.len()),
            related: None,
            // nearly every item of xacro has one of these: the words are for those that are wrong
            message: String::new(),
            expat: expat::UNBOUND,
            expat_offset: self.rel(tag),
        };
        self.push_error(Condition::UnlessBound, error);
    }

    fn check_attribute_prefixes(&mut self, tag: usize, first: usize) {
        let mut prefixed: Vec<(&'t str, &'t str, AttrData)> = Vec::new();
        for at in first..self.attrs.len() {
            let attr = self.attrs[at];
            let name = self.attr_name(&attr);
            let Some((prefix, local)) = name.split_once(':') else {
                continue;
            };
            if attr.flags & PREFIXED == 0 || prefix == "xmlns" {
                continue;
            }
            self.check_prefix(tag, self.base + attr.name as usize, name);
            prefixed.push((local, prefix, attr));
        }
        if prefixed.len() < 2 {
            return;
        }
        // Same local name under two prefixes: a duplicate if both mean the same namespace.
        prefixed.sort_by_key(|&(local, _, attr)| (local, attr.name));
        for pair in prefixed.windows(2) {
            let [(local, before, _), (other, prefix, attr)] = pair else {
                continue;
            };
            if local == other && before != prefix {
                self.same_namespace(tag, attr, (before, prefix), local);
            }
        }
    }

    fn same_namespace(&mut self, tag: usize, attr: &AttrData, prefixes: (&str, &str), local: &str) {
        let (one, two) = (self.namespace(prefixes.0), self.namespace(prefixes.1));
        let error = SyntaxError {
            kind: Kind::DuplicateAttribute,
            range: base::TextRange::new(attr.name, attr.name + attr.name_len),
            related: None,
            message: format!(
                "duplicate attribute: `{0}:{local}` and `{1}:{local}` have the same namespace\nremove one of them",
                prefixes.0, prefixes.1
            ),
            expat: expat::DUPLICATE,
            expat_offset: self.rel(tag),
        };
        self.push_error(Condition::SameNamespace(one, two), error);
    }

    fn namespace(&self, prefix: &str) -> Namespace {
        match self.scopes.lookup(prefix) {
            Some(uri) => Namespace::Uri(uri.into()),
            None if prefix == "xml" => Namespace::Uri(XML_URI.into()),
            None => Namespace::Outer(prefix.into()),
        }
    }
}

/// Why a namespace may not be declared like this.
fn declaration_fault(prefix: &str, uri: &str) -> Option<(&'static str, String)> {
    Some(match (prefix, uri) {
        ("", "") => return None,
        (_, "") => (
            expat::UNDECLARED,
            format!(
                "empty namespace for prefix `{prefix}`\nwrite xmlns:{prefix}=\"...\" with a URI"
            ),
        ),
        ("xmlns", _) => (
            expat::RESERVED_XMLNS,
            "prefix `xmlns` must not be declared\nremove the declaration".to_owned(),
        ),
        _ if uri.contains(' ') => (
            expat::SYNTAX,
            "namespace contains whitespace\nremove the whitespace".to_owned(),
        ),
        ("xml", XML_URI) => return None,
        ("xml", _) => (
            expat::RESERVED_XML,
            format!("prefix `xml` is reserved for `{XML_URI}`\nremove the declaration"),
        ),
        (_, XML_URI | XMLNS_URI) => (
            expat::RESERVED_URI,
            format!("namespace `{uri}` is reserved\nuse another namespace"),
        ),
        _ => return None,
    })
}

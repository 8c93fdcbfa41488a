//! Qualified names and namespace scopes.

use std::collections::HashSet;

use super::ItemParser;
use crate::chars::{is_space, name_char, skip_ascii_name};
use base::FastMap;

/// A name as it stands in the text.
pub(super) struct QName {
    pub(super) end: usize,
    pub(super) prefixed: bool,
    /// Where the grammar breaks, if it does.
    pub(super) bad: Option<usize>,
}

impl ItemParser<'_> {
    /// Read a qualified name at `start`: `name` or `prefix:name`. A name with a mistake goes on to the next
    /// character that certainly is not part of it.
    pub(super) fn qname(&self, start: usize) -> QName {
        // nearly all names end here
        let plain = skip_ascii_name(self.bytes, start);
        if plain > start
            && self
                .bytes
                .get(plain)
                .is_some_and(|&b| b != b':' && b < 0x80)
        {
            return QName {
                end: plain,
                prefixed: false,
                bad: None,
            };
        }
        let mut end = start;
        let mut prefixed = false;
        let mut bad = None;
        let mut first = true;
        loop {
            match name_char(self.text, end, first) {
                0 if first => bad = Some(end),
                0 if self.bytes.get(end) == Some(&b':') => {
                    if prefixed {
                        bad = Some(end);
                    } else {
                        (prefixed, first) = (true, true);
                        end += 1;
                        continue;
                    }
                }
                0 => {}
                n => {
                    first = false;
                    end += n;
                    continue;
                }
            }
            break;
        }
        if bad.is_some() {
            while self
                .bytes
                .get(end)
                .is_some_and(|&b| !is_space(b) && !b"/><=\"'&{}$?".contains(&b))
            {
                end = self.char_end(end);
            }
        }
        QName { end, prefixed, bad }
    }
}

/// The namespace declarations in force inside an item.
#[derive(Default)]
pub(super) struct NamespaceScopes<'t> {
    bindings: Vec<NamespaceBinding<'t>>,
    current: FastMap<&'t str, usize>,
    /// Prefixes used without a declaration inside the item.
    outer: HashSet<&'t str>,
    /// The one of them that was asked about last: nearly always the only one.
    last_outer: Option<&'t str>,
}

struct NamespaceBinding<'t> {
    prefix: &'t str,
    uri: String,
    /// How many elements were open at the declaration.
    depth: usize,
    /// The binding it hides.
    hidden: Option<usize>,
}

impl<'t> NamespaceScopes<'t> {
    pub(super) fn clear(&mut self) {
        self.bindings.clear();
        self.current.clear();
        self.outer.clear();
        self.last_outer = None;
    }

    /// Whether a prefix was used before without a declaration inside the item.
    #[inline]
    pub(super) fn is_outer(&mut self, prefix: &'t str) -> bool {
        if self.last_outer == Some(prefix) {
            return true;
        }
        let is_outer = self.outer.contains(prefix);
        if is_outer {
            self.last_outer = Some(prefix);
        }
        is_outer
    }

    pub(super) fn add_outer(&mut self, prefix: &'t str) {
        self.outer.insert(prefix);
        self.last_outer = Some(prefix);
    }

    pub(super) fn bind(&mut self, prefix: &'t str, uri: String, depth: usize) {
        let hidden = self.current.insert(prefix, self.bindings.len());
        self.bindings.push(NamespaceBinding {
            prefix,
            uri,
            depth,
            hidden,
        });
    }

    pub(super) fn lookup(&self, prefix: &str) -> Option<&str> {
        if self.bindings.is_empty() {
            return None;
        }
        let at = *self.current.get(prefix)?;
        self.bindings.get(at).map(|binding| binding.uri.as_str())
    }

    /// Forget the declarations of elements deeper than `depth`.
    pub(super) fn leave(&mut self, depth: usize) {
        while let Some(binding) = self.bindings.pop_if(|binding| binding.depth > depth) {
            match binding.hidden {
                Some(at) => self.current.insert(binding.prefix, at),
                None => self.current.remove(binding.prefix),
            };
        }
    }
}

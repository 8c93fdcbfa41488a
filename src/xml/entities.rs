//! General entities and what references to them stand for.

use std::borrow::Cow;
use std::ops::Range;

use super::chars::{is_legal, name_char, skip_name};
use crate::base::FastMap;

/// Bytes one entity, or one value with entities, may grow to: the size from which expat starts to watch.
const MAX_EXPANSION: usize = 8 << 20;
/// Entities nested in each other at most.
const MAX_DEPTH: u32 = 64;

/// The general entities a document declares, and the five it need not declare.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Entities {
    declared: FastMap<Box<str>, Entity>,
    /// Declarations may hide in places that are not read, so an unknown entity is no error but empty.
    pub(super) incomplete: bool,
}

/// A declared entity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Entity {
    /// Its replacement text: character references resolved, others not.
    Internal(Box<str>),
    /// `SYSTEM`, `PUBLIC`: never read.
    External,
    /// `NDATA`.
    Unparsed,
}

/// Why a reference to an entity has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EntityFault {
    Undefined,
    Recursive,
    TooLarge,
    Unparsed,
    ExternalInAttribute,
    /// Its replacement text has a `<`, in an attribute value.
    Markup,
    /// Its replacement text is not well-formed by itself.
    Malformed,
}

impl Entities {
    pub(super) fn declare(&mut self, name: &str, entity: Entity) {
        // The first declaration counts.
        self.declared.entry(name.into()).or_insert(entity);
    }

    /// Whether any entity is declared.
    pub fn is_empty(&self) -> bool {
        self.declared.is_empty()
    }

    /// The first entity named in `raw` whose replacement text holds markup: the tree does not show that.
    pub fn markup_entity<'r>(&self, raw: &'r str) -> Option<&'r str> {
        if self.declared.is_empty() {
            return None;
        }
        references(raw).find_map(|(_, reference)| match reference {
            Reference::Entity { name, .. } if self.holds_markup(name, 0) => Some(name),
            _ => None,
        })
    }

    fn holds_markup(&self, name: &str, depth: u32) -> bool {
        let Some(Entity::Internal(text)) = self.declared.get(name) else { return false };
        text.contains('<')
            || (depth < MAX_DEPTH
                && references(text).any(|(_, reference)| match reference {
                    Reference::Entity { name, .. } => self.holds_markup(name, depth + 1),
                    _ => false,
                }))
    }

    /// The value of `&name;`, or why it has none.
    pub(super) fn value(&self, name: &str, is_attr: bool) -> Result<Cow<'_, str>, EntityFault> {
        if let Some(c) = predefined(name) {
            return Ok(Cow::Borrowed(c));
        }
        let mut out = String::new();
        self.expand(name, is_attr, 0, &mut out)?;
        Ok(Cow::Owned(out))
    }

    fn expand(&self, name: &str, is_attr: bool, depth: u32, out: &mut String) -> Result<(), EntityFault> {
        let text = match self.declared.get(name) {
            Some(Entity::Internal(text)) => text,
            Some(Entity::External) if is_attr => return Err(EntityFault::ExternalInAttribute),
            Some(Entity::External) => return Ok(()),
            Some(Entity::Unparsed) => return Err(EntityFault::Unparsed),
            None if self.incomplete => return Ok(()),
            None => return Err(EntityFault::Undefined),
        };
        if depth > MAX_DEPTH {
            return Err(EntityFault::Recursive);
        }
        if is_attr && text.contains('<') {
            return Err(EntityFault::Markup);
        }
        let mut fault = None;
        each_piece(text, is_attr, &mut |piece, _| {
            match piece {
                Piece::Text(text) => out.push_str(text),
                Piece::Char(c) => out.push(c),
                Piece::Entity(name) => match predefined(name) {
                    Some(text) => out.push_str(text),
                    None => fault = self.expand(name, is_attr, depth + 1, out).err(),
                },
            }
            if out.len() > MAX_EXPANSION {
                fault = Some(EntityFault::TooLarge);
            }
            fault.is_none()
        });
        fault.map_or(Ok(()), Err)
    }
}

fn predefined(name: &str) -> Option<&'static str> {
    Some(match name {
        "amp" => "&",
        "lt" => "<",
        "gt" => ">",
        "quot" => "\"",
        "apos" => "'",
        _ => return None,
    })
}

/// A `&` and what follows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reference<'t> {
    /// Not a reference: the offset of the first byte that does not fit.
    Bad(usize),
    /// A character, `None` when XML forbids it, and the offset behind the `;`.
    Char(Option<char>, usize),
    /// A named entity.
    Entity { name: &'t str, end: usize },
}

/// Read the reference whose `&` stands at `at`.
pub(super) fn read_reference(text: &str, at: usize) -> Reference<'_> {
    let bytes = text.as_bytes();
    let after = at + 1;
    if bytes.get(after) != Some(&b'#') {
        if name_char(text, after, true) == 0 {
            return Reference::Bad(after);
        }
        let end = skip_name(text, after);
        return match (bytes.get(end), text.get(after..end)) {
            (Some(b';'), Some(name)) => Reference::Entity { name, end: end + 1 },
            _ => Reference::Bad(end),
        };
    }
    let (radix, start) = if bytes.get(after + 1) == Some(&b'x') { (16, after + 2) } else { (10, after + 1) };
    let mut end = start;
    let mut code = 0u32;
    while let Some(digit) = bytes.get(end).and_then(|b| (*b as char).to_digit(radix)) {
        code = code.saturating_mul(radix).saturating_add(digit);
        end += 1;
    }
    if end == start || bytes.get(end) != Some(&b';') {
        return Reference::Bad(end);
    }
    Reference::Char(char::from_u32(code).filter(|&c| is_legal(c)), end + 1)
}

/// The references of `text` with their offsets.
pub(super) fn references(text: &str) -> impl Iterator<Item = (usize, Reference<'_>)> {
    memchr::memchr_iter(b'&', text.as_bytes()).map(move |at| (at, read_reference(text, at)))
}

enum Piece<'t> {
    Text(&'t str),
    Char(char),
    Entity(&'t str),
}

/// Cut raw text into pieces of its value, each with the raw range it comes from, until `sink` says no.
fn each_piece<'t>(raw: &'t str, is_attr: bool, sink: &mut dyn FnMut(Piece<'t>, Range<usize>) -> bool) {
    let bytes = raw.as_bytes();
    let mut done = 0;
    let mut at = 0;
    while let Some(&b) = bytes.get(at) {
        let (piece, end) = match b {
            b'&' => match read_reference(raw, at) {
                Reference::Char(Some(c), end) => (Piece::Char(c), end),
                Reference::Entity { name, end } => (Piece::Entity(name), end),
                Reference::Char(None, _) | Reference::Bad(_) => {
                    at += 1;
                    continue;
                }
            },
            b'\r' => {
                let end = at + if bytes.get(at + 1) == Some(&b'\n') { 2 } else { 1 };
                (Piece::Char(if is_attr { ' ' } else { '\n' }), end)
            }
            b'\n' | b'\t' if is_attr => (Piece::Char(' '), at + 1),
            _ => {
                at += 1;
                continue;
            }
        };
        let text = raw.get(done..at).unwrap_or("");
        if (!text.is_empty() && !sink(Piece::Text(text), done..at)) || !sink(piece, at..end) {
            return;
        }
        done = end;
        at = end;
    }
    if let Some(text) = raw.get(done..).filter(|text| !text.is_empty()) {
        sink(Piece::Text(text), done..raw.len());
    }
}

/// The value of raw text or of a raw attribute value. A reference without a value stays as written, apart
/// from those to external entities, which are empty.
pub(super) fn decode<'t>(raw: &'t str, entities: &Entities, is_attr: bool) -> Cow<'t, str> {
    let mut out = String::with_capacity(raw.len());
    each_piece(raw, is_attr, &mut |piece, range| {
        push(&mut out, &piece, raw, range, entities, is_attr);
        out.len() <= MAX_EXPANSION.max(raw.len())
    });
    Cow::Owned(out)
}

fn push(
    out: &mut String,
    piece: &Piece<'_>,
    raw: &str,
    range: Range<usize>,
    entities: &Entities,
    is_attr: bool,
) {
    match *piece {
        Piece::Text(text) => out.push_str(text),
        Piece::Char(c) => out.push(c),
        Piece::Entity(name) => match entities.value(name, is_attr) {
            Ok(value) => out.push_str(&value),
            Err(EntityFault::ExternalInAttribute) => {}
            Err(_) => out.push_str(raw.get(range).unwrap_or("")),
        },
    }
}

/// The offset in raw text that made the byte at `decoded_offset` of its value; inside the value of a
/// reference: the offset of its `&`. Offsets behind the end give the end.
pub fn source_offset(raw: &str, entities: &Entities, is_attr: bool, decoded_offset: usize) -> usize {
    let mut out = String::new();
    let mut found = None;
    each_piece(raw, is_attr, &mut |piece, range| {
        let before = out.len();
        push(&mut out, &piece, raw, range.clone(), entities, is_attr);
        if decoded_offset >= out.len() {
            return true;
        }
        let inside = if matches!(piece, Piece::Text(_)) { decoded_offset - before } else { 0 };
        found = Some(range.start + inside);
        false
    });
    found.unwrap_or(raw.len())
}

//! The errors of a document: those of its items, in the light of its header.

use super::document::{Document, HeaderContext};
use super::entities::EntityFault;
use super::error::{Condition, ItemError, Namespace, SyntaxError, SyntaxErrorKind, expat};
use super::item::Item;
use base::limits::{
    ENTITIES_BYTES, ENTITY_BYTES, ENTITY_DEPTH, ENTITY_FACTOR, ENTITY_GROWTH, XML_ERRORS,
    XML_ERRORS_SEEN,
};
use base::{FastSet, TextRange};

impl Document {
    /// Everything a conforming, non-validating, namespace-aware parser rejects, in the order expat would
    /// meet it: the first error is the one expat reports. Ranges are absolute. At most 1000 errors.
    pub fn errors(&self) -> Vec<SyntaxError> {
        let mut found = OrderedErrors::default();
        let head = self.header.len();
        found.add(&self.context, 0, &self.header);
        let quiet = |prefix: &str| self.context.namespaces.contains_key(prefix);
        for (start, item) in self.items.iter_with_errors(&quiet) {
            found.add(&self.context, head + start, item);
            if found.errors.len() > XML_ERRORS_SEEN {
                break;
            }
        }
        found.add(&self.context, self.footer_start(), &self.footer.item);
        found.errors.extend(self.amplification());
        found.finish()
    }
}

/// Errors on their way into the order in which expat would meet them.
#[derive(Default)]
struct OrderedErrors<'a> {
    errors: Vec<SyntaxError>,
    /// Prefixes reported so far.
    prefixes: FastSet<&'a str>,
    /// Where the tree becomes a guess, and where expat stops because of that: the first such place and the
    /// last one so far.
    divergence: Option<(u32, u32)>,
    min_offset: u32,
}

impl<'a> OrderedErrors<'a> {
    fn add(&mut self, context: &HeaderContext, start: u32, item: &'a Item) {
        for stored in item.errors() {
            let Some(mut error) = context.judge(&stored, item) else {
                continue;
            };
            if stored.condition == Condition::UnlessBound {
                let prefix = error.range.slice(&item.text);
                if !self.prefixes.insert(prefix) {
                    continue;
                }
                error.message = format!(
                    "undeclared prefix `{prefix}`\nadd xmlns:{prefix}=\"...\" to the root element"
                );
            }
            error.range = error.range.shift(start);
            error.related = error
                .related
                .map(|(range, label)| (range.shift(start), label));
            error.expat_offset = (error.expat_offset + start).max(self.min_offset);
            if stored.diverges {
                self.min_offset = error.expat_offset;
                self.divergence
                    .get_or_insert((error.range.start, error.expat_offset));
            }
            self.errors.push(error);
        }
    }

    fn finish(mut self) -> Vec<SyntaxError> {
        let (from, stop) = self.divergence.unwrap_or((u32::MAX, u32::MAX));
        let place = |error: &SyntaxError| {
            // The end of an element that began before a guess lies behind it: expat never sees it. And that
            // nothing more comes, it notices last.
            let hidden = error.expat_offset > from && error.range.start < from;
            let offset = if hidden {
                error.expat_offset.max(stop)
            } else {
                error.expat_offset
            };
            (offset, hidden, error.expat == expat::NO_ELEMENT)
        };
        for error in &mut self.errors {
            error.expat_offset = place(error).0;
        }
        self.errors.sort_by_key(place);
        self.errors.truncate(XML_ERRORS);
        self.errors
    }
}

impl Document {
    /// An error when the entities make much text out of little.
    fn amplification(&self) -> Option<SyntaxError> {
        let entities = &self.context.entities;
        if entities.is_empty() {
            return None;
        }
        let mut bytes = 0u64;
        for (start, item) in self.parts() {
            for used in item.entity_uses() {
                let value = entities
                    .value(&used.name, used.in_attribute)
                    .map_or(0, |text| text.len());
                bytes = bytes.saturating_add(u64::from(used.count).saturating_mul(value as u64));
            }
            if bytes > ENTITY_GROWTH && bytes > ENTITY_FACTOR * u64::from(self.len()) {
                return Some(SyntaxError {
                    kind: SyntaxErrorKind::BadEntity,
                    range: TextRange::empty(start),
                    related: None,
                    message: format!(
                        "entities expand to more than {ENTITY_FACTOR} times the size of the file"
                    ),
                    expat: expat::AMPLIFICATION,
                    expat_offset: start,
                });
            }
        }
        None
    }
}

impl HeaderContext {
    /// The address that a prefix inside an item stands for; none when it is not bound.
    fn uri<'a>(&'a self, namespace: &'a Namespace) -> Option<&'a str> {
        match namespace {
            Namespace::Uri(uri) => Some(uri),
            Namespace::Outer(prefix) => self.namespaces.get(prefix).map(|uri| &**uri),
        }
    }

    /// The error, if it is one.
    fn judge(&self, stored: &ItemError, item: &Item) -> Option<SyntaxError> {
        let error = || stored.error.clone();
        match &stored.condition {
            Condition::Always => Some(error()),
            Condition::UnlessBound => {
                let prefix = stored.error.range.slice(&item.text);
                (!self.namespaces.contains_key(prefix)).then(error)
            }
            Condition::SameNamespace(one, two) => {
                let one = self.uri(one)?;
                (Some(one) == self.uri(two)).then(error)
            }
            Condition::Entity { name, in_attribute } => {
                let fault = self.entities.value(name, *in_attribute).err()?;
                let (kind, expat_error, message) = describe(fault, name);
                Some(SyntaxError {
                    kind,
                    expat: expat_error,
                    message,
                    ..error()
                })
            }
        }
    }
}

fn describe(fault: EntityFault, name: &str) -> (SyntaxErrorKind, &'static str, String) {
    use SyntaxErrorKind::{BadEntity, UndefinedEntity};
    match fault {
        EntityFault::Undefined => (
            UndefinedEntity,
            expat::UNDEFINED_ENTITY,
            format!(
                "undefined entity `{name}`\nuse `amp`, `lt`, `gt`, `quot` or `apos`, or write `&amp;` for a literal `&`"
            ),
        ),
        EntityFault::Recursive => (
            BadEntity,
            expat::RECURSIVE_ENTITY,
            format!("entity `{name}` refers to itself"),
        ),
        EntityFault::TooLarge => {
            let message = format!(
                "entity `{name}` exceeds a limit: {} MB for one entity, {} MB for all, {ENTITY_DEPTH} levels",
                ENTITY_BYTES >> 20,
                ENTITIES_BYTES >> 20
            );
            (BadEntity, expat::AMPLIFICATION, message)
        }
        EntityFault::Unparsed => (
            BadEntity,
            expat::BINARY_ENTITY,
            format!("entity `{name}` is not text"),
        ),
        EntityFault::ExternalInAttribute => (
            BadEntity,
            expat::EXTERNAL_IN_ATTRIBUTE,
            format!("external entity `{name}` is not allowed in an attribute"),
        ),
        EntityFault::BadCharacter => (
            BadEntity,
            expat::BAD_CHAR_REF,
            format!("entity `{name}` contains a character that is not allowed in XML"),
        ),
        EntityFault::Unfinished => (
            BadEntity,
            expat::UNCLOSED_TOKEN,
            format!("text of entity `{name}` ends inside a reference"),
        ),
        EntityFault::Markup(expat_error) => {
            let message = format!("markup in entity `{name}` is not well-formed");
            (BadEntity, expat_error, message)
        }
        EntityFault::Malformed => (
            BadEntity,
            expat::INVALID,
            format!("text of entity `{name}` is not allowed here"),
        ),
    }
}

//! The errors of a document: those of its items, in the light of its header.

use super::document::{Context, Document};
use super::entities::EntityFault;
use super::error::{Condition, ItemError, Namespace, SyntaxError, SyntaxErrorKind, expat};
use crate::base::FastSet;

impl Document {
    /// Everything a conforming, non-validating, namespace-aware parser rejects, in the order expat would
    /// meet it: the first error is the one expat reports. Ranges are absolute.
    pub fn errors(&self) -> Vec<SyntaxError> {
        let mut out: Vec<SyntaxError> = Vec::new();
        let mut reported = FastSet::default();
        for (start, item) in self.parts() {
            for stored in item.errors() {
                let Some(mut error) = self.context.judge(stored) else { continue };
                if let Condition::UnlessBound(prefix) = &stored.condition
                    && !reported.insert(prefix)
                {
                    continue;
                }
                error.range = error.range.shift(start);
                error.related = error.related.map(|(range, label)| (range.shift(start), label));
                error.expat_offset =
                    (error.expat_offset + start).max(out.last().map_or(0, |e| e.expat_offset));
                out.push(error);
            }
        }
        out
    }
}

impl Context {
    /// The error, if it is one.
    fn judge(&self, stored: &ItemError) -> Option<SyntaxError> {
        let error = || stored.error.clone();
        match &stored.condition {
            Condition::Always => Some(error()),
            Condition::UnlessBound(prefix) => (!self.namespaces.contains_key(prefix)).then(error),
            Condition::SameNamespace(one, two) => {
                let uri = |of| match of {
                    &Namespace::Uri(ref uri) => Some(uri),
                    Namespace::Outer(prefix) => self.namespaces.get(prefix),
                };
                let one = uri(one)?;
                (Some(one) == uri(two)).then(error)
            }
            Condition::Entity { name, in_attribute } => {
                let fault = self.entities.value(name, *in_attribute).err()?;
                let (kind, verdict, message) = describe(fault, name);
                Some(SyntaxError { kind, expat: verdict, message, ..error() })
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
            format!("entity `{name}` is not defined: XML knows only `amp`, `lt`, `gt`, `quot` and `apos`"),
        ),
        EntityFault::Recursive => {
            (BadEntity, expat::RECURSIVE_ENTITY, format!("entity `{name}` refers to itself"))
        }
        EntityFault::TooLarge => {
            (BadEntity, expat::AMPLIFICATION, format!("entity `{name}` grows without reasonable limit"))
        }
        EntityFault::Unparsed => {
            (BadEntity, expat::BINARY_ENTITY, format!("entity `{name}` stands for data that is no text"))
        }
        EntityFault::ExternalInAttribute => (
            BadEntity,
            expat::EXTERNAL_IN_ATTRIBUTE,
            format!("entity `{name}` is external: it may not stand in an attribute"),
        ),
        EntityFault::Markup | EntityFault::Malformed => {
            (BadEntity, expat::INVALID, format!("the text of entity `{name}` does not fit here"))
        }
    }
}

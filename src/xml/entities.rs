//! What the internal DTD subset declares: general entities with what references to them stand for, and types of
//! attributes.

use std::borrow::Cow;

use super::decode::{Reference, TextContext, ValuePiece, pieces, references};
use super::document::Document;
use super::error::{SyntaxErrorKind, expat};
use base::FastMap;
use base::limits::{ENTITIES_BYTES, ENTITY_BYTES, ENTITY_DEPTH};

/// The general entities a document declares, and the five it need not declare.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Entities {
    declared: FastMap<Box<str>, DeclaredEntity>,
    /// Declarations may hide in places that are not read, so an unknown entity is no error but empty.
    pub(super) incomplete: bool,
    /// The XML declaration says that there are no such declarations.
    pub(super) standalone: bool,
    /// Bytes all values take.
    total: usize,
    /// The attributes with an `ATTLIST`, by element and name: whether their type is other than `CDATA`.
    attributes: FastMap<Box<str>, FastMap<Box<str>, bool>>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct DeclaredEntity {
    entity: Entity,
    /// Values in text and in an attribute, once they are known.
    values: [Option<Result<Box<str>, EntityFault>>; 2],
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
    /// Its replacement text is not well-formed by itself, or has a `<` in an attribute value.
    Malformed,
    /// Its replacement text ends inside a reference.
    Unfinished,
    /// Its replacement text refers to a forbidden character.
    BadCharacter,
    /// Its replacement text has markup that is not well-formed by itself; what expat says.
    Markup(&'static str),
}

impl Entities {
    pub(super) fn declare(&mut self, name: &str, entity: Entity) {
        // The first declaration counts.
        let declared = DeclaredEntity {
            entity,
            values: [None, None],
        };
        self.declared.entry(name.into()).or_insert(declared);
    }

    /// Note the type of an attribute; the first declaration counts.
    pub(super) fn declare_attribute(&mut self, element: &str, attribute: &str, is_tokenized: bool) {
        let known = self.attributes.entry(element.into()).or_default();
        known.entry(attribute.into()).or_insert(is_tokenized);
    }

    /// Whether the document declares types of attributes.
    pub(super) fn has_attributes(&self) -> bool {
        !self.attributes.is_empty()
    }

    /// Whether the blanks of an attribute are reduced to single ones between its words.
    pub(super) fn is_tokenized(&self, element: &str, attribute: &str) -> bool {
        let declared = self.attributes.get(element);
        declared
            .and_then(|known| known.get(attribute))
            .is_some_and(|tokenized| *tokenized)
    }

    /// Work out all values; to be called when all declarations are known.
    pub(super) fn resolve(&mut self) {
        let mut names: Vec<Box<str>> = self.declared.keys().cloned().collect();
        names.sort();
        for name in &names {
            for is_attr in [false, true] {
                let _ = self.resolve_one(name, is_attr, 0);
            }
        }
    }

    fn resolve_one(
        &mut self,
        name: &str,
        is_attr: bool,
        depth: u32,
    ) -> Result<Cow<'_, str>, EntityFault> {
        let place = usize::from(is_attr);
        let declared = self.declared.get(name);
        if declared.is_some_and(|entry| entry.values.get(place).is_none_or(Option::is_none)) {
            // Seen again while its own value is under way, the entity is recursive.
            self.store(name, place, Err(EntityFault::Recursive));
            let value = self.compute(name, is_attr, depth);
            self.store(name, place, value);
        }
        self.value(name, is_attr)
    }

    fn store(&mut self, name: &str, place: usize, value: Result<Box<str>, EntityFault>) {
        self.total += value.as_ref().map_or(0, |text| text.len());
        if let Some(slot) = self
            .declared
            .get_mut(name)
            .and_then(|entry| entry.values.get_mut(place))
        {
            *slot = Some(value);
        }
    }

    fn compute(&mut self, name: &str, is_attr: bool, depth: u32) -> Result<Box<str>, EntityFault> {
        let text = match self.declared.get(name).map(|entry| &entry.entity) {
            Some(Entity::Internal(text)) => text.clone(),
            Some(Entity::External) if is_attr => return Err(EntityFault::ExternalInAttribute),
            Some(Entity::External) => return Ok("".into()),
            Some(Entity::Unparsed) | None => return Err(EntityFault::Unparsed),
        };
        if depth > ENTITY_DEPTH {
            return Err(EntityFault::TooLarge);
        }
        check_replacement(&text, is_attr)?;
        if text.contains('<') {
            self.check_markup(&text, depth)?;
            return Ok(text);
        }
        let mut out = String::new();
        for (piece, _) in pieces(
            &text,
            if is_attr {
                TextContext::Attribute
            } else {
                TextContext::Replacement
            },
        ) {
            match piece {
                ValuePiece::Text(text) => out.push_str(text),
                ValuePiece::Char(c) => out.push(c),
                ValuePiece::Entity(name) => {
                    out.push_str(&self.resolve_one(name, is_attr, depth + 1)?)
                }
            }
            if out.len() > ENTITY_BYTES || self.total + out.len() > ENTITIES_BYTES {
                return Err(EntityFault::TooLarge);
            }
        }
        Ok(out.into())
    }

    /// Check replacement text with markup. It must be well-formed by itself wherever it is referred to, also where
    /// its elements are not used.
    fn check_markup(&mut self, text: &str, depth: u32) -> Result<(), EntityFault> {
        // the element around it has a name that the text does not hold, so that it cannot close it
        let longest = text.split(|c| c != 'e').map(str::len).max().unwrap_or(0);
        let name = "e".repeat(longest + 1);
        let start = name.len() + 2;
        let document = Document::parse(&format!("<{name}>{text}</{name}>"));
        if let Some(error) = document
            .errors()
            .into_iter()
            .find(|error| !depends_on_place(error.kind))
        {
            let is_left_open = error.expat_offset as usize >= start + text.len();
            let is_wrapper_hit = error.expat == expat::MISMATCH && is_left_open;
            return Err(EntityFault::Markup(if is_wrapper_hit {
                expat::ASYNC_ENTITY
            } else {
                error.expat
            }));
        }
        for (_, item) in document.parts() {
            for used in item.entity_uses() {
                self.resolve_one(&used.name, used.in_attribute, depth + 1)?;
            }
        }
        Ok(())
    }

    /// The value of `&name;`, or why it has none.
    pub(super) fn value(&self, name: &str, is_attr: bool) -> Result<Cow<'_, str>, EntityFault> {
        if let Some(text) = predefined(name) {
            return Ok(Cow::Borrowed(text));
        }
        match self
            .declared
            .get(name)
            .and_then(|entry| entry.values.get(usize::from(is_attr))?.as_ref())
        {
            Some(Ok(text)) => Ok(Cow::Borrowed(text)),
            Some(Err(fault)) => Err(*fault),
            None if self.incomplete => Ok(Cow::Borrowed("")),
            None => Err(EntityFault::Undefined),
        }
    }

    /// Whether the document declares no entity.
    pub fn is_empty(&self) -> bool {
        self.declared.is_empty()
    }

    /// The first entity named in `raw` whose replacement text holds markup. The tree does not show such
    /// markup: the value has it as text.
    pub fn markup_entity<'r>(&self, raw: &'r str) -> Option<&'r str> {
        if self.declared.is_empty() {
            return None;
        }
        references(raw).find_map(|(_, reference)| match reference {
            Reference::Entity { name, .. } => self.holds_markup(name).then_some(name),
            _ => None,
        })
    }

    fn holds_markup(&self, name: &str) -> bool {
        // Faults are transitive, and `<` in the text of any entity below is one for attributes.
        let Some(entry) = self.declared.get(name) else {
            return false;
        };
        let [text, attribute] = &entry.values;
        matches!((text, attribute), (Some(Ok(text)), Some(Err(EntityFault::Malformed))) if text.contains('<'))
    }
}

/// Whether an error in the text of an entity may be none where the entity is used.
fn depends_on_place(kind: SyntaxErrorKind) -> bool {
    matches!(
        kind,
        SyntaxErrorKind::UndefinedEntity | SyntaxErrorKind::UnboundPrefix
    )
}

/// Whether the replacement text can stand where a reference to it does.
fn check_replacement(text: &str, is_attr: bool) -> Result<(), EntityFault> {
    if if is_attr {
        text.contains('<')
    } else {
        text.contains("]]>") && !text.contains('<')
    } {
        return Err(EntityFault::Malformed);
    }
    if !is_attr && text.contains('<') {
        return Ok(());
    }
    for (_, reference) in references(text) {
        match reference {
            Reference::Bad(stop) if stop >= text.len() && !is_attr => {
                return Err(EntityFault::Unfinished);
            }
            Reference::Bad(_) => return Err(EntityFault::Malformed),
            Reference::Char(None, _) => return Err(EntityFault::BadCharacter),
            Reference::Char(..) | Reference::Entity { .. } => {}
        }
    }
    Ok(())
}

/// The entities every document has.
pub(super) fn predefined(name: &str) -> Option<&'static str> {
    Some(match name {
        "amp" => "&",
        "lt" => "<",
        "gt" => ">",
        "quot" => "\"",
        "apos" => "'",
        _ => return None,
    })
}

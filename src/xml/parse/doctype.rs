//! The DOCTYPE with its internal subset: checked in full, kept only as far as general entities go.

use super::token::DoctypeToken;
use super::{ExpatError, ItemParser};
use crate::decode::{Reference, decode, read_reference};
use crate::entities::{Entities, Entity};
use crate::error::{SyntaxErrorKind as Kind, expat};
use crate::node::{CLOSED, NodeKind};

type Checked<T = ()> = Result<T, ExpatError>;

/// Types of attributes that are one word.
const ATTRIBUTE_TYPES: [&str; 8] = [
    "CDATA", "ID", "IDREF", "IDREFS", "ENTITY", "ENTITIES", "NMTOKEN", "NMTOKENS",
];

impl<'t> ItemParser<'t> {
    /// Read a DOCTYPE.
    pub(super) fn doctype(&mut self, entities: &mut Entities) {
        let start = self.pos;
        let first_error = self.errors.len();
        self.has_doctype = true;
        self.pos += "<!DOCTYPE".len();
        match self.doctype_grammar(entities) {
            Ok(()) => {
                self.push_node(NodeKind::Doctype, start, CLOSED);
            }
            Err(expat_error) => {
                self.pos = start + 9;
                let closed = self.skip_doctype();
                self.push_node(NodeKind::Doctype, start, if closed { CLOSED } else { 0 });
                if self.errors.len() == first_error {
                    let message = "malformed DOCTYPE\nremove the DOCTYPE; a robot description does not need one";
                    self.error(Kind::BadDoctype, (start, start + 9), expat_error, message);
                }
                self.mark_divergence();
            }
        }
    }

    /// Move behind a broken DOCTYPE: to its `>`, or to the next line that looks like the document.
    fn skip_doctype(&mut self) -> bool {
        let start = self.pos;
        let mut in_subset = false;
        while let Some(b) = self.peek() {
            match b {
                b'[' => in_subset = true,
                b']' => in_subset = false,
                b'>' if !in_subset => {
                    self.pos += 1;
                    return true;
                }
                b'<' if self.at_tag() && self.indent(self.pos).is_some() => break,
                b'<' if !in_subset && self.pos > start => break,
                _ => {}
            }
            self.pos += 1;
        }
        self.pos = self.trimmed(self.pos).max(start);
        false
    }

    /// The next token of a declaration, its start, its text. Moves behind it.
    fn next_token(&mut self) -> Checked<(DoctypeToken, usize, &'t str)> {
        self.skip_space();
        let start = self.pos;
        if self.starts_with(b"<!--") || self.starts_with(b"<?") {
            return Err(self.skip_markup().err().unwrap_or((expat::SYNTAX, start)));
        }
        let (token, end) = self.token(start);
        self.look(end + 1);
        self.pos = end;
        match token {
            DoctypeToken::End => {
                self.hit_end = true;
                Err((expat::NO_ELEMENT, start))
            }
            DoctypeToken::Unfinished => {
                self.hit_end = true;
                Err((expat::UNCLOSED_TOKEN, start))
            }
            DoctypeToken::Invalid(at) => {
                self.look(at + 1);
                Err((expat::INVALID, at))
            }
            _ => Ok((token, start, self.slice(start, end))),
        }
    }

    fn expect(&mut self, wanted: &[DoctypeToken]) -> Checked<(DoctypeToken, usize, &'t str)> {
        let found = self.next_token()?;
        if wanted.contains(&found.0) {
            Ok(found)
        } else {
            Err(unexpected(found))
        }
    }

    /// The `>` of a declaration.
    fn declaration_close(&mut self) -> Checked {
        self.expect(&[DoctypeToken::Punctuation(b'>')]).map(drop)
    }

    fn doctype_grammar(&mut self, entities: &mut Entities) -> Checked {
        self.expect(&[DoctypeToken::Name, DoctypeToken::PrefixedName])?;
        let mut found = self.next_token()?;
        if found.0 == DoctypeToken::Name {
            self.external_id(found)?;
            entities.incomplete = !entities.standalone;
            found = self.next_token()?;
        }
        match found.0 {
            DoctypeToken::Punctuation(b'>') => Ok(()),
            DoctypeToken::Punctuation(b'[') => {
                self.subset(entities)?;
                self.declaration_close()
            }
            _ => Err(unexpected(found)),
        }
    }

    /// `SYSTEM "…"` or `PUBLIC "…" "…"`; the keyword has been read.
    fn external_id(&mut self, keyword: (DoctypeToken, usize, &str)) -> Checked {
        match keyword.2 {
            "PUBLIC" => {
                let (_, start, text) = self.expect(&[DoctypeToken::Literal])?;
                check_public_id(start, text)?;
            }
            "SYSTEM" => {}
            _ => return Err((expat::SYNTAX, keyword.1)),
        }
        self.expect(&[DoctypeToken::Literal]).map(drop)
    }

    fn subset(&mut self, entities: &mut Entities) -> Checked {
        // Behind a reference to a parameter entity, which is not read, declarations count no more.
        let mut counts = true;
        loop {
            self.skip_space();
            if self.starts_with(b"<!--") || self.starts_with(b"<?") {
                self.skip_markup()?;
                continue;
            }
            let (token, start, text) = self.next_token()?;
            match (token, text) {
                (DoctypeToken::Punctuation(b']'), _) => return Ok(()),
                (DoctypeToken::ParameterReference, _) => {
                    entities.incomplete = !entities.standalone;
                    counts = entities.standalone;
                }
                (DoctypeToken::DeclarationOpen, "<!ENTITY") => {
                    let declared = self.entity(counts)?;
                    if let Some((name, entity)) = declared.filter(|_| counts) {
                        entities.declare(name, entity);
                    }
                }
                (DoctypeToken::DeclarationOpen, "<!ATTLIST") => {
                    for (element, attribute, is_tokenized) in self.attribute_list()? {
                        if counts {
                            entities.declare_attribute(element, attribute, is_tokenized);
                        }
                    }
                }
                (DoctypeToken::DeclarationOpen, "<!ELEMENT") => self.element_type()?,
                (DoctypeToken::DeclarationOpen, "<!NOTATION") => self.notation()?,
                _ => return Err((expat::SYNTAX, start)),
            }
        }
    }

    /// A comment or instruction inside the subset, which makes no node.
    fn skip_markup(&mut self) -> Checked {
        let (nodes, errors) = (self.nodes.len(), self.errors.len());
        if self.starts_with(b"<!--") {
            self.bang();
        } else {
            self.instruction();
        }
        self.nodes.truncate(nodes);
        match self.errors.get(errors) {
            Some(found) => Err((
                found.error.expat,
                self.base + found.error.expat_offset as usize,
            )),
            None => Ok(()),
        }
    }

    fn entity(&mut self, counts: bool) -> Checked<Option<(&'t str, Entity)>> {
        let mut found = self.expect(&[DoctypeToken::Name, DoctypeToken::Percent])?;
        let general = found.0 == DoctypeToken::Name;
        if !general {
            found = self.expect(&[DoctypeToken::Name])?;
        }
        let name = found.2;
        found = self.expect(&[DoctypeToken::Name, DoctypeToken::Literal])?;
        if found.0 == DoctypeToken::Literal {
            let value = if counts {
                self.entity_value(found.1 + 1)?
            } else {
                String::new()
            };
            self.declaration_close()?;
            return Ok(general.then_some((name, Entity::Internal(value.into()))));
        }
        self.external_id(found)?;
        let mut kind = Entity::External;
        let end = self.next_token()?;
        match end {
            (DoctypeToken::Punctuation(b'>'), ..) => return Ok(general.then_some((name, kind))),
            (DoctypeToken::Name, _, "NDATA") if general => {
                self.expect(&[DoctypeToken::Name])?;
                kind = Entity::Unparsed;
            }
            _ => return Err(unexpected(end)),
        }
        self.declaration_close()?;
        Ok(Some((name, kind)))
    }

    /// Check the literal that ends before the current position and resolve its character references.
    fn entity_value(&mut self, start: usize) -> Checked<String> {
        let end = self.pos - 1;
        let literal = self.slice(start, end);
        for (at, b) in literal.bytes().enumerate() {
            match b {
                b'%' => {
                    let (token, stop) = self.token(start + at);
                    return Err(match token {
                        DoctypeToken::ParameterReference if stop <= end => {
                            (expat::PARAMETER_REFERENCE, start + at)
                        }
                        _ if stop >= end => (expat::INVALID, start + at),
                        _ => (expat::INVALID, stop),
                    });
                }
                b'&' => self.check_literal_reference(literal, at, start)?,
                _ => {}
            }
        }
        Ok(resolve_characters(literal))
    }

    fn check_literal_reference(&self, literal: &str, at: usize, start: usize) -> Checked {
        match read_reference(literal, at) {
            // expat takes a reference cut off by the closing quote for a bad token as a whole.
            Reference::Bad(stop) if stop >= literal.len() => Err((expat::INVALID, start + at)),
            Reference::Bad(stop) => Err((expat::INVALID, start + stop)),
            Reference::Char(None, _) => Err((expat::BAD_CHAR_REF, start + at)),
            Reference::Char(..) | Reference::Entity { .. } => Ok(()),
        }
    }

    /// The attributes of an `ATTLIST`: element, attribute, and whether its type is other than `CDATA`.
    fn attribute_list(&mut self) -> Checked<Vec<(&'t str, &'t str, bool)>> {
        let names = [DoctypeToken::Name, DoctypeToken::PrefixedName];
        let element = self.expect(&names)?.2;
        let mut attributes = Vec::new();
        loop {
            let found = self.next_token()?;
            match found.0 {
                DoctypeToken::Punctuation(b'>') => return Ok(attributes),
                DoctypeToken::Name | DoctypeToken::PrefixedName => {}
                _ => return Err(unexpected(found)),
            }
            attributes.push((element, found.2, self.attribute_type()?));
            let (token, start, text) =
                self.expect(&[DoctypeToken::PoundName, DoctypeToken::Literal])?;
            match (token, text) {
                (DoctypeToken::Literal, _) => self.default_value(start)?,
                (_, "#IMPLIED" | "#REQUIRED") => {}
                (_, "#FIXED") => {
                    let (_, start, _) = self.expect(&[DoctypeToken::Literal])?;
                    self.default_value(start)?;
                }
                _ => return Err((expat::SYNTAX, start)),
            }
        }
    }

    /// The type of an attribute; gives whether it is other than `CDATA`.
    fn attribute_type(&mut self) -> Checked<bool> {
        let open = DoctypeToken::Punctuation(b'(');
        let (token, start, text) = self.expect(&[DoctypeToken::Name, open])?;
        let notation = token == DoctypeToken::Name && text == "NOTATION";
        if notation {
            self.expect(&[open])?;
        } else if token == DoctypeToken::Name {
            let is_known = ATTRIBUTE_TYPES.contains(&text);
            return if is_known {
                Ok(text != "CDATA")
            } else {
                Err((expat::SYNTAX, start))
            };
        }
        let values: &[DoctypeToken] = if notation {
            &[DoctypeToken::Name]
        } else {
            &[
                DoctypeToken::Name,
                DoctypeToken::PrefixedName,
                DoctypeToken::NameToken,
            ]
        };
        loop {
            self.expect(values)?;
            if self
                .expect(&[DoctypeToken::CloseParen, DoctypeToken::Punctuation(b'|')])?
                .0
                == DoctypeToken::CloseParen
            {
                return Ok(true);
            }
        }
    }

    fn default_value(&mut self, quote: usize) -> Checked {
        let start = quote + 1;
        let literal = self.slice(start, self.pos - 1);
        for (at, b) in literal.bytes().enumerate() {
            match b {
                b'<' => return Err((expat::INVALID, start + at)),
                b'&' => self.check_literal_reference(literal, at, start)?,
                _ => {}
            }
        }
        Ok(())
    }

    fn element_type(&mut self) -> Checked {
        self.expect(&[DoctypeToken::Name, DoctypeToken::PrefixedName])?;
        let (token, start, text) =
            self.expect(&[DoctypeToken::Name, DoctypeToken::Punctuation(b'(')])?;
        if token == DoctypeToken::Name {
            return if matches!(text, "EMPTY" | "ANY") {
                self.declaration_close()
            } else {
                Err((expat::SYNTAX, start))
            };
        }
        self.content_model()?;
        self.declaration_close()
    }

    /// The groups of an element declaration; the first parenthesis has been read.
    fn content_model(&mut self) -> Checked {
        // The connector of each open group, once it is known.
        let mut groups = vec![0];
        let mut first = true;
        loop {
            let found = self.next_token()?;
            match found.0 {
                DoctypeToken::PoundName if first && found.2 == "#PCDATA" => {
                    return self.mixed_content();
                }
                DoctypeToken::Punctuation(b'(') => {
                    groups.push(0);
                    first = false;
                    continue;
                }
                DoctypeToken::Name | DoctypeToken::PrefixedName | DoctypeToken::RepeatedName => {}
                _ => return Err(unexpected(found)),
            }
            first = false;
            loop {
                let found = self.next_token()?;
                match (found.0, groups.last_mut()) {
                    (DoctypeToken::CloseParen | DoctypeToken::RepeatedParen, _) => {
                        groups.pop();
                        if groups.is_empty() {
                            return Ok(());
                        }
                    }
                    (DoctypeToken::Punctuation(b @ (b',' | b'|')), Some(connector)) => {
                        if *connector != 0 && *connector != b {
                            return Err(unexpected(found));
                        }
                        *connector = b;
                        break;
                    }
                    _ => return Err(unexpected(found)),
                }
            }
        }
    }

    /// The rest of `(#PCDATA …`.
    fn mixed_content(&mut self) -> Checked {
        let mut names = false;
        loop {
            let found = self.next_token()?;
            match found.0 {
                DoctypeToken::CloseParen if !names => return Ok(()),
                DoctypeToken::RepeatedParen if found.2 == ")*" => return Ok(()),
                DoctypeToken::Punctuation(b'|') => names = true,
                _ => return Err(unexpected(found)),
            }
            self.expect(&[DoctypeToken::Name, DoctypeToken::PrefixedName])?;
        }
    }

    fn notation(&mut self) -> Checked {
        self.expect(&[DoctypeToken::Name])?;
        let (_, start, text) = self.expect(&[DoctypeToken::Name])?;
        match text {
            "SYSTEM" => {
                self.expect(&[DoctypeToken::Literal])?;
            }
            "PUBLIC" => {
                let (_, start, text) = self.expect(&[DoctypeToken::Literal])?;
                check_public_id(start, text)?;
                let end = self.expect(&[DoctypeToken::Literal, DoctypeToken::Punctuation(b'>')])?;
                if end.0 != DoctypeToken::Literal {
                    return Ok(());
                }
            }
            _ => return Err((expat::SYNTAX, start)),
        }
        self.declaration_close()
    }
}

/// What expat says to a token that has no place where it stands.
fn unexpected((token, start, _): (DoctypeToken, usize, &str)) -> ExpatError {
    match token {
        DoctypeToken::ParameterReference => (expat::PARAMETER_REFERENCE, start),
        _ => (expat::SYNTAX, start),
    }
}

/// The characters a public identifier may hold.
fn check_public_id(start: usize, literal: &str) -> Checked {
    let inner = literal
        .get(1..literal.len().saturating_sub(1))
        .unwrap_or("");
    match inner.char_indices().find(|&(_, c)| !is_public_id(c)) {
        Some((at, _)) => Err((expat::PUBLIC_ID, start + 1 + at)),
        None => Ok(()),
    }
}

fn is_public_id(c: char) -> bool {
    c.is_ascii_alphanumeric() || " \r\n-'()+,./:=?;!*#@$_%".contains(c)
}

/// Resolve the character references of an entity's literal and its line ends; leave other references.
fn resolve_characters(literal: &str) -> String {
    let mut out = String::with_capacity(literal.len());
    let mut rest = literal;
    while let Some(at) = rest.find('&') {
        let (head, tail) = rest.split_at(at);
        out.push_str(&decode(head, &Entities::default(), false));
        let (text, end) = match read_reference(tail, 0) {
            Reference::Char(Some(c), end) => (c.to_string(), end),
            _ => ("&".to_owned(), 1),
        };
        out.push_str(&text);
        rest = tail.get(end..).unwrap_or("");
    }
    out.push_str(&decode(rest, &Entities::default(), false));
    out
}

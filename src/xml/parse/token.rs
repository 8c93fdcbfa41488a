//! The tokens of declarations, which are also what expat makes of text outside the root.

use super::ItemParser;
use crate::chars::{is_legal, is_space, name_char};

/// A token of a DOCTYPE.
#[allow(clippy::enum_variant_names)] // "name token" is the term of the XML specification
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DoctypeToken {
    Name,
    PrefixedName,
    /// A name token that is no name, such as `1a` or `a:`.
    NameToken,
    /// `name?`, `name*`, `name+`
    RepeatedName,
    /// `#name`
    PoundName,
    /// `"…"` or `'…'`
    Literal,
    /// `<!name`
    DeclarationOpen,
    /// `<![`
    SectionOpen,
    /// `]]>`
    SectionClose,
    /// `<` and a name: the root.
    TagOpen,
    /// `%name;`
    ParameterReference,
    Percent,
    CloseParen,
    /// `)?`, `)*`, `)+`
    RepeatedParen,
    /// `( [ ] , | >`
    Punctuation(u8),
    /// Nothing left.
    End,
    /// The text ends inside a token.
    Unfinished,
    /// No token: the offset of the character that does not fit.
    Invalid(usize),
}

impl ItemParser<'_> {
    /// The token at `at` and the offset behind it. White space, comments and instructions are the caller's.
    pub(super) fn token(&self, at: usize) -> (DoctypeToken, usize) {
        let Some(&b) = self.bytes.get(at) else {
            return (DoctypeToken::End, at);
        };
        match b {
            b'"' | b'\'' => self.literal(at, b),
            b'<' => self.opening(at),
            b'%' => self.named(at, DoctypeToken::ParameterReference),
            b'#' => self.named(at, DoctypeToken::PoundName),
            b']' if self.bytes.get(at + 1..) == Some(b"]") => (DoctypeToken::Unfinished, at + 2),
            b']' if self.bytes.get(at..at + 3) == Some(b"]]>") => {
                (DoctypeToken::SectionClose, at + 3)
            }
            b'(' | b'[' | b']' | b',' | b'|' | b'>' => (DoctypeToken::Punctuation(b), at + 1),
            b')' => self.close_paren(at),
            _ => self.name_token(at),
        }
    }

    fn literal(&self, at: usize, quote: u8) -> (DoctypeToken, usize) {
        for (n, c) in self.text.get(at + 1..).unwrap_or("").char_indices() {
            let here = at + 1 + n;
            if c == quote as char {
                return match self.bytes.get(here + 1) {
                    None => (DoctypeToken::Literal, here + 1),
                    Some(&b) if is_space(b) || b">%[".contains(&b) => {
                        (DoctypeToken::Literal, here + 1)
                    }
                    Some(_) => (DoctypeToken::Invalid(here + 1), here + 1),
                };
            }
            if !is_legal(c) {
                return (DoctypeToken::Invalid(here), here);
            }
        }
        (DoctypeToken::Unfinished, self.bytes.len())
    }

    fn opening(&self, at: usize) -> (DoctypeToken, usize) {
        match self.bytes.get(at + 1) {
            None => (DoctypeToken::Unfinished, at + 1),
            Some(b'!') => self.declaration_open(at),
            // Beyond ASCII expat looks no closer here.
            Some(&b) if b >= 0x80 || name_char(self.text, at + 1, true) > 0 => {
                (DoctypeToken::TagOpen, at)
            }
            Some(_) => (DoctypeToken::Invalid(at + 1), at + 1),
        }
    }

    fn declaration_open(&self, at: usize) -> (DoctypeToken, usize) {
        let mut end = at + 2;
        match self.bytes.get(end) {
            None => return (DoctypeToken::Unfinished, end),
            Some(b'[') => return (DoctypeToken::SectionOpen, end + 1),
            Some(&b) if is_letter(b) => {}
            // `<!-` of something that is no comment.
            Some(b'-') => {
                return match self.bytes.get(end + 1) {
                    None => (DoctypeToken::Unfinished, end + 1),
                    Some(_) => (DoctypeToken::Invalid(end + 1), end + 1),
                };
            }
            Some(_) => return (DoctypeToken::Invalid(end), end),
        }
        while self.bytes.get(end).is_some_and(|&b| is_letter(b)) {
            end += 1;
        }
        match (self.bytes.get(end), self.bytes.get(end + 1)) {
            (None, _) => (DoctypeToken::Unfinished, end),
            (Some(b'%'), None) => (DoctypeToken::Unfinished, end),
            (Some(b'%'), Some(&b)) if is_space(b) || b == b'%' => (DoctypeToken::Invalid(end), end),
            (Some(b'%'), _) => (DoctypeToken::DeclarationOpen, end),
            (Some(&b), _) if is_space(b) => (DoctypeToken::DeclarationOpen, end),
            _ => (DoctypeToken::Invalid(end), end),
        }
    }

    /// `%name;` or `#name`, or a plain `%`.
    fn named(&self, at: usize, kind: DoctypeToken) -> (DoctypeToken, usize) {
        let percent = kind == DoctypeToken::ParameterReference;
        let mut end = at + 1;
        match self.bytes.get(end) {
            None => return (DoctypeToken::Unfinished, end),
            Some(&b) if percent && (is_space(b) || b == b'%') => {
                return (DoctypeToken::Percent, end);
            }
            Some(_) if name_char(self.text, end, true) == 0 => {
                return (DoctypeToken::Invalid(end), end);
            }
            Some(_) => end = crate::chars::skip_name(self.text, end),
        }
        match self.bytes.get(end) {
            Some(b';') if percent => (kind, end + 1),
            Some(&b) if !percent && (is_space(b) || b")>%|".contains(&b)) => (kind, end),
            None if percent => (DoctypeToken::Unfinished, end),
            None => (kind, end),
            Some(_) => (DoctypeToken::Invalid(end), end),
        }
    }

    fn close_paren(&self, at: usize) -> (DoctypeToken, usize) {
        match self.bytes.get(at + 1) {
            None => (DoctypeToken::CloseParen, at + 1),
            Some(b'*' | b'?' | b'+') => (DoctypeToken::RepeatedParen, at + 2),
            Some(&b) if is_space(b) || b">,|)".contains(&b) => (DoctypeToken::CloseParen, at + 1),
            Some(_) => (DoctypeToken::Invalid(at + 1), at + 1),
        }
    }

    fn name_token(&self, at: usize) -> (DoctypeToken, usize) {
        let colon = self.bytes.get(at) == Some(&b':');
        let mut token = if name_char(self.text, at, true) > 0 {
            DoctypeToken::Name
        } else {
            DoctypeToken::NameToken
        };
        let mut end = at;
        loop {
            match name_char(self.text, end, false) {
                0 if end == at && !colon => return (DoctypeToken::Invalid(at), at),
                0 => {}
                n => {
                    end += n;
                    continue;
                }
            }
            match self.bytes.get(end) {
                None => return (token, end),
                Some(b':') => {
                    end += 1;
                    if end == at + 1 {
                        continue;
                    }
                    token = match token {
                        DoctypeToken::Name if end >= self.bytes.len() => {
                            return (DoctypeToken::Unfinished, end);
                        }
                        DoctypeToken::Name if name_char(self.text, end, false) > 0 => {
                            DoctypeToken::PrefixedName
                        }
                        _ => DoctypeToken::NameToken,
                    };
                }
                Some(b'+' | b'*' | b'?') if token != DoctypeToken::NameToken => {
                    return (DoctypeToken::RepeatedName, end + 1);
                }
                Some(&b) if is_space(b) || b">),|[%".contains(&b) => return (token, end),
                Some(_) => return (DoctypeToken::Invalid(end), end),
            }
        }
    }
}

/// Whether the word of a declaration may hold a byte, as in `<!ELEMENT`.
fn is_letter(b: u8) -> bool {
    b.is_ascii_alphabetic() || b == b'_'
}

//! Semantic tokens as the protocol has them: line by line, each relative to the one in front.
use lsp_types::{SemanticToken, SemanticTokenType};

use base::{Encoding, TextRange};
use ide::{HighlightToken, TokenKind};

/// The kinds in the order of their numbers.
pub(crate) const KINDS: &[(TokenKind, SemanticTokenType)] = &[
    (TokenKind::Macro, SemanticTokenType::MACRO),
    (TokenKind::Parameter, SemanticTokenType::PARAMETER),
    (TokenKind::Variable, SemanticTokenType::VARIABLE),
    (TokenKind::Property, SemanticTokenType::PROPERTY),
    (TokenKind::Keyword, SemanticTokenType::KEYWORD),
    (TokenKind::Function, SemanticTokenType::FUNCTION),
    (TokenKind::Number, SemanticTokenType::NUMBER),
    (TokenKind::String, SemanticTokenType::STRING),
    (TokenKind::Operator, SemanticTokenType::OPERATOR),
    (TokenKind::EnumMember, SemanticTokenType::ENUM_MEMBER),
    (TokenKind::Namespace, SemanticTokenType::NAMESPACE),
    (TokenKind::Class, SemanticTokenType::CLASS),
    (TokenKind::Event, SemanticTokenType::EVENT),
    (TokenKind::Comment, SemanticTokenType::COMMENT),
];

/// The tokens of a part of a document.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct EncodedPart {
    /// The first one is relative to the start of the part.
    tokens: Vec<SemanticToken>,
    /// Where the last one begins.
    last: Place,
    /// Where the part ends.
    end: Place,
}

/// A line, and a column that counts from the start of the part on its first line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Place {
    line: u32,
    col: u32,
}

impl Place {
    /// Where a place of a part is that begins at `start`.
    fn from(self, start: Self) -> Self {
        let col = match self.line {
            0 => start.col + self.col,
            _ => self.col,
        };
        Self {
            line: start.line + self.line,
            col,
        }
    }

    /// How much further a place is than the one in front.
    fn behind(self, before: Self) -> (u32, u32) {
        match self.line - before.line {
            0 => (0, self.col - before.col),
            lines => (lines, self.col),
        }
    }
}

impl EncodedPart {
    /// The pieces of a text, which are in order.
    pub(crate) fn of(text: &str, tokens: &[HighlightToken], encoding: Encoding) -> Self {
        let mut reader = PlaceReader::new(text, encoding);
        let mut out = Vec::with_capacity(tokens.len());
        let mut last = Place::default();
        for token in tokens {
            let kind = KINDS
                .iter()
                .position(|(kind, _)| *kind == token.kind)
                .unwrap_or(0) as u32;
            for words in reader.words_of(token.range) {
                let place = reader.place(words.start);
                let (delta_line, delta_start) = place.behind(last);
                out.push(SemanticToken {
                    delta_line,
                    delta_start,
                    length: encoding.width(words.slice(text)),
                    token_type: kind,
                    token_modifiers_bitset: token.modifiers.0,
                });
                last = place;
            }
        }
        let end = reader.place(text.len() as u32);
        Self {
            tokens: out,
            last,
            end,
        }
    }
}

/// Reads the places of a text in order.
struct PlaceReader<'t> {
    text: &'t str,
    encoding: Encoding,
    line: u32,
    /// Where the line begins, and the next one.
    line_start: u32,
    next_line: Option<u32>,
    /// A place on the line and its column: lines may be as long as the file.
    known: (u32, u32),
}

impl<'t> PlaceReader<'t> {
    fn new(text: &'t str, encoding: Encoding) -> Self {
        Self {
            text,
            encoding,
            line: 0,
            line_start: 0,
            next_line: next_line(text, 0),
            known: (0, 0),
        }
    }

    /// The words of a piece, line by line, without blanks around them.
    fn words_of(&self, piece: TextRange) -> impl Iterator<Item = TextRange> + use<'t> {
        let text = self.text;
        let mut start = piece.start;
        let lines = std::iter::from_fn(move || {
            let own = (start < piece.end).then_some(start)?;
            start = next_line(text, own).unwrap_or(piece.end).min(piece.end);
            Some(TextRange::new(own, start))
        });
        lines.filter_map(move |line| {
            let words = line.slice(text);
            let blank = words.len() - words.trim_start().len();
            let words = words.trim();
            let start = line.start + blank as u32;
            (!words.is_empty()).then(|| TextRange::new(start, start + words.len() as u32))
        })
    }

    /// The place of an offset that is not in front of the one before.
    fn place(&mut self, offset: u32) -> Place {
        while let Some(next) = self.next_line.filter(|next| *next <= offset) {
            (self.line, self.line_start) = (self.line + 1, next);
            self.next_line = next_line(self.text, next);
            self.known = (next, 0);
        }
        let between = TextRange::new(self.known.0, offset).slice(self.text);
        let col = self.known.1 + self.encoding.width(between);
        self.known = (offset, col);
        Place {
            line: self.line,
            col,
        }
    }
}

/// The offset behind the end of the line that `start` is on; none for the last line.
fn next_line(text: &str, start: u32) -> Option<u32> {
    let rest = text.get(start as usize..)?;
    let end = base::line_end(rest);
    let wide = rest.get(end..)?.starts_with("\r\n");
    (end < rest.len()).then_some(start + end as u32 + 1 + u32::from(wide))
}

/// The tokens of parts that follow each other.
#[derive(Default)]
pub(crate) struct JoinedTokens {
    /// All of them, each relative to the one in front.
    pub(crate) data: Vec<SemanticToken>,
    last: Place,
    end: Place,
}

impl JoinedTokens {
    /// Add those of the next part.
    pub(crate) fn add(&mut self, part: &EncodedPart) {
        if let Some((first, others)) = part.tokens.split_first() {
            let own = Place {
                line: first.delta_line,
                col: first.delta_start,
            };
            let (delta_line, delta_start) = own.from(self.end).behind(self.last);
            self.data.push(SemanticToken {
                delta_line,
                delta_start,
                ..*first
            });
            self.data.extend_from_slice(others);
            self.last = part.last.from(self.end);
        }
        self.end = part.end.from(self.end);
    }
}

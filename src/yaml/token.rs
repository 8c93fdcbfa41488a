//! Tokens.

use super::reader::Mark;

/// A token and its place.
#[derive(Clone, Debug)]
pub(super) struct Token {
    /// What it is.
    pub(super) kind: TokenKind,
    /// Its first character.
    pub(super) start: Mark,
    /// Behind its last character.
    pub(super) end: Mark,
}

/// Kinds of tokens.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum TokenKind {
    StreamEnd,
    Directive(Directive),
    DocumentStart,
    DocumentEnd,
    BlockSequenceStart,
    BlockMappingStart,
    BlockEnd,
    FlowSequenceStart,
    FlowMappingStart,
    FlowSequenceEnd,
    FlowMappingEnd,
    BlockEntry,
    FlowEntry,
    Key,
    Value,
    Alias(String),
    Anchor(String),
    /// Handle, if it has one, and the rest.
    Tag(Option<String>, String),
    /// Text, and whether it is written without quotes and markers.
    Scalar(String, bool),
}

/// Lines that begin with `%`.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Directive {
    /// The version's first number, as written.
    Yaml(String),
    /// Handle and prefix.
    Tag(String, String),
    /// Any other.
    Other,
}

impl TokenKind {
    /// The name of the kind in messages.
    pub(super) fn name(&self) -> &'static str {
        match self {
            TokenKind::StreamEnd => "<stream end>",
            TokenKind::Directive(_) => "<directive>",
            TokenKind::DocumentStart => "<document start>",
            TokenKind::DocumentEnd => "<document end>",
            TokenKind::BlockSequenceStart => "<block sequence start>",
            TokenKind::BlockMappingStart => "<block mapping start>",
            TokenKind::BlockEnd => "<block end>",
            TokenKind::FlowSequenceStart => "[",
            TokenKind::FlowMappingStart => "{",
            TokenKind::FlowSequenceEnd => "]",
            TokenKind::FlowMappingEnd => "}",
            TokenKind::BlockEntry => "-",
            TokenKind::FlowEntry => ",",
            TokenKind::Key => "?",
            TokenKind::Value => ":",
            TokenKind::Alias(_) => "<alias>",
            TokenKind::Anchor(_) => "<anchor>",
            TokenKind::Tag(..) => "<tag>",
            TokenKind::Scalar(..) => "<scalar>",
        }
    }
}

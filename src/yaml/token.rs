//! Tokens.

use super::reader::Mark;

/// A token and its place.
#[derive(Clone, Debug)]
pub(super) struct YamlToken {
    /// What it is.
    pub(super) kind: YamlTokenKind,
    /// Its first character.
    pub(super) start: Mark,
    /// Behind its last character.
    pub(super) end: Mark,
}

/// Kinds of tokens.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum YamlTokenKind {
    StreamEnd,
    Directive(YamlDirective),
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
pub(super) enum YamlDirective {
    /// The version's first number, as written.
    Yaml(String),
    /// Handle and prefix.
    Tag(String, String),
    /// Any other.
    Other,
}

impl YamlTokenKind {
    /// The name of the kind in messages.
    pub(super) fn name(&self) -> &'static str {
        match self {
            YamlTokenKind::StreamEnd => "<stream end>",
            YamlTokenKind::Directive(_) => "<directive>",
            YamlTokenKind::DocumentStart => "<document start>",
            YamlTokenKind::DocumentEnd => "<document end>",
            YamlTokenKind::BlockSequenceStart => "<block sequence start>",
            YamlTokenKind::BlockMappingStart => "<block mapping start>",
            YamlTokenKind::BlockEnd => "<block end>",
            YamlTokenKind::FlowSequenceStart => "[",
            YamlTokenKind::FlowMappingStart => "{",
            YamlTokenKind::FlowSequenceEnd => "]",
            YamlTokenKind::FlowMappingEnd => "}",
            YamlTokenKind::BlockEntry => "-",
            YamlTokenKind::FlowEntry => ",",
            YamlTokenKind::Key => "?",
            YamlTokenKind::Value => ":",
            YamlTokenKind::Alias(_) => "<alias>",
            YamlTokenKind::Anchor(_) => "<anchor>",
            YamlTokenKind::Tag(..) => "<tag>",
            YamlTokenKind::Scalar(..) => "<scalar>",
        }
    }
}

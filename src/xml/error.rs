//! What is wrong with a document, in our words and in expat's.

use base::TextRange;

/// One violation of XML or of its namespaces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SyntaxError {
    /// What kind of mistake.
    pub kind: SyntaxErrorKind,
    /// The offending text; byte offsets in the file.
    pub range: TextRange,
    /// A second place that belongs to the mistake, with a word on it.
    pub related: Option<(TextRange, &'static str)>,
    /// The headline, lower case, which names the thing; after a line feed, what to do.
    pub message: String,
    /// What expat, the parser of the reference, says to this.
    pub expat: &'static str,
    /// Where expat stops. Grows along a list of errors: the first error is the one expat reports.
    pub expat_offset: u32,
}

impl SyntaxError {
    /// What is wrong, in one line.
    pub fn headline(&self) -> &str {
        self.message.split('\n').next().unwrap_or_default()
    }

    /// What to do.
    pub fn help(&self) -> &str {
        match self.message.split_once('\n') {
            Some((_, help)) => help,
            None => "write the text itself instead of the entity, and remove the DOCTYPE",
        }
    }
}

/// The kinds of mistakes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SyntaxErrorKind {
    /// The file has no root element.
    NoRoot,
    /// Something else than white space, comments and instructions before or behind the root.
    OutsideRoot,
    /// A start tag without its `>`.
    UnclosedTag,
    /// An element without its end tag.
    UnclosedElement,
    /// An end tag that closes nothing, or something else than it says.
    MismatchedEndTag,
    /// A comment, CDATA section, instruction or DOCTYPE without its end.
    UnclosedMarkup,
    /// A name with a character that may not be there.
    BadName,
    /// A `<` that begins nothing.
    StrayLt,
    /// An attribute without `=`, without value, or without quotes.
    BadAttribute,
    /// An attribute value without its closing quote.
    UnclosedValue,
    /// A `<` inside an attribute value.
    LtInValue,
    /// An attribute given twice.
    DuplicateAttribute,
    /// A `&` that begins no reference.
    BadReference,
    /// An entity nobody declared.
    UndefinedEntity,
    /// An entity that holds itself, or too much of others.
    BadEntity,
    /// A reference to a character XML does not allow.
    BadCharacterReference,
    /// A character XML does not allow.
    IllegalCharacter,
    /// `]]>` in text.
    CDataEndInText,
    /// `--` in a comment.
    BadComment,
    /// A malformed or misplaced XML declaration.
    BadDeclaration,
    /// A malformed or misplaced DOCTYPE.
    BadDoctype,
    /// A prefix without a declaration.
    UnboundPrefix,
    /// A namespace declaration that is not allowed.
    BadNamespace,
    /// A marker a version control system left behind.
    MergeConflict,
    /// The file is longer than this parser handles.
    TooLong,
}

/// An error as an item stores it: offsets relative to the item, perhaps depending on the header.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ItemError {
    pub(super) error: SyntaxError,
    pub(super) condition: Condition,
    /// From here on the tree is a guess: expat stops at this error before it could meet later ones.
    pub(super) diverges: bool,
}

/// When an [`ItemError`] holds. What the header says is looked up late, so that an edit there leaves
/// the items alone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Condition {
    /// In any case.
    Always,
    /// When the root does not declare the prefix at the place of the error.
    UnlessBound,
    /// When this entity is missing, or not fit for its place.
    Entity { name: Box<str>, in_attribute: bool },
    /// When both mean the same namespace.
    SameNamespace(Namespace, Namespace),
}

/// What a prefix inside an item stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Namespace {
    /// Bound inside the item.
    Uri(Box<str>),
    /// Bound by the root, if at all.
    Outer(Box<str>),
}

pub(super) mod expat {
    //! The wording of expat.
    pub(crate) const INVALID: &str = "not well-formed (invalid token)";
    pub(crate) const NO_ELEMENT: &str = "no element found";
    pub(crate) const SYNTAX: &str = "syntax error";
    pub(crate) const UNCLOSED_TOKEN: &str = "unclosed token";
    pub(crate) const UNCLOSED_CDATA: &str = "unclosed CDATA section";
    pub(crate) const MISMATCH: &str = "mismatched tag";
    pub(crate) const DUPLICATE: &str = "duplicate attribute";
    pub(crate) const JUNK: &str = "junk after document element";
    pub(crate) const UNDEFINED_ENTITY: &str = "undefined entity";
    pub(crate) const RECURSIVE_ENTITY: &str = "recursive entity reference";
    pub(crate) const ASYNC_ENTITY: &str = "asynchronous entity";
    pub(crate) const BINARY_ENTITY: &str = "reference to binary entity";
    pub(crate) const EXTERNAL_IN_ATTRIBUTE: &str = "reference to external entity in attribute";
    pub(crate) const BAD_CHAR_REF: &str = "reference to invalid character number";
    pub(crate) const MISPLACED_DECLARATION: &str = "XML or text declaration not at start of entity";
    pub(crate) const BAD_DECLARATION: &str = "XML declaration not well-formed";
    pub(crate) const UNBOUND: &str = "unbound prefix";
    pub(crate) const UNDECLARED: &str = "must not undeclare prefix";
    pub(crate) const RESERVED_XML: &str =
        "reserved prefix (xml) must not be undeclared or bound to another namespace name";
    pub(crate) const RESERVED_XMLNS: &str =
        "reserved prefix (xmlns) must not be declared or undeclared";
    pub(crate) const RESERVED_URI: &str =
        "prefix must not be bound to one of the reserved namespace names";
    pub(crate) const PARAMETER_REFERENCE: &str = "illegal parameter entity reference";
    pub(crate) const PUBLIC_ID: &str = "illegal character(s) in public id";
    pub(crate) const AMPLIFICATION: &str =
        "limit on input amplification factor (from DTD and entities) breached";
}

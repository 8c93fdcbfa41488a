//! A package that a text names.
use base::TextRange;

/// A package that a text names.
#[derive(Debug)]
pub struct PackageMention {
    /// Its name.
    pub name: String,
    /// Where the name stands, absolute.
    pub range: TextRange,
    /// Whether a condition in the file decides whether it is read.
    pub is_conditional: bool,
    /// Of a `package://` URI: what follows the slash behind the name, as far as it is written out.
    pub path: Option<(String, TextRange)>,
}

//! The values of expressions.

/// A Python value.
#[derive(Clone, Debug, Default)]
pub enum Value {
    /// The value of something that already failed: flows through everything and keeps later checks quiet.
    #[default]
    Unknown,
    /// `None`
    None,
}

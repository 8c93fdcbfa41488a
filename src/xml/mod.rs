//! XML as editors see it: a lossless parser that survives half-typed text, redoes only what an edit
//! touched, and knows exactly what expat, the parser of the reference, would say.

mod chars;
mod chunks;
mod document;
mod entities;
mod error;
mod item;
mod name_table;
mod node;
mod parse;
mod positions;
mod verdict;

pub use document::{Document, Part, Place};
pub use entities::{Entities, source_offset};
pub use error::{SyntaxError, SyntaxErrorKind};
pub use item::{CacheSlot, Item};
pub use node::{Attr, Node, NodeId, NodeKind, Siblings};

#[cfg(test)]
mod tests;

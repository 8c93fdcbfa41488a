//! XML as editors see it: a lossless parser that survives half-typed text, redoes only what an edit
//! touched, and knows exactly what expat, the parser of the reference, would say.

mod chars;
mod chunks;
mod decode;
mod doctype;
mod document;
mod edit;
mod entities;
mod error;
mod expat_error;
mod item;
mod item_run;
mod line_table;
mod name_table;
mod node;
mod parse;
mod positions;

pub use decode::{decode as decode_text, source_offset, source_offsets};
pub use doctype::printed_doctype;
pub use document::{Document, DocumentPart, DocumentPosition};
pub use entities::Entities;
pub use error::{SyntaxError, SyntaxErrorKind};
pub use item::Item;
pub use item_run::ItemRun;
pub use node::{Attr, Node, NodeId, NodeKind, Siblings, normalize_line_ends};

#[cfg(test)]
mod edit_tests;
#[cfg(test)]
mod tests;

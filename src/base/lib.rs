//! Ids, text ranges, positions and cancellation: the vocabulary all other modules share.

mod cache;
mod cancel;
pub mod clock;
mod expansion_limits;
mod id_vec;
pub mod limits;
pub mod paths;
mod position;
mod range;
mod severity;
mod shared_id_vec;
mod shared_vec;
mod text;

pub use cache::Cache;
pub use cancel::CancelFlag;
pub use expansion_limits::ExpansionLimits;
pub use id_vec::{Id, IdVec};
pub use position::{Encoding, LineCol, count_line_ends, last_line_start, line_end, nth_line_start};
pub use range::{FileId, Span, TextRange};
pub use severity::Severity;
pub use shared_id_vec::SharedIdVec;
pub use shared_vec::{SharedVec, SharedVecIter};
pub use text::{counted, escape_xml};

/// The hash map used throughout: fast, not resistant to chosen keys, never iterated into output.
pub type FastMap<K, V> = rustc_hash::FxHashMap<K, V>;
/// The hash set that goes with [`FastMap`].
pub type FastSet<K> = rustc_hash::FxHashSet<K>;

//! `xacro-lsp` and `xacro-lint`: exact expansion and analysis of xacro and URDF.
//!
//! The crates below are listed in import order: each uses only those above it (see `docs/architecture.md`).

pub use base;
pub use xml;
pub use expr;
pub use yaml;
pub use vfs;
pub use workspace;
pub use facts;
pub use expand;
pub use model;
pub use rules;
pub use ide;
pub use analysis;
pub use preview;
#[cfg(feature = "cli")]
pub use picture;
#[cfg(feature = "lsp")]
pub use server;
#[cfg(feature = "cli")]
pub use cli;

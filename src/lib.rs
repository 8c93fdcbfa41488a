//! `xacro-lsp` and `xacro-lint`: exact expansion and analysis of xacro and URDF.
//!
//! The crates behind it, each under its own name. `docs/architecture.md` says what they are and which may use which.

pub use analysis;
pub use base;
#[cfg(feature = "cli")]
pub use cli;
pub use expand;
pub use expr;
pub use facts;
pub use ide;
pub use model;
pub use packages;
#[cfg(feature = "cli")]
pub use picture;
pub use preview;
pub use rules;
#[cfg(feature = "lsp")]
pub use server;
pub use vfs;
pub use workspace;
pub use xml;
pub use yaml;

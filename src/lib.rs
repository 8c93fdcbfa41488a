//! `xacro-lsp` and `xacro-lint`: exact expansion and analysis of xacro and URDF.
//!
//! The modules below are listed in import order: each may use only those above it
//! (see `docs/architecture.md`; `tests/architecture.rs` fails when an import breaks the order).

pub mod analysis;
pub mod base;
#[cfg(feature = "cli")]
pub mod cli;
pub mod expand;
pub mod expr;
pub mod facts;
pub mod ide;
pub mod model;
#[cfg(feature = "cli")]
pub mod picture;
pub mod preview;
pub mod rules;
#[cfg(feature = "lsp")]
pub mod server;
pub mod vfs;
pub mod workspace;
pub mod xml;
pub mod yaml;

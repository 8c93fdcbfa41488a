//! What a client asks, one file for each kind of request: functions of the state and the parameters.

pub(crate) mod actions;
mod arguments;
pub(crate) mod asked;
pub mod beside;
mod branches;
pub(crate) mod calls;
pub(crate) mod code_action;
pub(crate) mod colors;
pub(crate) mod commands;
pub(crate) mod completion;
mod configuration;
pub(crate) mod expand_at;
pub(crate) mod expansion;
pub(crate) mod formatting;
pub(crate) mod hints;
pub(crate) mod hover;
mod launch;
pub(crate) mod lenses;
pub(crate) mod links;
pub(crate) mod navigation;
pub(crate) mod of_description;
pub(crate) mod refactorings;
pub(crate) mod references;
pub(crate) mod rename;
pub(crate) mod structure;
pub(crate) mod tokens;
pub(crate) mod workspace_symbols;

//! The language server, driven over its standard input and output as an editor drives it.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

mod acceptance;
mod actions;
mod beside;
mod calls;
mod capabilities;
mod client;
mod completion;
mod completion_calls;
mod completion_elements;
mod completion_items;
mod completion_near;
mod configuration;
mod context;
mod diagnostics;
mod diagnostics_at_calls;
mod diagnostics_of_contexts;
mod expansion;
mod faults;
mod files;
mod first_answer;
mod format;
mod hints;
mod hover;
mod instances;
mod launch;
mod launch_any;
mod lifecycle;
mod limits;
mod logs;
mod messages;
mod names;
mod names_by_arguments;
mod navigation;
mod picked;
mod positions;
mod preview;
mod protocol;
mod quick_fixes;
mod refactorings;
mod rename;
mod rewrites;
mod structure;
mod table;
mod tokens;
mod typing;
mod workspace;

//! What must hold for every input, one function a part of the program.
//!
//! Two programs use these: `tests/properties.rs` with a bounded number of changed seeds, on every run of the tests,
//! and the targets of cargo-fuzz (`tests/fuzz/run.py`) for as long as one likes. A function fails by panicking.

mod data;
mod expressions;
mod launch_files;
mod launch_requests;
mod messages;
mod robots;
mod texts;

pub use data::{configuration, mesh, yaml};
pub use expressions::{expression, outcome};
pub use launch_files::launch;
pub use launch_requests::launch_requests;
pub use messages::messages;
pub use robots::{expander, fixes};
pub use texts::{edits, formatter, xml};

/// A part of the program with what must hold for it.
pub struct Target {
    /// Its name, which is that of the fuzz target too.
    pub name: &'static str,
    /// Tries one input.
    pub run: fn(&[u8]),
    /// What to begin with: files with these endings, or a list of `tests/properties/seeds.rs`.
    pub seeds: &'static [&'static str],
    /// Whether the first byte chooses among variants.
    pub has_choice: bool,
}

/// All of them.
pub const TARGETS: &[Target] = &[
    Target {
        name: "xml",
        run: xml,
        seeds: &["xacro", "urdf", "xml"],
        has_choice: false,
    },
    Target {
        name: "edits",
        run: edits,
        seeds: &["xacro", "urdf"],
        has_choice: false,
    },
    Target {
        name: "formatter",
        run: formatter,
        seeds: &["xacro", "urdf"],
        has_choice: true,
    },
    Target {
        name: "expression",
        run: expression,
        seeds: &["expressions"],
        has_choice: false,
    },
    Target {
        name: "yaml",
        run: yaml,
        seeds: &["yaml"],
        has_choice: false,
    },
    Target {
        name: "expander",
        run: expander,
        seeds: &["xacro", "urdf"],
        has_choice: true,
    },
    Target {
        name: "fixes",
        run: fixes,
        seeds: &["xacro", "urdf"],
        has_choice: true,
    },
    Target {
        name: "mesh",
        run: mesh,
        seeds: &["stl", "meshes"],
        has_choice: true,
    },
    Target {
        name: "configuration",
        run: configuration,
        seeds: &["toml"],
        has_choice: false,
    },
    Target {
        name: "launch",
        run: launch,
        seeds: &["launch"],
        has_choice: true,
    },
    Target {
        name: "launch_requests",
        run: launch_requests,
        seeds: &["launch", "launch-of-a-package"],
        has_choice: true,
    },
    Target {
        name: "messages",
        run: messages,
        seeds: &["messages"],
        has_choice: false,
    },
];

/// The target with this name.
pub fn target(name: &str) -> &'static Target {
    TARGETS
        .iter()
        .find(|target| target.name == name)
        .unwrap_or_else(|| panic!("no target `{name}`"))
}

/// The first byte, which chooses among variants, and the rest as text.
fn choice_and_text(data: &[u8]) -> (u8, String) {
    let (&first, rest) = data.split_first().unwrap_or((&0, &[]));
    (first, xacro_lsp::vfs::text_of(rest.to_vec()))
}

//! The arguments that descriptions declare.
use std::sync::Arc;

use ecow::EcoString;

use base::FastSet;
use vfs::SourceFile;

/// The arguments that a description knows.
#[derive(Default)]
pub(super) struct KnownArguments {
    pub(super) names: FastSet<EcoString>,
    /// Whether all that may be included was read, and each name is written out.
    pub(super) complete: bool,
    /// The files that were read.
    pub(super) files: Vec<Arc<SourceFile>>,
}

impl KnownArguments {
    /// The arguments that are declared, each with its default where it has one.
    pub(super) fn defaults(&self) -> Vec<(String, Option<String>)> {
        let mut found = Vec::new();
        for file in &self.files {
            let entities = file.document.entities();
            for (_, item) in file.document.parts() {
                for node in item.all_nodes().filter(|node| node.name() == "xacro:arg") {
                    let Some(name) = node.attr("name") else {
                        continue;
                    };
                    let default = node
                        .attr("default")
                        .map(|default| default.value(entities).into_owned());
                    found.push((name.raw().to_owned(), default));
                }
            }
        }
        found
    }
}

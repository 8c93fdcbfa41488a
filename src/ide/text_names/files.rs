//! The files that includes name, as far as their texts say.

use std::sync::Arc;

use base::{FastMap, FileId, Span};
use expand::Expansion;
use rules::{RuleEnv, include_tags};
use vfs::SourceFile;
use workspace::{admitted_files, named_file};

/// The files behind includes: those that an expansion read, and for the others what the text says.
pub(super) struct IncludedFiles<'a> {
    world: RuleEnv<'a>,
    expansion: &'a Expansion,
    /// By the start of the tag.
    taken: FastMap<(FileId, u32), Vec<FileId>>,
}

impl<'a> IncludedFiles<'a> {
    pub fn new(expansion: &'a Expansion, world: RuleEnv<'a>) -> Self {
        let mut taken: FastMap<(FileId, u32), Vec<FileId>> = FastMap::default();
        for (file, tag) in include_tags(expansion, world) {
            let known = taken.entry((tag.file, tag.range.start)).or_default();
            if !known.contains(&file) {
                known.push(file);
            }
        }
        Self {
            world,
            expansion,
            taken,
        }
    }

    /// The file that the expansion begins with.
    pub fn root(&self) -> Option<Arc<SourceFile>> {
        Some(self.expansion.files.first()?.source.clone())
    }

    /// The files that an include with a computed name may bring in with other arguments.
    pub fn alternatives(&self, from: &SourceFile, filename: &str) -> Vec<Arc<SourceFile>> {
        let paths = admitted_files(filename, &from.path, self.world.packages, self.world.vfs);
        paths
            .iter()
            .filter_map(|path| self.world.vfs.document(path).ok())
            .collect()
    }

    /// What the include whose tag stands at `tag` of a file brings in.
    pub fn of(&self, from: &SourceFile, tag: Span, filename: &str) -> Vec<Arc<SourceFile>> {
        if let Some(known) = self.taken.get(&(tag.file, tag.range.start)) {
            let source = |id: &FileId| {
                self.expansion
                    .files
                    .iter()
                    .find(|file| file.source.id == *id)
            };
            return known
                .iter()
                .filter_map(source)
                .map(|file| file.source.clone())
                .collect();
        }
        let path = named_file(filename, &from.path, self.world.packages, self.world.vfs);
        path.and_then(|path| self.world.vfs.document(&path).ok())
            .into_iter()
            .collect()
    }
}

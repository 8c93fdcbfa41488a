//! The files that includes name, as far as their texts say.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use base::{FastMap, FileId, Span};
use expand::Expansion;
use rules::{Surroundings, include_tags};
use vfs::{SourceFile, Vfs};
use workspace::{Packages, include_pattern};

use vfs::without_parents;

/// Files that one include may bring in.
const MOST_ALTERNATIVES: usize = 20;
/// Folders that one include has looked into.
const MOST_FOLDERS: usize = 60;

/// The file that `filename` names, when nothing has to be computed but packages.
pub fn included(filename: &str, from: &Path, packages: &Packages, vfs: &Vfs) -> Option<PathBuf> {
    let mut path = String::new();
    let mut rest = filename;
    while let Some((before, after)) = rest.split_once("$(find ") {
        let (package, behind) = after.split_once(')')?;
        path.push_str(before);
        path.push_str(packages.find(package.trim(), from).ok()?.path.to_str()?);
        rest = behind;
    }
    path.push_str(rest);
    let plain = !path.contains(['$', '*', '?', '[']);
    let path = plain.then(|| without_parents(&from.parent().unwrap_or(from).join(path)))?;
    let path = packages.present(&path).into_owned();
    vfs.is_file(&path).then_some(path)
}

/// The files that an include with a computed name may bring in. None when there are too many, or too many folders to look into: the
/// name says too little then.
pub fn alternatives(filename: &str, from: &Path, packages: &Packages, vfs: &Vfs) -> Vec<PathBuf> {
    let pattern = filename.contains('$').then(|| include_pattern(filename, from, packages)).flatten();
    let Some(pattern) = pattern.filter(|pattern| !pattern.start().1) else { return Vec::new() };
    let mut found = pattern.reached(vfs, MOST_FOLDERS);
    if found.len() > MOST_ALTERNATIVES {
        found.clear();
    }
    found
}

/// The files behind includes: those that an expansion read, and for the others what the text says.
pub(super) struct Files<'a> {
    world: Surroundings<'a>,
    expansion: &'a Expansion,
    /// By the start of the tag.
    taken: FastMap<(FileId, u32), Vec<FileId>>,
}

impl<'a> Files<'a> {
    pub fn new(expansion: &'a Expansion, world: Surroundings<'a>) -> Self {
        let mut taken: FastMap<(FileId, u32), Vec<FileId>> = FastMap::default();
        for (file, tag) in include_tags(expansion, world) {
            let known = taken.entry((tag.file, tag.range.start)).or_default();
            if !known.contains(&file) {
                known.push(file);
            }
        }
        Self { world, expansion, taken }
    }

    /// The file that the expansion begins with.
    pub fn root(&self) -> Option<Arc<SourceFile>> {
        Some(self.expansion.files.first()?.source.clone())
    }

    /// The files that an include with a computed name may bring in with other arguments.
    pub fn alternatives(&self, from: &SourceFile, filename: &str) -> Vec<Arc<SourceFile>> {
        let paths = alternatives(filename, &from.path, self.world.packages, self.world.vfs);
        paths.iter().filter_map(|path| self.world.vfs.document(path).ok()).collect()
    }

    /// What the include whose tag stands at `tag` of a file brings in.
    pub fn of(&self, from: &SourceFile, tag: Span, filename: &str) -> Vec<Arc<SourceFile>> {
        if let Some(known) = self.taken.get(&(tag.file, tag.range.start)) {
            let source = |id: &FileId| self.expansion.files.iter().find(|file| file.source.id == *id);
            return known.iter().filter_map(source).map(|file| file.source.clone()).collect();
        }
        let path = included(filename, &from.path, self.world.packages, self.world.vfs);
        path.and_then(|path| self.world.vfs.document(&path).ok()).into_iter().collect()
    }
}

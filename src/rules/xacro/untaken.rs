//! Files that are not included with these arguments: those of branches that are not taken, and the others that a computed name admits.
use std::path::Path;
use std::sync::Arc;

use super::super::context::DocumentCx;
use super::source;
use base::{FastSet, FileId};
use expand::FileRange;
use vfs::SourceFile;
use workspace::{admitted_files, named_file};
use xml::NodeKind;

/// The files that further arguments could bring in; none when it cannot be told which.
pub(super) fn files(cx: &DocumentCx<'_>) -> Option<Vec<Arc<SourceFile>>> {
    let taken: FastSet<FileRange> = source::inclusions(cx.expansion, cx.world)
        .into_iter()
        .map(|inclusion| inclusion.tag)
        .collect();
    let mut known: FastSet<FileId> = cx
        .expansion
        .files
        .iter()
        .map(|file| file.source.id)
        .collect();
    let mut open = Vec::new();
    for (idx, file) in cx.expansion.files.iter_ids() {
        for (range, filename) in includes(&file.source) {
            let place = FileRange { file: idx, range };
            if !taken.contains(&place) {
                open.extend(load(cx, &filename, &file.source.path)?);
            } else if is_computed(&filename) {
                // a folder that a property holds is often the same with all arguments: what was read has to do then
                open.extend(load(cx, &filename, &file.source.path).unwrap_or_default());
            }
        }
    }
    let mut found = Vec::new();
    while let Some(file) = open.pop() {
        if known.insert(file.id) {
            for (_, filename) in includes(&file) {
                open.extend(load(cx, &filename, &file.path)?);
            }
            found.push(file);
        }
    }
    Some(found)
}

/// The include tags of a file, from `<` to the end of the name, and what they include.
fn includes(file: &SourceFile) -> Vec<(base::TextRange, String)> {
    let mut found = Vec::new();
    for (base, item) in file.document.parts() {
        let elements = item
            .all_nodes()
            .filter(|node| node.kind() == NodeKind::Element);
        for node in elements.filter(|node| node.name() == "xacro:include") {
            let name = node.name_range();
            let range = base::TextRange::new(name.start - 1, name.end).shift(base);
            found.extend(
                node.attr("filename")
                    .map(|filename| (range, filename.raw().to_owned())),
            );
        }
    }
    found
}

/// Whether other arguments may name another file.
fn is_computed(filename: &str) -> bool {
    filename.replace("$(find ", "").contains('$')
}

/// The files that an include may bring in; none when that may be any.
fn load(cx: &DocumentCx<'_>, filename: &str, from: &Path) -> Option<Vec<Arc<SourceFile>>> {
    let (packages, vfs) = (cx.world.packages, cx.world.vfs);
    let paths = match named_file(filename, from, packages, vfs) {
        Some(path) => vec![path],
        None => admitted_files(filename, from, packages, vfs),
    };
    let files: Vec<_> = paths
        .iter()
        .filter_map(|path| vfs.document(path).ok())
        .collect();
    (!files.is_empty()).then_some(files)
}

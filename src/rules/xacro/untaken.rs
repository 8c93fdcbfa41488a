//! Files that are included in branches that are not taken with these arguments.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::super::context::DocumentCx;
use super::source;
use base::{FastSet, FileId};
use expand::Place;
use vfs::SourceFile;
use xml::NodeKind;

/// The files that further arguments could bring in; none when it cannot be told which.
pub(super) fn files(cx: &DocumentCx<'_>) -> Option<Vec<Arc<SourceFile>>> {
    let taken: FastSet<Place> =
        source::inclusions(cx.expansion, cx.world).into_iter().map(|inclusion| inclusion.tag).collect();
    let mut known: FastSet<FileId> = cx.expansion.files.iter().map(|file| file.source.id).collect();
    let mut open = Vec::new();
    for (number, file) in (0..).zip(&cx.expansion.files) {
        for (range, filename) in includes(&file.source) {
            let place = Place { file: expand::FileIdx(number), range };
            if !taken.contains(&place) {
                open.push(load(cx, &filename, &file.source.path)?);
            }
        }
    }
    let mut found = Vec::new();
    while let Some(file) = open.pop() {
        if known.insert(file.id) {
            for (_, filename) in includes(&file) {
                open.push(load(cx, &filename, &file.path)?);
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
        let elements = item.all_nodes().filter(|node| node.kind() == NodeKind::Element);
        for node in elements.filter(|node| node.name() == "xacro:include") {
            let name = node.name_range();
            let range = base::TextRange::new(name.start - 1, name.end).shift(base);
            found.extend(node.attr("filename").map(|filename| (range, filename.raw().to_owned())));
        }
    }
    found
}

fn load(cx: &DocumentCx<'_>, filename: &str, from: &Path) -> Option<Arc<SourceFile>> {
    let path = match filename.strip_prefix("$(find ") {
        Some(rest) => {
            let (package, rest) = rest.split_once(')')?;
            let found = cx.world.packages.find(package.trim(), from).ok()?;
            found.path.join(rest.trim_start_matches('/'))
        }
        None => PathBuf::from(filename),
    };
    let computed = path.to_string_lossy().contains(['$', '*']);
    let path = from.parent()?.join(path);
    let path = cx.world.packages.present(&path);
    cx.world.vfs.document(&cx.world.vfs.absolute(&path)).ok().filter(|_| !computed)
}

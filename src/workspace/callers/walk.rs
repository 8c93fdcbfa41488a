//! The files of a folder of sources, for those who read them as text.

use std::path::Path;

use base::FastSet;
use base::limits::{CALLER_BYTES, CALLER_DEPTH, CALLER_FOLDERS};
use packages::{is_built, is_cache};
use vfs::Vfs;

/// Takes the path of a file, its name, and whether it is small enough to be read.
pub(super) type Visit<'v> = dyn FnMut(&Path, &str, &dyn Fn() -> bool) + 'v;

/// Visit the files below a folder, each with its name and whether it is small enough to be read; whether that were all.
pub(super) fn walk(vfs: &Vfs, top: &Path, visit: &mut Visit<'_>) -> bool {
    // a link that leads up does not make what lies beside the folder a part of it
    let mut seen: FastSet<u128> = top
        .ancestors()
        .skip(1)
        .filter_map(|folder| vfs.identity(folder))
        .collect();
    let above = seen.len();
    let mut open = vec![(top.to_owned(), 0)];
    let mut is_whole = true;
    while let Some((folder, depth)) = open.pop() {
        is_whole &= seen.len() - above <= CALLER_FOLDERS;
        if !is_whole
            || !vfs
                .identity(&folder)
                .is_some_and(|identity| seen.insert(identity))
        {
            continue;
        }
        let entries = vfs.list_dir(&folder);
        if is_cache(&entries) {
            continue;
        }
        for entry in entries.iter() {
            let path = folder.join(&entry.name);
            let passed_over = entry.name.starts_with('.')
                || is_built(&entry.name)
                || entry.name == "node_modules";
            if !entry.is_dir {
                let is_small = || vfs.size(&path).is_some_and(|size| size <= CALLER_BYTES);
                visit(&path, &entry.name, &is_small);
            } else if !passed_over && depth < CALLER_DEPTH {
                open.push((path, depth + 1));
            }
        }
    }
    is_whole
}

//! The round trip: from the expanded text to its source and back leads to where it began.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::source_map::{entry_at, instances, origin_of};
use crate::expand::{Expansion, MapKind, Request, World, expand, write_mapped};
use crate::vfs::{Environment, Vfs};
use crate::workspace::{PackageOptions, Packages};

/// All descriptions below a folder.
fn descriptions(vfs: &Vfs, folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in vfs.list_dir(folder) {
        let path = folder.join(&entry.name);
        let name = entry.name.to_string();
        match entry.is_dir {
            true => descriptions(vfs, &path, found),
            false if name.ends_with(".xacro") || name.ends_with(".urdf") => found.push(path),
            false => {}
        }
    }
}

/// Positions of the expanded text from which the way back does not lead there; how many were tried.
fn lost(expansion: &Expansion) -> (Vec<String>, usize) {
    let written = write_mapped(&expansion.tree, "");
    let mut lost = Vec::new();
    for entry in &written.map {
        let at = entry.out.start;
        let found = entry_at(&written, at).unwrap();
        let place = expansion.place(origin_of(expansion, found)).unwrap();
        let back = instances(expansion, &written, place.file, place.range.start);
        if !back.iter().any(|(out, _)| out.start <= at && at < out.end) {
            let text = entry.out.slice(&written.text);
            lost.push(format!("{:?} `{}`", entry.kind, text.chars().take(60).collect::<String>()));
        }
    }
    (lost, written.map.len())
}

#[test]
fn the_way_back_leads_to_where_it_began() {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    let vfs = Arc::new(Vfs::with_cwd(u64::MAX, manifest.to_path_buf()));
    let env = Environment { vars: Default::default(), cwd: manifest.to_path_buf() };
    let packages = Packages::new(vfs.clone(), &env, PackageOptions::default());
    let mut files = Vec::new();
    for folder in ["docs/examples", "tests/conformance", "tests/cli", "tests/preview/rig"] {
        descriptions(&vfs, &manifest.join(folder), &mut files);
    }
    let (mut tried, mut wrong) = (0, Vec::new());
    for file in files {
        let request = Request { file: file.to_string_lossy().into_owned(), ..Request::default() };
        let expansion = expand(World { vfs: &vfs, packages: &packages, env: &env }, &request);
        let (lost, count) = lost(&expansion);
        tried += count;
        wrong.extend(lost.into_iter().map(|lost| format!("{}: {lost}", file.display())));
    }
    assert!(tried > 1000, "{tried}");
    assert!(wrong.is_empty(), "{} of {tried}:\n{}", wrong.len(), wrong.join("\n"));
    assert_eq!(MapKind::Element as u32, 0);
}

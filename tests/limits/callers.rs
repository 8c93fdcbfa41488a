//! How far the callers of a robot are searched for.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use xacro_lsp::base::limits::*;
use xacro_lsp::packages::{PackageOptions, Packages};
use xacro_lsp::vfs::{Environment, Vfs};
use xacro_lsp::workspace::Callers;

use super::{folder, write};

/// The callers in a folder.
pub fn callers_in(folder: &Path) -> Callers {
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let options = PackageOptions {
        workspace_folders: vec![folder.to_owned()],
        search_upward: false,
        ..PackageOptions::default()
    };
    let vfs = Arc::new(Vfs::with_cwd(1 << 24, folder.to_owned()));
    Callers::new(Arc::new(Packages::new(vfs, &env, options)))
}

/// How many callers of a robot are found below `folder`.
fn callers_of(folder: &Path, robot: &str) -> usize {
    callers_in(folder).of(&folder.join(robot)).len()
}

#[test]
fn caller_depth() {
    let found = |levels: usize| {
        let folder = folder();
        let deep: PathBuf = (0..levels).map(|_| "d").collect();
        write(
            &folder,
            &format!("{}/r.launch", deep.display()),
            "deep.urdf",
        );
        callers_of(&folder, "deep.urdf")
    };
    assert_eq!((found(CALLER_DEPTH - 4), found(CALLER_DEPTH + 4)), (1, 0));
}

#[test]
fn caller_bytes() {
    let found = |bytes: u64| {
        let folder = folder();
        write(
            &folder,
            "r.launch",
            format!("large.urdf{}", " ".repeat(bytes as usize)),
        );
        callers_of(&folder, "large.urdf")
    };
    assert_eq!((found(CALLER_BYTES / 2), found(CALLER_BYTES)), (1, 0));
}

#[test]
fn caller_folders() {
    let folder = folder();
    write(&folder, "a/r.launch", "far.urdf");
    assert_eq!(callers_of(&folder, "far.urdf"), 1);
    for n in 0..=CALLER_FOLDERS {
        fs::create_dir(folder.join(format!("f{n}"))).unwrap();
    }
    // those that are listed last are searched first
    assert_eq!(callers_of(&folder, "far.urdf"), 0);
    // a folder that a tool made counts as one, whatever is in it
    write(&folder, "b/CACHEDIR.TAG", "");
    write(&folder, "b/r.launch", "made.urdf");
    assert_eq!(callers_of(&folder.join("b"), "made.urdf"), 0);
    let _ = fs::remove_dir_all(folder);
}

#[test]
fn caller_files() {
    let folder = folder();
    for n in 0..3 {
        write(&folder, &format!("{n}/r.launch"), "many.urdf");
    }
    assert_eq!(callers_of(&folder, "many.urdf"), 3);
    for n in 0..=CALLER_FILES {
        write(&folder, &format!("0/{n}.md"), "");
    }
    // the folders are read one by one: how many came before the limit depends on the order
    assert!(callers_of(&folder, "many.urdf") < 3);
    let _ = fs::remove_dir_all(folder);
}

#[test]
fn caller_calls() {
    let folder = folder();
    let text: String = (0..LAUNCH_CALLS)
        .map(|n| format!("xacro r.xacro n:={n}\n"))
        .collect();
    for n in 0..=CALLER_CALLS / LAUNCH_CALLS {
        write(&folder, &format!("{n}.sh"), &text);
    }
    assert_eq!(callers_in(&folder).calls_below(&folder).len(), CALLER_CALLS);
}

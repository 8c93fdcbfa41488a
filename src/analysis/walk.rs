//! The descriptions below a folder.
use std::path::{Path, PathBuf};

use ignore::WalkBuilder;
use ignore::gitignore::{Gitignore, GitignoreBuilder};

use super::report::{SkipReason, Skipped};
use super::session::Session;
use base::limits::SCAN_FILES;
use packages::is_built;
use vfs::{Environment, LoadError, Vfs};

/// The descriptions below `folder`, sorted by path. Left out are hidden files, what git ignores, the folders
/// of build tools and what the configuration excludes. With them, what could not be searched.
pub(super) fn descriptions(folder: &Path, session: &Session) -> (Vec<PathBuf>, Vec<Skipped>) {
    let mut found = Listing::of(&[folder.to_owned()], &session.vfs, &session.env);
    found.go_on(session, &|| false);
    found.skipped.sort_by(|a, b| a.path.cmp(&b.path));
    (found.done, found.skipped)
}

/// The same with what the configuration excludes: an excluded file may include others all the same, and no
/// configuration is read for it.
pub(super) fn all_descriptions(folder: &Path, vfs: &Vfs, env: &Environment) -> Vec<PathBuf> {
    let entries = walk(folder, vfs, env)
        .filter_map(Result::ok)
        .take(SCAN_FILES * 10);
    entries
        .flatten()
        .filter(|path| is_description(path))
        .take(SCAN_FILES)
        .collect()
}

/// A search for descriptions below some folders that may be interrupted: a folder can be as large as the disk.
pub(super) struct Listing {
    walks: Vec<Walk>,
    /// What was found below the folders before, and below the present one.
    done: Vec<PathBuf>,
    found: Vec<PathBuf>,
    /// What could not be searched.
    skipped: Vec<Skipped>,
}

impl Listing {
    /// One that was not begun.
    pub fn of(folders: &[PathBuf], vfs: &Vfs, env: &Environment) -> Self {
        let walks = folders
            .iter()
            .rev()
            .map(|folder| walk(folder, vfs, env))
            .collect();
        Self {
            walks,
            done: Vec::new(),
            found: Vec::new(),
            skipped: Vec::new(),
        }
    }

    /// Search on until `stop` says so; whether all was searched.
    pub fn go_on(&mut self, session: &Session, stop: &dyn Fn() -> bool) -> bool {
        while let Some(walk) = self.walks.last_mut() {
            let Some(entry) = walk.next() else {
                self.walks.pop();
                self.found.sort();
                self.done.append(&mut self.found);
                continue;
            };
            match entry {
                Ok(file) => file.into_iter().for_each(|file| self.add(file, session)),
                Err(error) => self.skipped.extend(unreadable(error)),
            }
            if stop() {
                return false;
            }
        }
        true
    }

    fn add(&mut self, path: PathBuf, session: &Session) {
        if !is_description(&path) || session.settings(&path).excludes(&path) {
            return;
        }
        match path.to_str() {
            Some(_) => self.found.push(path),
            None => self.skipped.push(Skipped {
                path,
                reason: SkipReason::NotUtf8,
            }),
        }
    }

    /// The files, those of each folder sorted.
    pub fn done(self) -> Vec<PathBuf> {
        self.done
    }
}

/// A folder that cannot be listed.
fn unreadable(error: ignore::Error) -> Option<Skipped> {
    let mut inner = &error;
    let mut path = None;
    while let ignore::Error::WithDepth { err, .. } | ignore::Error::WithPath { err, .. } = inner {
        if let ignore::Error::WithPath { path: own, .. } = inner {
            path = Some(own.clone());
        }
        inner = err;
    }
    let path = path?;
    let reason = SkipReason::Unreadable(LoadError::from_io(&error.into_io_error()?, &path));
    Some(Skipped { path, reason })
}

/// The files of a search, one after the other; `None` for a folder.
type Walk = Box<dyn Iterator<Item = Result<Option<PathBuf>, ignore::Error>> + Send>;

/// What lies below a folder, without what build tools made.
fn walk(folder: &Path, vfs: &Vfs, env: &Environment) -> Walk {
    if let Some(files) = vfs.files_in_memory(folder) {
        return Box::new(
            in_memory(folder, files, vfs)
                .into_iter()
                .map(|file| Ok(Some(file))),
        );
    }
    let file = |entry: ignore::DirEntry| {
        (!entry.file_type().is_some_and(|kind| kind.is_dir())).then(|| entry.into_path())
    };
    Box::new(on_disk(folder, env).map(move |entry| entry.map(file)))
}

/// The same of files in memory: what is left of them without hidden ones and those that git ignores.
fn in_memory(folder: &Path, mut files: Vec<PathBuf>, vfs: &Vfs) -> Vec<PathBuf> {
    let mut ignored: Vec<Gitignore> = Vec::new();
    for list in files.iter().filter(|file| file.ends_with(".gitignore")) {
        let Ok(text) = vfs.text(list) else { continue };
        let mut builder = GitignoreBuilder::new(list.parent().unwrap_or(folder));
        for line in text.text.lines() {
            // a line that is no pattern has no effect, as with git
            let _ = builder.add_line(None, line);
        }
        ignored.extend(builder.build());
    }
    // the list that is nearest to a file has the last word
    ignored.sort_by_key(|list| std::cmp::Reverse(list.path().components().count()));
    files.retain(|file| {
        let inside = file.strip_prefix(folder).unwrap_or(file);
        let folders = inside.parent().into_iter().flat_map(Path::components);
        let is_hidden = inside
            .components()
            .any(|part| part.as_os_str().as_encoded_bytes().starts_with(b"."));
        let mut verdicts = ignored.iter().filter(|list| file.starts_with(list.path()));
        let verdict = verdicts.find_map(|list| {
            let found = list.matched_path_or_any_parents(file, false);
            (!found.is_none()).then(|| found.is_ignore())
        });
        !is_hidden
            && !folders.into_iter().any(|part| is_built(part.as_os_str()))
            && verdict != Some(true)
    });
    files
}

fn on_disk(folder: &Path, env: &Environment) -> ignore::Walk {
    let top = folder.to_owned();
    let mut walk = WalkBuilder::new(folder);
    // what git ignores everywhere is written down at home; where no home is named the user database of the system
    // would be asked, which a static program cannot do safely
    let has_home = env.home().is_some();
    walk.require_git(false)
        .git_global(has_home)
        .filter_entry(move |entry| {
            let is_dir = entry.file_type().is_some_and(|kind| kind.is_dir());
            !(is_dir && is_built(entry.file_name())) || entry.path() == top
        });
    walk.build()
}

/// Whether a file is a description, by its name: `.urdf`, `.srdf` and `.xacro`, alone or in front of `.xml`, in letters of
/// any case.
pub(super) fn is_description(path: &Path) -> bool {
    let name = path
        .file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .to_ascii_lowercase();
    let name = name.strip_suffix(".xml").unwrap_or(&name);
    [".urdf", ".srdf", ".xacro"]
        .iter()
        .any(|ending| name.ends_with(ending))
}

/// Whether a file is certainly no description, by its name: an editor opens configurations and manifests as well.
pub(super) fn is_something_else(path: &Path) -> bool {
    const ENDINGS: [&str; 4] = ["yaml", "yml", "toml", "json"];
    let ending = path
        .extension()
        .and_then(|ending| ending.to_str())
        .unwrap_or("");
    const NAMES: [&str; 2] = ["package.xml", ".setup_assistant"];
    let is_named = |name: &std::ffi::OsStr| NAMES.iter().any(|own| name == *own);
    ENDINGS.contains(&ending) || path.file_name().is_some_and(is_named) || is_launch(path)
}

/// Whether a file is a launch file or script, by its name: no description, and other servers know it better.
pub fn is_launch(path: &Path) -> bool {
    let name = path
        .file_name()
        .and_then(|name| name.to_str())
        .unwrap_or("")
        .to_ascii_lowercase();
    let endings = [
        ".py",
        ".launch",
        ".launch.xml",
        ".launch.yaml",
        ".launch.yml",
        ".sh",
        ".bash",
        ".test",
    ];
    endings.iter().any(|ending| name.ends_with(ending))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::is_description;

    #[test]
    fn names_of_descriptions() {
        for (name, expected) in [
            ("a.urdf", true),
            ("a.xacro", true),
            ("a.urdf.xacro", true),
            ("a.urdf.xml", true),
            ("a.xacro.xml", true),
            ("a.URDF", true),
            ("a.Xacro", true),
            ("a.URDF.xacro", true),
            ("a.XACRO.XML", true),
            ("package.xml", false),
            ("a.srdf.xacro", true),
            ("a.srdf", true),
            ("a.sdf", false),
            ("urdf", false),
        ] {
            assert_eq!(is_description(Path::new(name)), expected, "{name}");
        }
    }
}

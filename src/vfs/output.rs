//! Writing files.

use std::fs::{File, Metadata, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use super::process::is_process_alive;
use super::read::{self, Stamp};

/// How long a file that another program has locked is waited for.
const PATIENCE: Duration = Duration::from_secs(5);

/// Write a file so that no reader ever sees half of it, and a failure leaves the old content: the bytes go
/// to a new file beside it, which then takes its name. Missing folders are created; a link keeps pointing
/// where it points; permissions of an existing file stay, and its owner where the system allows it. A file that may
/// not be written is not replaced either.
///
/// # Errors
/// Those of the system.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    replace(path, bytes, &|| true, None)
}

/// The same, if at the last moment everything is still `as_before`; `lock` is the file itself, open.
fn replace(
    path: &Path,
    bytes: &[u8],
    as_before: &dyn Fn() -> bool,
    lock: Option<File>,
) -> io::Result<()> {
    let target = std::fs::canonicalize(path).unwrap_or_else(|_| end_of_links(path));
    let existing = std::fs::metadata(&target).ok();
    if existing.as_ref().is_some_and(|found| !found.is_file()) {
        // A pipe or device (`/dev/stdout`) has no content to protect; a folder gives its error.
        return OpenOptions::new()
            .write(true)
            .open(&target)?
            .write_all(bytes);
    }
    if let Some(parent) = target
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty())
    {
        std::fs::create_dir_all(parent)?;
    }
    if existing.is_some() {
        // renaming asks for the folder only: what its author protected stays as it is
        OpenOptions::new().write(true).open(&target)?;
    }
    if existing.as_ref().is_some_and(has_other_names) {
        // a new file would have one of the names, and the old content the others
        if !as_before() {
            return Err(changed_meanwhile());
        }
        return OpenOptions::new()
            .write(true)
            .truncate(true)
            .open(&target)?
            .write_all(bytes);
    }
    remove_left_over(&target);
    let (temporary, file) = new_beside(&target)?;
    let written = fill(file, bytes, existing.as_ref()).and_then(|()| {
        if !as_before() {
            return Err(changed_meanwhile());
        }
        let renamed = std::fs::rename(&temporary, &target);
        let is_open = |error: &io::Error| error.kind() == io::ErrorKind::PermissionDenied;
        // some systems replace no file that is open, be it here
        match lock.filter(|_| renamed.as_ref().is_err_and(is_open)) {
            Some(lock) => {
                drop(lock);
                std::fs::rename(&temporary, &target)
            }
            None => renamed,
        }
    });
    if written.is_err() {
        // The first error is the one to tell.
        let _ = std::fs::remove_file(&temporary);
    }
    written
}

fn changed_meanwhile() -> io::Error {
    io::Error::other("it was changed by another program")
}

/// Where a link leads, be there a file or not.
fn end_of_links(path: &Path) -> PathBuf {
    /// As many as Linux follows.
    const MOST: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..MOST {
        match std::fs::read_link(&path) {
            Ok(target) => path = path.parent().unwrap_or(Path::new("")).join(target),
            Err(_) => break,
        }
    }
    path
}

/// Remove what runs that were killed left beside `target`.
fn remove_left_over(target: &Path) {
    /// Processes of another machine, which the folder may be shared with, are not seen: theirs are at work no longer.
    const OLD: Duration = Duration::from_secs(600);
    let (Some(folder), Some(prefix)) = (target.parent(), temporary_prefix(target)) else {
        return;
    };
    let folder = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let rest = name
            .to_str()
            .and_then(|name| name.strip_prefix(&prefix)?.strip_suffix(".tmp"));
        let process = rest.and_then(|rest| rest.split('-').next()?.parse().ok());
        let age = || entry.metadata().ok()?.modified().ok()?.elapsed().ok();
        if process.is_some_and(|process| !is_process_alive(process))
            && age().is_some_and(|age| age > OLD)
        {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// Replace the bytes of an existing file of at most `limit` bytes by what `change` makes of them, if anything. While
/// one program does this, others that do the same wait, so that no change is lost.
///
/// # Errors
/// That of `change`, and those of the system.
pub(super) fn change(
    path: &Path,
    limit: u64,
    change: impl FnOnce(&[u8]) -> io::Result<Option<Vec<u8>>>,
) -> io::Result<()> {
    let lock = lock(path)?;
    let before = stamp(path);
    let old = read::stat(path)
        .and_then(|known| read::bytes(path, &known, limit))
        .map_err(|error| io::Error::other(error.reason()))?;
    change(&old)?.map_or(Ok(()), |new| {
        replace(path, &new, &|| stamp(path) == before, Some(lock))
    })
}

/// The stamp of a file; none when there is none.
fn stamp(path: &Path) -> Option<Stamp> {
    read::stat(path).map(|found| found.stamp).ok()
}

/// The file at `path`, locked against others that use this function.
fn lock(path: &Path) -> io::Result<File> {
    let begin = Instant::now();
    loop {
        // asked before it is opened: opening a pipe would wait for somebody at its other end
        if !std::fs::metadata(path)?.is_file() {
            return Err(io::Error::new(
                io::ErrorKind::InvalidInput,
                "it is not a regular file",
            ));
        }
        let file = read::open(path)?;
        match file.try_lock() {
            // who waited may hold a file that was replaced meanwhile
            Ok(()) if is_at(&file, path) => return Ok(file),
            // some systems know no locks
            Err(std::fs::TryLockError::Error(_)) => return Ok(file),
            Ok(()) | Err(std::fs::TryLockError::WouldBlock) => {}
        }
        if begin.elapsed() > PATIENCE {
            return Err(io::Error::new(
                io::ErrorKind::WouldBlock,
                "another program has locked it",
            ));
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    identity(file.metadata()) == identity(std::fs::metadata(path))
}

/// The device and the number of a file.
#[cfg(unix)]
fn identity(found: io::Result<Metadata>) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt;
    found.map(|found| (found.dev(), found.ino())).ok()
}

#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// Whether a file is known by other names as well (hard links).
#[cfg(unix)]
fn has_other_names(found: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    found.nlink() > 1
}

#[cfg(not(unix))]
fn has_other_names(_: &Metadata) -> bool {
    false
}

/// Write a new file, with what an existing one has beside its content.
fn fill(mut file: File, bytes: &[u8], existing: Option<&Metadata>) -> io::Result<()> {
    file.write_all(bytes)?;
    if let Some(found) = existing {
        keep_owner(&file, found);
        file.set_permissions(found.permissions())?;
    }
    file.sync_all()
}

/// Keep the owner of a file; only some users may.
#[cfg(unix)]
fn keep_owner(file: &File, found: &Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    if file
        .metadata()
        .is_ok_and(|new| (new.uid(), new.gid()) != (found.uid(), found.gid()))
    {
        let _ = fchown(file, Some(found.uid()), Some(found.gid()));
    }
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) {}

/// A new file beside `target`. One that replaces another can be read by nobody else until it has the permissions of
/// the old one.
fn new_beside(target: &Path) -> io::Result<(PathBuf, File)> {
    static NUMBER: AtomicU64 = AtomicU64::new(0);
    let Some(prefix) = temporary_prefix(target) else {
        return Err(io::Error::new(
            io::ErrorKind::IsADirectory,
            "not a file name",
        ));
    };
    let (process, options) = (std::process::id(), new_file(target.exists()));
    loop {
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let temporary = target.with_file_name(format!("{prefix}{process}-{number}.tmp"));
        match options.open(&temporary) {
            Ok(file) => return Ok((temporary, file)),
            // left over from a run that was killed
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
}

/// How names of temporary files beside `target` begin.
fn temporary_prefix(target: &Path) -> Option<String> {
    /// Longest part of the old name that is kept: names have at most 255 bytes.
    const KEPT: usize = 100;
    let name = target.file_name()?.to_string_lossy();
    Some(format!(
        ".{}.",
        name.get(..name.floor_char_boundary(KEPT))
            .unwrap_or_default()
    ))
}

#[cfg(unix)]
fn new_file(is_private: bool) -> OpenOptions {
    use std::os::unix::fs::OpenOptionsExt;
    let mut options = OpenOptions::new();
    options
        .write(true)
        .create_new(true)
        .mode(if is_private { 0o600 } else { 0o666 });
    options
}

#[cfg(not(unix))]
fn new_file(_: bool) -> OpenOptions {
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    options
}

#[cfg(test)]
mod tests {
    use super::super::testing::Tree;
    use super::write_atomically;

    #[test]
    fn creates_folders_and_replaces() {
        let tree = Tree::new();
        let path = tree.path("new/deep/out.urdf");
        write_atomically(&path, b"one").unwrap();
        write_atomically(&path, b"two").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"two");
        assert_eq!(
            std::fs::read_dir(path.parent().unwrap()).unwrap().count(),
            1
        );
    }

    #[cfg(unix)]
    #[test]
    fn follows_links_that_lead_nowhere() {
        let tree = Tree::new();
        std::os::unix::fs::symlink("sub/new", tree.path("link")).unwrap();
        write_atomically(&tree.path("link"), b"text").unwrap();
        assert!(tree.path("link").symlink_metadata().unwrap().is_symlink());
        assert_eq!(std::fs::read(tree.path("sub/new")).unwrap(), b"text");
    }

    #[test]
    fn all_names_of_a_file_see_the_new_content() {
        let tree = Tree::new();
        tree.write("one", "old and longer");
        std::fs::hard_link(tree.path("one"), tree.path("two")).unwrap();
        write_atomically(&tree.path("one"), b"new").unwrap();
        assert_eq!(std::fs::read(tree.path("one")).unwrap(), b"new");
        assert_eq!(
            std::fs::read(tree.path("two")).unwrap() == b"new",
            cfg!(unix)
        );
    }

    #[test]
    fn what_a_killed_run_left_goes() {
        let tree = Tree::new();
        let long_ago = std::time::SystemTime::now() - std::time::Duration::from_secs(3600);
        for name in [
            ".a.4000000-1.tmp",
            ".a.4000000-x.bak",
            ".b.4000000-1.tmp",
            ".a.young-1.tmp",
        ] {
            tree.write(name, "");
            std::fs::File::options()
                .write(true)
                .open(tree.path(name))
                .unwrap()
                .set_modified(long_ago)
                .unwrap();
        }
        tree.write(".a.4000000-2.tmp", "");
        write_atomically(&tree.path("a"), b"new").unwrap();
        let mut left: Vec<_> = std::fs::read_dir(tree.root())
            .unwrap()
            .map(|entry| entry.unwrap().file_name())
            .collect();
        left.sort();
        let expected = [
            ".a.4000000-2.tmp",
            ".a.4000000-x.bak",
            ".a.young-1.tmp",
            ".b.4000000-1.tmp",
            "a",
        ];
        assert_eq!(left, expected);
    }

    #[test]
    fn refuses_a_folder() {
        let tree = Tree::new();
        tree.write("sub/x", "");
        assert!(write_atomically(&tree.path("sub"), b"").is_err());
        assert!(write_atomically(&tree.path("sub/x/y"), b"").is_err());
    }

    #[cfg(unix)]
    #[test]
    fn keeps_links_and_permissions() {
        use std::os::unix::fs::PermissionsExt;
        let tree = Tree::new();
        tree.write("real", "old");
        std::fs::set_permissions(tree.path("real"), std::fs::Permissions::from_mode(0o640))
            .unwrap();
        std::os::unix::fs::symlink("real", tree.path("link")).unwrap();
        write_atomically(&tree.path("link"), b"new").unwrap();
        assert_eq!(std::fs::read(tree.path("real")).unwrap(), b"new");
        assert!(tree.path("link").symlink_metadata().unwrap().is_symlink());
        assert_eq!(
            tree.path("real").metadata().unwrap().permissions().mode() & 0o777,
            0o640
        );
    }
}

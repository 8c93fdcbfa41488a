//! Writing files.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Write a file so that no reader ever sees half of it, and a failure leaves the old content: the bytes go
/// to a new file beside it, which then takes its name. Missing folders are created; a link keeps pointing
/// where it points; permissions of an existing file stay.
///
/// # Errors
/// Those of the system.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let target = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let existing = std::fs::metadata(&target).ok();
    if existing.as_ref().is_some_and(|found| !found.is_file()) {
        // A pipe or device (`/dev/stdout`) has no content to protect; a folder gives its error.
        return std::fs::OpenOptions::new().write(true).open(&target)?.write_all(bytes);
    }
    if let Some(parent) = target.parent().filter(|parent| !parent.as_os_str().is_empty()) {
        std::fs::create_dir_all(parent)?;
    }
    let temporary = temporary_name(&target)?;
    let written = write_new(&temporary, bytes).and_then(|()| {
        if let Some(found) = existing {
            std::fs::set_permissions(&temporary, found.permissions())?;
        }
        std::fs::rename(&temporary, &target)
    });
    if written.is_err() {
        // The first error is the one to tell.
        let _ = std::fs::remove_file(&temporary);
    }
    written
}

fn write_new(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = std::fs::OpenOptions::new().write(true).create_new(true).open(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

fn temporary_name(target: &Path) -> io::Result<PathBuf> {
    let Some(name) = target.file_name() else {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "not the name of a file"));
    };
    let mut temporary = std::ffi::OsString::from(".");
    temporary.push(name);
    temporary.push(format!(".{}.tmp", std::process::id()));
    Ok(target.with_file_name(temporary))
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
        assert_eq!(std::fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
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
        std::fs::set_permissions(tree.path("real"), std::fs::Permissions::from_mode(0o640)).unwrap();
        std::os::unix::fs::symlink("real", tree.path("link")).unwrap();
        write_atomically(&tree.path("link"), b"new").unwrap();
        assert_eq!(std::fs::read(tree.path("real")).unwrap(), b"new");
        assert!(tree.path("link").symlink_metadata().unwrap().is_symlink());
        assert_eq!(tree.path("real").metadata().unwrap().permissions().mode() & 0o777, 0o640);
    }
}

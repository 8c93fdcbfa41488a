//! Temporary folder trees, for tests of all crates.

#![allow(
    clippy::unwrap_used,
    clippy::disallowed_methods,
    clippy::new_without_default,
    reason = "a test may fail loudly"
)]

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use super::{Environment, Vfs};

static NEXT: AtomicU32 = AtomicU32::new(0);

/// A folder that goes away with the value.
pub struct Tree {
    root: PathBuf,
    vfs: Arc<Vfs>,
}

impl Tree {
    /// An empty folder.
    pub fn new() -> Self {
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("xacro-lsp-test-{}-{number}", std::process::id());
        let root = std::env::temp_dir().canonicalize().unwrap().join(name);
        std::fs::create_dir_all(&root).unwrap();
        let vfs = Arc::new(Vfs::with_cwd(1 << 20, root.clone()));
        Self { root, vfs }
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// A place below it.
    pub fn path(&self, relative: &str) -> PathBuf {
        self.root.join(relative)
    }

    /// Its file system; the working directory is the root.
    pub fn vfs(&self) -> &Arc<Vfs> {
        &self.vfs
    }

    /// Write a file and the folders above it.
    pub fn write(&self, relative: &str, text: &str) {
        let path = self.path(relative);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }

    /// An environment with the root as working directory; `{root}` in values stands for it.
    pub fn environment(&self, vars: &[(&str, &str)]) -> Environment {
        let root = self.root.to_str().unwrap();
        let vars = vars
            .iter()
            .map(|(name, value)| ((*name).to_owned(), value.replace("{root}", root)));
        Environment {
            vars: vars.collect(),
            cwd: self.root.clone(),
            ..Environment::default()
        }
    }
}

impl Drop for Tree {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.root);
    }
}

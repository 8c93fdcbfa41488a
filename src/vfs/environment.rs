//! The environment a run sees.

use std::collections::BTreeMap;
use std::path::PathBuf;

/// Variables and working directory, captured once by a program and passed down from there.
#[derive(Clone, Debug, Default)]
pub struct Environment {
    /// Environment variables.
    pub vars: BTreeMap<String, String>,
    /// Working directory, absolute.
    pub cwd: PathBuf,
}

impl Environment {
    /// The environment of this process. Bytes that are not UTF-8 become U+FFFD.
    pub fn capture() -> Self {
        let vars = std::env::vars_os()
            .map(|(name, value)| (name.to_string_lossy().into_owned(), value.to_string_lossy().into_owned()))
            .collect();
        Self { vars, cwd: std::env::current_dir().unwrap_or_default() }
    }

    /// The value of a variable that is set.
    pub fn var(&self, name: &str) -> Option<&str> {
        self.vars.get(name).map(String::as_str)
    }

    /// The non-empty entries of a list of folders, as they are spelled in the variable.
    pub fn paths(&self, name: &str) -> Vec<PathBuf> {
        let value = self.var(name).unwrap_or_default();
        std::env::split_paths(value).filter(|path| !path.as_os_str().is_empty()).collect()
    }
}

//! The environment a run sees.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::PathBuf;

use super::relative::spelled;
use base::paths::{HERE, System};

/// Variables and working directory, captured once by a program and passed down from there.
#[derive(Clone, Debug, Default)]
pub struct Environment {
    /// Environment variables.
    pub vars: BTreeMap<String, String>,
    /// Working directory, absolute.
    pub cwd: PathBuf,
    /// Folders outside of which no file is read; none: all files may be read.
    pub within: Vec<PathBuf>,
}

/// Text without what is not Unicode in it.
fn text(text: OsString) -> String {
    text.into_string()
        .unwrap_or_else(|text| text.to_string_lossy().into_owned())
}

impl Environment {
    /// The environment of this process. Bytes that are not UTF-8 become U+FFFD.
    pub fn capture() -> Self {
        let vars = std::env::vars_os()
            .map(|(name, value)| (text(name), text(value)))
            .collect();
        Self {
            vars,
            cwd: spelled(std::env::current_dir().unwrap_or_default()),
            within: Vec::new(),
        }
    }

    /// The value of a variable that is set.
    pub fn var(&self, name: &str) -> Option<&str> {
        let found = match self.vars.get(name) {
            None if HERE != System::Posix => self
                .vars
                .iter()
                .find(|(own, _)| HERE.folded(own) == HERE.folded(name))
                .map(|(_, value)| value),
            found => found,
        };
        found.map(String::as_str)
    }

    /// The folder of the user.
    pub fn home(&self) -> Option<&str> {
        let profile = || self.var("USERPROFILE").filter(|_| HERE == System::Windows);
        self.var("HOME")
            .or_else(profile)
            .filter(|home| !home.is_empty())
    }

    /// The non-empty entries of a list of folders, as they are spelled in the variable.
    pub fn paths(&self, name: &str) -> Vec<PathBuf> {
        // where there is no environment, as in a browser, lists cannot be split either
        let Some(value) = self.var(name) else {
            return Vec::new();
        };
        let paths = std::env::split_paths(value).filter(|path| !path.as_os_str().is_empty());
        paths.map(spelled).collect()
    }
}

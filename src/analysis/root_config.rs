//! Under which root a file is shown.
use std::path::{Path, PathBuf};

/// A root and the arguments it is expanded with.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RootConfig {
    /// The file, absolute.
    pub file: PathBuf,
    /// Arguments over the defaults of the file.
    pub args: Vec<(String, String)>,
    /// The preset of the configuration they come from.
    pub preset: Option<String>,
}

impl RootConfig {
    /// A file with the defaults of its arguments.
    pub fn plain(file: &Path) -> Self {
        Self {
            file: file.to_path_buf(),
            args: Vec::new(),
            preset: None,
        }
    }

    /// For people: the name of the file and the arguments.
    pub fn label(&self) -> String {
        label(short_name(&self.file), &self.args)
    }
}

/// The name of a file without its folder.
pub(super) fn short_name(file: &Path) -> String {
    file.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// A root with its arguments, as one writes them on a command line; later arguments win.
pub(super) fn label(mut text: String, args: &[(String, String)]) -> String {
    for (number, (name, value)) in args.iter().enumerate() {
        if !args.iter().skip(number + 1).any(|(later, _)| later == name) {
            text.push_str(&format!(" {name}:={value}"));
        }
    }
    text
}

/// Why a root was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootReason {
    /// The user selected it.
    Selected,
    /// A comment `xacro-root:` at the top of the file names it.
    Comment,
    /// The configuration lists it.
    Configured,
    /// The file is a robot itself.
    Itself,
    /// It includes the file.
    Includes,
    /// No robot includes the file.
    None,
}

impl RootReason {
    /// For a status line.
    pub fn text(self) -> &'static str {
        match self {
            RootReason::Selected => "selected in this session",
            RootReason::Comment => "set by the xacro-root comment",
            RootReason::Configured => "set in the configuration",
            RootReason::Itself => "the file is a robot",
            RootReason::Includes => "it includes the file",
            RootReason::None => "no root includes this file",
        }
    }
}

/// The context of a file.
#[derive(Clone, Debug)]
pub struct Context {
    /// The active root; none for a file that no robot includes.
    pub root: Option<RootConfig>,
    /// Why it is active.
    pub reason: RootReason,
    /// All roots that reach the file, with their distance in includes.
    pub candidates: Vec<(RootConfig, u32)>,
}

#[cfg(test)]
mod tests {
    use super::label;

    #[test]
    fn the_last_value_of_an_argument_counts() {
        let args = [("a", "1"), ("b", "2"), ("a", "3")]
            .map(|(name, value)| (name.to_owned(), value.to_owned()));
        assert_eq!(label("r.xacro".to_owned(), &args), "r.xacro b:=2 a:=3");
    }
}

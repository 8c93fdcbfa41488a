//! Expands [xacro](https://github.com/ros/xacro) robot descriptions into URDF, byte for byte as `xacro` 2.1.1 does, without ROS
//! and without Python. For viewers, simulators and tools in Rust that load robots.
//!
//! ```
//! # let folder = std::env::temp_dir().join(format!("xacro-expand-{}", std::process::id()));
//! # std::fs::create_dir_all(&folder).unwrap();
//! # let file = folder.join("arm.urdf.xacro");
//! # std::fs::write(&file, "<robot name='arm' xmlns:xacro='http://www.ros.org/wiki/xacro'>
//! #   <xacro:arg name='prefix' default=''/>
//! #   <link name='$(arg prefix)base_link'/>
//! # </robot>").unwrap();
//! let robot = xacro_expand::expand(&file, &xacro_expand::Options::new().arg("prefix", "left_"));
//! assert!(robot.text().unwrap().contains("<link name=\"left_base_link\"/>"));
//! # std::fs::remove_dir_all(folder).unwrap();
//! ```
//!
//! Expansion never fails with a bare error: what went wrong is in [`Robot::problems`], all of it, each at the source text that
//! caused it. It always ends, whatever the files say, and executes nothing of them.

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic)] // a test may fail loudly
mod tests;

use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use base::Encoding;
use base::limits::FILE_MB;
use expand::{Expansion, FileRange, Origin, Request, Sources, Written};
use packages::{PackageOptions, Packages, UriOutcome};
use vfs::{Environment, Vfs};

/// How a file is expanded.
#[derive(Clone, Debug, Default)]
pub struct Options {
    args: Vec<(String, String)>,
    package_path: Vec<PathBuf>,
}

impl Options {
    /// No arguments; packages are searched in the source tree around the file and where the environment names them
    /// (`ROS_PACKAGE_PATH`, `AMENT_PREFIX_PATH`).
    pub fn new() -> Self {
        Self::default()
    }

    /// Give an argument of the robot, as `name:=value` does on the command line; later ones win.
    #[must_use]
    pub fn arg(mut self, name: impl Into<String>, value: impl Into<String>) -> Self {
        self.args.push((name.into(), value.into()));
        self
    }

    /// Search a folder for packages first.
    #[must_use]
    pub fn package_path(mut self, folder: impl Into<PathBuf>) -> Self {
        self.package_path.push(folder.into());
        self
    }
}

/// An expanded robot.
pub struct Robot {
    expansion: Expansion,
    written: Option<Written>,
    problems: Vec<Problem>,
    packages: Packages,
}

/// What went wrong, or may be wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Whether it is an error: there is no document then.
    pub is_error: bool,
    /// One line, lower case, with the name of the thing.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
    /// The text that is wrong; none when the root file could not be read.
    pub location: Option<Location>,
    /// The macro calls and includes that led there, innermost first.
    pub calls: Vec<Location>,
}

/// A place in a source file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// The file, absolute.
    pub path: PathBuf,
    /// The line, from 1.
    pub line: u32,
    /// The column, from 1, in characters.
    pub column: u32,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}:{}:{}",
            vfs::slashed(&self.path),
            self.line,
            self.column
        )
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(location) = &self.location {
            write!(f, "{location}: ")?;
        }
        write!(
            f,
            "{}: {}",
            if self.is_error { "error" } else { "warning" },
            self.message
        )
    }
}

/// Expand a xacro file; plain URDF comes out as it is. Relative paths are relative to the working directory.
pub fn expand(file: impl AsRef<Path>, options: &Options) -> Robot {
    let env = Environment::capture();
    let vfs = Arc::new(Vfs::of(&env, FILE_MB * 1_000_000));
    let explicit = options
        .package_path
        .iter()
        .map(|folder| env.cwd.join(folder))
        .collect();
    let found = PackageOptions {
        explicit,
        environment_first: true,
        ..PackageOptions::default()
    };
    let packages = Packages::new(vfs.clone(), &env, found);
    let request = Request {
        file: vfs::slashed(file.as_ref()),
        args: options.args.clone(),
        ..Request::default()
    };
    let expansion = expand::expand(
        Sources {
            vfs: &vfs,
            packages: &packages,
            env: &env,
        },
        &request,
    );
    let problems = problems(&expansion);
    let is_whole = !problems.iter().any(|problem| problem.is_error);
    let written = is_whole.then(|| expand::write_lined(&expansion.tree, &request.file));
    Robot {
        expansion,
        written,
        problems,
        packages,
    }
}

impl Robot {
    /// The URDF, with the banner that xacro writes; none when there were errors.
    pub fn text(&self) -> Option<&str> {
        self.written.as_ref().map(|written| written.text.as_str())
    }

    /// All errors and warnings, in the order they were met.
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }

    /// The files that the robot is made from, the root file first: watch them to reload it.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        self.expansion.files.iter().map(|file| &*file.source.path)
    }

    /// The source of a line of [`Robot::text`] (from 1): the tag that the element there was made from.
    pub fn source_of_line(&self, line: u32) -> Option<Location> {
        let lines = &self.written.as_ref()?.lines;
        let node = (*lines.get(line.checked_sub(1)? as usize)?)?;
        let origin: Origin = self.expansion.tree.get(node).origin;
        location(&self.expansion, self.expansion.place(origin)?)
    }

    /// The file that a URI in the robot means (`package://`, `model://`, `file://`, a path), as RViz and Gazebo resolve it;
    /// none when there is no such file.
    pub fn resolve(&self, uri: &str) -> Option<PathBuf> {
        let root = self.files().next()?;
        match self.packages.resolve_uri(uri, root).outcome {
            UriOutcome::Found(path) => Some(path),
            _ => None,
        }
    }
}

fn problems(expansion: &Expansion) -> Vec<Problem> {
    let unreadable = expansion.root_error.as_ref().map(|error| Problem {
        is_error: true,
        message: error.to_string(),
        help: None,
        location: None,
        calls: Vec::new(),
    });
    let found = expansion.problems.iter().map(|problem| Problem {
        is_error: problem.severity == expand::Severity::Error,
        message: problem.message.clone(),
        help: problem.help.clone(),
        location: location(expansion, problem.place),
        calls: problem
            .trace
            .iter()
            .filter_map(|step| location(expansion, step.place))
            .collect(),
    });
    unreadable.into_iter().chain(found).collect()
}

fn location(expansion: &Expansion, place: FileRange) -> Option<Location> {
    let source = &expansion.files.get(place.file)?.source;
    let at = source.document.line_col(place.range.start, Encoding::Utf32);
    Some(Location {
        path: source.path.to_path_buf(),
        line: at.line + 1,
        column: at.col + 1,
    })
}

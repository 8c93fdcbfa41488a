//! The command line of `check`, declared.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::args::consumer;
use rules::Severity;

#[derive(Args, Debug, Default)]
pub(super) struct CheckArgs {
    /// Files and folders [default: .], `-` for standard input, and arguments as name:=value
    #[arg(value_name = "PATH")]
    pub(super) paths: Vec<String>,
    /// Output format
    #[arg(long, alias = "output-format", value_enum, default_value_t)]
    pub(super) format: OutputFormat,
    /// Run only these rules (codes, code prefixes, names or ALL)
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    pub(super) select: Vec<String>,
    /// Also run these rules
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    pub(super) extend_select: Vec<String>,
    /// Do not run these rules
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    pub(super) ignore: Vec<String>,
    /// Enable the rules of a profile
    #[arg(long, value_name = "PROFILE", value_delimiter = ',', value_parser = PROFILES)]
    pub(super) profile: Vec<String>,
    /// Report what these programs reject, change or ignore: mujoco, drake, gazebo and others (see
    /// `xacro-lint consumers --list`)
    #[arg(long = "for", value_name = "CONSUMER", value_delimiter = ',', value_parser = consumer)]
    pub(super) consumers: Vec<String>,
    /// Treat the paths as changed files: check the robots in the current folder that use them, and print only
    /// findings that concern them
    #[arg(long, conflicts_with_all = ["stdin_filename", "write_baseline"])]
    pub(super) changed: bool,
    /// Search this folder for packages first; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
    /// Treat this file as a robot even if it looks like a macro library
    #[arg(long, value_name = "FILE")]
    pub(super) entry: Vec<PathBuf>,
    /// Use this configuration file instead of the nearest xacro-lint.toml
    #[arg(long, value_name = "FILE")]
    pub(super) config: Option<PathBuf>,
    /// Settings over those of the configuration file, as an editor has them below `xacro.`: a JSON object
    #[arg(long, value_name = "JSON")]
    pub(super) settings: Option<String>,
    /// Apply safe fixes and print the remaining findings
    #[arg(long)]
    pub(super) fix: bool,
    /// Also apply fixes that may change numbers or names (with --fix or --diff)
    #[arg(long)]
    pub(super) unsafe_fixes: bool,
    /// Print the changes --fix would make, without writing files
    #[arg(long)]
    pub(super) diff: bool,
    /// Report only findings that are not in this baseline file
    #[arg(long, value_name = "FILE", conflicts_with = "write_baseline")]
    pub(super) baseline: Option<PathBuf>,
    /// Write all findings to this baseline file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["fix", "diff", "show_files"])]
    pub(super) write_baseline: Option<PathBuf>,
    /// Exit with 1 if packages of a robot are not found, so that it cannot be checked in full
    #[arg(long)]
    pub(super) require_packages: bool,
    /// Exit with 1 if there are findings of this severity or worse
    #[arg(long, value_enum, value_name = "SEVERITY", default_value_t)]
    pub(super) fail_level: FailLevel,
    /// Exit with 0 even if there are findings
    #[arg(long)]
    pub(super) exit_zero: bool,
    /// Print findings of this severity and worse; `all` prints every finding at every location
    #[arg(long, value_enum, value_name = "SEVERITY")]
    pub(super) show: Option<Show>,
    /// Report every location separately, even if several have the same cause
    #[arg(long)]
    pub(super) no_group: bool,
    /// Print the number of findings per rule instead of the findings
    #[arg(long)]
    pub(super) statistics: bool,
    /// Check again when a file changes
    #[arg(long, conflicts_with_all = ["diff", "write_baseline", "show_files", "stdin_filename"])]
    pub(super) watch: bool,
    /// List the files that would be checked
    #[arg(long)]
    pub(super) show_files: bool,
    /// Use this file name for standard input
    #[arg(long, value_name = "NAME")]
    pub(super) stdin_filename: Option<PathBuf>,
}

impl CheckArgs {
    /// The arguments of a command line that has nothing but paths, as in a pre-commit hook: what a parser would
    /// give, without declaring a hundred options first. None where something else may be meant.
    pub(super) fn of_paths(paths: &[String]) -> Option<Self> {
        let plain = paths.iter().all(|path| !path.starts_with('-'));
        plain.then(|| Self {
            paths: paths.to_vec(),
            ..Self::default()
        })
    }
}

/// Profiles of rules.
pub(super) const PROFILES: [&str; 4] = ["ros-industrial", "mobile", "gazebo", "pedantic"];

/// Output formats of `check`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum OutputFormat {
    /// With source excerpts (default)
    #[default]
    Text,
    /// One line per finding
    Concise,
    /// A JSON array
    Json,
    /// SARIF 2.1.0, for code scanning
    Sarif,
    /// Annotations for GitHub Actions
    Github,
    /// Code quality report for GitLab
    Gitlab,
    /// Test results for CI servers
    Junit,
}

/// Severities that make `check` fail. An enum of its own for the default, and for the texts in `--help`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum FailLevel {
    /// Errors
    Error,
    /// Errors and warnings
    #[default]
    Warning,
    /// Everything except hints
    Info,
}

impl FailLevel {
    /// The least severity that makes `check` fail.
    pub(super) fn severity(self) -> Severity {
        match self {
            FailLevel::Error => Severity::Error,
            FailLevel::Warning => Severity::Warning,
            FailLevel::Info => Severity::Info,
        }
    }
}

/// Which findings are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Show {
    /// Conventions and portability
    Info,
    /// Unnecessary code too
    Hint,
    /// Everything, at every location
    All,
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::super::args::{Arguments, Command};
    use super::CheckArgs;

    #[test]
    fn paths_alone_need_no_parser() {
        for line in [
            "",
            "robot.urdf",
            ".",
            "a.xacro prefix:=left b.urdf",
            "help",
            "check",
        ] {
            let paths: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
            let all = ["xacro-lint", "check"]
                .into_iter()
                .map(str::to_owned)
                .chain(paths.clone());
            let Command::Check(parsed) = Arguments::try_parse_from(all).unwrap().command else {
                panic!("{line}: another command");
            };
            assert_eq!(
                format!("{:?}", CheckArgs::of_paths(&paths).unwrap()),
                format!("{parsed:?}")
            );
        }
        for line in ["-", "--", "a.xacro --fix", "--fix a.xacro", "-h"] {
            let paths: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
            assert!(CheckArgs::of_paths(&paths).is_none(), "{line}");
        }
    }
}

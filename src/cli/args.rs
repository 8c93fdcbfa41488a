//! The command line, declared.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

/// Check xacro and URDF robot descriptions.
#[derive(Debug, Parser)]
#[command(name = "xacro-lint", version, about, subcommand_required = true, arg_required_else_help = true)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Check files and folders: every robot in them, with every preset
    Check(CheckArgs),
    /// Fix what can be fixed: `check --fix`
    Fix(CheckArgs),
    /// Format files: indentation and the white space between attributes
    Format(FormatArgs),
    /// Expand a file exactly as xacro does (has xacro's options)
    #[command(disable_help_flag = true)]
    Expand {
        /// Options of xacro, the file, name:=value
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        args: Vec<String>,
    },
    /// Print the links of a robot as a tree, as `check_urdf` does
    Tree(TreeArgs),
    /// Draw a robot: a still picture, for documents and pull requests
    Render(RenderArgs),
    /// Show a robot in 3D in a browser, and follow its files
    #[cfg(feature = "preview")]
    Preview(PreviewArgs),
    /// Print the packages that can be found, and where
    Packages(PackagesArgs),
    /// Print the files that a robot is made from
    Deps(DepsArgs),
    /// Say what a rule is about
    Explain {
        /// Code or name of the rule
        rule: Option<String>,
    },
    /// Print the rules
    Rules(RulesArgs),
    /// Print the settings that hold for a file or folder, and which file sets them
    Config(ConfigArgs),
    /// Print a script that completes commands and options in a shell
    Completions {
        /// The shell
        #[arg(value_enum)]
        shell: Shell,
    },
}

#[derive(Args, Debug, Default)]
pub(super) struct RulesArgs {
    /// Only these rules (codes, beginnings of codes, names)
    #[arg(value_name = "RULE")]
    pub(super) rules: Vec<String>,
    /// Only rules of this category
    #[arg(long, value_parser = CATEGORIES)]
    pub(super) category: Option<String>,
    /// Only rules of this severity
    #[arg(long, value_enum)]
    pub(super) severity: Option<Level>,
    /// Only rules that run with this profile
    #[arg(long, value_parser = PROFILES)]
    pub(super) profile: Option<String>,
    /// Only rules that offer fixes
    #[arg(long)]
    pub(super) fixable: bool,
    /// Form of the list
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

/// Categories of rules.
const CATEGORIES: [&str; 12] = [
    "xml",
    "xacro",
    "structure",
    "joint",
    "frames",
    "inertia",
    "geometry",
    "conventions",
    "package",
    "control",
    "style",
    "linter",
];

/// Severities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Level {
    /// Some tool in common use rejects it, or it is physically impossible
    Error,
    /// Accepted, and almost surely not meant
    Warning,
    /// Convention or portability
    Info,
    /// Unnecessary
    Hint,
}

impl Level {
    /// Its name.
    pub(super) fn name(self) -> &'static str {
        match self {
            Level::Error => "error",
            Level::Warning => "warning",
            Level::Info => "info",
            Level::Hint => "hint",
        }
    }
}

#[derive(Args, Debug)]
pub(super) struct ConfigArgs {
    /// The file or folder
    #[arg(default_value = ".")]
    pub(super) path: PathBuf,
    /// Use this configuration file instead of the nearest xacro-lint.toml
    #[arg(long, value_name = "FILE")]
    pub(super) config: Option<PathBuf>,
    /// Print the JSON schema of the configuration file
    #[arg(long)]
    pub(super) schema: bool,
    /// Form of the settings
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

#[derive(Args, Debug, Default)]
pub(super) struct CheckArgs {
    /// Files and folders [default: .], `-` for standard input, and name:=value for their arguments
    #[arg(value_name = "PATH")]
    pub(super) paths: Vec<String>,
    /// Form of the result
    #[arg(long, alias = "output-format", value_enum, default_value_t)]
    pub(super) format: Format,
    /// Run these rules instead of the default ones (codes, beginnings of codes, names, ALL)
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    pub(super) select: Vec<String>,
    /// Run these rules in addition
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    pub(super) extend_select: Vec<String>,
    /// Do not run these rules
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    pub(super) ignore: Vec<String>,
    /// Switch on the rules of a profile
    #[arg(long, value_name = "PROFILE", value_delimiter = ',', value_parser = PROFILES)]
    pub(super) profile: Vec<String>,
    /// The paths are files that changed: check the robots below the folder you are in that read them, and print
    /// only what concerns them
    #[arg(long, conflicts_with_all = ["stdin_filename", "write_baseline"])]
    pub(super) changed: bool,
    /// Look for packages there first
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
    /// Check this file as a robot, whatever it looks like
    #[arg(long, value_name = "FILE")]
    pub(super) entry: Vec<PathBuf>,
    /// Use this configuration file instead of the nearest xacro-lint.toml
    #[arg(long, value_name = "FILE")]
    pub(super) config: Option<PathBuf>,
    /// Fix what can be fixed without changing the meaning, and print what is left
    #[arg(long)]
    pub(super) fix: bool,
    /// Fix also by fixes that may change numbers and names (with --fix or --diff)
    #[arg(long)]
    pub(super) unsafe_fixes: bool,
    /// Print what --fix would change, and change nothing
    #[arg(long)]
    pub(super) diff: bool,
    /// Report only what exceeds the findings in this file
    #[arg(long, value_name = "FILE", conflicts_with = "write_baseline")]
    pub(super) baseline: Option<PathBuf>,
    /// Write the findings to this file, for --baseline
    #[arg(long, value_name = "FILE", conflicts_with_all = ["fix", "diff", "show_files"])]
    pub(super) write_baseline: Option<PathBuf>,
    /// Exit with 1 for findings of this severity or worse
    #[arg(long, value_enum, value_name = "SEVERITY", default_value_t)]
    pub(super) fail_level: FailLevel,
    /// Exit with 0 whatever is found
    #[arg(long)]
    pub(super) exit_zero: bool,
    /// Print findings down to this severity; `all`: every finding at every place, with nothing left out
    #[arg(long, value_enum, value_name = "SEVERITY")]
    pub(super) show: Option<Show>,
    /// Report every place as a finding of its own, also where several places are one defect
    #[arg(long)]
    pub(super) no_group: bool,
    /// Print how often each rule fired instead of its findings
    #[arg(long)]
    pub(super) statistics: bool,
    /// Check again whenever a file changes
    #[arg(long, conflicts_with_all = ["diff", "write_baseline", "show_files", "stdin_filename"])]
    pub(super) watch: bool,
    /// Print the files that would be checked
    #[arg(long)]
    pub(super) show_files: bool,
    /// Read standard input as the content of this file
    #[arg(long, value_name = "NAME")]
    pub(super) stdin_filename: Option<PathBuf>,
}

impl CheckArgs {
    /// The arguments of a command line that has nothing but paths, as in a pre-commit hook: what a parser would
    /// give, without declaring a hundred options first. None where something else may be meant.
    pub(super) fn of_paths(paths: &[String]) -> Option<Self> {
        let plain = paths.iter().all(|path| !path.starts_with('-'));
        plain.then(|| Self { paths: paths.to_vec(), ..Self::default() })
    }
}

/// Profiles that rules can belong to.
const PROFILES: [&str; 4] = ["ros-industrial", "mobile", "gazebo", "pedantic"];

/// Forms of the result of `check`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// With the source text, for people
    #[default]
    Text,
    /// One line a finding
    Concise,
    /// An array of objects
    Json,
    /// SARIF 2.1.0, for code scanning
    Sarif,
    /// Annotations of GitHub Actions
    Github,
    /// Code quality report of GitLab
    Gitlab,
    /// Test results
    Junit,
}

/// Forms of lists.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Plain {
    /// For people
    #[default]
    Text,
    /// For programs
    Json,
}

/// Severities that make `check` fail.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum FailLevel {
    /// Errors
    Error,
    /// Errors and warnings
    #[default]
    Warning,
    /// Everything but hints
    Info,
}

/// What is not printed unless asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Show {
    /// Conventions and portability
    Info,
    /// Unnecessary things too
    Hint,
    /// Everything, however often it occurs
    All,
}

#[derive(Args, Debug)]
pub(super) struct FormatArgs {
    /// Files and folders, `-` for standard input
    #[arg(value_name = "PATH", default_value = ".")]
    pub(super) paths: Vec<PathBuf>,
    /// Print which files would change, change nothing, and exit with 1 when there are any
    #[arg(long)]
    pub(super) check: bool,
    /// Print what would change, change nothing, and exit with 1 when there is something
    #[arg(long, conflicts_with = "check")]
    pub(super) diff: bool,
}

#[derive(Args, Debug)]
pub(super) struct TreeArgs {
    /// The file, and name:=value for its arguments
    #[arg(value_name = "FILE", required = true)]
    pub(super) file: Vec<String>,
    /// Name the joints and their types
    #[arg(long)]
    pub(super) joints: bool,
    /// Form of the tree
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: TreeFormat,
    /// Look for packages there first
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
}

/// Forms of a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum TreeFormat {
    /// As `check_urdf` prints it
    #[default]
    Text,
    /// For Graphviz
    Dot,
    /// For programs
    Json,
    /// A picture
    Svg,
}

#[derive(Args, Debug)]
pub(super) struct RenderArgs {
    /// The file, and name:=value for its arguments
    #[arg(value_name = "FILE", required = true)]
    pub(super) file: Vec<String>,
    /// The picture: `.png` for shaded shapes, `.svg` for outlines, frames and names
    #[arg(short, long, value_name = "PICTURE")]
    pub(super) output: PathBuf,
    /// From where the robot is seen
    #[arg(long, value_enum, default_value_t)]
    pub(super) view: Viewpoint,
    /// Width and height, pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "800x600")]
    pub(super) size: String,
    /// Put a joint somewhere: radians, degrees as `90deg`, or metres; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) joint: Vec<String>,
    /// Draw collisions instead of visuals
    #[arg(long)]
    pub(super) collision: bool,
    /// Draw the frames of the links too, and shapes so that one sees through them
    #[arg(long)]
    pub(super) frames: bool,
    /// What is behind the robot: `white`, `black`, `transparent` or `#rrggbb`
    #[arg(long, value_name = "COLOR", default_value = "white")]
    pub(super) background: String,
    /// Draw the tree of links and joints, as `tree --format svg` does
    #[arg(long, conflicts_with_all = ["view", "size", "joint", "collision", "frames", "background"])]
    pub(super) tree: bool,
    /// Look for packages there first
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
}

/// Directions to look from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Viewpoint {
    /// From the front, the right and above
    #[default]
    Iso,
    /// From the front
    Front,
    /// From the right: the robot looks to the right
    Side,
    /// From above: the robot looks to the right
    Top,
}

#[cfg(feature = "preview")]
#[derive(Args, Debug)]
pub(super) struct PreviewArgs {
    /// The file, and name:=value for its arguments
    #[arg(value_name = "FILE", required = true)]
    pub(super) file: Vec<String>,
    /// Look for packages there first
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
}

#[derive(Args, Debug)]
pub(super) struct PackagesArgs {
    /// A file or folder that packages are looked for from
    #[arg(default_value = ".")]
    pub(super) from: PathBuf,
    /// Look for packages there first
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
    /// Form of the list
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

#[derive(Args, Debug)]
pub(super) struct DepsArgs {
    /// The file, and name:=value for its arguments
    #[arg(value_name = "FILE", required = true)]
    pub(super) file: Vec<String>,
    /// Look for packages there first
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
    /// Form of the list: files one a line, or everything the result depends on
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::{Arguments, CheckArgs, Command};

    #[test]
    fn paths_alone_need_no_parser() {
        for line in ["", "robot.urdf", ".", "a.xacro prefix:=left b.urdf", "help", "check"] {
            let paths: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
            let all = ["xacro-lint", "check"].into_iter().map(str::to_owned).chain(paths.clone());
            let Command::Check(parsed) = Arguments::try_parse_from(all).unwrap().command else {
                panic!("{line}: another command");
            };
            assert_eq!(format!("{:?}", CheckArgs::of_paths(&paths).unwrap()), format!("{parsed:?}"));
        }
        for line in ["-", "--", "a.xacro --fix", "--fix a.xacro", "-h"] {
            let paths: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
            assert!(CheckArgs::of_paths(&paths).is_none(), "{line}");
        }
    }
}

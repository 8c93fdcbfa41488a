//! The command line, declared.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use super::check_args::{CheckArgs, PROFILES};
use rules::consumers::Consumer;
use rules::{Category, Severity};

/// Linter, language server and expander for xacro and URDF robot descriptions
#[derive(Debug, Parser)]
#[command(
    name = "xacro-lint",
    version,
    subcommand_required = true,
    arg_required_else_help = true
)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Check files and folders: every robot in them, with every preset
    Check(CheckArgs),
    /// Apply safe fixes (same as `check --fix`)
    Fix(CheckArgs),
    /// Test the robots of `[[roots]]`: each combination of arguments, against what the configuration expects
    Test(TestArgs),
    /// Format files: indentation and whitespace between attributes
    Format(FormatArgs),
    /// Expand a file exactly as xacro does (accepts the options of xacro)
    #[command(disable_help_flag = true)]
    Expand {
        /// Options of xacro, the file and its arguments (name:=value)
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        args: Vec<String>,
    },
    /// Print the tree of links and joints (replaces `check_urdf` and `urdf_to_graphviz`)
    Tree(TreeArgs),
    /// Render a picture of a robot, for documents and pull requests
    Render(RenderArgs),
    /// Print what the programs that read URDF make of a robot
    Consumers(ConsumersArgs),
    /// Show a robot in 3D in a browser and update it when its files change
    #[cfg(feature = "preview")]
    Preview(PreviewArgs),
    /// List the calls of xacro in launch files and scripts, with their arguments
    Calls(CallsArgs),
    /// Print the packages that were found, with their folders
    Packages(PackagesArgs),
    /// Print the files a robot depends on
    Deps(DepsArgs),
    /// Explain a rule
    Explain {
        /// Code or name of the rule
        rule: Option<String>,
    },
    /// List all rules
    Rules(RulesArgs),
    /// Show the effective settings for a path and where each comes from
    Config(ConfigArgs),
    /// Run the language server: editors start it and talk to it on standard input and output
    #[cfg(feature = "lsp")]
    Server(ServerArgs),
    /// Answer coding assistants: tools of the Model Context Protocol that only read, on standard input and output
    Mcp(McpArgs),
    /// Print a shell completion script
    Completions {
        /// The shell
        #[arg(value_enum)]
        shell: Shell,
    },
}

#[derive(Args, Debug, Default)]
pub(super) struct RulesArgs {
    /// Only these rules (codes, code prefixes or names)
    #[arg(value_name = "RULE")]
    pub(super) rules: Vec<String>,
    /// Only rules in this category
    #[arg(long, value_parser = categories())]
    pub(super) category: Option<String>,
    /// Only rules of this severity
    #[arg(long, value_enum)]
    pub(super) severity: Option<SeverityArg>,
    /// Only rules that this profile enables
    #[arg(long, value_parser = PROFILES)]
    pub(super) profile: Option<String>,
    /// Only rules with fixes
    #[arg(long)]
    pub(super) fixable: bool,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

/// Names of the categories of rules.
fn categories() -> PossibleValuesParser {
    PossibleValuesParser::new(Category::ALL.map(Category::name))
}

/// A severity as it is given on the command line, with what `--help` says of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SeverityArg(pub(super) Severity);

impl ValueEnum for SeverityArg {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self(Severity::Error),
            Self(Severity::Warning),
            Self(Severity::Info),
            Self(Severity::Hint),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let help = match self.0 {
            Severity::Error => "A common tool rejects the robot, or it is physically impossible",
            Severity::Warning => "Accepted, but almost certainly a mistake",
            Severity::Info => "Convention or portability",
            Severity::Hint => "Unnecessary code",
        };
        Some(PossibleValue::new(self.0.name()).help(help))
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
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

/// Output formats of lists.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Plain {
    /// Readable text
    #[default]
    Text,
    /// JSON
    Json,
}

#[derive(Args, Debug)]
pub(super) struct FormatArgs {
    /// Files and folders, `-` for standard input
    #[arg(value_name = "PATH", default_value = ".")]
    pub(super) paths: Vec<PathBuf>,
    /// List files that are not formatted, without writing; exit with 1 if there are any
    #[arg(long)]
    pub(super) check: bool,
    /// Print the changes without writing files; exit with 1 if there are any
    #[arg(long, conflicts_with = "check")]
    pub(super) diff: bool,
}

#[derive(Args, Debug)]
pub(super) struct TestArgs {
    /// Files and folders whose configured roots are tested; default: the current folder
    #[arg(value_name = "PATH")]
    pub(super) paths: Vec<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: TestFormat,
    /// Run only tests whose names contain this text
    #[arg(long, value_name = "TEXT")]
    pub(super) filter: Option<String>,
    /// Write the files of `expands-to` that differ from the robots
    #[arg(long)]
    pub(super) update: bool,
    /// Use this configuration file instead of the nearest xacro-lint.toml
    #[arg(long, value_name = "FILE")]
    pub(super) config: Option<PathBuf>,
    /// Search this folder for packages first; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
}

/// Output formats of `test`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum TestFormat {
    /// One line per test, then the failures
    #[default]
    Text,
    /// A JSON array
    Json,
    /// Test results for CI servers
    Junit,
}

#[derive(Args, Debug)]
pub(super) struct TreeArgs {
    /// The file and its arguments (name:=value)
    #[arg(value_name = "FILE", required = true)]
    pub(super) file: Vec<String>,
    /// Show the joints and their types
    #[arg(long)]
    pub(super) joints: bool,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: TreeFormat,
    /// Search this folder for packages first; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
}

/// Output formats of a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum TreeFormat {
    /// The output of `check_urdf`
    #[default]
    Text,
    /// Graphviz
    Dot,
    /// JSON
    Json,
    /// A picture
    Svg,
}

#[derive(Args, Debug)]
pub(super) struct RenderArgs {
    /// The file and its arguments (name:=value)
    #[arg(value_name = "FILE", required = true)]
    pub(super) file: Vec<String>,
    /// Output file: `.png` for shaded shapes, `.svg` for outlines, frames and names
    #[arg(short, long, value_name = "PICTURE")]
    pub(super) output: PathBuf,
    /// Camera view
    #[arg(long, value_enum, default_value_t)]
    pub(super) view: Viewpoint,
    /// Width and height in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "800x600")]
    pub(super) size: String,
    /// Set a joint position: radians (`1.57`), degrees (`90deg`) or meters; repeatable
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) joint: Vec<String>,
    /// Draw collision geometry instead of visual geometry
    #[arg(long)]
    pub(super) collision: bool,
    /// Also draw link frames, and make shapes transparent
    #[arg(long)]
    pub(super) frames: bool,
    /// Background color: `white`, `black`, `transparent` or `#rrggbb`
    #[arg(long, value_name = "COLOR", default_value = "white")]
    pub(super) background: String,
    /// Draw the tree of links and joints (same as `tree --format svg`)
    #[arg(long, conflicts_with_all = ["view", "size", "joint", "collision", "frames", "background"])]
    pub(super) tree: bool,
    /// Search this folder for packages first; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
}

/// Camera views.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Viewpoint {
    /// From the front right, above
    #[default]
    Iso,
    /// From the front
    Front,
    /// From the right; the front of the robot is on the right
    Side,
    /// From above; the front of the robot is on the right
    Top,
}

#[cfg(feature = "preview")]
#[derive(Args, Debug)]
pub(super) struct PreviewArgs {
    /// The file and its arguments (name:=value)
    #[arg(value_name = "FILE", required = true)]
    pub(super) file: Vec<String>,
    /// Search this folder for packages first; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
}

#[cfg(feature = "lsp")]
#[derive(Args, Debug)]
pub(super) struct ServerArgs {
    /// Talk on standard input and output (the only way there is; editors pass it on)
    #[arg(long)]
    pub(super) stdio: bool,
    /// Print version
    #[arg(short = 'V', long)]
    pub(super) version: bool,
}

#[derive(Args, Debug)]
pub(super) struct McpArgs {
    /// The folder whose files may be read; no others are
    #[arg(value_name = "DIR", default_value = ".")]
    pub(super) folder: PathBuf,
    /// Search this folder for packages first, and allow reading it; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
}

#[derive(Args, Debug)]
pub(super) struct PackagesArgs {
    /// The file or folder to search from
    #[arg(default_value = ".")]
    pub(super) from: PathBuf,
    /// Search this folder for packages first; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

#[derive(Args, Debug)]
pub(super) struct CallsArgs {
    /// The folder to search, or the launch file or description whose calls are listed
    #[arg(default_value = ".")]
    pub(super) path: PathBuf,
    /// Search this folder for packages first; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

#[derive(Args, Debug)]
pub(super) struct ConsumersArgs {
    /// The file and its arguments (name:=value)
    #[arg(value_name = "FILE", required_unless_present = "list")]
    pub(super) file: Vec<String>,
    /// Only these programs
    #[arg(long = "for", value_name = "CONSUMER", value_delimiter = ',', value_parser = consumer)]
    pub(super) consumers: Vec<String>,
    /// Also print the constructs that all programs accept
    #[arg(long)]
    pub(super) all: bool,
    /// List the programs, with the versions that the table was measured with
    #[arg(long)]
    pub(super) list: bool,
    /// Search this folder for packages first; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

/// The name of a consumer, which may be given by one of its other names.
pub(super) fn consumer(name: &str) -> Result<String, String> {
    match Consumer::named(name) {
        Some(consumer) => Ok(consumer.name.to_owned()),
        None => Err(match Consumer::nearest(name) {
            Some(near) => format!("did you mean `{near}`?"),
            None => "run `xacro-lint consumers --list`".to_owned(),
        }),
    }
}

#[derive(Args, Debug)]
pub(super) struct DepsArgs {
    /// The file and its arguments (name:=value)
    #[arg(value_name = "FILE", required = true)]
    pub(super) file: Vec<String>,
    /// Search this folder for packages first; repeatable
    #[arg(long, value_name = "DIR")]
    pub(super) package_path: Vec<String>,
    /// List the files beside the robot as well: SRDF, controllers, settings of MoveIt; JSON always lists them
    #[arg(long)]
    pub(super) beside: bool,
    /// Output format: one file per line, or JSON with everything the robot depends on
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Plain,
}

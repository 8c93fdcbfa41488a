//! How robots are really called: launch files, scripts and jobs of build servers, read as text and never executed.
//!
//! Each format has a reader that gives a [`LaunchFile`]: commands in pieces, arguments that the file declares, files that it
//! includes. What a reader does not understand is opaque. [`calls`] resolves the pieces.

mod command;
mod element;
mod loads;
mod opened;
mod place;
mod python;
mod resolve;
mod shell;
mod spawners;
mod text;
mod transforms;
mod xml;

#[cfg(test)]
mod forms;
#[cfg(test)]
mod forms_of_files;
#[cfg(test)]
mod forms_of_loads;
#[cfg(test)]
mod forms_of_parameters;
#[cfg(test)]
mod forms_of_programs;

use std::path::{Path, PathBuf};

use base::TextRange;
use base::limits::LAUNCH_CALLS;

pub(crate) use loads::loads_in;
pub(crate) use opened::opened_in;
pub use resolve::{CallArgument, CommandWord, LaunchCall, Why, calls};
pub(crate) use resolve::{LaunchContext, calls_in, forget_defaults, included, values_given};
pub use spawners::SpawnedController;
pub(crate) use spawners::spawned_in;
use text::Text;
pub use transforms::StaticTransform;
pub(crate) use transforms::transforms_in;

/// What a launch file says.
#[derive(Clone, Debug, Default)]
pub struct LaunchFile {
    /// The file.
    pub path: PathBuf,
    /// Arguments that it declares, in order.
    pub declared: Vec<DeclaredArgument>,
    /// Defaults that are written where arguments are read.
    pub defaults: Vec<(String, Text)>,
    /// Commands that may call xacro.
    pub commands: Vec<LaunchCommand>,
    /// Words that may name descriptions which are read as they are.
    pub loads: Vec<LaunchCommand>,
    /// Words that may name other files which have to be there: parameters, settings of RViz, worlds, launch files.
    pub files: Vec<LaunchCommand>,
    /// The words of publishers of transforms that do not change.
    pub transforms: Vec<LaunchCommand>,
    /// The words of spawners of controllers.
    pub spawners: Vec<LaunchCommand>,
    /// Nodes that load the hardware of a robot themselves.
    pub control_nodes: Vec<LaunchCommand>,
    /// Launch files that it includes.
    pub includes: Vec<LaunchInclude>,
    /// Arguments that it sets while it runs.
    pub set: Vec<String>,
    /// Whether the files it includes see its arguments, as in ROS 2.
    pub shares: bool,
}

impl LaunchFile {
    fn of(path: &Path) -> Self {
        Self {
            path: path.to_owned(),
            shares: true,
            ..Self::default()
        }
    }

    /// The values that an argument may have: those of all its declarations; none where it may have any.
    pub(crate) fn choices_of(&self, name: &str) -> Option<Vec<String>> {
        let mut own = self
            .declared
            .iter()
            .filter(|declared| declared.name == name)
            .peekable();
        own.peek()?;
        let all: Option<Vec<_>> = own.map(|declared| declared.choices.clone()).collect();
        Some(all?.concat())
    }

    fn is_declared(&self, name: &str) -> bool {
        self.declared.iter().any(|declared| declared.name == name)
    }
}

/// An argument of a launch file.
#[derive(Clone, Debug)]
pub struct DeclaredArgument {
    /// Its name.
    pub name: String,
    /// Its default; none when whoever starts the file has to give it.
    pub default: Option<Text>,
    /// The values it may have.
    pub choices: Option<Vec<String>>,
    /// Where it is declared.
    pub range: TextRange,
    /// Whether its value cannot be given from outside.
    pub is_fixed: bool,
}

/// Something that may call xacro.
#[derive(Clone, Debug)]
pub struct LaunchCommand {
    /// Where it stands.
    pub range: TextRange,
    /// What is called.
    pub what: CommandForm,
    /// Arguments of the launch file that a condition around it reads: they need not have their defaults here.
    pub assumed: Vec<String>,
    /// Whether launch reads what it prints as YAML: a parameter of a node whose type is not given.
    pub is_read_as_yaml: bool,
}

impl LaunchCommand {
    fn at(range: TextRange, what: CommandForm, assumed: Vec<String>) -> Self {
        Self {
            range,
            what,
            assumed,
            is_read_as_yaml: false,
        }
    }

    /// Put it behind others, as long as there are not too many.
    fn add_to(self, others: &mut Vec<Self>) {
        if others.len() < LAUNCH_CALLS {
            others.push(self);
        }
    }
}

/// A command in one of its forms.
#[derive(Clone, Debug)]
pub enum CommandForm {
    /// One text, which is split as a shell does.
    Line(Text),
    /// A list of words, which is not split again.
    Words(Vec<Text>),
    /// A call of xacro from Python.
    Process {
        /// The description.
        file: Text,
        /// Its arguments.
        mappings: Vec<UnresolvedArgument>,
        /// Whether there may be further ones.
        open: bool,
    },
}

/// An argument of a robot that a program gives.
#[derive(Clone, Debug)]
pub struct UnresolvedArgument {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub range: Option<TextRange>,
    /// Its value, as far as the program spells it.
    pub value: Text,
}

/// Another launch file that is included.
#[derive(Clone, Debug)]
pub struct LaunchInclude {
    /// Its path, as far as the text spells it.
    pub file: Text,
    /// The arguments it is given.
    pub args: Vec<(String, Text)>,
    /// Whether it may be given others.
    pub open: bool,
    /// Where the include stands.
    pub range: TextRange,
    /// Arguments that a condition around it reads.
    pub assumed: Vec<String>,
}

/// Whether a text may hold a call of xacro, load a description as it is, or include a file that does.
pub(super) fn may_call(text: &str) -> bool {
    const WORDS: [&str; 4] = [
        "xacro",
        "IncludeLaunchDescription",
        "<include",
        "MoveItConfigsBuilder",
    ];
    const LOADS: [&str; 5] = ["textfile=", "cat ", "-file", "open(", ".read_text("];
    let has_any = |words: &[&str]| words.iter().any(|word| text.contains(word));
    has_any(&WORDS)
        || has_any(&[TRANSFORM_PUBLISHER, SPAWNER])
        || has_any(&LAUNCHES) && has_any(&opened::ENDINGS)
        || has_any(&LOADS) && has_any(&DESCRIPTIONS)
}

/// What the text of a launch file has.
const LAUNCHES: [&str; 2] = ["LaunchDescription", "<launch"];

/// Endings of the names of descriptions.
const DESCRIPTIONS: [&str; 3] = [".urdf", ".xacro", ".srdf"];

/// The program that publishes one transform.
const TRANSFORM_PUBLISHER: &str = "static_transform_publisher";

/// The program that has a controller manager start controllers.
const SPAWNER: &str = "spawner";

/// The program that loads the hardware of a robot and runs its controllers.
const CONTROL_NODE: &str = "ros2_control_node";

/// Read a file; none when nothing in it can call xacro or load a description.
pub fn read(path: &Path, text: &str) -> Option<LaunchFile> {
    if !may_call(text) {
        return None;
    }
    let name = path.file_name()?.to_str()?;
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    let file = match ending {
        "py" => python::read(path, text),
        "launch" | "xml" | "test" => xml::read(path, text),
        "sh" | "bash" => shell::script(path, text),
        "yaml" | "yml" => shell::embedded(path, text),
        _ => return None,
    };
    let commands = [
        &file.commands,
        &file.loads,
        &file.files,
        &file.transforms,
        &file.spawners,
        &file.control_nodes,
    ];
    let is_empty = commands.into_iter().all(Vec::is_empty) && file.includes.is_empty();
    (!is_empty).then_some(file)
}

//! What the sources of a package must hold for its build to succeed: the files and folders that rules of installation
//! name, one by one and under no condition.

use std::path::PathBuf;

use super::cmake::{CMakeFile, CMakeReader, KEYWORDS, in_tree};
use super::commands::{CMakeArgument, CMakeCommand};
use base::TextRange;

/// Words with which a rule goes on where a file is missing.
const LENIENT: [&str; 4] = [
    "OPTIONAL",
    "FILES_MATCHING",
    "CONFIGURATIONS",
    "EXCLUDE_FROM_ALL",
];

/// Commands that may make files.
const MAKERS: [&str; 4] = [
    "configure_file",
    "execute_process",
    "add_custom_command",
    "add_custom_target",
];

/// So many sources are looked for on the disk at each check, and compared with what the build makes.
const MOST: usize = 500;

/// What `file` only reads.
const READS: [&str; 4] = ["GLOB", "GLOB_RECURSE", "READ", "STRINGS"];

/// Something of the sources that a rule of installation names.
#[derive(Clone, Debug)]
pub struct RequiredSource {
    /// The file or folder.
    pub path: PathBuf,
    /// How the rule writes it, with its variables replaced.
    pub shown: String,
    /// Whether the rule is one for folders.
    pub is_folder: bool,
    /// The build file.
    pub file: PathBuf,
    /// The argument of the rule in that file.
    pub range: TextRange,
}

/// Remember what a command that is always run needs, what it may make, and whether it is for `ament_cmake`.
pub(super) fn note(reader: &mut CMakeReader<'_>, command: &CMakeCommand, here: CMakeFile<'_>) {
    let name = command.name.as_str();
    let first = command.arguments.first().map_or("", |first| &*first.text);
    reader.build.is_ament |= matches!(name, "ament_package" | "ament_auto_package")
        || name == "find_package" && first.starts_with("ament_cmake");
    if reader.conditions > 0 && matches!(name, "set" | "list") {
        // what a list holds is decided by the condition
        let names = command.arguments.iter().map(|one| one.text.clone());
        reader.uncertain.extend(names.take(2));
    } else if MAKERS.contains(&name) || name == "file" && !READS.contains(&first) {
        for argument in &command.arguments {
            let path = reader.replaced(&argument.text);
            let path = path.map(|path| in_tree(here.folder, &path));
            reader.build.made.extend(path);
        }
    } else if reader.conditions == 0 {
        let room = MOST.saturating_sub(reader.build.required.len());
        let found = required(reader, command, here).into_iter().take(room);
        reader.build.required.extend(found);
    }
}

/// A loop over a list that a condition decides is about what may be there.
pub(super) fn note_loop(reader: &mut CMakeReader<'_>, command: &CMakeCommand) {
    let Some((variable, list)) = command.arguments.split_first() else {
        return;
    };
    let is_uncertain = |name: &String| {
        let value = format!("${{{name}}}");
        list.iter()
            .any(|one| one.text == *name || one.text.contains(&value))
    };
    if reader.uncertain.iter().any(is_uncertain) {
        reader.uncertain.insert(variable.text.clone());
    }
}

fn required(
    reader: &CMakeReader<'_>,
    command: &CMakeCommand,
    here: CMakeFile<'_>,
) -> Vec<RequiredSource> {
    let arguments = &command.arguments[..];
    if arguments.iter().any(|a| LENIENT.contains(&&*a.text)) {
        return Vec::new();
    }
    let (listed, is_folder) = match (command.name.as_str(), arguments) {
        ("install", [kind, listed @ ..]) if kind.text == "DIRECTORY" => (listed, true),
        ("install", [kind, listed @ ..]) if matches!(&*kind.text, "FILES" | "PROGRAMS") => {
            (listed, false)
        }
        ("ament_auto_package", all) => {
            let at = all.iter().position(|a| a.text == "INSTALL_TO_SHARE");
            let behind = at.and_then(|at| all.get(at + 1..));
            (behind.unwrap_or_default(), true)
        }
        _ => return Vec::new(),
    };
    let ends = |argument: &&CMakeArgument| {
        let word = argument.text.as_str();
        !KEYWORDS.contains(&word) && word != "INSTALL_TO_PATH"
    };
    let mut found = Vec::new();
    let is_certain = |argument: &&CMakeArgument| {
        let mut names = reader.uncertain.iter();
        !names.any(|name| argument.text.contains(&format!("${{{name}}}")))
    };
    for argument in listed.iter().take_while(ends).filter(is_certain) {
        let text = reader.replaced(&argument.text).unwrap_or_default();
        for shown in text.split(';').filter(|shown| !shown.is_empty()) {
            found.push(RequiredSource {
                path: in_tree(here.folder, shown),
                shown: shown.to_owned(),
                is_folder,
                file: here.path.to_owned(),
                range: argument.range,
            });
        }
    }
    // what lies elsewhere may be there on the computer that builds
    found.retain(|source| source.path.starts_with(reader.top) && source.path != reader.top);
    found
}

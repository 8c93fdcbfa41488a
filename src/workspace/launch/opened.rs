//! Files other than descriptions that launch files name for what they start: parameters, settings of RViz, maps, worlds, other
//! launch files.

use super::LaunchFile;
use super::command::split;
use super::resolve::{CommandWord, LaunchCall, LaunchContext, Resolver};

/// Endings of such files.
pub(super) const ENDINGS: [&str; 9] = [
    ".yaml",
    ".yml",
    ".rviz",
    ".world",
    ".sdf",
    ".launch",
    ".launch.py",
    ".launch.xml",
    ".lua",
];

/// The files that a launch file names, as calls without arguments.
pub(crate) fn opened_in(file: &LaunchFile, context: &LaunchContext) -> Vec<LaunchCall> {
    let mut found: Vec<LaunchCall> = Vec::new();
    for command in &file.files {
        let resolver = Resolver::new(file, context, &command.assumed);
        let words = resolver.words(command).unwrap_or_default();
        // what is passed on may be a line of words: `-r -v 4 world.sdf`
        let words = words
            .iter()
            .flat_map(|word| split(word).unwrap_or_default());
        let files = words.filter(is_file);
        found.extend(files.map(|word| LaunchCall {
            caller: file.path.clone(),
            through: context.through.clone(),
            range: command.range,
            file: word,
            args: Vec::new(),
            open: false,
            is_read_as_yaml: false,
        }));
    }
    found
}

fn is_file(word: &CommandWord) -> bool {
    word.is_known() && ENDINGS.iter().any(|ending| word.shown().ends_with(ending))
}

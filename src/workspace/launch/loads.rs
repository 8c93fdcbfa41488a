//! Descriptions that launch files load as they are, without xacro: `textfile`, `cat`, `open(...)`, `-file` of a spawner.

use super::LaunchFile;
use super::command;
use super::resolve::{LaunchCall, LaunchContext, Resolver};

/// The descriptions that a file loads as they are, as calls without arguments.
pub(crate) fn loads_in(file: &LaunchFile, context: &LaunchContext) -> Vec<LaunchCall> {
    let mut found: Vec<LaunchCall> = Vec::new();
    for command in file.commands.iter().chain(&file.loads) {
        let resolver = Resolver::new(file, context, &command.assumed);
        let words = resolver.words(command).unwrap_or_default();
        // xacro reads its description itself
        if words.iter().any(command::is_xacro) {
            continue;
        }
        for description in command::descriptions_of(words) {
            found.push(LaunchCall {
                caller: file.path.clone(),
                through: context.through.clone(),
                range: command.range,
                file: description,
                args: Vec::new(),
                open: false,
                is_read_as_yaml: false,
            });
        }
    }
    found
}

//! Whether a launch file that takes any description has one as its default.

use super::read::{descriptions, is_description};

/// Whether the arguments that name the description of a call have the name of one as their default: other files are not meant
/// unless somebody says so. A name that is put together may be that of any file of a folder.
pub(super) fn has_default(name: &str, text: &str) -> bool {
    if !name.ends_with(".launch") && !name.ends_with(".xml") {
        return !descriptions(name, text).is_empty()
            && !["environ", "EnvironmentVariable"]
                .iter()
                .any(|word| text.contains(word));
    }
    let open = ["$(arg ", "$(var ", "env ", "$(eval "];
    let is_whole =
        |default: &str| is_description(default) && !open.iter().any(|part| default.contains(part));
    let taken = text.match_indices("xacro").filter_map(|(at, word)| {
        let after = text
            .get(at + word.len()..)?
            .trim_start_matches([' ', '\'', '"', ',', '.', 'p', 'y']);
        let argument = after
            .strip_prefix("$(arg ")
            .or_else(|| after.strip_prefix("$(var "))?;
        argument.split(')').next()
    });
    let attribute = |tag: &'_ str, key: &str| {
        let value = tag.split(key).nth(1)?.strip_prefix('=')?;
        let quote = value.chars().next()?;
        Some(value.get(1..)?.split(quote).next()?.to_owned())
    };
    let defaults = |argument: &str| -> Vec<String> {
        let tags = text
            .split("<arg")
            .skip(1)
            .filter_map(|rest| rest.split('>').next());
        tags.filter(|tag| attribute(tag, " name").as_deref() == Some(argument.trim()))
            .filter_map(|tag| attribute(tag, " default"))
            .collect()
    };
    taken.into_iter().all(|argument| {
        let defaults = defaults(argument);
        !defaults.is_empty() && defaults.iter().all(|default| is_whole(default))
    })
}

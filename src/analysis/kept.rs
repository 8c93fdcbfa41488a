//! Files that are kept and not used, as their paths say, and launch files that nobody runs.
use std::path::Path;

use super::session::Session;

/// Words in the name of a file or folder that say that it is kept and not used.
const KEPT: [&str; 19] = [
    "archive",
    "archived",
    "attic",
    "backup",
    "backups",
    "bak",
    "copy",
    "deprecated",
    "legacy",
    "obsolete",
    "old",
    "orig",
    "original",
    "outdated",
    "past",
    "temp",
    "testing",
    "tmp",
    "unused",
];

/// Whether the path of a file says that it is kept and not used.
pub(super) fn is_kept(session: &Session, file: &Path) -> bool {
    let words = words_of(session, file);
    // the second backup has a number
    let is_kept =
        |word: &String| KEPT.contains(&word.trim_end_matches(|c: char| c.is_ascii_digit()));
    words.iter().any(is_kept)
        || words.windows(2).any(|pair| pair == ["not", "used"])
        || is_second_download(file) && !session.callers.spell_out(file)
}

/// Whether nobody runs a launch file: it is kept, in a package that was put aside or is not built, or for ROS 1 in a package for
/// ROS 2.
pub(super) fn is_launch_left_over(session: &Session, file: &Path) -> bool {
    is_kept(session, file)
        || session.callers.is_launch_of_ros1(file)
        || session.callers.is_put_aside(file)
        || session.packages.is_never_built(file)
}

/// The words in the path of a file, from the top of the workspace. What file managers call copies are old.
pub(super) fn words_of(session: &Session, file: &Path) -> Vec<String> {
    let top = session.packages.sources_around(file);
    let inside = top
        .and_then(|top| file.strip_prefix(top).ok())
        .or_else(|| file.file_name().map(Path::new))
        .unwrap_or(Path::new(""));
    let copied = ["(copy", "(copia", "(otra copia", "(copie", "(kopie"];
    let path = inside.to_string_lossy().to_lowercase();
    words_in(
        &copied
            .iter()
            .fold(path, |path, copy| path.replace(copy, "(old")),
    )
}

/// Whether a file has the name that browsers give to what is downloaded once more: `arm (1).urdf`.
fn is_second_download(file: &Path) -> bool {
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let number = name
        .strip_suffix(')')
        .and_then(|name| name.rsplit_once(" ("));
    number.is_some_and(|(_, number)| number.parse::<u32>().is_ok())
}

/// The words of a text, in small letters.
pub(super) fn words_in(text: &str) -> Vec<String> {
    let text = text.to_lowercase();
    text.split(|c: char| !c.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .map(str::to_owned)
        .collect()
}

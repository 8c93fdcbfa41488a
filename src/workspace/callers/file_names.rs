//! What files are by their names.

use std::path::Path;

/// The name of a file; empty where there is none.
pub(super) fn name_of(file: &Path) -> &str {
    file.file_name()
        .and_then(|name| name.to_str())
        .unwrap_or_default()
}

/// Whether a file of that name may call a robot.
pub(super) fn may_call(name: &str) -> bool {
    const ENDINGS: [&str; 17] = [
        "launch", "xml", "py", "sh", "bash", "md", "rst", "txt", "yaml", "yml", "cmake", "test",
        "in", "cpp", "toml", "ipynb", "m",
    ];
    // these say what is installed, what depends on what, and what was; not what is used
    let tells_nothing =
        ["package.xml", "setup.py"].contains(&name) || name.to_lowercase().starts_with("changelog");
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    ENDINGS.contains(&ending) && !tells_nothing && !is_description(name)
}

/// Whether a file of that name is a description.
pub(super) fn is_description(name: &str) -> bool {
    let name = name.to_lowercase();
    let name = name.strip_suffix(".xml").unwrap_or(&name);
    name.ends_with(".xacro") || name.ends_with(".urdf")
}

/// Whether a file is there to be read, not run.
pub fn is_page(path: &Path) -> bool {
    let ending = path
        .extension()
        .and_then(|ending| ending.to_str())
        .unwrap_or("");
    ["md", "rst", "txt", "ipynb"].contains(&ending) && !path.ends_with("CMakeLists.txt")
}

/// Whether a file is a launch file, by its name or folder.
pub(super) fn is_launch(path: &Path) -> bool {
    let folder = path.parent().and_then(Path::file_name);
    name_of(path).contains("launch")
        || folder.is_some_and(|folder| folder == "launch") && !is_page(path)
}

/// Whether a file is a program, and no test of one.
pub(super) fn is_program(path: &Path) -> bool {
    has_ending_of_program(path) && !has_name_of_test(path)
}

/// Whether a file is a program that tests something.
pub(super) fn is_test(path: &Path) -> bool {
    has_ending_of_program(path) && has_name_of_test(path)
}

fn has_ending_of_program(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| ["py", "cpp", "sh", "m"].contains(&ending))
}

fn has_name_of_test(path: &Path) -> bool {
    let folder = path.parent().and_then(Path::file_name);
    let mut names = path.file_name().into_iter().chain(folder);
    names.any(|name| name.to_string_lossy().to_lowercase().starts_with("test"))
}

/// Whether a file may belong to a robot, by its name: SRDF, YAML, what MoveIt's setup assistant wrote down.
pub(super) fn is_beside(name: &str) -> bool {
    let name = name.to_lowercase();
    let endings = [".srdf", ".srdf.xacro", ".yaml", ".yml"];
    name == ".setup_assistant" || endings.iter().any(|ending| name.ends_with(ending))
}

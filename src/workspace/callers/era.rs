//! The xacro that launch files are for: older ones read a description in another way.

/// The xacro that a launch file is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Era {
    /// It runs `xacro.py` without `--inorder`: macros and properties were read before what uses them.
    Unordered,
    /// It runs `xacro.py`, which there is no more since ROS Noetic: tags without their prefix were taken.
    Old,
    /// It says `--inorder`, as nobody has to since ROS Melodic, where xacro took such tags and warned of them.
    Melodic,
    /// Nothing says that it is old.
    Any,
}

/// The xacro that a text is for.
pub(super) fn era(text: &str) -> Option<Era> {
    match (text.contains("xacro.py"), text.contains("--inorder")) {
        (true, false) => Some(Era::Unordered),
        (true, true) => Some(Era::Old),
        (false, true) => Some(Era::Melodic),
        // the name of a file does not run it
        (false, false) => {
            let mut names = text
                .match_indices("xacro")
                .map(|(at, _)| text.get(..at).unwrap_or(""));
            names
                .any(|before| !before.ends_with('.'))
                .then_some(Era::Any)
        }
    }
}

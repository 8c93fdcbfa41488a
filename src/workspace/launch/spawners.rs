//! Controllers that a launch file has started by `spawner` of controller_manager in ROS 2. In ROS 1 their parameters may be loaded
//! under any name.

use base::TextRange;

use super::LaunchFile;
use super::resolve::{CommandWord, LaunchContext, Resolver};

/// Options of the spawner that say what a controller is: nothing else needs to.
const SAY: [&str; 4] = ["-p", "--param-file", "-t", "--controller-type"];
/// Options without a value.
const SWITCHES: [&str; 6] = [
    "--load-only",
    "--stopped",
    "--inactive",
    "--unload-on-kill",
    "-u",
    "--activate-as-group",
];
/// What the words of ROS itself begin with.
const ROS_ARGS: &str = "--ros-args";

/// A controller that a launch file starts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpawnedController {
    /// Its name.
    pub name: String,
    /// Where it is written.
    pub range: TextRange,
}

/// The controllers that a file starts whenever it is started itself, and of which it does not say what they are.
pub(crate) fn spawned_in(file: &LaunchFile) -> Vec<SpawnedController> {
    let context = LaunchContext::default();
    let always = file.spawners.iter().filter(|one| one.assumed.is_empty());
    let read = |command| {
        let words = Resolver::new(file, &context, &[]).words(command)?;
        Some(spawned(&words))
    };
    always.filter_map(read).flatten().collect()
}

/// The names among the words of a spawner.
fn spawned(words: &[CommandWord]) -> Vec<SpawnedController> {
    let mut found = Vec::new();
    let mut words = words.iter();
    while let Some(word) = words.next() {
        let Some(text) = word.literal() else { continue };
        if SAY.contains(&&*text) {
            return Vec::new();
        } else if text == ROS_ARGS {
            break;
        } else if text.starts_with('-') {
            if !SWITCHES.contains(&&*text) && !text.contains('=') {
                words.next();
            }
        } else if let Some(range) = word.place().filter(|_| is_name(&text)) {
            found.push(SpawnedController { name: text, range });
        }
    }
    found
}

fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

#[cfg(test)]
mod tests {
    use super::super::read;
    use super::spawned_in;
    use std::path::Path;

    /// Check which controllers a launch file starts.
    fn check_spawned(name: &str, text: &str, expected: &[&str]) {
        let file = read(Path::new(name), text).unwrap_or_default();
        let names = spawned_in(&file).into_iter().map(|one| {
            assert_eq!(
                one.range.slice(text).trim_matches(['\'', '"']),
                one.name,
                "{text}"
            );
            one.name
        });
        assert_eq!(names.collect::<Vec<_>>(), expected, "{text}");
    }

    #[test]
    fn python() {
        let node = |words: &str| {
            format!("Node(package='controller_manager', executable='spawner', arguments=[{words}])")
        };
        for (text, expected) in [
            (node("'arm_controller'"), &["arm_controller"][..]),
            (
                node("'a_controller', 'b_controller', '-c', '/controller_manager', '--inactive'"),
                &["a_controller", "b_controller"],
            ),
            (
                node("'a_controller', '--controller-manager-timeout', '50'"),
                &["a_controller"],
            ),
            (node("'a_controller', '--param-file', config"), &[]),
            (
                node("'a_controller', '--ros-args', '-r', 'b_controller'"),
                &["a_controller"],
            ),
            (node("name, 'b_controller'"), &["b_controller"]),
            (node("'a_controller'], condition=IfCondition(own"), &[]),
        ] {
            check_spawned("/ws/a.launch.py", &text, expected);
        }
        let text = node("'a_controller'");
        let left_out = format!("a = {text}\nreturn LaunchDescription([\n  # a,\n])\n");
        check_spawned("/ws/a.launch.py", &left_out, &[]);
        let handed_on =
            format!("a = {text}\nb = RegisterEventHandler([a])\nreturn LaunchDescription([b])\n");
        check_spawned("/ws/a.launch.py", &handed_on, &["a_controller"]);
        let by_nothing = handed_on.replace("[b]", "[]");
        check_spawned("/ws/a.launch.py", &by_nothing, &[]);
    }

    #[test]
    fn xml() {
        let node = |program: &str, args: &str| {
            format!(
                "<launch><node pkg='controller_manager' {program}='spawner' args='{args}'/></launch>"
            )
        };
        let words =
            "--namespace=/arm a_controller b_controller -c /arm/controller_manager $(var other)";
        check_spawned_words(&node("exec", words), &["a_controller", "b_controller"]);
        check_spawned_words(&node("type", words), &[]);
    }

    /// The same of a launch file in XML, where the words of a node have one place together.
    fn check_spawned_words(text: &str, expected: &[&str]) {
        let file = read(Path::new("/ws/a.launch"), text).unwrap_or_default();
        let names = spawned_in(&file).into_iter().map(|one| one.name);
        assert_eq!(names.collect::<Vec<_>>(), expected, "{text}");
    }
}

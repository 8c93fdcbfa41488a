//! Names of arguments of robots in launch files: where they are spelled, and what they mean.
use std::path::{Path, PathBuf};

use super::argument_places::spelled_argument;
use super::declared::KnownArguments;
use super::session::Session;
use base::{Span, TextRange};
use workspace::RobotCall;
use workspace::launch::{self, LaunchCall};

/// An argument of robots where a launch file gives it.
#[derive(Clone, Debug)]
pub struct LaunchName {
    /// Its name.
    pub name: String,
    /// The robots that know it, in the order of the calls.
    pub robots: Vec<PathBuf>,
    /// Where the name stands.
    pub span: Span,
}

/// Where launch files spell the name of an argument of these robots.
pub fn launch_places(session: &Session, robots: &[PathBuf], name: &str) -> Vec<Span> {
    let mut found: Vec<Span> = Vec::new();
    for robot in robots {
        let calls = session.robot_calls(robot);
        for call in calls
            .iter()
            .filter(|call| call.target.as_ref() == Some(robot))
        {
            let argument = call.call.args.iter().find(|argument| argument.name == name);
            let span =
                argument.and_then(|argument| spelled_argument(&session.vfs, &call.call, argument));
            // files that are included from many others call the robot as often
            found.extend(span.filter(|span| !found.contains(span)));
        }
    }
    found.retain(|span| is_spelled(session, &session.vfs.path(span.file), span.range, name));
    found.sort_by_key(|span| (span.file, span.range.start));
    found
}

/// The robot beside these that a launch file gives the argument at a place, too, and that knows it.
pub fn gives_to_another(
    session: &Session,
    place: Span,
    robots: &[PathBuf],
    name: &str,
) -> Option<PathBuf> {
    let path = session.vfs.path(place.file);
    let others = session
        .robot_calls(&path)
        .into_iter()
        .filter(|call| call.call.caller == *path);
    let others = others.filter(|call| place_in(session, &call.call, name) == Some(place));
    let mut others = others.filter_map(|call| call.target);
    others.find(|other| {
        !robots.contains(other) && KnownArguments::of(session, other).names.contains(name)
    })
}

/// Where a call spells an argument.
fn place_in(session: &Session, call: &LaunchCall, name: &str) -> Option<Span> {
    let argument = call.args.iter().find(|argument| argument.name == name)?;
    spelled_argument(&session.vfs, call, argument)
}

/// The calls of a launch file with their arguments, wherever these stand.
pub(super) fn given_in(session: &Session, path: &Path) -> Vec<String> {
    let text = session.vfs.text(path).ok();
    let file = text.and_then(|file| launch::read(path, &file.text));
    let given = |call: &LaunchCall| {
        let args = call
            .args
            .iter()
            .map(|argument| format!(" {}:={}", argument.name, argument.value.shown()));
        call.file.shown() + &args.collect::<String>()
    };
    file.as_ref()
        .map(launch::calls)
        .unwrap_or_default()
        .iter()
        .map(given)
        .collect()
}

/// The argument whose name stands at an offset of a launch file.
pub fn launch_name_at(session: &Session, path: &Path, offset: u32) -> Option<LaunchName> {
    let mut found: Option<LaunchName> = None;
    for call in calls_at(session, path, offset) {
        for argument in &call.call.args {
            let span = spelled_argument(&session.vfs, &call.call, argument)
                .filter(|span| span.range.touches(offset));
            let (Some(span), Some(robot)) = (span, &call.target) else {
                continue;
            };
            let name = &argument.name;
            let found = found.get_or_insert_with(|| LaunchName {
                name: name.clone(),
                robots: Vec::new(),
                span,
            });
            if found.span == span && !found.robots.contains(robot) {
                found.robots.push(robot.clone());
            }
        }
    }
    let found = found.filter(|found| is_spelled(session, path, found.span.range, &found.name));
    found.map(|mut found| {
        found.robots.retain(|robot| {
            KnownArguments::of(session, robot)
                .names
                .contains(found.name.as_str())
        });
        found
    })
}

/// The calls of robots around an offset of a launch file.
pub(super) fn calls_at(session: &Session, path: &Path, offset: u32) -> Vec<RobotCall> {
    let mut calls = session.robot_calls(path);
    calls.retain(|call| call.call.caller == *path && call.call.range.touches(offset));
    calls
}

/// Whether a text in a launch file is the name of an argument: with another text there, the calls are the same but for it.
fn is_spelled(session: &Session, path: &Path, range: TextRange, name: &str) -> bool {
    let other = format!("{name}_other");
    let Ok(text) = session.vfs.text(path) else {
        return false;
    };
    let Some(before) = calls_in(path, &text.text) else {
        return false;
    };
    let edited = super::plan::apply(&text.text, &[(range, other.clone())]);
    let Some(after) = calls_in(path, &edited) else {
        return false;
    };
    is_renamed(&before, &after, name, &other)
}

/// What may be written at a place in a launch file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LaunchChoices {
    /// The word that it replaces.
    pub range: TextRange,
    /// Arguments of the robot, each with its default where it has one.
    pub arguments: Vec<(String, Option<String>)>,
    /// Whether `:=` belongs behind the name.
    pub with_sign: bool,
}

/// The arguments that may be given at an offset of a launch file: in the command of a call, or in its mappings.
pub fn launch_choices_at(session: &Session, path: &Path, offset: u32) -> Option<LaunchChoices> {
    let calls = calls_at(session, path, offset);
    let call = &calls.first()?.call;
    let text = session.vfs.text(path).ok()?;
    let before = TextRange::new(call.range.start, offset).slice(&text.text);
    let word = before.len() - before.trim_end_matches(is_word).len();
    let is_python = path.extension().is_some_and(|ending| ending == "py");
    let before = before.get(..before.len() - word)?;
    let with_sign = if is_python {
        starts_argument(before)?
    } else {
        before.ends_with(char::is_whitespace).then_some(true)?
    };
    let after = text.text.get(offset as usize..)?;
    let rest = after.len() - after.trim_start_matches(is_word).len();
    let has_sign = after
        .get(rest..)
        .is_some_and(|after| after.starts_with(":="));
    let mut arguments: Vec<(String, Option<String>)> = Vec::new();
    for robot in calls.iter().filter_map(|call| call.target.as_ref()) {
        for (name, default) in KnownArguments::of(session, robot).defaults() {
            if !arguments.iter().any(|(known, _)| *known == name) {
                arguments.push((name, default));
            }
        }
    }
    let range = TextRange::new(offset - word as u32, offset + rest as u32);
    Some(LaunchChoices {
        range,
        arguments,
        with_sign: with_sign && !has_sign,
    })
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether a text of a call in Python ends where the name of an argument may begin, and if so, whether `:=` belongs behind it:
/// behind a blank in a command, or as a key of mappings.
fn starts_argument(before: &str) -> Option<bool> {
    let quote = before
        .chars()
        .next_back()
        .filter(|c| matches!(c, '\'' | '"'));
    let mut open = None;
    for c in before.chars() {
        match open {
            None if matches!(c, '\'' | '"') => open = Some(c),
            Some(quote) if quote == c => open = None,
            _ => {}
        }
    }
    let is_inside = open.is_some();
    let Some(quote) = quote.filter(|_| is_inside) else {
        return (is_inside && before.ends_with(char::is_whitespace)).then_some(true);
    };
    let outside = before.strip_suffix(quote)?.trim_end();
    let is_key = outside.ends_with(['{', ','])
        && outside
            .rsplit_once('{')
            .is_some_and(|(_, rest)| !rest.contains('}'));
    if is_key && outside.contains("mappings") {
        return Some(false);
    }
    // a blank of its own stands in front: `' ', 'name:=', value`
    let is_blank = |text: &str| text.ends_with(" '") || text.ends_with(" \"");
    outside
        .strip_suffix(',')
        .is_some_and(is_blank)
        .then_some(true)
}

fn calls_in(path: &Path, text: &str) -> Option<Vec<LaunchCall>> {
    Some(launch::calls(&launch::read(path, text)?))
}

/// Whether calls are the same but for arguments that have another name, of which there are some.
fn is_renamed(before: &[LaunchCall], after: &[LaunchCall], name: &str, other: &str) -> bool {
    let is_same = |(a, b): (&LaunchCall, &LaunchCall)| {
        a.file.shown() == b.file.shown() && a.args.len() == b.args.len()
    };
    if before.len() != after.len() || !before.iter().zip(after).all(is_same) {
        return false;
    }
    let old = before.iter().flat_map(|call| &call.args);
    let new = after.iter().flat_map(|call| &call.args);
    let mut changes = 0;
    for (a, b) in old.zip(new) {
        let is_change = a.name == name && b.name == other;
        if !(is_change || a.name == b.name) || a.value.shown() != b.value.shown() {
            return false;
        }
        changes += usize::from(is_change);
    }
    changes > 0
}

#[cfg(test)]
mod tests {
    use super::super::walk::is_launch;
    use super::starts_argument;
    use std::path::Path;

    #[test]
    fn names_of_launch_files() {
        for name in [
            "a.launch",
            "a.launch.py",
            "a.launch.xml",
            "a.launch.yaml",
            "start.sh",
            "nodes.py",
        ] {
            assert!(is_launch(Path::new(name)), "{name}");
        }
        for name in ["a.xacro", "a.xml", "a.yaml", "launch", "package.xml"] {
            assert!(!is_launch(Path::new(name)), "{name}");
        }
    }

    #[test]
    fn where_arguments_begin() {
        for (before, expected) in [
            ("Command(['xacro ', path, ' ", Some(true)),
            ("Command(['xacro ', path, ' side:=left ", Some(true)),
            ("Command([\"xacro\", \" \", path, \" \", \"", Some(true)),
            ("Command(['xacro ', path, ' side:=', '", None),
            ("Command(['xacro ', path, ", None),
            ("Command(['xacro ', LaunchConfiguration('", None),
            ("xacro.process_file(path, mappings={'", Some(false)),
            (
                "xacro.process_file(path, mappings={'side': 'left', '",
                Some(false),
            ),
            ("xacro.process_file(path, mappings={'side': '", None),
            ("xacro.process_file('", None),
        ] {
            assert_eq!(starts_argument(before), expected, "{before}");
        }
    }
}

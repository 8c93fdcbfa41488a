//! Robots that cannot be passed on where they are launched, because their text is read as YAML: as a parameter without a type in a
//! launch file, and by gazebo_ros2_control, which gives it to its controller manager.
//!
//! Source: `evaluate_parameters.py` of launch_ros; `gazebo_ros2_control_plugin.cpp` on the branches `humble` and `iron`.
use std::path::Path;

use super::kept::is_launch_left_over;
use super::session::Session;
use base::{FileId, Span, TextRange};
use expand::{Expansion, MapEntry, MapKind, Origin, Written, XId, write_mapped};
use rules::{Edit, Finding, YamlReader, description_read_as_yaml};
use workspace::RobotCall;
use yaml::YamlKind;

/// The import that a typed parameter needs.
const IMPORT: &str = "from launch_ros.parameter_descriptions import ParameterValue\n";

/// The plugin that passes the robot on as an argument.
const PLUGIN: &str = "libgazebo_ros2_control.so";

/// What stops YAML in a robot that something reads as such.
pub(super) fn read_as_yaml(
    session: &Session,
    file: &Path,
    expansion: &Expansion,
) -> Option<Finding> {
    if !expansion.whole {
        return None;
    }
    let reader = launch_file(session, file).or_else(|| plugin(session, file, expansion))?;
    if !may_stop(expansion) {
        return None;
    }
    let name = expansion.files.first().map_or("", |file| &file.name);
    let written = write_mapped(&expansion.tree, name);
    let (at, sign) = if reader.is_certain {
        stop(&written.text)?
    } else {
        // the library that reads it there takes tabs
        stop(&written.text.replace('\t', " "))?
    };
    let (origin, part) = source(&written, at)?;
    Some(description_read_as_yaml(
        span_of(expansion, origin)?,
        sign,
        part,
        reader,
    ))
}

fn span_of(expansion: &Expansion, origin: Origin) -> Option<Span> {
    let place = expansion.place(origin)?;
    Some(Span {
        file: expansion.files.get(place.file)?.source.id,
        range: place.range,
    })
}

/// The plugin that reads a robot as YAML, unless what launches the robot takes its comments out.
fn plugin(session: &Session, file: &Path, expansion: &Expansion) -> Option<YamlReader> {
    let tree = &expansion.tree;
    let blocks = tree.elements(tree.root()?);
    let mut nodes = blocks
        .filter(|&id| tree.get(id).text == "gazebo")
        .flat_map(|id| tree.elements(id));
    let library = nodes.find_map(|id| {
        let library = tree.attr(id, "filename")?;
        (library.value == PLUGIN && tree.get(id).text == "plugin").then_some(library)
    })?;
    // what Foxy and Galactic call active, and their program that starts controllers
    let is_older = ["--set-state start", "'start'", "\"start\"", "spawner.py"];
    let mut leave_it = ["<!--"].into_iter().chain(is_older);
    if leave_it.any(|text| session.callers.quote(file, text))
        || session.packages.is_before_humble(file)
    {
        return None;
    }
    Some(YamlReader {
        name: "gazebo_ros2_control of Humble".to_owned(),
        at: span_of(expansion, library.origin)?,
        what: "the plugin is loaded here",
        is_certain: false,
        help: "write it without a space after it, or remove the comments in the launch file"
            .to_owned(),
        edits: Vec::new(),
    })
}

/// Whether some text of the robot has what a plain scalar of YAML cannot hold: most have none of it.
fn may_stop(expansion: &Expansion) -> bool {
    let tree = &expansion.tree;
    tree.below(XId::DOCUMENT).any(|id| {
        let node = tree.get(id);
        let mut attributes = node.attrs.iter();
        has_sign(&node.text) || attributes.any(|attribute| has_sign(&attribute.value))
    })
}

/// Whether a text has a colon in front of blank space or its end, a `#` behind blank space or at its start, or something that no
/// plain scalar may hold.
fn has_sign(text: &str) -> bool {
    let mut before = ' ';
    for c in text.chars() {
        let is_odd = matches!(c, '\t' | '\u{85}' | '\u{2028}' | '\u{2029}' | '\u{feff}')
            || c.is_control() && c != '\n';
        if is_odd || before == ':' && c.is_whitespace() || c == '#' && before.is_whitespace() {
            return true;
        }
        before = c;
    }
    before == ':'
}

/// Where YAML stops in a text, and what stops it.
fn stop(text: &str) -> Option<(usize, &'static str)> {
    let error = match yaml::load(text, "") {
        Err(error) => error,
        Ok(value) => return (!matches!(value.kind, YamlKind::Str(_))).then_some((0, "a `:`")),
    };
    let at = error.range.start as usize;
    let rest = text.get(at..)?;
    if rest.starts_with(':') {
        return Some((at, "a `:`"));
    }
    if rest.starts_with('\t') {
        return Some((at, "a tab"));
    }
    // what stands behind a comment of YAML is a second text
    let before = text.get(..at)?;
    let comment = before.rmatch_indices('#').map(|(at, _)| at).find(|&at| {
        before
            .get(..at)
            .is_some_and(|text| text.ends_with([' ', '\n']))
    });
    Some(comment.map_or((at, "this character"), |at| (at, "a `#`")))
}

/// The text of the source that a byte of the printed robot came from, and what it is part of.
fn source(written: &Written, at: usize) -> Option<(Origin, &'static str)> {
    let holds = |entry: &&MapEntry| (entry.out.start..entry.out.end).contains(&(at as u32));
    let entry = written.map.iter().rfind(holds)?;
    let part = match entry.kind {
        MapKind::Comment => "comment",
        MapKind::Text => "text",
        MapKind::Attribute | MapKind::Piece => "value",
        MapKind::Element | MapKind::StartTag => "element",
    };
    let origin = entry.origin;
    let is_verbatim = entry.out.end - entry.out.start == origin.range.end - origin.range.start;
    let start = origin.range.start + (at as u32 - entry.out.start);
    let range = if is_verbatim {
        TextRange::new(start, start + 1)
    } else {
        origin.range
    };
    Some((Origin { range, ..origin }, part))
}

/// A launch file that passes a robot to a node as a parameter without a type.
fn launch_file(session: &Session, file: &Path) -> Option<YamlReader> {
    let calls = session.callers.calls(file);
    let is_untyped = |call: &&RobotCall| {
        call.call.is_read_as_yaml
            && call.target.as_deref() == Some(file)
            && !is_launch_left_over(session, &call.call.caller)
    };
    let call = &calls.iter().find(is_untyped)?.call;
    let file = session.vfs.file_id(&call.caller);
    let name = call.caller.file_name()?.to_string_lossy();
    let is_python = name.ends_with(".py");
    let typed = if is_python {
        "`ParameterValue(Command([...]), value_type=str)`"
    } else {
        "`type=\"str\"` in the parameter"
    };
    let text = session.vfs.text(&call.caller).ok()?;
    let edits = if is_python {
        typed_in_python(file, call.range, &text.text)
    } else {
        Vec::new()
    };
    Some(YamlReader {
        name: format!("`{name}`"),
        at: Span {
            file,
            range: call.range,
        },
        what: "passed as a parameter here",
        is_certain: true,
        help: format!("write {typed} in `{name}`"),
        edits,
    })
}

/// What wraps a command in a parameter with a type.
fn typed_in_python(file: FileId, range: TextRange, text: &str) -> Vec<Edit> {
    if !range.slice(text).starts_with("Command(") {
        return Vec::new();
    }
    let insert = |at: u32, content: &str| Edit {
        span: Span {
            file,
            range: TextRange::new(at, at),
        },
        content: content.to_owned(),
    };
    let mut edits = vec![
        insert(range.start, "ParameterValue("),
        insert(range.end, ", value_type=str)"),
    ];
    if !text.contains("ParameterValue") {
        edits.insert(0, insert(import(text), IMPORT));
    }
    edits
}

/// Where another import of launch stands.
fn import(text: &str) -> u32 {
    let start_of = |words: &str| {
        let mut at = 0;
        let mut lines = text.split_inclusive('\n').map(|line| {
            at += line.len();
            (at - line.len(), line)
        });
        lines.find(|(_, line)| line.starts_with(words))
    };
    let found = start_of("from launch_ros").or_else(|| start_of("from launch"));
    found.map_or(0, |(at, _)| at as u32)
}

//! Robots that launch files cannot pass to a node: as a parameter without a type, the text of the robot is read as YAML.
use std::path::Path;

use super::session::Session;
use base::{Span, TextRange};
use expand::{Expansion, MapEntry, MapKind, Origin, Written, XId, write_mapped};
use rules::{Edit, Finding, UntypedParameter, description_read_as_yaml};
use workspace::RobotCall;
use yaml::YamlKind;

/// The import that a typed parameter needs.
const IMPORT: &str = "from launch_ros.parameter_descriptions import ParameterValue\n";

/// What stops YAML in a robot that a launch file passes without a type.
pub(super) fn read_as_yaml(
    session: &Session,
    file: &Path,
    expansion: &Expansion,
) -> Option<Finding> {
    if !expansion.whole || !may_stop(expansion) {
        return None;
    }
    let calls = session.callers.calls(file);
    let call = calls.iter().find(|call| {
        call.call.is_read_as_yaml
            && call.target.as_deref() == Some(file)
            && !session.is_launch_left_over(&call.call.caller)
    })?;
    let name = expansion.files.first().map_or("", |file| &file.name);
    let written = write_mapped(&expansion.tree, name);
    let (at, sign) = stop(&written.text)?;
    let (origin, part) = source(&written, at)?;
    let place = expansion.place(origin)?;
    let span = Span {
        file: expansion.files.get(place.file)?.source.id,
        range: place.range,
    };
    let parameter = parameter(session, call)?;
    Some(description_read_as_yaml(span, sign, part, parameter))
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

/// A call whose result is read as YAML, with what gives its parameter a type.
fn parameter(session: &Session, call: &RobotCall) -> Option<UntypedParameter> {
    let caller = &call.call.caller;
    let file = session.vfs.file_id(caller);
    let text = session.vfs.text(caller).ok()?;
    let range = call.call.range;
    let insert = |at: u32, content: &str| Edit {
        span: Span {
            file,
            range: TextRange::new(at, at),
        },
        content: content.to_owned(),
    };
    let is_python = caller.extension().is_some_and(|ending| ending == "py");
    let mut edits = Vec::new();
    if is_python && range.slice(&text.text).starts_with("Command(") {
        if !text.text.contains("ParameterValue") {
            edits.push(insert(import(&text.text), IMPORT));
        }
        edits.push(insert(range.start, "ParameterValue("));
        edits.push(insert(range.end, ", value_type=str)"));
    }
    let typed = if is_python {
        "`ParameterValue(Command([...]), value_type=str)`"
    } else {
        "`type=\"str\"` in the parameter"
    };
    Some(UntypedParameter {
        file: caller.file_name()?.to_string_lossy().into_owned(),
        call: Span { file, range },
        typed,
        edits,
    })
}

/// Where another import of launch stands.
fn import(text: &str) -> u32 {
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if line.starts_with("from launch") || line.starts_with("import launch") {
            return at;
        }
        at += line.len() as u32;
    }
    0
}

//! What a value was meant to be that is no number: signs of a word processor, commas, expressions without their brackets.
use super::super::context::{DocumentCx, is_plain_urdf};
use super::super::schema::ElementSpec;
use super::walk;
use expand::{BindingInfo, BindingKind, XId};
use expr::is_identifier;
use model::{AttrValue, is_decimal};

/// What a value was meant to be.
pub(super) struct MeantValue {
    /// What to know about it.
    pub help: &'static str,
    /// The value to write.
    pub value: String,
}

/// Of an attribute that holds so many numbers; none when it does, or when it cannot be told.
pub(super) fn of_numbers(
    cx: &DocumentCx<'_>,
    text: &AttrValue,
    count: usize,
) -> Option<MeantValue> {
    let value = text.value.as_str();
    if holds_numbers(value, count) {
        return None;
    }
    let plain = value.replace(['\u{2212}', '\u{2013}'], "-");
    if plain != value && holds_numbers(&plain, count) {
        return Some(MeantValue {
            help: "write an ASCII minus sign `-`",
            value: plain,
        });
    }
    let spaced = value
        .replace([',', ';'], " ")
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    if count > 1 && spaced != value && holds_numbers(&spaced, count) {
        return Some(MeantValue {
            help: "separate the numbers with spaces, not commas",
            value: spaced,
        });
    }
    let is_xacro = cx
        .expansion
        .files
        .first()
        .is_some_and(|file| !is_plain_urdf(&file.source.path));
    let bracketed = bracketed(cx, value)?;
    (bracketed != value && text.is_literal() && is_xacro).then_some(MeantValue {
        help: "write the expression in `${...}`",
        value: bracketed,
    })
}

fn holds_numbers(value: &str, count: usize) -> bool {
    value.split_whitespace().count() == count && value.split_whitespace().all(is_decimal)
}

/// The words of a value with `${...}` around those that are expressions of known names.
fn bracketed(cx: &DocumentCx<'_>, value: &str) -> Option<String> {
    let words = value.split_whitespace().map(|word| {
        if is_decimal(word) {
            Some(word.to_owned())
        } else {
            expression(cx, word).map(|code| format!("${{{code}}}"))
        }
    });
    Some(words.collect::<Option<Vec<String>>>()?.join(" "))
}

/// `{width}`, `$width` and `pi/2` as the expression in it.
fn expression<'w>(cx: &DocumentCx<'_>, word: &'w str) -> Option<&'w str> {
    let inner = word
        .strip_prefix('{')
        .and_then(|rest| rest.strip_suffix('}'));
    let code = inner.or_else(|| word.strip_prefix('$')).unwrap_or(word);
    let mut names = code
        .split(|c: char| !c.is_alphanumeric() && c != '_')
        .filter(|name| is_identifier(name))
        .peekable();
    let is_code = names.peek().is_some() && names.all(|name| is_known(cx, name));
    (is_code && expr::parse(code).errors.is_empty()).then_some(code)
}

/// `{width}` and `$width` as `${width}`, in the text of a robot that speaks xacro.
pub(super) fn of_word(cx: &DocumentCx<'_>, word: &str) -> Option<String> {
    let is_xacro = cx
        .expansion
        .files
        .first()
        .is_some_and(|file| !is_plain_urdf(&file.source.path));
    let code = expression(cx, word).filter(|&code| is_xacro && code != word)?;
    Some(format!("${{{code}}}"))
}

/// Names of attributes that other formats or other elements use: the element, the name, and what URDF calls it.
const OTHER_NAMES: &[(&str, &[&str], &str)] = &[
    ("limit", &["min", "minimum", "low", "lower_limit"], "lower"),
    ("limit", &["max", "maximum", "high", "upper_limit"], "upper"),
    ("limit", &["force", "torque", "max_effort"], "effort"),
    ("limit", &["speed", "vel", "max_velocity"], "velocity"),
    ("origin", &["position", "pos", "translation"], "xyz"),
    ("origin", &["rotation", "orientation", "euler"], "rpy"),
    ("axis", &["rpy", "direction"], "xyz"),
    ("mesh", &["file", "path", "uri", "url", "src"], "filename"),
    (
        "texture",
        &["file", "path", "uri", "url", "src"],
        "filename",
    ),
    ("plugin", &["file", "path"], "filename"),
    ("parent", &["name"], "link"),
    ("child", &["name"], "link"),
    ("cylinder", &["height"], "length"),
    ("box", &["dimensions", "dim", "extents"], "size"),
    ("mesh", &["scaling"], "scale"),
];

/// The attribute that is meant by the name of an unknown one, among those that the element could have and does not, and
/// whether that is sure.
pub(super) fn of_attribute<'a>(
    element: &str,
    name: &str,
    absent: impl Iterator<Item = &'a str> + Clone,
) -> Option<(&'a str, bool)> {
    let other = OTHER_NAMES
        .iter()
        .find(|(of, names, _)| *of == element && names.contains(&name));
    let other = other.and_then(|(_, _, meant)| absent.clone().find(|absent| absent == meant));
    other
        .map(|meant| (meant, false))
        .or_else(|| walk::meant(name, absent))
}

/// The attributes that are meant by unknown ones of an element, which `unknown-attribute` reports.
pub(in super::super) fn attributes(
    cx: &DocumentCx<'_>,
    id: XId,
    spec: &ElementSpec,
) -> Vec<&'static str> {
    const MOST: usize = 50;
    let attrs = &cx.expansion.tree.get(id).attrs;
    let unknown = attrs
        .iter()
        .filter(|attr| spec.attribute(&attr.name).is_none())
        .take(MOST);
    let absent = walk::absent(cx, id, spec);
    unknown
        .filter_map(|attr| Some(of_attribute(spec.name, &attr.name, absent.iter().copied())?.0))
        .collect()
}

/// The expression that was meant by a word that is the name of a property.
pub(super) fn name_of_property(cx: &DocumentCx<'_>, word: &str) -> Option<String> {
    let is_property =
        |binding: &BindingInfo| binding.name == word && binding.kind == BindingKind::Property;
    let is_known = is_identifier(word) && cx.expansion.index.bindings.iter().any(is_property);
    is_known.then(|| format!("${{{word}}}"))
}

/// Whether an expression can name it.
fn is_known(cx: &DocumentCx<'_>, name: &str) -> bool {
    name == "pi"
        || cx
            .expansion
            .index
            .bindings
            .iter()
            .any(|binding| binding.name == name)
}

/// A name with `${...}` where `{...}`, `#{...}` or `$[...]` holds a name of the expansion: `{prefix}tcp` as `${prefix}tcp`.
pub(in super::super) fn with_dollars(cx: &DocumentCx<'_>, name: &str) -> Option<String> {
    let mut out = String::new();
    let mut rest = name;
    while let Some(start) = rest.find(['{', '[']) {
        let (before, behind) = rest.split_at(start);
        let end = if behind.starts_with('{') { '}' } else { ']' };
        let (code, after) = behind.get(1..)?.split_once(end)?;
        if !is_identifier(code) || !is_known(cx, code) {
            return None;
        }
        out.push_str(&format!(
            "{}${{{code}}}",
            before.trim_end_matches(['#', '$'])
        ));
        rest = after;
    }
    out.push_str(rest);
    (out != name).then_some(out)
}

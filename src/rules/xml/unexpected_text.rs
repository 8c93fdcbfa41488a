//! Text where URDF has elements only.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::invalid_number::is_reported;
use super::seen::CheckedElement;
use super::walk;
use base::TextRange;
use expand::{Origin, XId, XKind};

pub(in super::super) static RULE: Rule = Rule {
    code: "XML013",
    name: "unexpected-text",
    category: Category::Xml,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("unexpected-text"),
    check: Check::Element(check),
};

/// Where text is nobody's.
const PLACES: [&str; 7] = [
    "robot",
    "link",
    "joint",
    "visual",
    "collision",
    "geometry",
    "inertial",
];

fn check(
    cx: &DocumentCx<'_>,
    &CheckedElement { id, known, .. }: &CheckedElement,
    out: &mut Sink<'_>,
) {
    let tree = &cx.expansion.tree;
    if known.is_none_or(|spec| !PLACES.contains(&spec.name)) || !tree.may_have_text(id) {
        return;
    }
    for text in tree.children(id) {
        let node = tree.get(text);
        let is_text = matches!(node.kind, XKind::Text | XKind::CData);
        if is_text && !node.text.trim().is_empty() && !is_reported(cx, node.origin) {
            report(cx, id, text, out);
        }
    }
}

fn report(cx: &DocumentCx<'_>, parent: XId, text: XId, out: &mut Sink<'_>) {
    let node = cx.expansion.tree.get(text);
    let shown: String = node.text.split_whitespace().collect::<Vec<_>>().join(" ");
    let shown = match shown.char_indices().nth(30) {
        Some((end, _)) => format!("{}...", shown.get(..end).unwrap_or_default()),
        None => shown,
    };
    let message = format!(
        "unexpected text `{shown}` in {}",
        walk::described(cx, parent)
    );
    // what other languages write in front of a comment
    let is_comment = ["#", "//"].iter().any(|start| shown.starts_with(start));
    let is_harmless = is_comment
        || is_slip(&shown)
        || is_prose(cx, parent, &shown)
        || is_left_over(cx, text)
        || is_note(cx, parent, text);
    out.report(trimmed(cx, node.origin), message)
        .severity(if is_harmless {
            Severity::Info
        } else {
            RULE.severity
        })
        .help("remove it, or put it in a comment <!-- ... -->; parsers ignore it")
        .done();
}

/// Whether a text is a number or one character, typed by accident: neither markup nor a value is lost with it.
fn is_slip(shown: &str) -> bool {
    let is_of_markup = |c: char| matches!(c, '<' | '>' | '=' | '"' | '\'' | '{' | '}');
    let is_one = shown.chars().nth(1).is_none() && !shown.contains(is_of_markup);
    is_one || shown.parse::<f64>().is_ok()
}

/// Whether a text is words without the marks of a comment in a part of a robot, or one word or sign between parts of a robot or link:
/// neither markup nor a value is lost with it.
fn is_prose(cx: &DocumentCx<'_>, parent: XId, shown: &str) -> bool {
    let around = cx.expansion.tree.get(parent).text.as_str();
    let is_between_parts = ["robot", "link"].contains(&around);
    let is_of_markup = |c: char| matches!(c, '<' | '>' | '=' | '"' | '\'' | '{' | '}');
    let has_letters = |word: &&str| word.chars().filter(|c| c.is_alphabetic()).count() > 1;
    let words = shown.split_whitespace().filter(has_letters).count();
    let is_one = !shown.contains(char::is_whitespace);
    !shown.contains(is_of_markup) && (words > 1 && around != "robot" || is_one && is_between_parts)
}

/// Whether a text is a bracket that was typed twice, as in `<link name="a"/>>`, or the end of a comment that was taken away.
fn is_left_over(cx: &DocumentCx<'_>, text: XId) -> bool {
    let shown = cx.expansion.tree.get(text).text.trim();
    shown.chars().all(|c| matches!(c, '<' | '>' | '/' | '-'))
}

/// Whether a text without marks of markup stands behind something in the same line: a note about it, if it is behind a comment or
/// has several words.
fn is_note(cx: &DocumentCx<'_>, parent: XId, text: XId) -> bool {
    let tree = &cx.expansion.tree;
    let said = tree.get(text).text.as_str();
    let blank = said.len() - said.trim_start().len();
    let is_in_line = !said.get(..blank).is_some_and(|blank| blank.contains('\n'));
    let before = tree.children(parent).take_while(|&child| child != text);
    let is_comment = |id: XId| tree.get(id).kind == XKind::Comment;
    let is_long = said.split_whitespace().nth(2).is_some();
    is_in_line
        && !said.contains(['<', '>', '='])
        && (is_long || before.last().is_some_and(is_comment))
}

/// A place without the blanks around its text.
fn trimmed(cx: &DocumentCx<'_>, origin: Origin) -> Origin {
    let Some(source) = cx.expansion.sources.get(origin.src) else {
        return origin;
    };
    let text = origin.range.slice(source.item.text());
    let start = origin.range.start + (text.len() - text.trim_start().len()) as u32;
    Origin {
        range: TextRange::new(start, start + text.trim().len() as u32),
        ..origin
    }
}

//! Values of expressions, in each call of the macro around them.

use super::super::context::Cx;
use super::super::expressions::{ExprText, parsed, path_to};
use super::super::locate::LocatedNode;
use super::super::values::{Instance, UNKNOWN, distinct, instances, part_values, short};
use super::page::{Page, code};
use super::{files, numbers, symbols};
use base::{TextRange, counted};
use expand::{FrameId, FrameKind, Origin};
use expr::ast::{Expr, ExprKind};
use expr::{TemplateToken, Value, display, global_symbols};
use rules::RuleEnv;

/// Most characters of a value.
const MOST_VALUE: usize = 200;

/// The expression or a part of it at a place.
pub(super) fn about(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    at: &LocatedNode<'_>,
) -> Option<(TextRange, Page)> {
    let text = ExprText::at(&cx.source.document, at)?;
    let token = text.token_at(at.offset)?;
    let whole = text.range(token.range());
    if let Some((range, name)) = package_at(&text, at.offset) {
        return Some((range, files::package(cx, world, name)));
    }
    if let Some(found) = files::loaded(cx, world, &text, at.offset) {
        return Some(found);
    }
    let Some((expr, start)) = parsed(token) else {
        let source = token.range().slice(&text.text);
        return Some((whole, valued(cx, at, source, &instances(cx, whole))));
    };
    let inside = text.offset(at.offset).saturating_sub(start);
    let mut path = path_to(expr, inside);
    // a literal is no news: what it stands in is
    while path.len() > 1
        && path
            .last()
            .is_some_and(|part| matches!(part.kind, ExprKind::Const(_)))
    {
        path.pop();
    }
    let part = path.last().copied().unwrap_or(expr);
    let is_whole = std::ptr::eq(part, expr);
    let range = if is_whole {
        whole
    } else {
        text.range(part.range.shift(start))
    };
    if let Some(page) = function(&path) {
        return Some((range, page));
    }
    let values = part_values(cx, whole, expr, part);
    if let ExprKind::Name(name) = &part.kind
        && values.is_empty()
        && let Some(page) = symbols::by_name(cx, name)
    {
        return Some((range, page));
    }
    let source = part.range.shift(start).slice(&text.text);
    let mut page = valued(cx, at, source, &values);
    page.add(reason(cx, whole, &values));
    Some((range, page))
}

/// All of the expression at a place.
pub(super) fn whole(cx: &Cx<'_>, at: &LocatedNode<'_>) -> Option<Page> {
    let text = ExprText::at(&cx.source.document, at)?;
    let token = text.token_at(at.offset)?;
    let range = text.range(token.range());
    let source = match token {
        TemplateToken::Expr { inner, .. } => inner.slice(&text.text),
        other => other.range().slice(&text.text),
    };
    Some(valued(cx, at, source.trim(), &instances(cx, range)))
}

/// The package of the `$(find package)` at an offset of the file, wherever in an expression that stands, and its name
/// there; all of the substitution, when the offset is in front of the name.
pub fn package_at<'t>(text: &'t ExprText<'_>, offset: u32) -> Option<(TextRange, &'t str)> {
    const LEAD: &str = "$(find ";
    let inside = text.offset(offset);
    text.text.match_indices(LEAD).find_map(|(start, _)| {
        let name = text.text.get(start + LEAD.len()..)?.split(')').next()?;
        let begin = (start + LEAD.len()) as u32;
        let range = TextRange::new(begin, begin + name.len() as u32);
        let around = TextRange::new(start as u32, (range.end + 1).min(text.text.len() as u32));
        let shown = if range.touches(inside) { range } else { around };
        around
            .touches(inside)
            .then(|| (text.range(shown), name.trim()))
    })
}

fn valued(cx: &Cx<'_>, at: &LocatedNode<'_>, source: &str, values: &[Instance]) -> Page {
    let mut page = match distinct(values.iter().map(|instance| &instance.value)).as_slice() {
        [value] => Page::titled(format!("{} = {}", code(source), shown(value))),
        _ => Page::titled(code(source)),
    };
    value_lines(cx, values)
        .into_iter()
        .for_each(|line| page.add(line));
    if let [value] = distinct(values.iter().map(|instance| &instance.value)).as_slice()
        && let Value::Float(number) = value
    {
        page.add(numbers::in_degrees(at, *number).unwrap_or_default());
    }
    page
}

/// Why no value is known: which names it needs have none.
fn reason(cx: &Cx<'_>, range: TextRange, values: &[Instance]) -> String {
    const MOST: usize = 4;
    let Some(place) = cx
        .source_range(range)
        .filter(|_| values.iter().all(|known| known.value.is_unknown()))
    else {
        return String::new();
    };
    let evaluations = &cx.expansion.index.evaluations;
    let reads = evaluations
        .at(place)
        .flat_map(|evaluation| cx.expansion.index.read_in(evaluation.reads));
    let bindings = reads.filter_map(|&read| cx.expansion.index.bindings.get(read));
    let unknown = bindings.filter(|info| info.value.as_ref().is_some_and(Value::is_unknown));
    let mut names: Vec<String> = unknown.map(|info| code(&info.name)).collect();
    names.sort_unstable();
    names.dedup();
    names.truncate(MOST);
    match names.as_slice() {
        [] => String::new(),
        [name] => format!("{name} has no known value"),
        names => format!("{} have no known values", names.join(", ")),
    }
}

/// A value as code; a number also exactly, when that reads otherwise.
pub(in super::super) fn shown(value: &Value) -> String {
    let text = short(value, MOST_VALUE);
    match (value, display::to_str(value)) {
        (Value::Unknown, _) => UNKNOWN.to_owned(),
        (Value::Float(_), Some(exact)) if exact != text => {
            format!("{} (exactly {})", code(&text), code(&exact))
        }
        _ => code(&text),
    }
}

/// What there is to say about values beside the only one: which call gives which, and why one is not known.
pub fn value_lines(cx: &Cx<'_>, values: &[Instance]) -> Vec<String> {
    const MOST: usize = 3;
    let different = distinct(values.iter().map(|instance| &instance.value));
    match different.as_slice() {
        [] => {
            return vec![format!(
                "{UNKNOWN} – {} does not use this code",
                root_name(cx)
            )];
        }
        [Value::Unknown] => return vec!["the value is unknown".to_owned()],
        [_] if cx.selected_frame.is_some() => {
            let label = values
                .first()
                .and_then(|instance| call_label(cx, instance.frame));
            return label
                .map(|label| format!("in {label}"))
                .into_iter()
                .collect();
        }
        [_] if values.len() > 1 => {
            return vec![format!("the same in all {}", counted(values.len(), "call"))];
        }
        [_] => return Vec::new(),
        _ => {}
    }
    let mut lines = Vec::new();
    for value in different.iter().take(MOST) {
        let given = values
            .iter()
            .find(|instance| std::ptr::eq(&raw const instance.value, *value));
        let label = given.and_then(|instance| call_label(cx, instance.frame));
        lines.push(format!(
            "- {}{}",
            shown(value),
            label.map(|label| format!(" – {label}")).unwrap_or_default()
        ));
    }
    if different.len() > MOST {
        lines.push(format!("- … ({})", counted(values.len(), "call")));
    }
    vec![lines.join("\n")]
}

/// The macro call that a frame belongs to: its macro, file and line.
pub fn call_label(cx: &Cx<'_>, frame: FrameId) -> Option<String> {
    let at = Origin {
        frame,
        ..Origin::NOWHERE
    };
    let call = cx
        .expansion
        .frames_of(at)
        .find(|frame| frame.kind == FrameKind::Macro)?;
    Some(format!(
        "{} at {}",
        code(&call.name),
        place_name(cx, call.call)?
    ))
}

/// `file.xacro:12`
pub(super) fn place_name(cx: &Cx<'_>, origin: Origin) -> Option<String> {
    let place = cx.expansion.place(origin)?;
    let source = &cx.expansion.files.get(place.file)?.source;
    let line = source
        .document
        .line_col(place.range.start, base::Encoding::Utf8)
        .line
        + 1;
    Some(format!(
        "{}:{line}",
        source.path.file_name()?.to_string_lossy()
    ))
}

/// The name of the root file.
pub(super) fn root_name(cx: &Cx<'_>) -> String {
    let path = cx
        .expansion
        .files
        .first()
        .and_then(|file| file.source.path.file_name());
    path.map_or_else(
        || "the robot".to_owned(),
        |name| code(&name.to_string_lossy()),
    )
}

/// A name that every expression knows.
pub(super) fn function(path: &[&Expr]) -> Option<Page> {
    let (part, around) = (
        path.last()?,
        path.len().checked_sub(2).and_then(|i| path.get(i)),
    );
    let (namespace, name) = match (&part.kind, around.map(|around| &around.kind)) {
        (ExprKind::Attribute { value, name, .. }, _) => match &value.kind {
            ExprKind::Name(module) => (Some(module.as_str()), name),
            _ => return None,
        },
        (ExprKind::Name(name), _) => (None, name),
        _ => return None,
    };
    let symbol = global_symbols().find(|symbol| {
        symbol.name == name && symbol.namespace.map(|module| module.name()) == namespace
    })?;
    if symbol.params.is_empty()
        && symbol.namespace.is_none()
        && symbol.kind == expr::BuiltinKind::Constant
    {
        return None;
    }
    let lead = namespace
        .map(|module| format!("{module}."))
        .unwrap_or_default();
    let mut page = Page::titled(code(&format!("{lead}{name}({})", symbol.params)));
    page.add(symbol.doc);
    if let Some(better) = symbol.deprecated.filter(|_| namespace.is_none()) {
        page.add(format!(
            "deprecated: use {}",
            code(&format!("{better}.{name}"))
        ));
    }
    Some(page)
}

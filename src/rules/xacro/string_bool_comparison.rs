//! A truth value compared with the text 'true' or 'false'.
use std::cell::LazyCell;

use memchr::memchr;

use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::source;
use base::{FastMap, FastSet, TextRange};
use expand::{Definition, DefinitionId, FileRange, SourceRange, SymbolKind, UseKind};
use expr::ast::{CmpOp, Const, Expr, ExprKind};
use expr::{Code, TemplateToken, split, visit};
use facts::{facts_of, may_hold};

pub(super) static RULE: Rule = Rule {
    code: "XAC028",
    name: "string-bool-comparison",
    category: Category::Xacro,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("string-bool-comparison"),
    check: Check::Document(check),
};

/// Names that lead to names that lead to names.
const MOST_STEPS: u32 = 8;

/// The uses of an expansion by their place.
type UsesByPlace = FastMap<SourceRange, Vec<DefinitionId>>;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if !source::is_main(cx) {
        return;
    }
    let mut documents = cx.expansion.files.iter().map(|file| &file.source.document);
    if !documents.any(|document| may_hold(document, |marks| marks.truth)) {
        return;
    }
    let uses = LazyCell::new(|| uses(cx));
    let sources = cx.expansion.sources.iter_ids();
    for (src, read) in sources.filter(|(_, read)| facts_of(&read.item).marks.truth) {
        let attrs = read.item.all_nodes().flat_map(|node| node.attrs());
        for attr in attrs.filter(|attr| attr.has_dollar() && may_compare(attr.raw())) {
            let start = attr.value_range().start;
            for (found, offset) in comparisons(attr.raw()) {
                let at = SourceRange {
                    src,
                    range: found.name_range.shift(start + offset),
                };
                let definitions = uses.get(&at).map_or(&[][..], Vec::as_slice);
                let converted = |&id: &DefinitionId| is_converted(cx, id, &uses, MOST_STEPS);
                if !definitions.is_empty() && definitions.iter().all(converted) {
                    let range = found.range.shift(start + offset + read.base);
                    report(
                        FileRange {
                            file: read.file,
                            range,
                        },
                        &found,
                        out,
                    );
                }
            }
        }
    }
}

/// Whether a text may compare something with a truth value. References such as &quot; shift the text against the source.
fn may_compare(text: &str) -> bool {
    memchr(b'=', text.as_bytes()).is_some()
        && memchr(b'&', text.as_bytes()).is_none()
        && (text.contains("rue") || text.contains("alse"))
}

fn uses(cx: &DocumentCx<'_>) -> UsesByPlace {
    let mut uses = UsesByPlace::default();
    for used in cx
        .expansion
        .index
        .symbols
        .uses
        .iter()
        .filter(|used| used.kind == UseKind::Read)
    {
        uses.entry(used.place).or_default().push(used.definition);
    }
    uses
}

/// `name == 'true'`
struct StringComparison {
    name: String,
    name_range: TextRange,
    range: TextRange,
    equal: bool,
    text: String,
}

/// The comparisons in a text, each with the offset its ranges count from.
fn comparisons(text: &str) -> Vec<(StringComparison, u32)> {
    let mut found = Vec::new();
    for token in split(text).tokens {
        if let TemplateToken::Expr {
            inner,
            code: Code::Static(parsed),
            ..
        } = token
        {
            let mut truths = FastSet::default();
            visit_all(&parsed.expr, &mut |expr| {
                truths.extend(compared_with_truth(expr))
            });
            let is_news = |found: &StringComparison| !truths.contains(found.name.as_str());
            visit_all(&parsed.expr, &mut |expr| {
                found.extend(
                    comparison(expr)
                        .filter(is_news)
                        .map(|found| (found, inner.start)),
                )
            });
        }
    }
    found
}

fn visit_all(expr: &Expr, f: &mut dyn FnMut(&Expr)) {
    f(expr);
    visit::children(expr, &mut |child| visit_all(child, f));
}

/// The name that is compared with `True` or `False`: who writes `x == 'true' or x == True` knows both.
fn compared_with_truth(expr: &Expr) -> Option<String> {
    let ExprKind::Compare(left, rest) = &expr.kind else {
        return None;
    };
    let [(CmpOp::Eq | CmpOp::Ne | CmpOp::Is | CmpOp::IsNot, right)] = rest.as_slice() else {
        return None;
    };
    match (&left.kind, &right.kind) {
        (ExprKind::Name(name), _) if is_truth(right) => Some(name.to_string()),
        (_, ExprKind::Name(name)) if is_truth(left) => Some(name.to_string()),
        _ => None,
    }
}

fn is_truth(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Const(Const::Bool(_)) => true,
        ExprKind::Name(name) => matches!(name.as_str(), "True" | "False"),
        _ => false,
    }
}

fn comparison(expr: &Expr) -> Option<StringComparison> {
    let ExprKind::Compare(left, rest) = &expr.kind else {
        return None;
    };
    let [(op, right)] = rest.as_slice() else {
        return None;
    };
    let equal = match op {
        CmpOp::Eq => true,
        CmpOp::Ne => false,
        _ => return None,
    };
    let (name, name_range, text) = match (&left.kind, &right.kind) {
        (ExprKind::Name(name), ExprKind::Const(Const::Str(text))) => (name, left.range, text),
        (ExprKind::Const(Const::Str(text)), ExprKind::Name(name)) => (name, right.range, text),
        _ => return None,
    };
    let is_truth = matches!(text.as_str(), "true" | "True" | "false" | "False");
    let (name, text) = (name.to_string(), text.to_string());
    is_truth.then_some(StringComparison {
        name,
        name_range,
        range: expr.range,
        equal,
        text,
    })
}

/// Whether the text `true` given to a definition becomes a truth value in any case.
fn is_converted(cx: &DocumentCx<'_>, id: DefinitionId, uses: &UsesByPlace, steps: u32) -> bool {
    let Some(definition) = cx.expansion.index.symbols.get(id).filter(|_| steps > 0) else {
        return false;
    };
    match definition.kind {
        SymbolKind::Property => {
            let node = source::definition_tag(cx.expansion, definition);
            let value = node.and_then(|node| node.attr("value").or_else(|| node.attr("default")));
            value.is_some_and(|value| {
                let at = SourceRange {
                    src: definition.place.src,
                    range: value.value_range(),
                };
                is_converted_text(cx, value.raw(), at, uses, steps)
            })
        }
        SymbolKind::Parameter => is_converted_param(cx, id, definition, uses, steps),
        _ => false,
    }
}

/// A parameter: by its default and by all calls.
fn is_converted_param(
    cx: &DocumentCx<'_>,
    id: DefinitionId,
    param: &Definition,
    uses: &UsesByPlace,
    steps: u32,
) -> bool {
    let given: Vec<_> = cx
        .expansion
        .index
        .symbols
        .uses_of(id)
        .filter(|used| used.kind == UseKind::Given)
        .collect();
    let default = default_of(cx, param);
    let plain = |text: &str| !text.contains(['\'', '"', '^', '{']);
    default.as_deref().is_none_or(plain)
        && (default.is_some() || !given.is_empty())
        && given
            .iter()
            .all(|used| is_converted_use(cx, used.place, uses, steps))
}

/// The value that a call gives at a place.
fn is_converted_use(cx: &DocumentCx<'_>, at: SourceRange, uses: &UsesByPlace, steps: u32) -> bool {
    let attr = source::tag(cx.expansion, at)
        .and_then(|(_, node)| node.attrs().find(|attr| attr.name_range() == at.range));
    attr.is_some_and(|attr| {
        let value = SourceRange {
            src: at.src,
            range: attr.value_range(),
        };
        is_converted_text(cx, attr.raw(), value, uses, steps)
    })
}

/// What stands behind the `=` of a parameter, up to the next blank.
fn default_of(cx: &DocumentCx<'_>, param: &Definition) -> Option<String> {
    let source = cx.expansion.sources.get(param.place.src)?;
    let rest = source.item.text().get(param.place.range.end as usize..)?;
    let value = rest.strip_prefix(':').unwrap_or(rest).strip_prefix('=')?;
    value
        .split([' ', '\t', '\n', '\r'])
        .next()
        .map(str::to_owned)
}

/// Whether a text at `at` is a literal, an argument, or the value of a name that is.
fn is_converted_text(
    cx: &DocumentCx<'_>,
    text: &str,
    at: SourceRange,
    uses: &UsesByPlace,
    steps: u32,
) -> bool {
    if text.contains(['\'', '"', '&']) {
        return false;
    }
    let tokens = split(text).tokens;
    match tokens.as_slice() {
        [
            TemplateToken::Expr {
                inner,
                code: Code::Static(parsed),
                ..
            },
        ] => {
            let range = parsed.expr.range.shift(at.range.start + inner.start);
            let definitions = uses.get(&SourceRange { src: at.src, range });
            matches!(parsed.expr.kind, ExprKind::Name(_))
                && definitions
                    .is_some_and(|ids| ids.iter().all(|&id| is_converted(cx, id, uses, steps - 1)))
        }
        tokens => tokens
            .iter()
            .all(|token| matches!(token, TemplateToken::Text(_) | TemplateToken::Subst { .. })),
    }
}

fn report(at: FileRange, found: &StringComparison, out: &mut Sink<'_>) {
    let StringComparison {
        name, equal, text, ..
    } = found;
    let verdict = if *equal { "never" } else { "always" };
    let truth = text.eq_ignore_ascii_case("true");
    let replacement = if truth == *equal {
        name.clone()
    } else {
        format!("not {name}")
    };
    let message =
        format!("comparison is {verdict} true: xacro converts `{text}` in `{name}` to a boolean");
    out.report_in(at.file, at.range, message)
        .help(format!("write `{replacement}`"))
        .replace_with(
            Safety::Safe,
            format!("replace with `{replacement}`"),
            replacement,
        )
        .done();
}

#[cfg(test)]
mod tests {
    use super::comparisons;

    #[test]
    fn what_is_a_comparison_with_a_truth() {
        let table = [
            ("${a == 'true'}", "a == 'true'"),
            ("x${1 if 'False' != b else 2}", "'False' != b"),
            ("${a == 'yes'}", ""),
            ("${a == true}", ""),
            ("${a == 'true' or a == True}", ""),
            ("${a == 'true' or b == True}", "a == 'true'"),
            ("${a.b == 'true'}", ""),
            ("${a < b == 'true'}", ""),
            ("a == 'true'", ""),
        ];
        for (text, expected) in table {
            let found: Vec<_> = comparisons(text)
                .iter()
                .map(|(found, offset)| found.range.shift(*offset).slice(text))
                .collect();
            assert_eq!(found.join(" "), expected, "{text}");
        }
    }
}

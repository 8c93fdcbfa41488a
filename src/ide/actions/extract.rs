//! A value gets a name.

use super::place::{before, top_level};
use super::{Action, ActionKind, edit};
use crate::{Cx, LocatedNode, NodePart, locate};
use base::TextRange;
use expr::{Code, TemplateToken, WordKind, is_identifier, split, words};
use facts::{FactKind, facts};
use vfs::SourceFile;
use xml::Attr;

/// A number or text that can be given a name.
struct ExtractedValue<'a> {
    text: String,
    /// Where it stands in the file.
    range: TextRange,
    /// Whether it stands inside of `${}`.
    in_expression: bool,
    attr: Attr<'a>,
    element: &'a str,
}

/// Make a property of the value that is selected, or of the number at the cursor: of it alone, and of all that are
/// written alike in the same attribute of such elements. Zeros and ones are in every line, so they have to be selected.
pub(super) fn property(cx: &Cx<'_>, selection: TextRange) -> Vec<Action> {
    let source = cx.source;
    let Some(value) = value_at(source, selection) else {
        return Vec::new();
    };
    let Some(at) = before(&source.document, value.range.start) else {
        return Vec::new();
    };
    let name = free_name(cx, &value);
    let text = format!("<xacro:property name=\"{name}\" value=\"{}\"/>", value.text);
    let new = edit(
        source,
        TextRange::empty(at),
        top_level(&source.document, at, &text),
    );
    let one = vec![
        new.clone(),
        edit(source, value.range, reading(&name, value.in_expression)),
    ];
    let title = format!("extract `{}` to property `{name}`", value.text);
    let mut actions = vec![Action {
        title,
        kind: ActionKind::Extract,
        edits: one,
    }];
    let alike = alike(source, &value, at);
    if alike.len() > 1 {
        let uses = alike
            .iter()
            .map(|(range, in_expression)| edit(source, *range, reading(&name, *in_expression)));
        let edits = std::iter::once(new).chain(uses).collect();
        let title = format!(
            "extract all {} `{}` to property `{name}`",
            alike.len(),
            value.text
        );
        actions.push(Action {
            title,
            kind: ActionKind::Extract,
            edits,
        });
    }
    actions
}

/// How a property is read.
fn reading(name: &str, in_expression: bool) -> String {
    if in_expression {
        name.to_owned()
    } else {
        format!("${{{name}}}")
    }
}

/// Attributes whose text xacro does not evaluate, or that name things.
const FIXED: [&str; 4] = ["name", "params", "type", "version"];

fn value_at(source: &SourceFile, selection: TextRange) -> Option<ExtractedValue<'_>> {
    let document = &source.document;
    let speaks_xacro = document.root()?.attr("xmlns:xacro").is_some();
    let at: LocatedNode<'_> = locate(document, selection.start);
    let (NodePart::AttrValue(attr), Some(node)) = (at.part, at.node) else {
        return None;
    };
    let whole = at.shift(attr.value_range());
    let fixed = FIXED.contains(&attr.name()) || attr.name().starts_with("xmlns") || at.base == 0;
    if !speaks_xacro
        || fixed
        || node.name() == "xacro:property" && attr.raw().len() == selection.len() as usize
    {
        return None;
    }
    let range = if selection.is_empty() {
        numbers(attr.raw())
            .map(|range| range.shift(whole.start))
            .find(|range| range.touches(selection.start))?
    } else {
        selection
    };
    if !whole.contains_range(range) {
        return None;
    }
    let text = document.slice(range);
    if selection.is_empty()
        && text
            .parse()
            .is_ok_and(|number: f64| number == 0.0 || number == 1.0)
    {
        return None;
    }
    let inside = TextRange::new(range.start - whole.start, range.end - whole.start);
    let is_number = numbers(attr.raw()).any(|number| number == inside);
    let in_expression = in_expression(attr.raw(), inside.start as usize)?;
    // xacro reads truth values from properties, and prints them in another way
    let truth = matches!(text.trim(), "true" | "false" | "True" | "False");
    let plain =
        !truth && !text.trim().is_empty() && !text.contains(['$', '"', '\'', '<', '&', '{', '}']);
    let admitted = is_number || plain && !in_expression && text.parse::<f64>().is_err();
    admitted.then(|| ExtractedValue {
        text,
        range,
        in_expression,
        attr,
        element: node.local_name(),
    })
}

/// The numbers that are written in a text.
fn numbers(text: &str) -> impl Iterator<Item = TextRange> + '_ {
    let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.');
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let rest = text.get(at..).filter(|rest| !rest.is_empty())?;
            let start = at + rest.find(is_word)?;
            let word = text.get(start..)?;
            let mut len = word.find(|c| !is_word(c)).unwrap_or(word.len());
            let begins = word.starts_with(|c: char| c.is_ascii_digit() || c == '.');
            // the sign of an exponent
            if begins
                && word.get(..len)?.ends_with(['e', 'E'])
                && word.get(len..)?.starts_with(['-', '+'])
            {
                let more = word.get(len + 1..)?;
                len += 1 + more
                    .find(|c: char| !c.is_ascii_digit())
                    .unwrap_or(more.len());
            }
            at = start + len;
            if begins && word.get(..len)?.parse::<f64>().is_ok() {
                return Some(TextRange::new(start as u32, at as u32));
            }
        }
    })
}

/// Whether an offset of a text stands inside of `${}`; none inside of `$()`, in a string, in code that is put together when
/// it is evaluated, and where code is broken.
fn in_expression(text: &str, offset: usize) -> Option<bool> {
    let offset = u32::try_from(offset).ok()?;
    let template = split(text);
    let is_broken = |token: &TemplateToken| matches!(token, TemplateToken::Expr { code: Code::Static(parsed), .. } if !parsed.errors.is_empty());
    if template.tokens.iter().any(is_broken) {
        return None;
    }
    let mut tokens = template.tokens.iter();
    let token = tokens.find(|token| holds(token.range(), offset));
    match token {
        None | Some(TemplateToken::Text(_)) => Some(false),
        Some(TemplateToken::Expr {
            inner,
            code: Code::Static(_),
            ..
        }) if inner.start <= offset => {
            let mut words = words(inner.slice(text)).into_iter();
            let is_in_string = words.any(|(range, kind)| {
                matches!(kind, WordKind::String | WordKind::OpenString)
                    && holds(range.shift(inner.start), offset)
            });
            (!is_in_string).then_some(true)
        }
        Some(_) => None,
    }
}

fn holds(range: TextRange, offset: u32) -> bool {
    range.start <= offset && offset < range.end
}

/// The same value in attributes of the same meaning, behind an offset.
fn alike(source: &SourceFile, value: &ExtractedValue<'_>, from: u32) -> Vec<(TextRange, bool)> {
    let mut found = Vec::new();
    for (base, item) in source
        .document
        .items()
        .filter(|(base, item)| base + item.len() > from)
    {
        let elements = item
            .all_nodes()
            .filter(|node| node.local_name() == value.element);
        let attrs = elements.flat_map(|node| node.attrs());
        for attr in attrs.filter(|attr| attr.name() == value.attr.name()) {
            let raw = attr.raw();
            let whole = TextRange::new(0, raw.len() as u32);
            let candidates = numbers(raw).chain((raw == value.text).then_some(whole));
            let same = candidates.filter(|range| range.slice(raw) == value.text);
            let mut same: Vec<TextRange> = same.collect();
            same.dedup();
            for range in same {
                let place = range.shift(base + attr.value_range().start);
                if let Some(inside) =
                    in_expression(raw, range.start as usize).filter(|_| place.start >= from)
                {
                    found.push((place, inside));
                }
            }
        }
    }
    found
}

/// A name that says where the value stands and that nothing else has.
fn free_name(cx: &Cx<'_>, value: &ExtractedValue<'_>) -> String {
    let wanted = format!("{}_{}", value.element, value.attr.name())
        .replace(|c: char| !c.is_ascii_alphanumeric(), "_");
    let wanted = if is_identifier(&wanted) {
        wanted
    } else {
        "value".to_owned()
    };
    let here = facts(&cx.source.document).flat_map(|(_, facts)| {
        let named = facts
            .of(FactKind::Property)
            .map(|fact| fact.name.to_string());
        let read = facts.mentions().map(|mention| mention.name.to_string());
        named.chain(read).collect::<Vec<_>>()
    });
    let known: Vec<String> = here
        .chain(
            cx.expansion
                .index
                .symbols
                .definitions
                .iter()
                .map(|known| known.name.to_string()),
        )
        .collect();
    let numbered = (2..1000).map(|number| format!("{wanted}_{number}"));
    let mut names = std::iter::once(wanted.clone()).chain(numbered);
    names.find(|name| !known.contains(name)).unwrap_or(wanted)
}

#[cfg(test)]
mod tests {
    use super::{in_expression, numbers};

    #[test]
    fn numbers_are_words_of_their_own() {
        let text = "0.1 -2 1e-3 a1 x.5 .5 ${2*b2+3} 1.2.3";
        let found: Vec<&str> = numbers(text).map(|range| range.slice(text)).collect();
        assert_eq!(found, ["0.1", "2", "1e-3", ".5", "2", "3"]);
    }

    #[test]
    fn expressions_are_told_from_text() {
        for (text, expected) in [
            ("|1", Some(false)),
            ("${|1}", Some(true)),
            ("${a} |1", Some(false)),
            ("$(arg |1)", None),
            ("$(arg a) |1", Some(false)),
            ("${'|1'}", None),
            ("${d['}'] + |1}", None),
            ("${d['a\\'b'] + |1}", Some(true)),
            ("${$(arg a) + |1}", None),
            ("$5 |1", Some(false)),
            // xacro ends an expression at the first `}`
            ("${dict(a={}) + |1}", None),
        ] {
            let offset = text.find('|').unwrap();
            assert_eq!(
                in_expression(&text.replace('|', ""), offset),
                expected,
                "{text}"
            );
        }
    }
}

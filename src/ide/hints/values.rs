//! Values behind expressions, as far as a reader could not say them at once.

use super::{Hint, HintKind};
use crate::context::Cx;
use crate::expressions::{ExprText, parsed};
use crate::schema;
use crate::values::{cut, distinct, instances, short};
use base::{Encoding, LineCol, TextRange};
use expr::{self, Code, Subst, TemplateToken, Value, parse_substitution};
use xml::{Attr, Document, Node};

/// The values of a file, collected.
pub(super) struct Values<'a> {
    cx: &'a Cx<'a>,
    /// Most characters of one.
    most: usize,
    found: Vec<ValueHint>,
}

/// A value, and the attribute that it stands in, by its place and name; none in text.
struct ValueHint {
    hint: Hint,
    attribute: Option<(u32, String)>,
}

/// What stands around an expression.
#[derive(Clone, Copy)]
struct ExpressionContext {
    /// Angles in radians are shown in degrees, too.
    is_angle: bool,
    /// In a tag of xacro, an attribute that is a name alone passes the value on.
    passes_on: bool,
}

impl<'a> Values<'a> {
    pub(super) fn new(cx: &'a Cx<'a>, most: usize) -> Self {
        Self {
            cx,
            most,
            found: Vec::new(),
        }
    }

    pub(super) fn of_text(&mut self, text: &ExprText<'_>) {
        self.collect(
            text,
            ExpressionContext {
                is_angle: false,
                passes_on: false,
            },
            None,
        );
    }

    pub(super) fn of_attribute(&mut self, text: &ExprText<'_>, node: Node<'_>, attr: Attr<'_>) {
        let is_xacro = node.name().starts_with("xacro:");
        let around = ExpressionContext {
            is_angle: !is_xacro && schema::is_angle(node, attr.name()),
            passes_on: is_xacro && text.template.tokens.len() == 1,
        };
        self.collect(text, around, Some((attr.value_range().start, attr.name())));
    }

    fn collect(
        &mut self,
        text: &ExprText<'_>,
        around: ExpressionContext,
        attribute: Option<(u32, &str)>,
    ) {
        for token in &text.template.tokens {
            let Some(arrow) = arrow(text, token) else {
                continue;
            };
            if is_evident(text, token, around) {
                continue;
            }
            let range = text.range(token.range());
            let Some(shown) = self.listed(range, around.is_angle) else {
                continue;
            };
            let label = format!("{arrow}{shown}");
            let hint = Hint {
                offset: range.end,
                label,
                kind: HintKind::Value,
                about: range.start,
            };
            self.found.push(ValueHint {
                hint,
                attribute: attribute.map(|(at, name)| (at, name.to_owned())),
            });
        }
    }

    /// The values of an expression: up to three, of more the first two.
    fn listed(&self, range: TextRange, is_angle: bool) -> Option<String> {
        const MOST_VALUES: usize = 3;
        let values = instances(self.cx, range);
        let values = distinct(values.iter().map(|instance| &instance.value));
        // a part that is not known makes the rest a guess
        if values.is_empty() || !values.iter().all(|value| is_short(value)) {
            return None;
        }
        if values.iter().all(|value| is_prefix(value)) {
            return None;
        }
        let count = if values.len() > MOST_VALUES {
            2
        } else {
            values.len()
        };
        let mut shown: Vec<String> = values
            .iter()
            .take(count)
            .map(|value| rounded(value, is_angle, self.most))
            .collect();
        if values.len() > count {
            shown.push("…".to_owned());
        }
        Some(cut(&shown.join(", "), self.most)).filter(|shown| !shown.is_empty())
    }

    /// The hints: where a line has several values, one at its end that names the attributes.
    pub(super) fn finish(self) -> Vec<Hint> {
        let document = &self.cx.source.document;
        let mut found = self.found;
        found.sort_by_key(|found| found.hint.offset);
        let lines = found.chunk_by(|a, b| line_of(document, a) == line_of(document, b));
        let hint = |values: &[ValueHint]| match values {
            [one] => Some(one.hint.clone()),
            [first, ..] => {
                let line = line_of(document, first);
                let col = document.line_text(line).trim_end().len() as u32;
                let offset = document.offset(LineCol { line, col }, Encoding::Utf8);
                Some(Hint {
                    offset,
                    label: joined(values),
                    ..first.hint.clone()
                })
            }
            [] => None,
        };
        lines.filter_map(hint).collect()
    }
}

fn line_of(document: &Document, found: &ValueHint) -> u32 {
    document.line_col(found.hint.offset, Encoding::Utf8).line
}

/// `xyz = 0.1 0.3; rpy = 1.571 (90°)`
fn joined(values: &[ValueHint]) -> String {
    const MOST: usize = 80;
    let bare = |found: &ValueHint| {
        found
            .hint
            .label
            .trim_start_matches(['=', '→', ' '])
            .to_owned()
    };
    let attributes = values.chunk_by(|a, b| a.attribute == b.attribute);
    let part = |values: &[ValueHint]| {
        let shown: Vec<String> = values.iter().map(bare).collect();
        match values.first().and_then(|found| found.attribute.as_ref()) {
            Some((_, attribute)) => format!("{attribute} = {}", shown.join(" ")),
            None => format!("= {}", shown.join(" ")),
        }
    };
    cut(&attributes.map(part).collect::<Vec<_>>().join("; "), MOST)
}

/// What stands in front of the value; none for tokens without one, and for expressions without names.
fn arrow(text: &ExprText<'_>, token: &TemplateToken) -> Option<&'static str> {
    match token {
        TemplateToken::Expr {
            code: Code::Static(_),
            ..
        } => {
            let has_names = parsed(token).is_some_and(|(expr, _)| !expr::names(expr).is_empty());
            has_names.then_some("= ")
        }
        TemplateToken::Expr { .. } => Some("= "),
        TemplateToken::Subst {
            inner,
            nested: None,
            ..
        } => match parse_substitution(inner.slice(&text.text)) {
            Subst::Arg(_) | Subst::Env(_) | Subst::OptEnv { .. } => Some("→ "),
            Subst::Eval { .. } => Some("= "),
            // packages are links: their paths are long
            _ => None,
        },
        _ => None,
    }
}

/// Whether a reader knows the value, or sees it passed on as it is.
fn is_evident(text: &ExprText<'_>, token: &TemplateToken, around: ExpressionContext) -> bool {
    const CONSTANTS: [&str; 6] = ["pi", "math.pi", "-pi", "pi/2", "-pi/2", "tau"];
    let TemplateToken::Expr { inner, .. } = token else {
        return false;
    };
    let written = inner.slice(&text.text).replace(' ', "");
    CONSTANTS.contains(&written.as_str()) || around.passes_on && expr::is_identifier(&written)
}

/// Whether a value says something in a few characters.
fn is_short(value: &Value) -> bool {
    match value {
        Value::Bool(_)
        | Value::Int(_)
        | Value::Big(_)
        | Value::Float(_)
        | Value::Str(_)
        | Value::None => true,
        Value::List(list) => list.len() <= 6,
        Value::Tuple(tuple) => tuple.items().len() <= 6,
        _ => false,
    }
}

/// Whether a text only comes in front of names: what it is says nothing about the place.
fn is_prefix(value: &Value) -> bool {
    matches!(value, Value::Str(text) if text.is_empty() || text.ends_with(['_', '/', '-']))
}

/// A number with four digits that count; those in front of the point all stay.
fn four(number: f64) -> f64 {
    const FOUR_IN_FRONT: f64 = 1000.0;
    if number.abs() >= FOUR_IN_FRONT {
        return number.round();
    }
    format!("{number:.3e}").parse().unwrap_or(number)
}

/// A value with four digits that count, and an angle in degrees beside it.
fn rounded(value: &Value, is_angle: bool, most: usize) -> String {
    let number = match value {
        Value::Float(number) if number.is_finite() => *number,
        Value::Str(text) => match text.trim().parse::<f64>() {
            Ok(number) if text.contains('.') && number.is_finite() => number,
            _ => return short(value, most),
        },
        _ => return short(value, most),
    };
    let shown = short(&Value::Float(four(number)), most);
    if is_angle && number != 0.0 {
        return format!("{shown} ({}°)", four(number.to_degrees()));
    }
    shown
}

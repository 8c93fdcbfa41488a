//! Splitting the text of an attribute or text node at `${…}`, `$(…)` and `$$`.

use std::sync::Arc;

use memchr::memchr;

use super::syntax::{Parsed, parse};
use base::TextRange;

/// A text split into tokens. All ranges, also those of nested templates, are byte offsets in the
/// text given to [`split`].
///
/// The reference reads one token ahead: it reports a [`TemplateToken::Invalid`] before it evaluates the
/// token in front of that, but after those further left.
#[derive(Clone, Debug, PartialEq)]
pub struct Template {
    /// The tokens in order; together they cover the text. Empty for the empty text.
    pub tokens: Vec<TemplateToken>,
}

/// A piece of a text.
#[derive(Clone, Debug, PartialEq)]
pub enum TemplateToken {
    /// Verbatim text.
    Text(TextRange),
    /// `$${` or `$$(`, maybe with more dollars: this much of it is put out, the first `$` is not.
    Escape(TextRange),
    /// `${…}`
    Expr {
        /// With the braces.
        range: TextRange,
        /// What stands between them.
        inner: TextRange,
        /// Its meaning.
        code: Code,
    },
    /// `$(…)`
    Subst {
        /// With the parentheses.
        range: TextRange,
        /// What stands between them.
        inner: TextRange,
        /// `inner` split further, when it holds a `$`: it must be evaluated as text first.
        nested: Option<Box<Template>>,
    },
    /// From here to the end the text makes no sense: `invalid expression: REST`.
    Invalid {
        /// All of the rest.
        range: TextRange,
        /// `${` or `$(` when that is not closed; none for a `$$` without a bracket.
        unclosed: Option<&'static str>,
    },
}

/// What stands between `${` and `}`.
#[derive(Clone, Debug, PartialEq)]
pub enum Code {
    /// An expression. Its ranges count from the start of the token's `inner`.
    Static(Arc<Parsed>),
    /// It holds `$(…)`, `$$(` or the like: to be evaluated as text first, then to be parsed.
    Dynamic(Box<Template>),
}

impl Template {
    /// Whether evaluating gives the text itself.
    pub fn is_verbatim(&self) -> bool {
        self.tokens
            .iter()
            .all(|token| matches!(token, TemplateToken::Text(_)))
    }
}

impl TemplateToken {
    /// Where the token stands.
    pub fn range(&self) -> TextRange {
        match self {
            TemplateToken::Text(range) | TemplateToken::Invalid { range, .. } => *range,
            TemplateToken::Escape(output) => TextRange::new(output.start - 1, output.end),
            TemplateToken::Expr { range, .. } | TemplateToken::Subst { range, .. } => *range,
        }
    }
}

/// Split `text`; cheap when it holds no `$`.
pub fn split(text: &str) -> Template {
    if u32::try_from(text.len()).is_err() {
        return Template { tokens: Vec::new() };
    }
    TemplateSplitter {
        text,
        end: text.len(),
        pos: 0,
        tokens: Vec::new(),
    }
    .run()
}

/// Works on `text[pos..end]`; brackets are looked for within that only.
struct TemplateSplitter<'t> {
    text: &'t str,
    end: usize,
    pos: usize,
    tokens: Vec<TemplateToken>,
}

impl TemplateSplitter<'_> {
    fn run(mut self) -> Template {
        while self.pos < self.end {
            self.token();
        }
        Template {
            tokens: self.tokens,
        }
    }

    fn byte(&self, ahead: usize) -> Option<u8> {
        self.text
            .as_bytes()
            .get(self.pos + ahead..self.end)?
            .first()
            .copied()
    }

    /// Offset of the next `byte` from `from` on.
    fn find(&self, byte: u8, from: usize) -> Option<usize> {
        memchr(byte, self.text.as_bytes().get(from..self.end)?).map(|i| from + i)
    }

    fn token(&mut self) {
        if self.byte(0) != Some(b'$') {
            let end = self.find(b'$', self.pos).unwrap_or(self.end);
            return self.push_text(end);
        }
        match self.byte(1) {
            Some(b'$') => self.dollars(),
            Some(b'{') => self.bracket(b'}', "${"),
            Some(b'(') => self.bracket(b')', "$("),
            _ => {
                let end = self.find(b'$', self.pos + 1).unwrap_or(self.end);
                self.push_text(end);
            }
        }
    }

    /// Text up to `end`; adjacent texts become one.
    fn push_text(&mut self, end: usize) {
        let (start, stop) = (self.pos as u32, end as u32);
        match self.tokens.last_mut() {
            Some(TemplateToken::Text(last)) => last.end = stop,
            _ => self
                .tokens
                .push(TemplateToken::Text(TextRange::new(start, stop))),
        }
        self.pos = end;
    }

    fn dollars(&mut self) {
        let start = self.pos;
        let rest = self.text.as_bytes().get(start..self.end).unwrap_or(&[]);
        let count = rest.iter().take_while(|b| **b == b'$').count();
        match self.byte(count) {
            Some(b'{' | b'(') => {
                self.pos = start + count + 1;
                self.tokens.push(TemplateToken::Escape(TextRange::new(
                    start as u32 + 1,
                    self.pos as u32,
                )));
            }
            _ => self.invalid(None),
        }
    }

    fn invalid(&mut self, unclosed: Option<&'static str>) {
        let range = TextRange::new(self.pos as u32, self.end as u32);
        self.tokens.push(TemplateToken::Invalid { range, unclosed });
        self.pos = self.end;
    }

    fn bracket(&mut self, close: u8, open: &'static str) {
        let Some(close) = self.find(close, self.pos + 2) else {
            return self.invalid(Some(open));
        };
        let range = TextRange::new(self.pos as u32, close as u32 + 1);
        let inner = TextRange::new(self.pos as u32 + 2, close as u32);
        let nested = self.nested(inner);
        self.tokens.push(if open == "${" {
            let code = match nested {
                Some(template) if !template.is_verbatim() => Code::Dynamic(template),
                _ => Code::Static(Arc::new(parse(inner.slice(self.text)))),
            };
            TemplateToken::Expr { range, inner, code }
        } else {
            TemplateToken::Subst {
                range,
                inner,
                nested: nested.filter(|template| !template.is_verbatim()),
            }
        });
        self.pos = close + 1;
    }

    /// What stands between brackets as a template of its own, if it holds a `$`. Every level needs its own
    /// closing bracket in front of the outer one's, so there are at most three.
    fn nested(&self, inner: TextRange) -> Option<Box<Template>> {
        let (pos, end) = (inner.start as usize, inner.end as usize);
        memchr(b'$', self.text.as_bytes().get(pos..end)?)?;
        Some(Box::new(
            TemplateSplitter {
                text: self.text,
                end,
                pos,
                tokens: Vec::new(),
            }
            .run(),
        ))
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;

    /// The tokens as `tests/oracle/text_tables.py` writes them; checks on the way that they cover their text.
    fn tokens(text: &str, template: &Template, within: TextRange) -> Value {
        let mut at = within.start;
        let mut out = Vec::new();
        for token in &template.tokens {
            assert_eq!(token.range().start, at, "gap in {text:?}");
            at = token.range().end;
            out.push(match token {
                TemplateToken::Text(range) => json!(["text", range.slice(text)]),
                TemplateToken::Escape(range) => json!(["escape", range.slice(text)]),
                TemplateToken::Expr { inner, code, .. } => {
                    let inner_text = inner.slice(text);
                    json!([
                        "expr",
                        match code {
                            Code::Dynamic(nested) => tokens(text, nested, *inner),
                            Code::Static(_) if inner_text.contains('$') =>
                                json!([["text", inner_text]]),
                            Code::Static(_) => json!(inner_text),
                        }
                    ])
                }
                TemplateToken::Subst { inner, nested, .. } => {
                    let inner_text = inner.slice(text);
                    json!([
                        "subst",
                        match nested {
                            Some(nested) => tokens(text, nested, *inner),
                            None if inner_text.contains('$') => json!([["text", inner_text]]),
                            None => json!(inner_text),
                        }
                    ])
                }
                TemplateToken::Invalid { range, .. } => json!(["invalid", range.slice(text)]),
            });
        }
        assert_eq!(at, within.end, "rest of {text:?}");
        Value::Array(out)
    }

    #[test]
    fn tokens_are_those_of_the_reference() {
        for line in include_str!("testdata/templates.txt").lines() {
            let (text, want): (String, Value) = serde_json::from_str(line).unwrap();
            let all = TextRange::new(0, text.len() as u32);
            assert_eq!(tokens(&text, &split(&text), all), want, "{text:?}");
        }
    }

    #[test]
    fn unclosed_brackets_are_named() {
        for (text, want) in [("a ${b", Some("${")), ("$(a", Some("$(")), ("a $$ b", None)] {
            let template = split(text);
            let Some(TemplateToken::Invalid { unclosed, .. }) = template.tokens.last() else {
                panic!("{text}")
            };
            assert_eq!(*unclosed, want, "{text}");
        }
    }

    #[test]
    fn expressions_count_from_their_start() {
        let text = "x ${ a+1}";
        let template = split(text);
        let Some(TemplateToken::Expr {
            inner,
            code: Code::Static(parsed),
            ..
        }) = template.tokens.last()
        else {
            panic!()
        };
        assert_eq!(parsed.expr.range.shift(inner.start).slice(text), "a+1");
    }

    #[test]
    fn templates_are_shared_between_threads() {
        fn shared<T: Send + Sync>() {}
        shared::<Template>();
    }
}

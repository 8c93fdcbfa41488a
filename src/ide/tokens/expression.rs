//! The pieces of `${...}` and `$(...)`.

use super::super::expressions::ExprText;
use super::{Collector, Modifiers, TokenKind};
use base::TextRange;
use expr::{Code, Subst, Template, TemplateToken, WordKind, parse_substitution, words};
use xml::Node;

const PLAIN: Modifiers = Modifiers(0);

/// What an expression stands in.
struct TokenSite<'t, 'a> {
    text: &'t ExprText<'a>,
    node: Option<Node<'a>>,
}

impl Collector<'_, '_> {
    /// The expressions of a text; `plain` is what the text around them is.
    pub fn template(
        &mut self,
        text: &ExprText<'_>,
        node: Option<Node<'_>>,
        plain: Option<(TokenKind, Modifiers)>,
    ) {
        let site = TokenSite { text, node };
        for token in &text.template.tokens {
            if let (TemplateToken::Text(range), Some((kind, modifiers))) = (token, plain) {
                self.add(text.range(*range), kind, modifiers);
            }
        }
        self.tokens_of(&site, &text.template);
    }

    fn tokens_of(&mut self, site: &TokenSite<'_, '_>, template: &Template) {
        for token in &template.tokens {
            match token {
                TemplateToken::Expr { range, inner, code } => {
                    self.brackets(site, *range, *inner);
                    let nested = match code {
                        Code::Dynamic(nested) => {
                            self.tokens_of(site, nested);
                            nested
                                .tokens
                                .iter()
                                .filter(|token| !matches!(token, TemplateToken::Text(_)))
                                .collect()
                        }
                        Code::Static(_) => Vec::new(),
                    };
                    let holes: Vec<TextRange> =
                        nested.into_iter().map(TemplateToken::range).collect();
                    self.words(site, *inner, &holes, false);
                }
                TemplateToken::Subst {
                    range,
                    inner,
                    nested,
                } => {
                    self.brackets(site, *range, *inner);
                    match nested {
                        Some(nested) => self.tokens_of(site, nested),
                        None => self.substitution(site, *inner),
                    }
                }
                // half-typed: what stands behind `${` is an expression all the same
                TemplateToken::Invalid {
                    range,
                    unclosed: Some("${"),
                } => {
                    self.words(site, TextRange::new(range.start + 2, range.end), &[], false);
                }
                _ => {}
            }
        }
    }

    /// What a name in an expression of `node` is.
    fn named(
        &self,
        name: &str,
        range: TextRange,
        node: Option<Node<'_>>,
    ) -> (TokenKind, Modifiers) {
        if self.names.at(range).is_none() {
            self.rests_on_properties.set(true);
        }
        self.names.named(name, range, node)
    }

    fn brackets(&mut self, site: &TokenSite<'_, '_>, range: TextRange, inner: TextRange) {
        for bracket in [
            TextRange::new(range.start, inner.start),
            TextRange::new(inner.end, range.end),
        ] {
            self.add(site.text.range(bracket), TokenKind::Operator, PLAIN);
        }
    }

    fn substitution(&mut self, site: &TokenSite<'_, '_>, inner: TextRange) {
        let source = inner.slice(&site.text.text);
        let command = source
            .split(' ')
            .find(|word| !word.is_empty())
            .unwrap_or("");
        let start = inner.start + source.find(command).unwrap_or(0) as u32;
        let range = TextRange::new(start, start + command.len() as u32);
        self.add(site.text.range(range), TokenKind::Keyword, PLAIN);
        let (word, kind) = match parse_substitution(source) {
            Subst::Arg(word) => (word, TokenKind::Parameter),
            Subst::Find(word) => (word, TokenKind::Namespace),
            Subst::Env(word) | Subst::OptEnv { name: word, .. } => (word, TokenKind::Variable),
            Subst::Eval { code } => return self.words(site, code.shift(inner.start), &[], true),
            _ => return,
        };
        self.add(site.text.range(word.range.shift(inner.start)), kind, PLAIN);
    }

    /// The words of code; what stands in `holes` has its own pieces. In `$(eval)`, names are arguments.
    fn words(
        &mut self,
        site: &TokenSite<'_, '_>,
        inner: TextRange,
        holes: &[TextRange],
        is_eval: bool,
    ) {
        let source = inner.slice(&site.text.text);
        let words = words(source);
        let text = |i: usize| words.get(i).map_or("", |(range, _)| range.slice(source));
        for (i, (range, kind)) in words.iter().enumerate() {
            let place = range.shift(inner.start);
            let before = |back: usize| i.checked_sub(back).map_or("", text);
            let (kind, modifiers) = match kind {
                WordKind::Name if before(1) == "." => match self.names.member(before(2), text(i)) {
                    Some(kind) => (kind, Modifiers::DEFAULT_LIBRARY),
                    None if text(i + 1) == "(" => (TokenKind::Function, PLAIN),
                    None => (TokenKind::Property, PLAIN),
                },
                WordKind::Name if is_eval && self.names.at(site.text.range(place)).is_none() => {
                    match self.named(text(i), site.text.range(place), None) {
                        (TokenKind::Variable, PLAIN) => (TokenKind::Parameter, PLAIN),
                        found => found,
                    }
                }
                WordKind::Name => self.named(text(i), site.text.range(place), site.node),
                WordKind::String
                    if before(1) == "[" && text(i + 1) == "]" && is_operand(before(2)) =>
                {
                    (TokenKind::Property, PLAIN)
                }
                WordKind::String | WordKind::OpenString => (TokenKind::String, PLAIN),
                WordKind::Number => (TokenKind::Number, PLAIN),
                WordKind::Keyword => (TokenKind::Keyword, PLAIN),
                WordKind::Operator => (TokenKind::Operator, PLAIN),
            };
            for piece in without(place, holes) {
                self.add(site.text.range(piece), kind, modifiers);
            }
        }
    }
}

/// Whether an index may stand behind a word.
fn is_operand(word: &str) -> bool {
    word.ends_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | ')' | ']'))
}

/// The parts of a range outside of others, which are in order.
fn without(range: TextRange, holes: &[TextRange]) -> Vec<TextRange> {
    let mut parts = Vec::new();
    let mut start = range.start;
    for hole in holes
        .iter()
        .filter(|hole| hole.start < range.end && range.start < hole.end)
    {
        parts.push(TextRange::new(start, hole.start.max(start)));
        start = hole.end.min(range.end);
    }
    parts.push(TextRange::new(start, range.end));
    parts.retain(|part| !part.is_empty());
    parts
}

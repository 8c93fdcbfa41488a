//! Text with `${...}` and `$(...)`: to values, and to strings that know their pieces.
use std::borrow::Cow;
use std::sync::Arc;

use ecow::EcoString;

use super::expander::{Expander, raise};
use super::functions::ExprHost;
use super::kind::ProblemKind;
use super::names::EvalContext;
use super::node::Piece;
use super::origin::Origin;
use super::problem::Outside;
use super::scope::TextOrigin;
use super::split_text::{CodeSite, SplitText, TextSite};
use super::{advice, meant};
use base::TextRange;
use base::paths::HERE;
use expr::ast::ExprKind;
use expr::{
    self, Code, ErrorKind, EvalError, ExprErrorKind, Parsed, ScopeId, Template, TemplateToken,
    Value, display,
};

/// Bytes of texts that are kept in their split form: blocks can be evaluated again and again with ever new texts.
const KEPT_BYTES: usize = 4 << 20;

/// What stands for a value that could not be computed.
pub(super) const UNKNOWN_TEXT: &str = "?";

impl Expander<'_> {
    /// The typed value of a text: one token keeps its type, several are joined as strings.
    pub fn eval_text(&mut self, text: &str, place: TextOrigin, scope: ScopeId) -> Value {
        if !text.contains('$') {
            return Value::Str(text.into());
        }
        let cached = self.split(text);
        let site = self.site(&cached.text, place);
        match cached.template.tokens.as_slice() {
            [] => Value::Str(EcoString::new()),
            [token] => self.eval_token(token, site, scope).0,
            tokens => {
                let mut out = EcoString::new();
                let mut known = true;
                for token in tokens {
                    match display::to_str(&self.eval_token(token, site, scope).0) {
                        Some(text) if self.affords(text.len(), site) => {
                            out.push_str(HERE.joint(&out, &text));
                            out.push_str(&text);
                        }
                        _ => known = false,
                    }
                }
                if known {
                    Value::Str(out)
                } else {
                    Value::Unknown
                }
            }
        }
    }

    /// The string form of a text with the pieces that expressions made.
    /// A piece that cannot be computed reads `?`.
    pub fn eval_pieces(
        &mut self,
        text: &str,
        place: TextOrigin,
        cx: EvalContext,
    ) -> (EcoString, Box<[Piece]>) {
        if !text.contains('$') {
            return (text.into(), Box::default());
        }
        let cached = self.split(text);
        let site = self.site(&cached.text, place);
        let mut out = EcoString::new();
        let mut pieces = Vec::new();
        for token in &cached.template.tokens {
            let mark = self.names.reads.len();
            let (value, read) = self.eval_token(token, site, cx.scope);
            self.names.reads.truncate(mark);
            let value = self.without_function(value, token, site);
            let shown = display::to_str(&value).filter(|text| self.affords(text.len(), site));
            let unknown = shown.is_none();
            self.result.complete &= !unknown;
            let shown = shown.as_deref().unwrap_or(UNKNOWN_TEXT);
            out.push_str(HERE.joint(&out, shown));
            let start = out.len() as u32;
            out.push_str(shown);
            if let Some((source, reads)) = read {
                pieces.push(Piece {
                    out: TextRange::new(start, out.len() as u32),
                    source,
                    reads,
                    unknown,
                });
            }
        }
        (out, pieces.into())
    }

    /// A built-in function as text is no value: a property of that name was meant. The reference writes the text that
    /// Python shows of it.
    fn without_function(
        &mut self,
        value: Value,
        token: &TemplateToken,
        site: TextSite<'_>,
    ) -> Value {
        let (Value::Builtin(_) | Value::Type(_), TemplateToken::Expr { range, inner, .. }) =
            (&value, token)
        else {
            return value;
        };
        if !self.request.probe {
            return value;
        }
        let name = inner.slice(site.text).trim();
        let message = format!("property `{name}` is not defined; `{name}` is a Python function");
        let problem = self.problem(
            ProblemKind::UndefinedProperty,
            self.origin_in(site, *range),
            message,
        );
        let help =
            format!("add <xacro:property name=\"{name}\" value=\"...\"/> before this expression");
        self.push(problem.help(help).depends_on(Outside::Includer));
        Value::Unknown
    }

    /// Whether the budget admits so many more bytes of text; expansion winds up when it does not.
    fn affords(&mut self, bytes: usize, site: TextSite<'_>) -> bool {
        if self.flow.stopped || bytes == 0 {
            return !self.flow.stopped;
        }
        let admitted = self.guards.budget.charge(bytes);
        if !admitted {
            let most = self.request.limits.output_bytes >> 20;
            self.stop(
                site.place.origin,
                format!("the evaluated text of this file is larger than {most} MB"),
                None,
            );
        }
        admitted
    }

    /// The split form of a text. Those of macros are kept: they are evaluated with each call, and the same ones stand
    /// in many places.
    fn split(&mut self, text: &str) -> Arc<SplitText> {
        if let Some(kept) = self.files.texts.get(text) {
            return kept.clone();
        }
        let split = SplitText::of(text);
        if !self.guards.calls.is_empty() && self.files.text_bytes + text.len() <= KEPT_BYTES {
            self.files.text_bytes += text.len();
            self.files.texts.insert(split.text.clone(), split.clone());
        }
        split
    }

    /// The value of a token; of one that is evaluated also where it stands and what was read for it.
    fn eval_token(
        &mut self,
        token: &TemplateToken,
        site: TextSite<'_>,
        scope: ScopeId,
    ) -> (Value, Option<(Origin, TextRange)>) {
        let mark = self.names.reads.len();
        let value = self.token_value(token, site, scope);
        let read = match token {
            TemplateToken::Expr { range, .. } | TemplateToken::Subst { range, .. } => {
                let at = self.origin_in(site, *range);
                Some((at, self.note_value(at, &value, mark)))
            }
            TemplateToken::Invalid { range, .. } => {
                Some((self.origin_in(site, *range), TextRange::default()))
            }
            TemplateToken::Text(_) | TemplateToken::Escape(_) => None,
        };
        (value, read)
    }

    fn token_value(&mut self, token: &TemplateToken, site: TextSite<'_>, scope: ScopeId) -> Value {
        match token {
            TemplateToken::Text(range) | TemplateToken::Escape(range) => {
                Value::Str(range.slice(site.text).into())
            }
            TemplateToken::Expr { range, inner, code } => {
                self.eval_code(code, *range, *inner, site, scope)
            }
            TemplateToken::Subst {
                range,
                inner,
                nested,
            } => {
                let mark = self.names.reads.len();
                let text = match nested {
                    None => Cow::Borrowed(inner.slice(site.text)),
                    Some(nested) => match self.eval_nested(nested, site, scope) {
                        Some(text) => Cow::Owned(text.to_string()),
                        None => return Value::Unknown,
                    },
                };
                self.substitute(
                    &text,
                    *range,
                    nested.is_none().then_some(*inner),
                    site,
                    (scope, mark),
                )
            }
            TemplateToken::Invalid { range, unclosed } => {
                self.invalid_text(*range, *unclosed, site)
            }
        }
    }

    fn invalid_text(
        &mut self,
        range: TextRange,
        unclosed: Option<&'static str>,
        site: TextSite<'_>,
    ) -> Value {
        let rest = range.slice(site.text);
        let at = self.origin_in(site, range);
        let reference = format!("invalid expression: {rest}");
        let problem = match unclosed {
            Some(open) => {
                let close = if open == "${" { "}" } else { ")" };
                let problem = self
                    .problem(
                        ProblemKind::UnclosedExpression,
                        at,
                        format!("unclosed `{open}`: missing `{close}`"),
                    )
                    .says(reference);
                match meant::by_other_bracket(rest, open) {
                    Some(meant) => meant.said_of(problem),
                    None => problem,
                }
            }
            None => self
                .problem(
                    ProblemKind::InvalidExpression,
                    at,
                    format!("`{}` is not followed by `{{` or `(`", lead(rest)),
                )
                .says(reference)
                .help("write a single `$` for a literal dollar sign"),
        };
        self.push(problem);
        Value::Unknown
    }

    /// A text inside a token, evaluated to a string; `None` when it cannot be computed.
    fn eval_nested(
        &mut self,
        nested: &Template,
        site: TextSite<'_>,
        scope: ScopeId,
    ) -> Option<EcoString> {
        let mut out = EcoString::new();
        let mut known = true;
        for token in &nested.tokens {
            match display::to_str(&self.eval_token(token, site, scope).0) {
                Some(text) => out.push_str(&text),
                None => known = false,
            }
        }
        known.then_some(out)
    }

    fn eval_code(
        &mut self,
        code: &Code,
        whole: TextRange,
        inner: TextRange,
        site: TextSite<'_>,
        scope: ScopeId,
    ) -> Value {
        let mark = self.names.reads.len();
        match code {
            Code::Static(parsed) => {
                let at = CodeSite {
                    whole,
                    start: Some(inner.start),
                    code: inner.slice(site.text),
                    site,
                };
                self.eval_parsed(parsed, at, scope, mark)
            }
            Code::Dynamic(nested) => {
                let Some(text) = self.eval_nested(nested, site, scope) else {
                    return Value::Unknown;
                };
                let parsed = expr::parse(&text);
                let at = CodeSite {
                    whole,
                    start: None,
                    code: inner.slice(site.text),
                    site,
                };
                self.eval_parsed(&parsed, at, scope, mark)
            }
        }
    }

    /// The value of an expression; what was read for it follows the first `mark` reads.
    fn eval_parsed(
        &mut self,
        parsed: &Parsed,
        at: CodeSite<'_>,
        scope: ScopeId,
        mark: usize,
    ) -> Value {
        if let Some(error) = parsed.errors.first() {
            return self.syntax_error(error, at);
        }
        self.names.scopes.note_evaluation(scope);
        // the most common expression by far needs no evaluator
        if let ExprKind::Name(name) = &parsed.expr.kind
            && let Some(value) = self.resolve(scope, name, self.origin_of(at, parsed.expr.range))
        {
            return value;
        }
        let mut budget = self.guards.budget.clone();
        let result = expr::evaluate(
            &parsed.expr,
            &mut ExprHost {
                expander: self,
                scope,
                at,
            },
            &mut budget,
        );
        self.guards.budget.steps = self.guards.budget.steps.min(budget.steps);
        self.guards.budget.bytes = self.guards.budget.bytes.min(budget.bytes);
        match result {
            Ok(value) => value,
            Err(error) => {
                self.evaluation_error(&error, at, mark);
                Value::Unknown
            }
        }
    }

    fn syntax_error(&mut self, error: &expr::ExprError, at: CodeSite<'_>) -> Value {
        let whole = self.origin_in(at.site, at.whole);
        let reference = format!(
            "{} \nwhen evaluating expression '{}'",
            error.reference, at.code
        );
        let code = at.code.trim();
        let mut problem = match error.kind {
            ExprErrorKind::ForbiddenName => {
                self.problem(ProblemKind::InvalidExpression, whole, error.message.clone())
            }
            _ if code.is_empty() => {
                self.problem(ProblemKind::InvalidExpression, whole, "empty expression")
            }
            _ => {
                let message = format!(
                    "invalid expression `{}`: {}",
                    shortened(code),
                    error.message
                );
                self.problem(ProblemKind::InvalidExpression, whole, message)
            }
        }
        .says(reference);
        if let Some(meant) = meant::by_expression(code) {
            problem = meant.said_of(problem);
        }
        self.push(problem);
        Value::Unknown
    }

    fn evaluation_error(&mut self, error: &EvalError, at: CodeSite<'_>, mark: usize) {
        let slip = match error.kind {
            ErrorKind::Io => self.folder_slip(error),
            _ => self.number_slip(error, mark),
        };
        if let Some(problem) = slip {
            return self.push(problem);
        }
        let reference = format!(
            "{} \nwhen evaluating expression '{}'",
            error.message, at.code
        );
        let (kind, place) = match error.kind {
            ErrorKind::Reported => return,
            ErrorKind::YamlKey => (
                ProblemKind::UndefinedProperty,
                self.origin_of(at, error.range),
            ),
            ErrorKind::Syntax | ErrorKind::ForbiddenName => (
                ProblemKind::InvalidExpression,
                self.origin_in(at.site, at.whole),
            ),
            _ => (
                ProblemKind::ExpressionError,
                self.origin_in(at.site, at.whole),
            ),
        };
        let message = match kind {
            ProblemKind::UndefinedProperty => advice::headline(error),
            _ => format!(
                "cannot evaluate `{}`: {}",
                shortened(at.code.trim()),
                advice::headline(error)
            ),
        };
        let mut problem = self.problem(kind, place, message).says(reference);
        if kind == ProblemKind::ExpressionError {
            problem.outside = match error.kind {
                ErrorKind::Io => Some(Outside::File),
                _ => self.outside_of_reads(mark),
            };
        }
        if let Some(meant) = meant::by_failure(at.code.trim(), &error.message) {
            problem = meant.said_of(problem);
        }
        if error.kind == ErrorKind::Budget && error.message.contains(" steps") {
            problem = problem.help(raise("eval-steps"));
        }
        self.push(problem);
    }

    /// The origin of a range of decoded text.
    pub fn origin_in(&self, site: TextSite<'_>, range: TextRange) -> Origin {
        let origin = site.place.origin;
        if site.is_raw {
            Origin {
                range: range.shift(origin.range.start),
                ..origin
            }
        } else {
            self.origins_in(site)(range)
        }
    }

    /// A text with its place.
    pub fn site<'t>(&self, text: &'t str, place: TextOrigin) -> TextSite<'t> {
        let source = self.result.sources.get(place.origin.src);
        let raw = source.map(|source| place.origin.range.slice(source.item.text()));
        TextSite {
            text,
            place,
            is_raw: raw == Some(text),
        }
    }

    /// The same for many ranges of one text: one pass, as long as each is behind the one before.
    pub fn origins_in(&self, site: TextSite<'_>) -> impl FnMut(TextRange) -> Origin {
        let TextOrigin { origin, is_attr } = site.place;
        let source = self.result.sources.get(origin.src);
        let raw = source.map(|source| origin.range.slice(source.item.text()));
        let is_same = site.is_raw;
        let file = source.and_then(|source| self.result.files.get(source.file));
        let mut offsets = raw
            .zip(file)
            .filter(|_| !is_same)
            .map(|(raw, file)| xml::source_offsets(raw, file.source.document.entities(), is_attr));
        move |range| {
            let mapped = match &mut offsets {
                _ if is_same => range,
                Some(map) => TextRange::new(
                    map(range.start as usize) as u32,
                    map(range.end as usize) as u32,
                ),
                None => return origin,
            };
            Origin {
                range: mapped.shift(origin.range.start),
                ..origin
            }
        }
    }

    /// The origin of a range of an expression; the whole `${...}` when its text was made at run time.
    pub fn origin_of(&self, at: CodeSite<'_>, range: TextRange) -> Origin {
        match at.start {
            Some(start) => self.origin_in(at.site, range.shift(start)),
            None => self.origin_in(at.site, at.whole),
        }
    }
}

/// The dollar signs a text starts with.
fn lead(text: &str) -> &str {
    text.get(..text.len() - text.trim_start_matches('$').len())
        .unwrap_or("")
}

/// An expression as messages name it: the reason behind a long one is what matters.
fn shortened(code: &str) -> Cow<'_, str> {
    const MOST: usize = 300;
    if code.len() <= MOST {
        return Cow::Borrowed(code);
    }
    Cow::Owned(format!(
        "{}...",
        code.get(..code.floor_char_boundary(MOST))
            .unwrap_or_default()
    ))
}

//! Templates, expressions and their evaluation.

use ecow::EcoString;
use xacro_lsp::base::TextRange;
use xacro_lsp::expr::{
    self, Budget, Code, ErrorKind, EvalError, ExprErrorKind, Host, HostFn, Lookup, Parsed, ScopeId,
    Template, TemplateToken, Value, display,
};

/// A host with a few properties that notes the first name that is missing.
pub struct Properties {
    known: Vec<(&'static str, Value)>,
    missing: Option<String>,
}

impl Properties {
    /// Numbers, a text, a list and a mapping.
    pub fn new() -> Self {
        let list = Value::list_from([3, 1, 2].map(Value::Int), false);
        let mapping = Value::dict_from(
            [("a".into(), Value::Int(1)), ("b".into(), list.clone())],
            true,
        );
        let known = vec![
            ("n", Value::Int(3)),
            ("x", Value::Float(1.5)),
            ("s", "hello world".into()),
            ("l", list),
            ("cfg", mapping),
        ];
        Self {
            known,
            missing: None,
        }
    }
}

impl Host for Properties {
    fn lookup(&mut self, name: &str, _: TextRange) -> Lookup {
        let found = self.known.iter().find(|(known, _)| *known == name);
        found.map_or(Lookup::Missing, |(_, value)| Lookup::Found(value.clone()))
    }

    fn scope_attribute(&mut self, _: ScopeId, name: &str, range: TextRange) -> Lookup {
        self.lookup(name, range)
    }

    fn call(
        &mut self,
        _: HostFn,
        _: &[Value],
        _: &[(EcoString, Value)],
        _: TextRange,
    ) -> Result<Value, EvalError> {
        Ok(Value::None)
    }

    fn deprecated(&mut self, _: &str, _: &str, _: TextRange) {}

    fn undefined(&mut self, name: &str, _: TextRange) {
        self.missing.get_or_insert_with(|| name.to_owned());
    }
}

/// Text with `${}` splits into pieces that cover it; expressions have their places in the text; evaluation ends
/// within its budget.
pub fn expression(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    pieces(&expr::split(&text), &text);
    parsed(&expr::parse(&text), &text);
}

fn pieces(template: &Template, text: &str) {
    let mut at = None;
    for token in &template.tokens {
        let range = token.range();
        assert!(range.end as usize <= text.len(), "{token:?} of {text:?}");
        assert!(
            at.is_none_or(|at| at == range.start),
            "a gap before {token:?} of {text:?}"
        );
        assert!(
            text.is_char_boundary(range.start as usize),
            "{token:?} of {text:?}"
        );
        at = Some(range.end);
        match token {
            TemplateToken::Expr {
                inner,
                code: Code::Static(found),
                ..
            } => parsed(found, inner.slice(text)),
            TemplateToken::Expr {
                code: Code::Dynamic(nested),
                ..
            } => pieces(nested, text),
            TemplateToken::Subst {
                nested: Some(nested),
                ..
            } => pieces(nested, text),
            _ => {}
        }
    }
}

fn parsed(parsed: &Parsed, text: &str) {
    for error in &parsed.errors {
        assert!(
            error.range.end as usize <= text.len(),
            "{error:?} of {text:?}"
        );
        assert!(
            !error.message.is_empty() && !error.message.contains('\n'),
            "{error:?} of {text:?}"
        );
    }
    for used in expr::names(&parsed.expr) {
        assert!(
            used.range.end as usize <= text.len(),
            "{:?} of {text:?}",
            used.range
        );
    }
    if !parsed.errors.is_empty() {
        return;
    }
    let mut budget = Budget::new(20_000, 1 << 20, 200);
    match expr::evaluate(&parsed.expr, &mut Properties::new(), &mut budget) {
        Ok(value) => {
            display::repr(&value);
            display::to_str(&value);
        }
        Err(error) => assert!(
            error.range.end as usize <= text.len(),
            "{error:?} of {text:?}"
        ),
    }
}

/// The `repr` of what an expression gives, or `! ` and the message of the exception; none where a limit of ours is
/// reached or something is not supported.
pub fn outcome(text: &str) -> Option<String> {
    let parsed = expr::parse(text);
    if let Some(error) = parsed.errors.first() {
        return (error.kind != ExprErrorKind::NotSupported)
            .then(|| shown(&format!("! {}", error.reference)));
    }
    let mut host = Properties::new();
    let result = expr::evaluate(&parsed.expr, &mut host, &mut Budget::default());
    if let Some(name) = host.missing {
        return Some(format!("! name '{name}' is not defined"));
    }
    match result {
        Ok(value) => display::repr(&value).map(|text| shown(&text)),
        Err(error) if matches!(error.kind, ErrorKind::Budget | ErrorKind::Recursion) => None,
        Err(error) => Some(shown(&format!("! {}", error.message))),
    }
}

fn shown(text: &str) -> String {
    text.replace('\n', "⏎").replace('\r', "␍")
}

//! Values of properties while somebody types: computed from the texts, as far as that goes.
//!
//! An expansion knows more, but is made only of whole files, and a property that nothing reads yet has no value in
//! it. What depends on a parameter, or on a name with several definitions, is unknown here and shown as nothing.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use vfs::without_parents;

use ecow::EcoString;

use super::scope::{CompletionScope, PropertyInfo};
use crate::host::{self, NameResolver};
use base::FastMap;
use expand::yaml_value;
use expr::{
    self, Code, Lookup, Subst, SubstError, Template, TemplateToken, Value, display, literal,
};

/// Where a property's value stands.
struct PropertySource {
    /// The last definition, by number.
    last: usize,
    /// Another definition says something else.
    ambiguous: bool,
}

/// Evaluates texts of a scope.
pub(super) struct Evaluator<'a> {
    scope: &'a CompletionScope<'a>,
    properties: Vec<PropertyInfo>,
    given: FastMap<EcoString, PropertySource>,
    arguments: FastMap<String, Option<String>>,
    memo: FastMap<String, Value>,
    /// Properties being evaluated.
    open: Vec<String>,
    /// The file that relative names start from.
    file: Arc<Path>,
    /// How many more expressions may be evaluated.
    evaluations: u32,
}

impl<'a> Evaluator<'a> {
    const MOST_EVALUATIONS: u32 = 1000;
    const DEPTH: u32 = 120;
    const LEAST_DEPTH: u32 = 16;
    const MOST_OPEN: usize = 12;

    /// For the place at `offset` of the edited file.
    pub fn new(scope: &'a CompletionScope<'a>, offset: u32) -> Self {
        let mut properties = scope.properties(offset);
        properties.retain(|property| !property.is_block);
        let mut given: FastMap<EcoString, PropertySource> = FastMap::default();
        for (last, property) in properties.iter().enumerate() {
            let known = given.get(&property.name);
            let other = known.and_then(|known| properties.get(known.last));
            let differs = other.is_some_and(|other| other.value() != property.value());
            let ambiguous = differs || known.is_some_and(|known| known.ambiguous);
            given.insert(property.name.clone(), PropertySource { last, ambiguous });
        }
        Self {
            scope,
            properties,
            given,
            arguments: scope.arguments().into_iter().collect(),
            memo: FastMap::default(),
            open: Vec::new(),
            file: scope.sources.source.path.clone(),
            evaluations: Self::MOST_EVALUATIONS,
        }
    }

    /// The value of a property to show: short, and only when there is no doubt about it.
    pub fn shown(&mut self, name: &str) -> Option<String> {
        if self.given.get(name)?.ambiguous {
            return None;
        }
        shown(&self.property(name))
    }

    fn property(&mut self, name: &str) -> Value {
        if let Some(known) = self.memo.get(name) {
            return known.clone();
        }
        let Some(given) = self.given.get(name) else {
            return Value::Unknown;
        };
        if self.open.iter().any(|open| open == name) || self.open.len() >= Self::MOST_OPEN {
            return Value::Unknown;
        }
        let found = self.properties.get(given.last).and_then(|property| {
            let file = self.scope.files.get(property.file)?;
            Some((property.value()?, file.source.path.clone()))
        });
        let Some((text, file)) = found else {
            return Value::Unknown;
        };
        self.open.push(name.to_owned());
        let before = std::mem::replace(&mut self.file, file);
        let value = match literal::from_text(&text) {
            Value::Str(text) => self.text(&text),
            value => value,
        };
        self.file = before;
        self.open.pop();
        self.memo.insert(name.to_owned(), value.clone());
        value
    }

    /// The value of a text with expressions.
    pub fn text(&mut self, text: &str) -> Value {
        let value = self.template(text, &expr::split(text));
        match value {
            Value::Str(text) => literal::from_text(&text),
            value => value,
        }
    }

    /// The value of an expression.
    pub fn code(&mut self, code: &str) -> Value {
        let parsed = expr::parse(code);
        if !parsed.errors.is_empty() {
            return Value::Unknown;
        }
        let Some(left) = self.evaluations.checked_sub(1) else {
            return Value::Unknown;
        };
        self.evaluations = left;
        // a property may be read inside of another one's evaluation: all of them share the stack
        let depth = (Self::DEPTH >> self.open.len().min(8)).max(Self::LEAST_DEPTH);
        host::evaluate(&parsed.expr, self, depth)
    }

    /// The text of a template, as far as all of it is known.
    pub fn string(&mut self, text: &str) -> Option<String> {
        let value = self.template(text, &expr::split(text));
        display::to_str(&value).map(|text| text.to_string())
    }

    fn template(&mut self, text: &str, template: &Template) -> Value {
        let mut result = String::new();
        for token in &template.tokens {
            let value = match token {
                TemplateToken::Text(range) | TemplateToken::Escape(range) => {
                    Value::str(range.slice(text))
                }
                TemplateToken::Expr {
                    inner,
                    code: Code::Static(_),
                    ..
                } => self.code(inner.slice(text)),
                TemplateToken::Expr {
                    code: Code::Dynamic(nested),
                    ..
                } => match self.template(text, nested) {
                    Value::Str(code) => self.code(&code),
                    _ => Value::Unknown,
                },
                TemplateToken::Subst {
                    inner,
                    nested: None,
                    ..
                } => self.substitution(inner.slice(text)),
                TemplateToken::Subst {
                    nested: Some(nested),
                    ..
                } => match self.template(text, nested) {
                    Value::Str(inner) => self.substitution(&inner),
                    _ => Value::Unknown,
                },
                TemplateToken::Invalid { .. } => Value::Unknown,
            };
            if template.tokens.len() == 1 {
                return value;
            }
            match display::to_str(&value) {
                Some(part) => result.push_str(&part),
                None => return Value::Unknown,
            }
        }
        Value::str(result)
    }

    fn substitution(&mut self, inner: &str) -> Value {
        let found = expr::resolve_substitution(inner, |subst| match subst {
            Subst::Arg(word) => self
                .argument(&word.text)
                .ok_or_else(|| SubstError::new("unknown")),
            Subst::Find(word) => {
                let found = self.scope.sources.packages.find(&word.text, &self.file);
                let path = found
                    .ok()
                    .and_then(|found| Some(EcoString::from(found.path.to_str()?)));
                path.ok_or_else(|| SubstError::new("unknown"))
            }
            Subst::Eval { code } => {
                let value = self.code(code.slice(inner));
                display::to_str(&value).ok_or_else(|| SubstError::new("unknown"))
            }
            _ => Err(SubstError::new("unknown")),
        });
        found.map_or(Value::Unknown, Value::Str)
    }

    fn argument(&mut self, name: &str) -> Option<EcoString> {
        let text = self.arguments.get(name)?.clone()?;
        if !text.contains('$') {
            return Some(text.into());
        }
        let key = format!("$(arg {name})");
        if self.open.contains(&key) || self.open.len() >= Self::MOST_OPEN {
            return None;
        }
        self.open.push(key);
        let text = self.string(&text);
        self.open.pop();
        text.map(EcoString::from)
    }

    /// The path of a file that an expression names.
    pub fn path(&self, name: &str) -> PathBuf {
        let folder = self.file.parent().unwrap_or(&self.file);
        without_parents(&folder.join(name))
    }
}

impl NameResolver for Evaluator<'_> {
    fn name(&mut self, name: &str) -> Lookup {
        if self.given.contains_key(name) {
            Lookup::Found(self.property(name))
        } else if expr::is_global_symbol(name) {
            Lookup::Missing
        } else {
            Lookup::Found(self.argument(name).map_or(Value::Unknown, |text| {
                // only `$(eval)` sees arguments as names; elsewhere such a name is an error anyway
                literal::from_text(&text)
            }))
        }
    }

    fn member(&mut self, _: &str) -> Lookup {
        Lookup::Missing
    }

    fn argument_value(&mut self, name: &str) -> Value {
        self.argument(name).map_or(Value::Unknown, Value::Str)
    }

    fn yaml(&mut self, args: &[Value]) -> Value {
        let [Value::Str(name)] = args else {
            return Value::Unknown;
        };
        let path = self.path(name);
        if !self.scope.may_list(path.parent().unwrap_or(&path)) {
            return Value::Unknown;
        }
        let Ok(file) = self.scope.sources.vfs.yaml(&path, name) else {
            return Value::Unknown;
        };
        let Ok(node) = &file.value else {
            return Value::Unknown;
        };
        yaml_value(node, &mut host::budget(Self::DEPTH)).unwrap_or(Value::Unknown)
    }
}

/// A value in a few characters; none when it is not known.
pub(super) fn shown(value: &Value) -> Option<String> {
    const MOST: usize = 40;
    let text = match value {
        Value::Unknown => return None,
        Value::Str(text) => format!("'{text}'"),
        Value::Lambda(_) | Value::Builtin(_) | Value::Method(_) => "function".to_owned(),
        Value::Dict(dict) => match dict.len() {
            1 => "1 key".to_owned(),
            count => format!("{count} keys"),
        },
        other => display::repr(other)?.to_string(),
    };
    Some(super::item::shortened(&text, MOST))
}

/// The keys of a value that has some, with what they stand for.
pub(super) fn keys(value: &Value) -> Vec<(Value, Option<String>)> {
    match value {
        Value::Dict(dict) => dict
            .entries()
            .into_iter()
            .map(|(key, value)| (key, shown(&value)))
            .collect(),
        _ => Vec::new(),
    }
}

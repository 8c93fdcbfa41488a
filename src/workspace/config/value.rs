//! Values with places, from TOML or JSON.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use base::TextRange;

/// A value and where it stands.
#[derive(Clone, Debug)]
pub(super) struct ConfigValue {
    pub(super) kind: ValueKind,
    pub(super) range: TextRange,
}

/// Kinds of values.
#[derive(Clone, Debug)]
pub(super) enum ValueKind {
    Text(String),
    /// A whole number, `None` when it is too large.
    Int(Option<i64>),
    /// A number and its text.
    Float(f64, String),
    Bool(bool),
    List(Vec<ConfigValue>),
    Table(Vec<ConfigEntry>),
    /// A date, or the `null` of JSON.
    Other(&'static str),
}

/// A key and its value.
#[derive(Clone, Debug)]
pub(super) struct ConfigEntry {
    pub(super) key: String,
    pub(super) key_range: TextRange,
    pub(super) value: ConfigValue,
}

impl ConfigValue {
    /// What it is, with article.
    pub(super) fn what(&self) -> &'static str {
        match self.kind {
            ValueKind::Text(_) => "a string",
            ValueKind::Int(_) => "an integer",
            ValueKind::Float(..) => "a number",
            ValueKind::Bool(_) => "a boolean",
            ValueKind::List(_) => "a list",
            ValueKind::Table(_) => "a table",
            ValueKind::Other(what) => what,
        }
    }
}

impl ConfigValue {
    /// The value as JSON has it.
    pub(super) fn json(&self) -> serde_json::Value {
        match &self.kind {
            ValueKind::Text(text) => text.as_str().into(),
            ValueKind::Int(value) => (*value).into(),
            ValueKind::Float(value, _) => (*value).into(),
            ValueKind::Bool(value) => (*value).into(),
            ValueKind::List(items) => items.iter().map(Self::json).collect(),
            ValueKind::Table(entries) => {
                let fields = entries
                    .iter()
                    .map(|entry| (entry.key.clone(), entry.value.json()));
                serde_json::Value::Object(fields.collect())
            }
            ValueKind::Other(_) => serde_json::Value::Null,
        }
    }
}

fn text_range(range: std::ops::Range<usize>) -> TextRange {
    let [start, end] = [range.start, range.end].map(|at| u32::try_from(at).unwrap_or(u32::MAX));
    TextRange::new(start, end)
}

/// The table of a TOML text and what is wrong with it.
pub(super) fn from_toml(text: &str) -> (Vec<ConfigEntry>, Vec<(String, TextRange)>) {
    let (table, errors) = DeTable::parse_recoverable(text);
    let errors = errors.iter().map(|error| {
        let range = error.span().map(text_range).unwrap_or_default();
        (
            error.message().lines().collect::<Vec<_>>().join(", "),
            range,
        )
    });
    (entries(table.get_ref()), errors.collect())
}

/// The entries of a table, in order of the text.
fn entries(table: &DeTable<'_>) -> Vec<ConfigEntry> {
    let mut entries: Vec<ConfigEntry> = table
        .iter()
        .map(|(key, value)| ConfigEntry {
            key: key.get_ref().to_string(),
            key_range: text_range(key.span()),
            value: toml_value(value),
        })
        .collect();
    entries.sort_by_key(|entry| entry.key_range.start);
    entries
}

fn toml_value(value: &Spanned<DeValue<'_>>) -> ConfigValue {
    let kind = match value.get_ref() {
        DeValue::String(text) => ValueKind::Text(text.to_string()),
        DeValue::Integer(digits) => {
            ValueKind::Int(i64::from_str_radix(digits.as_str(), digits.radix()).ok())
        }
        DeValue::Float(digits) => ValueKind::Float(
            digits.as_str().parse().unwrap_or(f64::NAN),
            digits.as_str().to_owned(),
        ),
        DeValue::Boolean(value) => ValueKind::Bool(*value),
        DeValue::Datetime(_) => ValueKind::Other("a date"),
        DeValue::Array(items) => ValueKind::List(items.iter().map(toml_value).collect()),
        DeValue::Table(table) => ValueKind::Table(entries(table)),
    };
    ConfigValue {
        kind,
        range: text_range(value.span()),
    }
}

/// The settings of an editor in the form of the file: `format.lineWidth` and `{format: {lineWidth}}`
/// become `line-width` in the table `format`. Keys below `free` are names of the user and stay.
pub(super) fn from_settings(settings: &serde_json::Value, free: &[&str]) -> Vec<ConfigEntry> {
    let mut entries = Vec::new();
    for (key, value) in settings.as_object().into_iter().flatten() {
        let mut parts = key.split('.').map(kebab_case);
        let first = parts.next().unwrap_or_default();
        let rest: Vec<String> = parts.collect();
        let is_free = free.contains(&first.as_str());
        let mut value = json_value(value, is_free);
        for key in rest.into_iter().rev() {
            value = ConfigValue {
                kind: ValueKind::Table(vec![entry(key, value)]),
                range: TextRange::default(),
            };
        }
        insert(&mut entries, entry(first, value));
    }
    entries
}

fn entry(key: String, value: ConfigValue) -> ConfigEntry {
    ConfigEntry {
        key,
        key_range: TextRange::default(),
        value,
    }
}

/// Add an entry; the tables of equal keys become one.
fn insert(entries: &mut Vec<ConfigEntry>, new: ConfigEntry) {
    let same = entries.iter_mut().find(|entry| entry.key == new.key);
    match (same.map(|entry| &mut entry.value.kind), new.value.kind) {
        (Some(ValueKind::Table(old)), ValueKind::Table(more)) => {
            for entry in more {
                insert(old, entry);
            }
        }
        (Some(old), kind) => *old = kind,
        (None, kind) => entries.push(ConfigEntry {
            value: ConfigValue { kind, ..new.value },
            ..new
        }),
    }
}

fn json_value(value: &serde_json::Value, keep_keys: bool) -> ConfigValue {
    use serde_json::Value as Json;
    let kind = match value {
        Json::Null => ValueKind::Other("null"),
        Json::Bool(value) => ValueKind::Bool(*value),
        Json::Number(number) => match number.as_i64() {
            Some(value) => ValueKind::Int(Some(value)),
            None if number.is_u64() => ValueKind::Int(None),
            None => ValueKind::Float(number.as_f64().unwrap_or(f64::NAN), number.to_string()),
        },
        Json::String(text) => ValueKind::Text(text.clone()),
        Json::Array(items) => ValueKind::List(
            items
                .iter()
                .map(|item| json_value(item, keep_keys))
                .collect(),
        ),
        Json::Object(fields) => {
            let key = |key: &String| {
                if keep_keys {
                    key.clone()
                } else {
                    kebab_case(key)
                }
            };
            let fields = fields
                .iter()
                .map(|(name, value)| entry(key(name), json_value(value, keep_keys)));
            ValueKind::Table(fields.collect())
        }
    };
    ConfigValue {
        kind,
        range: TextRange::default(),
    }
}

/// `lineWidth` as `line-width`, `fileMB` as `file-mb`.
fn kebab_case(key: &str) -> String {
    let mut out = String::new();
    let mut after_lower = false;
    for c in key.chars() {
        if c.is_uppercase() && after_lower {
            out.push('-');
        }
        after_lower = !c.is_uppercase();
        out.extend(c.to_lowercase());
    }
    out
}

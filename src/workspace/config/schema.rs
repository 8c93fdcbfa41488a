//! The JSON schema of the configuration file, made from the table of keys.

use serde_json::{Map, Value, json};

use super::Config;
use super::keys::{ConfigKey, KeyType};
use super::settings::ConfigTable;

/// A JSON schema (draft 7) that completes and checks `xacro-lint.toml` in editors.
pub fn schema() -> Value {
    let mut schema = table(Config::KEYS);
    if let Some(fields) = schema.as_object_mut() {
        fields.insert(
            "$schema".to_owned(),
            json!("http://json-schema.org/draft-07/schema#"),
        );
        fields.insert("title".to_owned(), json!("xacro-lint.toml"));
    }
    schema
}

fn table(keys: &[ConfigKey]) -> Value {
    let properties: Map<String, Value> = keys
        .iter()
        .map(|key| {
            let mut of = type_schema(key.of);
            if let Some(fields) = of.as_object_mut() {
                fields.insert("description".to_owned(), json!(key.doc));
            }
            (key.name.to_owned(), of)
        })
        .collect();
    json!({ "type": "object", "additionalProperties": false, "properties": properties })
}

fn type_schema(of: KeyType) -> Value {
    match of {
        KeyType::Text => json!({ "type": "string" }),
        KeyType::Choice(choices) => json!({ "type": "string", "enum": choices }),
        KeyType::Texts => json!({ "type": "array", "items": { "type": "string" } }),
        KeyType::Choices(choices) => {
            json!({ "type": "array", "items": { "type": "string", "enum": choices } })
        }
        KeyType::Bool => json!({ "type": "boolean" }),
        KeyType::Count(u64::MAX) => json!({ "type": "integer", "minimum": 1 }),
        KeyType::Count(most) => json!({ "type": "integer", "minimum": 1, "maximum": most }),
        KeyType::Keys(keys) => table(keys),
        KeyType::Tables(keys) => json!({ "type": "array", "items": table(keys) }),
        KeyType::Map(of) => json!({ "type": "object", "additionalProperties": type_schema(*of) }),
        KeyType::Number => json!({ "type": "number" }),
        KeyType::Argument => json!({ "type": ["string", "number", "boolean"] }),
        KeyType::Arguments => {
            let one = type_schema(KeyType::Argument);
            json!({ "anyOf": [one, { "type": "array", "items": one }] })
        }
        KeyType::List(of) => json!({ "type": "array", "items": type_schema(*of) }),
        KeyType::Whole => json!({ "type": "integer", "minimum": 0 }),
    }
}

//! The JSON schema of the configuration file, made from the table of keys.

use serde_json::{Map, Value, json};

use super::Config;
use super::keys::{Key, Type};
use super::settings::Table;

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

fn table(keys: &[Key]) -> Value {
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

fn type_schema(of: Type) -> Value {
    match of {
        Type::Text => json!({ "type": "string" }),
        Type::Choice(choices) => json!({ "type": "string", "enum": choices }),
        Type::Texts => json!({ "type": "array", "items": { "type": "string" } }),
        Type::Choices(choices) => {
            json!({ "type": "array", "items": { "type": "string", "enum": choices } })
        }
        Type::Bool => json!({ "type": "boolean" }),
        Type::Count(u64::MAX) => json!({ "type": "integer", "minimum": 1 }),
        Type::Count(most) => json!({ "type": "integer", "minimum": 1, "maximum": most }),
        Type::Keys(keys) => table(keys),
        Type::Tables(keys) => json!({ "type": "array", "items": table(keys) }),
        Type::Map(of) => json!({ "type": "object", "additionalProperties": type_schema(*of) }),
        Type::Number => json!({ "type": "number" }),
        Type::Argument => json!({ "type": ["string", "number", "boolean"] }),
        Type::Arguments => {
            let one = type_schema(Type::Argument);
            json!({ "anyOf": [one, { "type": "array", "items": one }] })
        }
        Type::List(of) => json!({ "type": "array", "items": type_schema(*of) }),
        Type::Whole => json!({ "type": "integer", "minimum": 0 }),
    }
}

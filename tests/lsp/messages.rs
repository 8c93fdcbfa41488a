//! Messages of the client: how they are read and merged, and the capabilities that the first of them names.

use std::io::BufRead;

use serde_json::{Value, json};

/// What editors can do that the tests speak for.
pub fn usual() -> Value {
    let formats = json!(["markdown", "plaintext"]);
    json!({
        "workspace": { "applyEdit": true },
        "textDocument": {
            "definition": { "linkSupport": true },
            "declaration": { "linkSupport": true },
            "typeDefinition": { "linkSupport": true },
            "implementation": { "linkSupport": true },
            "hover": { "contentFormat": formats },
            "completion": { "completionItem": { "documentationFormat": formats } },
            "signatureHelp": { "signatureInformation": { "documentationFormat": formats } },
            "documentSymbol": { "hierarchicalDocumentSymbolSupport": true },
            "codeAction": { "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } } },
            "rename": { "prepareSupport": true },
        },
        "experimental": { "xacro": { "contextChanged": true, "lensCommands": true, "expandedDocuments": true } },
    })
}

/// Take away what a pointer names.
pub fn remove(from: &mut Value, pointer: &str) {
    match pointer.rsplit_once('/') {
        None => *from = json!({}),
        Some((parent, key)) => {
            let parent = from
                .pointer_mut(parent)
                .and_then(Value::as_object_mut)
                .expect("an object there");
            parent.remove(key).expect("it is there");
        }
    }
}

pub fn merge(into: &mut Value, from: &Value) {
    match (into, from) {
        (Value::Object(into), Value::Object(from)) => {
            for (key, value) in from {
                merge(into.entry(key.clone()).or_insert(Value::Null), value);
            }
        }
        (_, Value::Null) => {}
        (into, from) => *into = from.clone(),
    }
}

pub fn read(output: &mut impl BufRead) -> Option<Value> {
    let mut length = None;
    loop {
        let mut line = String::new();
        if output.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim() {
            "" => break,
            header => {
                let value = header.strip_prefix("Content-Length: ").map(str::parse);
                length = value.map(Result::unwrap).or(length);
            }
        }
    }
    let mut body = vec![0; length.unwrap()];
    output.read_exact(&mut body).ok()?;
    Some(serde_json::from_slice(&body).unwrap())
}

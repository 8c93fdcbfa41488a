//! Messages as they arrive: forgiving about headers and bodies, so that one bad message is not the end.
//!
//! What is a message goes on to the service, with a plain header. What is none is said to be so in the log.
use std::borrow::Cow;
use std::io::{BufRead, Read};

use serde::de::IgnoredAny;
use serde::{Deserialize, Deserializer};
use serde_json::{Value, json};
use tower_lsp::jsonrpc::{Request, Response};

use base::limits::{HEADER_BYTES, MESSAGE_BYTES};

/// Our own notification about what was no message.
pub(super) const BAD_MESSAGE: &str = "xacro/badMessage";

/// A message from the client.
pub(super) enum Incoming {
    /// A request or a notification.
    Request(Request),
    /// The answer to a request of ours.
    Response(Response),
}

/// What changes the text of a document.
pub(super) const EDIT: &str = "textDocument/didChange";

/// What stands for a version where a client gives none: the types that read it want one.
pub(super) const NO_VERSION: i32 = i32::MIN;

/// Hand on messages until the input ends, or until `take` wants no more.
pub(super) fn read(input: impl BufRead, mut take: impl FnMut(Incoming) -> bool) {
    bodies(input, |body, is_reply| take(message(&body, is_reply)));
}

/// The message that a body is, repaired where it can be.
pub(super) fn of_body(body: &[u8]) -> Incoming {
    let (body, is_reply) = checked(body);
    message(&body, is_reply)
}

/// A body with a plain header.
pub(super) fn framed(body: &[u8]) -> Vec<u8> {
    let mut message = format!("Content-Length: {}\r\n\r\n", body.len()).into_bytes();
    message.extend_from_slice(body);
    message
}

/// Hand on the bodies of messages, repaired where they can be, and whether they are replies.
pub(super) fn bodies(mut input: impl BufRead, mut take: impl FnMut(Cow<'_, [u8]>, bool) -> bool) {
    while let Some(length) = next_length(&mut input) {
        let mut body = Vec::new();
        // grows as bytes arrive: a header that claims much costs nothing
        let read = input.by_ref().take(length).read_to_end(&mut body);
        if read.is_err() || (body.len() as u64) < length {
            return;
        }
        let (body, is_reply) = checked(&body);
        if !take(body, is_reply) {
            return;
        }
    }
}

/// What a body that was checked says.
fn message(body: &[u8], is_reply: bool) -> Incoming {
    let read = if is_reply {
        serde_json::from_slice(body).map(Incoming::Response)
    } else {
        serde_json::from_slice(body).map(Incoming::Request)
    };
    read.unwrap_or_else(|error| {
        let params = json!({ "reason": error.to_string() });
        Incoming::Request(Request::build(BAD_MESSAGE).params(params).finish())
    })
}

/// The length that the next header names; what is no header is passed over. None at the end of the input.
fn next_length(input: &mut impl BufRead) -> Option<u64> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        let read = input.take(HEADER_BYTES).read_until(b'\n', &mut line).ok()?;
        if read == 0 {
            return None;
        }
        let line = String::from_utf8_lossy(&line);
        match (line.trim(), length) {
            ("", Some(length)) => return Some(length),
            (header, _) => length = length_of(header).or(length),
        }
    }
}

fn length_of(header: &str) -> Option<u64> {
    let (name, value) = header.split_once(':')?;
    let length = value
        .trim()
        .parse()
        .ok()
        .filter(|&length| length <= MESSAGE_BYTES);
    length.filter(|_| name.trim().eq_ignore_ascii_case("content-length"))
}

/// What tells a message from other JSON.
#[derive(Deserialize)]
struct Head<'a> {
    #[serde(borrow)]
    jsonrpc: Option<Cow<'a, str>>,
    #[serde(borrow)]
    method: Option<Cow<'a, str>>,
    id: Option<Value>,
    #[serde(default, deserialize_with = "is_there")]
    result: bool,
    #[serde(default, deserialize_with = "is_there")]
    error: bool,
}

/// Whether a field is there: `null` is a result like any other.
fn is_there<'de, D: Deserializer<'de>>(field: D) -> Result<bool, D::Error> {
    IgnoredAny::deserialize(field).map(|_| true)
}

/// The body, repaired where it can be, and whether it is a reply; a note about it where it is no message.
fn checked(body: &[u8]) -> (Cow<'_, [u8]>, bool) {
    // what is no UTF-8 would be refused later, without an answer
    let repaired = match String::from_utf8_lossy(body) {
        Cow::Borrowed(text) => without_lone_surrogates(text.as_bytes()),
        Cow::Owned(text) => Cow::Owned(without_lone_surrogates(text.as_bytes()).into_owned()),
    };
    let head = match serde_json::from_slice::<Head<'_>>(&repaired) {
        Ok(head) => head,
        Err(error) => return bad(&error.to_string()),
    };
    let id_fits = head
        .id
        .as_ref()
        .is_none_or(|id| id.is_string() || id.is_i64() || id.is_null());
    let is_reply = head.method.is_none() && head.id.is_some() && (head.result || head.error);
    if head.jsonrpc.as_deref() != Some("2.0") || !id_fits || !(head.method.is_some() || is_reply) {
        return bad("not a JSON-RPC 2.0 message");
    }
    match (head.method.as_deref(), &head.id) {
        // some clients send `null` for no parameters, which the service would refuse
        (Some("shutdown"), Some(id)) => {
            written(json!({ "jsonrpc": "2.0", "id": id, "method": "shutdown" }))
        }
        (Some("initialize"), Some(_)) => (with_our_name_of_diagnostics(repaired), false),
        (Some(EDIT | "textDocument/didOpen"), None) => (with_a_version(repaired), false),
        (Some("exit"), _) => written(json!({ "jsonrpc": "2.0", "method": "exit" })),
        // requests with `$/` that are not known must be answered all the same
        (Some(method), Some(id)) if method.starts_with("$/") => {
            written(json!({ "jsonrpc": "2.0", "id": id, "method": format!("unknown{method}") }))
        }
        _ => (repaired, is_reply),
    }
}

/// A note about what is no message.
fn bad(reason: &str) -> (Cow<'static, [u8]>, bool) {
    written(json!({ "jsonrpc": "2.0", "method": BAD_MESSAGE, "params": { "reason": reason } }))
}

/// The body of a message that is no reply.
fn written(message: Value) -> (Cow<'static, [u8]>, bool) {
    (Cow::Owned(message.to_string().into_bytes()), false)
}

/// The protocol says `workspace.diagnostics`; the types that read it say `diagnostic`.
fn with_our_name_of_diagnostics(body: Cow<'_, [u8]>) -> Cow<'_, [u8]> {
    let Ok(mut message) = serde_json::from_slice::<Value>(&body) else {
        return body;
    };
    let workspace = message
        .pointer_mut("/params/capabilities/workspace")
        .and_then(Value::as_object_mut);
    match workspace.and_then(|workspace| Some((workspace.remove("diagnostics")?, workspace))) {
        Some((diagnostics, workspace)) => {
            workspace.insert("diagnostic".to_owned(), diagnostics);
            Cow::Owned(message.to_string().into_bytes())
        }
        None => body,
    }
}

/// A note about a text with a version, though old clients and small scripts give none or `null`.
fn with_a_version(body: Cow<'_, [u8]>) -> Cow<'_, [u8]> {
    #[derive(Deserialize)]
    struct Note {
        params: VersionedParams,
    }
    #[derive(Deserialize)]
    #[serde(rename_all = "camelCase")]
    struct VersionedParams {
        text_document: Versioned,
    }
    #[derive(Deserialize)]
    struct Versioned {
        version: i32,
    }
    let given = serde_json::from_slice::<Note>(&body).map(|note| note.params.text_document.version);
    if given.is_ok() {
        return body;
    }
    let Ok(mut message) = serde_json::from_slice::<Value>(&body) else {
        return body;
    };
    match message
        .pointer_mut("/params/textDocument")
        .and_then(Value::as_object_mut)
    {
        Some(document) => document.insert("version".to_owned(), NO_VERSION.into()),
        None => return body,
    };
    Cow::Owned(message.to_string().into_bytes())
}

/// JSON in which halves of surrogate pairs that stand alone are replaced: editors cut text anywhere.
fn without_lone_surrogates(body: &[u8]) -> Cow<'_, [u8]> {
    const REPLACEMENT: &[u8; 6] = br"\ufffd";
    let mut repaired: Option<Vec<u8>> = None;
    let mut at = 0;
    while let Some(found) = memchr::memchr(b'\\', body.get(at..).unwrap_or_default()) {
        let start = at + found;
        let high = unit(body, start).filter(|unit| (0xD800..0xDC00).contains(unit));
        let follows = unit(body, start + 6).is_some_and(|unit| (0xDC00..0xE000).contains(&unit));
        at = match unit(body, start) {
            Some(_) if high.is_some() && follows => start + 12,
            Some(unit) if (0xD800..0xE000).contains(&unit) => {
                let repaired = repaired.get_or_insert_with(|| body.to_vec());
                repaired.splice(start..start + 6, REPLACEMENT.iter().copied());
                start + 6
            }
            Some(_) => start + 6,
            None => start + 2,
        };
    }
    repaired.map_or(Cow::Borrowed(body), Cow::Owned)
}

/// The unit that an escape `\uXXXX` at `at` stands for.
fn unit(body: &[u8], at: usize) -> Option<u32> {
    let digits = body.get(at..at + 6)?.strip_prefix(br"\u")?;
    u32::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pumped(input: &str) -> String {
        String::from_utf8(super::super::reframe(input.as_bytes())).unwrap()
    }

    #[test]
    fn headers_in_every_form_and_junk_between_messages() {
        let body = r#"{"jsonrpc":"2.0","method":"x"}"#;
        let plain = format!("Content-Length: {}\r\n\r\n{body}", body.len());
        for header in [
            "content-length:30\r\n\r\n",
            "Content-Type: a\r\nContent-Length: 30\n\n",
            "junk\r\nContent-Length: 30\r\n\r\n",
        ] {
            assert_eq!(pumped(&format!("{header}{body}")), plain, "{header}");
        }
        assert_eq!(pumped("Content-Length: 99999999999999\r\n\r\n"), "");
    }

    #[test]
    fn what_is_no_message_is_said_to_be_none() {
        for body in [
            "{not json",
            "42",
            "[]",
            "{}",
            r#"{"jsonrpc":"1.0","method":"x"}"#,
            r#"{"jsonrpc":"2.0","id":{},"method":"x"}"#,
        ] {
            let passed = pumped(&format!("Content-Length: {}\r\n\r\n{body}", body.len()));
            assert!(passed.contains(BAD_MESSAGE), "{body}: {passed}");
        }
    }

    #[test]
    fn what_is_no_utf_8_is_replaced() {
        let (body, _) =
            checked(b"{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"x\",\"params\":[\"\xe4\"]}");
        assert_eq!(
            std::str::from_utf8(&body).unwrap(),
            "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"x\",\"params\":[\"\u{fffd}\"]}"
        );
    }

    #[test]
    fn replies_may_say_nothing() {
        let body = r#"{"jsonrpc":"2.0","result":null,"id":0}"#;
        let plain = format!("Content-Length: {}\r\n\r\n{body}", body.len());
        assert_eq!(pumped(&plain), plain);
    }

    #[test]
    fn lone_surrogates_are_replaced() {
        let repair = |text: &str| {
            String::from_utf8(without_lone_surrogates(text.as_bytes()).into_owned()).unwrap()
        };
        assert_eq!(repair(r#""a\ud800b""#), r#""a\ufffdb""#);
        assert_eq!(
            repair(r#""\ude00\ud83d\ude00\\ud800""#),
            r#""\ufffd\ud83d\ude00\\ud800""#
        );
    }
}

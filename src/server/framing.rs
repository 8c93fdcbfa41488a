//! Messages as they arrive: forgiving about headers and bodies, so that one bad message is not the end.
//!
//! What is a message goes on to the service, with a plain header. What is none is said to be so in the log.

use crate::base::limits::{HEADER_BYTES, MESSAGE_BYTES};
use std::borrow::Cow;

use serde::de::IgnoredAny;
use serde::{Deserialize, Deserializer};
use serde_json::{Value, json};
use tokio::io::{AsyncBufReadExt, AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt, BufReader};

/// Our own notification about what was no message.
pub(super) const BAD_MESSAGE: &str = "xacro/badMessage";

/// Pass messages on until the input ends.
///
/// `announce` is called for each edit before it is passed on.
pub(super) async fn pump(
    input: impl AsyncRead + Unpin,
    mut output: impl AsyncWrite + Unpin,
    announce: impl Fn(),
) {
    let mut input = BufReader::with_capacity(1 << 14, input);
    while let Some(length) = next_length(&mut input).await {
        let mut body = Vec::new();
        // grows as bytes arrive: a header that claims much costs nothing
        let read = (&mut input).take(length).read_to_end(&mut body).await;
        if read.is_err() || (body.len() as u64) < length {
            return;
        }
        let (body, is_edit) = checked(&body);
        if is_edit {
            announce();
        }
        let header = format!("Content-Length: {}\r\n\r\n", body.len());
        if output.write_all(header.as_bytes()).await.is_err() || output.write_all(&body).await.is_err() {
            return;
        }
    }
}

/// The length that the next header names; what is no header is passed over. None at the end of the input.
async fn next_length(input: &mut (impl AsyncBufReadExt + Unpin)) -> Option<u64> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        let read = input.take(HEADER_BYTES).read_until(b'\n', &mut line).await.ok()?;
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
    let length = value.trim().parse().ok().filter(|&length| length <= MESSAGE_BYTES);
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

/// The body, mended where it can be, and whether it is an edit; a note about it where it is no message.
fn checked(body: &[u8]) -> (Vec<u8>, bool) {
    let mended = without_lone_surrogates(body);
    let bad =
        |reason: String| json!({ "jsonrpc": "2.0", "method": BAD_MESSAGE, "params": { "reason": reason } });
    let head = match serde_json::from_slice::<Head<'_>>(&mended) {
        Ok(head) => head,
        Err(error) => return (bad(error.to_string()).to_string().into_bytes(), false),
    };
    let id_fits = head.id.as_ref().is_none_or(|id| id.is_string() || id.is_i64() || id.is_null());
    let is_reply = head.method.is_none() && head.id.is_some() && (head.result || head.error);
    if head.jsonrpc.as_deref() != Some("2.0") || !id_fits || !(head.method.is_some() || is_reply) {
        return (bad("it is no message of JSON-RPC 2.0".to_owned()).to_string().into_bytes(), false);
    }
    let is_edit = head.method.as_deref() == Some("textDocument/didChange");
    let body = match (head.method.as_deref(), &head.id) {
        // some clients send `null` for no parameters, which the service would refuse
        (Some("shutdown"), Some(id)) => {
            json!({ "jsonrpc": "2.0", "id": id, "method": "shutdown" }).to_string().into_bytes()
        }
        (Some("initialize"), Some(_)) => with_our_name_of_diagnostics(mended),
        (Some("exit"), _) => json!({ "jsonrpc": "2.0", "method": "exit" }).to_string().into_bytes(),
        // requests with `$/` that are not known must be answered all the same
        (Some(method), Some(id)) if method.starts_with("$/") => {
            json!({ "jsonrpc": "2.0", "id": id, "method": format!("unknown{method}") })
                .to_string()
                .into_bytes()
        }
        _ => mended.into_owned(),
    };
    (body, is_edit)
}

/// The protocol says `workspace.diagnostics`; the types that read it say `diagnostic`.
fn with_our_name_of_diagnostics(body: Cow<'_, [u8]>) -> Vec<u8> {
    let Ok(mut message) = serde_json::from_slice::<Value>(&body) else { return body.into_owned() };
    let workspace = message.pointer_mut("/params/capabilities/workspace").and_then(Value::as_object_mut);
    match workspace.and_then(|workspace| Some((workspace.remove("diagnostics")?, workspace))) {
        Some((diagnostics, workspace)) => {
            workspace.insert("diagnostic".to_owned(), diagnostics);
            message.to_string().into_bytes()
        }
        None => body.into_owned(),
    }
}

/// JSON in which halves of surrogate pairs that stand alone are replaced: editors cut text anywhere.
fn without_lone_surrogates(body: &[u8]) -> Cow<'_, [u8]> {
    const REPLACEMENT: &[u8; 6] = br"\ufffd";
    let mut mended: Option<Vec<u8>> = None;
    let mut at = 0;
    while let Some(found) = memchr::memchr(b'\\', body.get(at..).unwrap_or_default()) {
        let start = at + found;
        let high = unit(body, start).filter(|unit| (0xD800..0xDC00).contains(unit));
        let follows = unit(body, start + 6).is_some_and(|unit| (0xDC00..0xE000).contains(&unit));
        at = match unit(body, start) {
            Some(_) if high.is_some() && follows => start + 12,
            Some(unit) if (0xD800..0xE000).contains(&unit) => {
                let mended = mended.get_or_insert_with(|| body.to_vec());
                mended.splice(start..start + 6, REPLACEMENT.iter().copied());
                start + 6
            }
            Some(_) => start + 6,
            None => start + 2,
        };
    }
    mended.map_or(Cow::Borrowed(body), Cow::Owned)
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
        let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
        let mut output = Vec::new();
        runtime.block_on(pump(input.as_bytes(), &mut output, || ()));
        String::from_utf8(output).unwrap()
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
    fn replies_may_say_nothing() {
        let body = r#"{"jsonrpc":"2.0","result":null,"id":0}"#;
        let plain = format!("Content-Length: {}\r\n\r\n{body}", body.len());
        assert_eq!(pumped(&plain), plain);
    }

    #[test]
    fn lone_surrogates_are_replaced() {
        let mend =
            |text: &str| String::from_utf8(without_lone_surrogates(text.as_bytes()).into_owned()).unwrap();
        assert_eq!(mend(r#""a\ud800b""#), r#""a\ufffdb""#);
        assert_eq!(mend(r#""\ude00\ud83d\ude00\\ud800""#), r#""\ufffd\ud83d\ude00\\ud800""#);
    }
}

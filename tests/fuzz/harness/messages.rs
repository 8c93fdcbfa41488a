//! Messages of the protocol as they arrive.

use xacro_lsp::server;

/// Whatever arrives: what goes on to the service is a row of messages of JSON-RPC with plain headers.
pub fn messages(data: &[u8]) {
    let mut rest = &*server::reframe(data);
    while !rest.is_empty() {
        let text = String::from_utf8_lossy(rest);
        let (header, _) = text.split_once("\r\n\r\n").expect("a header");
        let length: usize = header
            .strip_prefix("Content-Length: ")
            .expect("a length")
            .parse()
            .expect("a number");
        let start = header.len() + 4;
        let body = rest.get(start..start + length).expect("as long as it says");
        let message: serde_json::Value = serde_json::from_slice(body).expect("JSON");
        assert_eq!(message["jsonrpc"], "2.0", "{message}");
        assert!(
            message["method"].is_string()
                || !message["id"].is_null()
                || message.get("result").is_some()
        );
        rest = &rest[start + length..];
    }
}

//! Which requests are answered at all, and what every answer says about itself.

use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::header::{
    ALLOW, CACHE_CONTROL, CONTENT_LENGTH, CONTENT_SECURITY_POLICY, HOST, HeaderMap, HeaderName,
    HeaderValue, ORIGIN, REFERRER_POLICY, TRANSFER_ENCODING, X_CONTENT_TYPE_OPTIONS,
    X_FRAME_OPTIONS,
};
use axum::http::{Method, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use super::hub::Hub;

/// What the page may do: run its one script, show what it got from here, and nothing else.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src blob: data:; \
    connect-src 'self' blob: data:; worker-src blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Let a request pass, or refuse it.
pub(super) async fn guard(State(hub): State<Arc<Hub>>, request: Request, next: Next) -> Response {
    let mut response = match refusal(&request, hub.port()) {
        Some(refused) => refused.into_response(),
        None => next.run(request).await,
    };
    let headers = response.headers_mut();
    let fixed = [
        (CONTENT_SECURITY_POLICY, POLICY),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (X_FRAME_OPTIONS, "DENY"),
        (REFERRER_POLICY, "no-referrer"),
        (CACHE_CONTROL, "no-store"),
        (
            HeaderName::from_static("cross-origin-resource-policy"),
            "same-origin",
        ),
        (
            HeaderName::from_static("cross-origin-opener-policy"),
            "same-origin",
        ),
    ];
    for (name, value) in fixed {
        headers.insert(name, HeaderValue::from_static(value));
    }
    if response.status() == StatusCode::METHOD_NOT_ALLOWED {
        response
            .headers_mut()
            .insert(ALLOW, HeaderValue::from_static("GET"));
    }
    response
}

/// Why a request is refused.
fn refusal(request: &Request, port: u16) -> Option<(StatusCode, &'static str)> {
    let headers = request.headers();
    if request.method() != Method::GET {
        return Some((
            StatusCode::METHOD_NOT_ALLOWED,
            "only GET requests are allowed",
        ));
    }
    let has_body = headers.contains_key(TRANSFER_ENCODING)
        || headers
            .get(CONTENT_LENGTH)
            .is_some_and(|length| length != "0");
    if has_body {
        return Some((
            StatusCode::PAYLOAD_TOO_LARGE,
            "request bodies are not allowed",
        ));
    }
    let target = request
        .uri()
        .authority()
        .map(axum::http::uri::Authority::as_str);
    if !one(headers, &HOST).is_some_and(|host| is_ours(host, port))
        || target.is_some_and(|host| !is_ours(host, port))
    {
        return Some((
            StatusCode::MISDIRECTED_REQUEST,
            "the Host header does not match this server",
        ));
    }
    let foreign = headers.contains_key(ORIGIN) && !same_origin(headers);
    let site = headers.get("sec-fetch-site").map(HeaderValue::as_bytes);
    if foreign || site.is_some_and(|site| site != b"same-origin" && site != b"none") {
        return Some((
            StatusCode::FORBIDDEN,
            "requests from other pages are not allowed",
        ));
    }
    None
}

/// Whether a request comes from a page of ours. `Host` was checked before.
pub(super) fn same_origin(headers: &HeaderMap) -> bool {
    let origin = one(headers, &ORIGIN).and_then(|origin| origin.strip_prefix("http://"));
    origin.is_some() && origin == one(headers, &HOST)
}

/// The value of a header that is there once.
fn one<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<&'a str> {
    let mut values = headers.get_all(name).iter();
    let value = values.next()?.to_str().ok()?;
    values.next().is_none().then_some(value)
}

/// Whether a host is a name of this server.
fn is_ours(host: &str, port: u16) -> bool {
    let name = host
        .strip_suffix(&port.to_string())
        .and_then(|host| host.strip_suffix(':'));
    name.is_some_and(|name| ["127.0.0.1", "localhost", "[::1]"].contains(&name))
}

/// Whether two texts are the same, in a time that does not tell where they differ.
pub(super) fn same(a: &str, b: &str) -> bool {
    let differences = a
        .bytes()
        .zip(b.bytes())
        .fold(0, |all, (a, b)| all | (a ^ b));
    std::hint::black_box(differences) == 0 && a.len() == b.len()
}

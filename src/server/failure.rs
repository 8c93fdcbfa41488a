//! Why a request has no answer.
use std::borrow::Cow;

use tower_lsp::jsonrpc::{Error, ErrorCode};

/// Why a request has no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum RequestFailure {
    /// The client no longer wants it.
    Cancelled,
    /// It was about a text that is another one by now.
    Outdated,
    /// The request makes no sense; the text says why.
    Invalid(String),
    /// What was asked for is refused; the text says why.
    Refused(String),
}

impl RequestFailure {
    pub fn into_error(self) -> Error {
        let (code, message) = match self {
            RequestFailure::Cancelled => (ErrorCode::RequestCancelled, "cancelled".to_owned()),
            RequestFailure::Outdated => (
                ErrorCode::ContentModified,
                "the text has changed; repeat the request".to_owned(),
            ),
            RequestFailure::Invalid(message) => (ErrorCode::InvalidParams, message),
            // `RequestFailed` of LSP 3.17
            RequestFailure::Refused(message) => (ErrorCode::ServerError(-32803), message),
        };
        Error {
            code,
            message: Cow::Owned(message),
            data: None,
        }
    }
}

//! The page: an empty one with the viewer, or a hint how to get one.

use axum::http::header::CONTENT_TYPE;
use axum::response::{Html, IntoResponse, Response};

const PAGE: &str = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
    <meta name=\"viewport\" content=\"width=device-width\"><title>xacro preview</title></head>\
    <body><script src=\"/viewer.js\"></script></body></html>\n";

const HINT: &str = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>xacro preview</title></head>\
    <body><h1>The viewer is not part of this build</h1>\
    <p>This program was built from source without the viewer. To add it, run</p>\
    <pre>cd editors/viewer\nnpm ci\nnpm run build\ncd ../..\ncargo build --release</pre>\
    <p>in the source folder and start the program again. Released binaries include the viewer.</p></body></html>\n";

/// `/`
pub(super) async fn page() -> Html<&'static str> {
    Html(if viewer::SCRIPT.is_some() { PAGE } else { HINT })
}

/// `/viewer.js`
pub(super) async fn script() -> Response {
    match viewer::SCRIPT {
        Some(script) => {
            ([(CONTENT_TYPE, "text/javascript; charset=utf-8")], script).into_response()
        }
        None => axum::http::StatusCode::NOT_FOUND.into_response(),
    }
}

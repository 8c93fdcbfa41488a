//! Connections and what is found at which path.

use std::net::TcpListener;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::{Path, State};
use axum::http::StatusCode;
use axum::http::header::{CONTENT_TYPE, HeaderMap};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use axum::{Extension, Router};
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::runtime::Builder;

use super::hub::Hub;
use super::limiter::Permit;
use super::{guard, page, socket};
use base::limits::{REQUEST_HEAD, SENT_BYTES};

/// A request has this long to arrive.
const REQUEST_TIME: Duration = Duration::from_secs(5);
/// And its answer this long to leave.
const ANSWER_TIME: Duration = Duration::from_secs(120);

/// Serve until the process ends.
pub(super) fn run(hub: &Arc<Hub>, listeners: Vec<TcpListener>) {
    let Ok(runtime) = Builder::new_current_thread().enable_all().build() else {
        return;
    };
    let router = routes(hub.clone());
    let accept = |listener| runtime.spawn(accept(hub.clone(), router.clone(), listener));
    let accepted: Vec<_> = listeners.into_iter().map(accept).collect();
    runtime.block_on(async {
        for listener in accepted {
            let _ = listener.await;
        }
    });
}

async fn accept(hub: Arc<Hub>, router: Router, listener: TcpListener) {
    let Ok(listener) = tokio::net::TcpListener::from_std(listener) else {
        return;
    };
    loop {
        let Ok((stream, peer)) = listener.accept().await else {
            // out of file handles: those there are will be given back soon
            tokio::time::sleep(Duration::from_millis(50)).await;
            continue;
        };
        if !peer.ip().is_loopback() {
            continue;
        }
        let permit = Arc::new(hub.connections.enter());
        let service = TowerToHyperService::new(router.clone().layer(Extension(permit.clone())));
        tokio::spawn(async move {
            let connection = http1::Builder::new()
                .timer(TokioTimer::new())
                .header_read_timeout(REQUEST_TIME)
                .keep_alive(false)
                .max_buf_size(REQUEST_HEAD)
                .serve_connection(TokioIo::new(stream), service)
                .with_upgrades();
            tokio::select! {
                _ = connection => {}
                () = permit.lost() => {}
                () = tokio::time::sleep(ANSWER_TIME) => {}
            }
        });
    }
}

fn routes(hub: Arc<Hub>) -> Router {
    Router::new()
        .route("/", get(page::page))
        .route("/viewer.js", get(page::script))
        .route("/mesh/{id}", get(mesh))
        .route("/urdf/{id}", get(urdf))
        .route("/socket", get(socket::open))
        .fallback(|| async { (StatusCode::NOT_FOUND, "page not found") })
        .layer(axum::middleware::from_fn_with_state(
            hub.clone(),
            guard::guard,
        ))
        .with_state(hub)
}

/// `/urdf/ID`: the robot of a view as URDF.
async fn urdf(
    State(hub): State<Arc<Hub>>,
    Extension(permit): Extension<Arc<Permit>>,
    Path(id): Path<u32>,
    headers: HeaderMap,
) -> Response {
    if !knows_token(&hub, &headers) {
        return forbidden();
    }
    permit.leave();
    match tokio::task::spawn_blocking(move || hub.urdf(id)).await {
        Ok(Ok(text)) => ([(CONTENT_TYPE, "application/xml; charset=utf-8")], text).into_response(),
        Ok(Err(why)) => (StatusCode::CONFLICT, why).into_response(),
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}

fn knows_token(hub: &Hub, headers: &HeaderMap) -> bool {
    let given = headers
        .get("x-xacro-token")
        .and_then(|token| token.to_str().ok());
    guard::same(given.unwrap_or(""), hub.token())
}

fn forbidden() -> Response {
    (StatusCode::FORBIDDEN, "the token is missing or wrong").into_response()
}

/// `/mesh/ID`: the bytes of a file of a model.
async fn mesh(
    State(hub): State<Arc<Hub>>,
    Extension(permit): Extension<Arc<Permit>>,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Response {
    if !knows_token(&hub, &headers) {
        return forbidden();
    }
    // a page of ours: others that come and say nothing do not end its download
    permit.leave();
    let Some(path) = hub.files.path(&id) else {
        return (StatusCode::NOT_FOUND, "no open preview uses this file").into_response();
    };
    let vfs = hub.vfs.clone();
    match tokio::task::spawn_blocking(move || vfs.bytes(&path, SENT_BYTES)).await {
        Ok(Ok(bytes)) => ([(CONTENT_TYPE, "application/octet-stream")], bytes).into_response(),
        Ok(Err(error)) => (
            StatusCode::NOT_FOUND,
            format!("it cannot be read: {}", error.reason()),
        )
            .into_response(),
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}

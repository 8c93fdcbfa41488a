//! What browsers are told, and who may listen.

use std::collections::BTreeMap;
use std::io;
use std::net::{Ipv4Addr, Ipv6Addr, TcpListener};
use std::sync::{Arc, Mutex, PoisonError};

use serde::Serialize;
use tokio::sync::watch;

use super::limiter::ConnectionLimiter;
use super::serve;
use crate::ModelFiles;
use crate::messages::{FromViewer, ModelMessage, ModelSource, Selection, Side};
use base::limits::{CONNECTIONS, PAGES, UNAUTHENTICATED};
use vfs::Vfs;

/// A message of a page about its view.
#[derive(Clone, Debug)]
pub struct Received {
    /// The view.
    pub id: u32,
    /// What the page says.
    pub message: FromViewer,
}

/// What a page is to know; newer texts take the place of older ones that were not sent yet.
#[derive(Clone, Debug, Default)]
pub(super) struct ViewState {
    pub main: Option<Arc<str>>,
    pub compare: Option<Arc<str>>,
    pub selection: Option<Arc<str>>,
    /// What the main robot was made of, for those who want its URDF.
    pub source: Option<ModelSource>,
}

/// The server for browsers: started once, ends with the process.
pub struct Hub {
    token: String,
    port: u16,
    views: Mutex<BTreeMap<u32, watch::Sender<ViewState>>>,
    pub(super) files: Arc<ModelFiles>,
    pub(super) vfs: Arc<Vfs>,
    pub(super) receive: Box<dyn Fn(Received) + Send + Sync>,
    pub(super) connections: Arc<ConnectionLimiter>,
    pub(super) unauthenticated: Arc<ConnectionLimiter>,
    pub(super) pages: Arc<ConnectionLimiter>,
}

impl Hub {
    /// Listen on a free port of 127.0.0.1, and on the same of ::1 where it is free. `receive` is told what pages say.
    ///
    /// # Errors
    /// When there is no port or no source of random numbers.
    pub fn start(
        files: Arc<ModelFiles>,
        vfs: Arc<Vfs>,
        receive: impl Fn(Received) + Send + Sync + 'static,
    ) -> io::Result<Arc<Self>> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
        let port = listener.local_addr()?.port();
        // some systems take `localhost` for the one, some for the other, and some have no ::1 at all
        let listeners: Vec<TcpListener> = [
            Some(listener),
            TcpListener::bind((Ipv6Addr::LOCALHOST, port)).ok(),
        ]
        .into_iter()
        .flatten()
        .collect();
        listeners
            .iter()
            .try_for_each(|listener| listener.set_nonblocking(true))?;
        let hub = Arc::new(Self {
            token: token()?,
            port,
            views: Mutex::default(),
            files,
            vfs,
            receive: Box::new(receive),
            connections: ConnectionLimiter::new(CONNECTIONS),
            unauthenticated: ConnectionLimiter::new(UNAUTHENTICATED),
            pages: ConnectionLimiter::new(PAGES),
        });
        let served = hub.clone();
        let thread = std::thread::Builder::new().name("preview".to_owned());
        thread.spawn(move || serve::run(&served, listeners))?;
        Ok(hub)
    }

    /// The address of the page of a view.
    pub fn url(&self, id: u32) -> String {
        format!(
            "http://127.0.0.1:{}/#token={}&id={id}",
            self.port, self.token
        )
    }

    pub(super) fn port(&self) -> u16 {
        self.port
    }

    pub(super) fn token(&self) -> &str {
        &self.token
    }

    /// A view may be looked at.
    pub fn open(&self, id: u32) {
        self.views()
            .entry(id)
            .or_insert_with(|| watch::Sender::new(ViewState::default()));
    }

    /// A view is no more: its pages are told.
    pub fn close(&self, id: u32) {
        self.views().remove(&id);
    }

    /// Whether a view may be looked at.
    pub fn has(&self, id: u32) -> bool {
        self.views().contains_key(&id)
    }

    /// Whether a page shows a view.
    pub fn is_watched(&self, id: u32) -> bool {
        self.views()
            .get(&id)
            .is_some_and(|view| view.receiver_count() > 0)
    }

    /// Tell the pages of a view about its robot.
    pub fn tell(&self, message: &ModelMessage) {
        let side = message.side;
        self.change(message.id, |updates| match side {
            Side::Main => {
                updates.main = json(message);
                updates.source = Some(message.source.clone());
            }
            Side::Compare => updates.compare = json(message),
        });
    }

    /// Tell the pages of a view what is selected.
    pub fn select(&self, selection: &Selection) {
        self.change(selection.id, |updates| updates.selection = json(selection));
    }

    /// Nothing is compared any more.
    pub fn end_compare(&self, id: u32) {
        self.change(id, |updates| updates.compare = None);
    }

    fn change(&self, id: u32, change: impl FnOnce(&mut ViewState)) {
        if let Some(view) = self.views().get(&id) {
            view.send_modify(change);
        }
    }

    /// The robot of a view as URDF, or why there is none.
    pub(super) fn urdf(&self, id: u32) -> Result<String, String> {
        let shown = self
            .views()
            .get(&id)
            .map(|view| view.borrow().source.clone());
        let source = shown.ok_or("this view is closed")?;
        source.ok_or("no robot is shown")?.urdf()
    }

    pub(super) fn updates(&self, id: u32) -> Option<watch::Receiver<ViewState>> {
        self.views().get(&id).map(watch::Sender::subscribe)
    }

    fn views(&self) -> std::sync::MutexGuard<'_, BTreeMap<u32, watch::Sender<ViewState>>> {
        self.views.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A message as it is sent; none when it cannot be written.
fn json(message: &impl Serialize) -> Option<Arc<str>> {
    serde_json::to_string(message).ok().map(Arc::from)
}

/// 128 random bits.
fn token() -> io::Result<String> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(io::Error::other)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

//! The robots that are shown in 3D.
use std::collections::BTreeSet;
#[cfg(feature = "preview")]
use std::sync::Arc;

use preview::Views;

/// The views of the client and of browsers.
#[derive(Default)]
pub(super) struct Previews {
    pub views: Views,
    /// Something changed since the last models.
    pub due: bool,
    /// The views that the client subscribed to.
    pub subscribed: BTreeSet<u32>,
    #[cfg(feature = "preview")]
    pub hub: Option<Arc<preview::Hub>>,
    /// Where what pages say is taken; none where there can be no pages.
    #[cfg(feature = "preview")]
    pub from_pages: Option<Arc<dyn Fn(preview::Received) + Send + Sync>>,
}

//! The preview in a browser on this machine.
//!
//! Any page of any site can send requests to 127.0.0.1, so a request counts only when its `Host` and its `Origin` are
//! ours, and says something only to who knows the token, which is in no address that is ever sent anywhere. Files
//! are named by the ids of a model, never by paths.

mod guard;
mod hub;
mod limiter;
mod page;
mod serve;
mod socket;
#[cfg(test)]
mod tests;

pub use hub::{Hub, Received};

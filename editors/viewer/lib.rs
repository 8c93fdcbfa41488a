//! The viewer of robots in a browser.

/// Its script; none in a build from source without it.
pub const SCRIPT: Option<&[u8]> = include!(concat!(env!("OUT_DIR"), "/viewer.rs"));

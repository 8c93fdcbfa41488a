//! Meshes: what the files say that visuals and collisions name.

/// Meshes that were read, by path; each is read once.
#[derive(Debug, Default)]
pub struct Meshes {}

//! Still pictures of robots, drawn without a graphics card: shaded as PNG, or as lines and outlines in SVG.
//!
//! What is drawn is the [`Model`](preview::Model) of the preview, so that both show the same robot.

mod camera;
mod color;
mod joints;
mod normals;
mod png;
mod raster;
mod scene;
mod solids;
mod svg;
#[cfg(test)]
mod tests;

pub use camera::ViewDirection;
pub use color::Background;
pub use joints::{Positions, movable};
pub use png::picture_png;
pub use scene::{Scene, SceneOptions};
pub use svg::picture_svg;

/// How a picture is taken.
#[derive(Clone, Copy, Debug)]
pub struct Viewport {
    /// From where.
    pub view: ViewDirection,
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Background color of the picture.
    pub background: Background,
}

/// Pixels of a picture at most.
pub const MOST_PIXELS: u64 = 16_000_000;
/// Length of a side at most, pixels.
pub const LONGEST_SIDE: u32 = 16_384;
/// Triangles of a picture at most.
pub const MOST_TRIANGLES: usize = 3_000_000;

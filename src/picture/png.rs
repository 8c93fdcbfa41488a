//! PNG files.

use super::raster::pixels;
use super::scene::Scene;
use super::{Background, Viewport};

/// The picture as a PNG file.
///
/// # Errors
/// When the file cannot be made, in words.
pub fn picture_png(scene: &Scene, shot: &Viewport) -> Result<Vec<u8>, String> {
    let pixels = pixels(scene, shot)?;
    let [width, height] = shot.size;
    let mut file = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut file, width, height);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.set_source_srgb(::png::SrgbRenderingIntent::Perceptual);
    let data = match shot.background {
        Background::Transparent => {
            encoder.set_color(::png::ColorType::Rgba);
            pixels
        }
        Background::Solid(_) => {
            encoder.set_color(::png::ColorType::Rgb);
            pixels
                .as_chunks::<4>()
                .0
                .iter()
                .flat_map(|&[r, g, b, _]| [r, g, b])
                .collect()
        }
    };
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&data)?;
        writer.finish()
    });
    written.map_err(|error| format!("cannot write the picture as PNG: {error}"))?;
    Ok(file)
}

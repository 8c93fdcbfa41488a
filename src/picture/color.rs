//! Colors and light.

use nalgebra::Vector3;

/// Red, green, blue and opacity, 0 to 1, as URDF writes them.
pub(super) type Rgba = [f64; 4];

/// What has no color.
pub(super) const PLAIN: Rgba = [0.72, 0.74, 0.78, 1.0];
/// What stands in for a mesh that cannot be drawn.
pub(super) const MISSING: Rgba = [1.0, 0.0, 1.0, 1.0];
/// The axes of a frame.
pub(super) const AXES: [Rgba; 3] = [
    [0.86, 0.16, 0.16, 1.0],
    [0.12, 0.6, 0.2, 1.0],
    [0.16, 0.35, 0.9, 1.0],
];
/// Lines from frame to frame.
pub(super) const LINK_LINE_COLOR: Rgba = [0.25, 0.29, 0.36, 1.0];

/// Colors of collisions, one link after the other.
const COLLISIONS: [Rgba; 6] = [
    [0.35, 0.62, 0.72, 1.0],
    [0.87, 0.62, 0.34, 1.0],
    [0.55, 0.68, 0.4, 1.0],
    [0.72, 0.52, 0.66, 1.0],
    [0.82, 0.74, 0.42, 1.0],
    [0.5, 0.56, 0.74, 1.0],
];

/// The color of the collisions of a link.
pub(super) fn collision(link: usize) -> Rgba {
    COLLISIONS
        .get(link % COLLISIONS.len())
        .copied()
        .unwrap_or(PLAIN)
}

/// Background color of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Background {
    /// Nothing.
    Transparent,
    /// Red, green and blue.
    Solid([u8; 3]),
}

impl Background {
    /// `transparent`, `white`, `black`, `#rrggbb` or `#rgb`.
    pub fn of(text: &str) -> Option<Self> {
        let digits = match text {
            "transparent" | "none" => return Some(Background::Transparent),
            "white" => "ffffff",
            "black" => "000000",
            text => text.strip_prefix('#')?,
        };
        let digits: Vec<u8> = digits
            .chars()
            .map(|c| c.to_digit(16).and_then(|digit| u8::try_from(digit).ok()))
            .collect::<Option<_>>()?;
        match *digits.as_slice() {
            [r, g, b] => Some(Background::Solid([r * 17, g * 17, b * 17])),
            [r, s, g, h, b, c] => Some(Background::Solid([r * 16 + s, g * 16 + h, b * 16 + c])),
            _ => None,
        }
    }
}

/// How much light a surface throws back, seen by a camera; `normal` in its directions, of length one.
pub(super) fn shade(normal: Vector3<f64>) -> f64 {
    // surfaces of many meshes are turned inside out: both sides count
    let normal = if normal.z < 0.0 { -normal } else { normal };
    let key = normal
        .dot(&Vector3::new(-0.35, 0.62, 0.70).normalize())
        .max(0.0);
    let fill = normal
        .dot(&Vector3::new(0.85, -0.1, 0.5).normalize())
        .max(0.0);
    let sky = 0.5 + 0.5 * normal.y;
    0.2 + 0.2 * sky + 0.62 * key + 0.16 * fill
}

/// A channel as an amount of light.
pub(super) fn light(channel: f64) -> f64 {
    let channel = channel.clamp(0.0, 1.0);
    if channel <= 0.040_45 {
        channel / 12.92
    } else {
        libm::pow((channel + 0.055) / 1.055, 2.4)
    }
}

/// An amount of light as a channel, 0 to 255.
pub(super) fn channel(light: f64) -> u8 {
    let light = light.clamp(0.0, 1.0);
    let channel = if light <= 0.003_130_8 {
        light * 12.92
    } else {
        1.055 * libm::pow(light, 1.0 / 2.4) - 0.055
    };
    (channel * 255.0).round() as u8
}

/// `#rrggbb`
pub(super) fn hex([r, g, b, _]: Rgba) -> String {
    let [r, g, b] = [r, g, b].map(|channel| (channel.clamp(0.0, 1.0) * 255.0).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

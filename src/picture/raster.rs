//! Triangles as pixels: each sample keeps the nearest surface, and a pixel is the mean of its samples.

use std::ops::Range;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::Viewport;
use super::camera::Camera;
use super::color::{self, Background, Rgba};
use super::normals::normals;
use super::scene::{ColoredSolid, Scene};

/// Samples a pixel, along each side.
const SAMPLES: usize = 3;
/// Rows of pixels that are drawn at a time.
const ROWS: usize = 32;

/// Samples that are looked at for all triangles together, at most: some minutes.
const MOST_COVERED_PIXELS: f64 = 1e11;

/// A triangle in the picture.
struct Facet {
    /// Right, down and nearness of its corners; samples.
    corners: [[f64; 3]; 3],
    /// Light at its corners.
    light: [[f32; 3]; 3],
    opacity: f32,
}

impl Facet {
    /// The samples of the part of a picture with these sides that the triangle may lie in.
    fn covered_pixels(&self, [width, height]: [f64; 2]) -> f64 {
        let [a, b, c] = self.corners;
        covered([a[0], b[0], c[0]], width) * covered([a[1], b[1], c[1]], height)
    }

    fn nearness(&self) -> f64 {
        self.corners.iter().map(|[_, _, key]| key).sum()
    }
}

/// The samples between the lowest and the highest of three numbers, inside of a side.
fn covered([a, b, c]: [f64; 3], side: f64) -> f64 {
    (a.max(b).max(c).min(side) - a.min(b).min(c).max(0.0)).max(0.0) + 1.0
}

/// The samples whose middles are between two places, inside of a side.
fn samples(from: f64, to: f64, side: usize) -> Range<usize> {
    let first = (from - 0.5).ceil().max(0.0) as usize;
    let end = ((to - 0.5).floor() + 1.0).clamp(0.0, side as f64) as usize;
    first..end
}

/// The light at a place inside of a triangle, from that at its corners and their weights.
fn mixed([p, q, r]: [[f32; 3]; 3], [i, j, k]: [f32; 3]) -> [f32; 3] {
    let mut light = p;
    for ((light, q), r) in light.iter_mut().zip(q).zip(r) {
        *light = *light * i + q * j + r * k;
    }
    light
}

/// The rows of the picture, one after the other, as red, green, blue and opacity.
///
/// # Errors
/// When it would take too long.
pub(super) fn pixels(scene: &Scene, shot: &Viewport) -> Result<Vec<u8>, String> {
    let camera = Camera::around(scene.points(), shot, 0.0);
    let (mut solid, mut translucent): (Vec<Facet>, Vec<Facet>) = (Vec::new(), Vec::new());
    for part in &scene.parts {
        facets(part, &camera, &mut |facet| {
            if facet.opacity < 1.0 {
                &mut translucent
            } else {
                &mut solid
            }
            .push(facet);
        });
    }
    for part in &scene.skeleton {
        // lines are no surfaces: they have their color wherever they are
        let light = Light::of(part.color);
        facets(part, &camera, &mut |facet| {
            solid.push(Facet {
                light: [light.color; 3],
                ..facet
            })
        });
    }
    // what can be seen through is drawn from the back to the front
    translucent.sort_by(|a, b| a.nearness().total_cmp(&b.nearness()));
    let sides = shot.size.map(|side| f64::from(side) * SAMPLES as f64);
    if solid
        .iter()
        .chain(&translucent)
        .map(|facet| facet.covered_pixels(sides))
        .sum::<f64>()
        > MOST_COVERED_PIXELS
    {
        return Err("too many overlapping shapes: choose a smaller size".to_owned());
    }
    let [_, height] = shot.size.map(|side| side as usize);
    let bands: Vec<Vec<u8>> = (0..height.div_ceil(ROWS))
        .into_par_iter()
        .map(|number| {
            let top = number * ROWS;
            let mut band = Band::new(shot, top, ROWS.min(height - top));
            solid.iter().for_each(|facet| band.draw::<true>(facet));
            translucent
                .iter()
                .for_each(|facet| band.draw::<false>(facet));
            band.pixels(shot.background)
        })
        .collect();
    Ok(bands.concat())
}

/// The triangles of a part as the camera sees them.
fn facets(part: &ColoredSolid, camera: &Camera, found: &mut dyn FnMut(Facet)) {
    let mut tints = part.solid.tints.iter().peekable();
    let mut now = Light::of(part.color);
    for (number, (triangle, normals)) in part
        .solid
        .triangles
        .iter()
        .zip(normals(&part.solid))
        .enumerate()
    {
        while let Some((_, tint)) = tints.next_if(|(start, _)| *start <= number) {
            now = Light::of(part.tinted(*tint));
        }
        let corners = part.solid.corners(*triangle).map(|corner| {
            let [x, y, key] = camera.project(corner);
            [x * SAMPLES as f64, y * SAMPLES as f64, key]
        });
        let light = normals.map(|normal| {
            let shade = color::shade(camera.turned(normal)) as f32;
            now.color.map(|channel| (channel * shade).min(1.0))
        });
        found(Facet {
            corners,
            light,
            opacity: now.opacity,
        });
    }
}

/// A color as amounts of light.
#[derive(Clone, Copy)]
struct Light {
    color: [f32; 3],
    opacity: f32,
}

impl Light {
    fn of([r, g, b, a]: Rgba) -> Self {
        Self {
            color: [r, g, b].map(|channel| color::light(channel) as f32),
            opacity: a.clamp(0.0, 1.0) as f32,
        }
    }
}

/// Some rows of the picture while they are drawn.
struct Band {
    width: usize,
    height: usize,
    /// The first row, samples.
    top: f64,
    depth: Vec<f64>,
    /// Light times opacity, and opacity.
    light: Vec<[f32; 4]>,
}

impl Band {
    fn new(shot: &Viewport, top: usize, rows: usize) -> Self {
        let (width, height) = (shot.size[0] as usize * SAMPLES, rows * SAMPLES);
        let count = width * height;
        let top = (top * SAMPLES) as f64;
        Self {
            width,
            height,
            top,
            depth: vec![f64::NEG_INFINITY; count],
            light: vec![[0.0; 4]; count],
        }
    }

    /// Draw a triangle; a solid one hides what is behind it.
    fn draw<const SOLID: bool>(&mut self, facet: &Facet) {
        let [a, b, c] = facet.corners.map(|[x, y, key]| [x, y - self.top, key]);
        let area = cross(a, b, c);
        let (x0, x1) = (a[0].min(b[0]).min(c[0]), a[0].max(b[0]).max(c[0]));
        let (y0, y1) = (a[1].min(b[1]).min(c[1]), a[1].max(b[1]).max(c[1]));
        if area == 0.0 || y1 < 0.0 || y0 > self.height as f64 {
            return;
        }
        for y in samples(y0, y1, self.height) {
            for x in samples(x0, x1, self.width) {
                let at = [x as f64 + 0.5, y as f64 + 0.5, 0.0];
                let weights = [
                    cross(b, c, at) / area,
                    cross(c, a, at) / area,
                    cross(a, b, at) / area,
                ];
                if weights.iter().any(|weight| *weight < -1e-9) {
                    continue;
                }
                let key = weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2];
                let index = y * self.width + x;
                let Some((depth, light)) = self.depth.get_mut(index).zip(self.light.get_mut(index))
                else {
                    continue;
                };
                if key <= *depth {
                    continue;
                }
                let [red, green, blue] = mixed(facet.light, weights.map(|weight| weight as f32));
                let over = [red, green, blue, 1.0];
                if SOLID {
                    *depth = key;
                    *light = over;
                } else {
                    let opacity = facet.opacity;
                    light
                        .iter_mut()
                        .zip(over)
                        .for_each(|(under, over)| *under += (over - *under) * opacity);
                }
            }
        }
    }

    /// The rows as pixels.
    fn pixels(&self, background: Background) -> Vec<u8> {
        let behind = match background {
            Background::Transparent => None,
            Background::Solid(channels) => {
                Some(channels.map(|channel| color::light(f64::from(channel) / 255.0) as f32))
            }
        };
        let (columns, rows) = (self.width / SAMPLES, self.height / SAMPLES);
        let mut bytes = Vec::with_capacity(columns * rows * 4);
        for row in 0..rows {
            for column in 0..columns {
                let [r, g, b, a] = self.mean(column, row);
                let pixel = match behind {
                    Some([br, bg, bb]) => {
                        let left = 1.0 - a;
                        [r + br * left, g + bg * left, b + bb * left, 1.0]
                    }
                    None if a > 0.0 => [r / a, g / a, b / a, a],
                    None => [0.0; 4],
                };
                let [r, g, b, a] = pixel;
                bytes.extend([r, g, b].map(|light| color::channel(f64::from(light))));
                bytes.push((f64::from(a) * 255.0).round() as u8);
            }
        }
        bytes
    }

    fn mean(&self, column: usize, row: usize) -> [f32; 4] {
        let mut sum = [0.0f32; 4];
        for y in row * SAMPLES..(row + 1) * SAMPLES {
            let start = y * self.width + column * SAMPLES;
            for sample in self.light.get(start..start + SAMPLES).into_iter().flatten() {
                sum.iter_mut()
                    .zip(sample)
                    .for_each(|(sum, value)| *sum += value);
            }
        }
        sum.map(|channel| channel / (SAMPLES * SAMPLES) as f32)
    }
}

/// Twice the area of a triangle, positive when it runs clockwise in the picture.
fn cross(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

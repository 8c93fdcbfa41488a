//! A robot as lines: outlines of its shapes, frames, lines from frame to frame, names.

use std::fmt::Write;

use super::Viewport;
use super::camera::{Camera, ROOM};
use super::color::{AXES, Background, LINK_LINE_COLOR, hex};
use super::scene::{ColoredSolid, LinkFrame, Scene};
use base::escape_xml;

/// Height of a line of text, and width of a letter in it, pixels.
const LINE: f64 = 14.0;
const LETTER: f64 = 6.7;
/// How far a name is to the right of its frame and below it, pixels: axes mostly point elsewhere.
const AWAY: f64 = 5.0;
const BELOW: f64 = 3.0;
/// Frames nearer than this are one point in the picture, pixels.
const TOGETHER: f64 = 3.0;
/// Names at a point at most.
const MOST_NAMES: usize = 3;
/// Length of the axes of a frame, pixels.
const AXIS: f64 = 22.0;

const STYLE: &str = "\
text{font:11px ui-monospace,SFMono-Regular,Menlo,Consolas,monospace;dominant-baseline:central;fill:#16243b;\
stroke:#fff;stroke-width:3px;stroke-linejoin:round;paint-order:stroke}\
.shape path{fill-opacity:.55;stroke-width:1;stroke-linejoin:round}\
.bone{stroke-width:2;stroke-linecap:round}.fixed{stroke-dasharray:2 4}\
.axis{stroke-width:1.8;stroke-linecap:round}.leader{stroke:#8a94a6;stroke-width:.8}";

/// The picture as an SVG file: every shape as the outline of its convex hull, far ones first.
pub fn picture_svg(scene: &Scene, robot: &str, shot: &Viewport) -> String {
    let frames: Vec<[f64; 3]> = scene
        .frames
        .iter()
        .map(|frame| frame.at.translation.vector.into())
        .collect();
    let points = scene
        .parts
        .iter()
        .flat_map(|part| &part.solid.points)
        .chain(&frames);
    let camera = Camera::around(points, shot, ROOM);
    let [width, height] = shot.size;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\">\n<title>{}</title>\n<style>{STYLE}</style>\n",
        escape_xml(robot)
    );
    if let Background::Solid([r, g, b]) = shot.background {
        let _ = writeln!(
            out,
            "<rect width=\"100%\" height=\"100%\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>"
        );
    }
    shapes(scene, &camera, &mut out);
    bones(scene, &camera, &mut out);
    axes(scene, &camera, &mut out);
    names(scene, &camera, shot, &mut out);
    out.push_str("</svg>\n");
    out
}

/// Outlines, far ones first.
fn shapes(scene: &Scene, camera: &Camera, out: &mut String) {
    let mut outlines: Vec<(f64, String)> = Vec::new();
    for part in &scene.parts {
        let seen: Vec<[f64; 3]> = part
            .solid
            .points
            .iter()
            .map(|point| camera.project(*point))
            .collect();
        let nearness = seen.iter().map(|[_, _, key]| key).sum::<f64>() / seen.len().max(1) as f64;
        outlines.push((nearness, outline(part, &seen)));
    }
    outlines.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    out.push_str("<g class=\"shape\">\n");
    outlines
        .iter()
        .for_each(|(_, outline)| out.push_str(outline));
    out.push_str("</g>\n");
}

fn outline(part: &ColoredSolid, seen: &[[f64; 3]]) -> String {
    let mut path = String::new();
    for (number, [x, y]) in hull(seen.iter().map(|&[x, y, _]| [x, y]).collect())
        .into_iter()
        .enumerate()
    {
        let _ = write!(path, "{}{x:.1} {y:.1}", if number == 0 { 'M' } else { 'L' });
    }
    let color = part.main_color();
    let [r, g, b, a] = color;
    let dark = [r * 0.55, g * 0.55, b * 0.55, a];
    format!(
        "<path d=\"{path}Z\" fill=\"{}\" stroke=\"{}\"/>\n",
        hex(color),
        hex(dark)
    )
}

/// The corners of the convex hull of points, in order.
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|[a, b], [c, d]| a.total_cmp(c).then(b.total_cmp(d)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut whole = hull_side(points.iter().copied());
    whole.extend(hull_side(points.iter().rev().copied()));
    whole
}

/// One side of a convex hull, from sorted points, without the last one.
fn hull_side(points: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut chain: Vec<[f64; 2]> = Vec::new();
    for point in points {
        while let [.., a, b] = *chain.as_slice() {
            let turn = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
            if turn > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(point);
    }
    chain.pop();
    chain
}

/// Lines from each frame to the one it hangs on.
fn bones(scene: &Scene, camera: &Camera, out: &mut String) {
    for frame in &scene.frames {
        let Some((parent, joint, kind)) = &frame.by else {
            continue;
        };
        let Some(parent) = scene.frames.get(*parent) else {
            continue;
        };
        let (from, to) = (origin(parent, camera), origin(frame, camera));
        let class = if kind == "fixed" {
            "bone fixed"
        } else {
            "bone"
        };
        let title = format!("{} ({})", escape_xml(joint), escape_xml(kind));
        let _ = writeln!(
            out,
            "{}<title>{title}</title></line>",
            line(from, to, class, &hex(LINK_LINE_COLOR))
        );
    }
}

fn axes(scene: &Scene, camera: &Camera, out: &mut String) {
    let length = AXIS / camera.scale;
    for frame in &scene.frames {
        let from = origin(frame, camera);
        for (axis, color) in [[length, 0.0, 0.0], [0.0, length, 0.0], [0.0, 0.0, length]]
            .iter()
            .zip(AXES)
        {
            let [x, y, _] =
                camera.project((frame.at * nalgebra::Point3::from(*axis)).coords.into());
            let _ = writeln!(out, "{}</line>", line(from, [x, y], "axis", &hex(color)));
        }
    }
}

/// The names of the links, beside their frames where there is room.
fn names(scene: &Scene, camera: &Camera, shot: &Viewport, out: &mut String) {
    let mut points: Vec<([f64; 2], Vec<&str>)> = Vec::new();
    for frame in &scene.frames {
        let at = origin(frame, camera);
        let known = points
            .iter_mut()
            .find(|(point, _)| (point[0] - at[0]).hypot(point[1] - at[1]) < TOGETHER);
        match known {
            Some((_, names)) => names.push(&frame.name),
            None => points.push((at, vec![&frame.name])),
        }
    }
    let [width, height] = shot.size.map(f64::from);
    // from the top down, so that what has no room moves down
    points.sort_by(|(a, _), (b, _)| a[1].total_cmp(&b[1]).then(a[0].total_cmp(&b[0])));
    let mut taken: Vec<[f64; 4]> = Vec::new();
    for ([x, y], names) in points {
        let mut text = names
            .iter()
            .take(MOST_NAMES)
            .copied()
            .collect::<Vec<_>>()
            .join(", ");
        if names.len() > MOST_NAMES {
            text.push_str(&format!(" and {} more", names.len() - MOST_NAMES));
        }
        let long = text.chars().count() as f64 * LETTER;
        let left = (x + AWAY).min(width - long - 2.0).max(2.0);
        let free = |top: &f64| {
            let one = [left, *top, left + long, *top + LINE];
            taken.iter().all(|other| {
                one[2] <= other[0] || other[2] <= one[0] || one[3] <= other[1] || other[3] <= one[1]
            })
        };
        let below = (0..).map(|step| y + BELOW + f64::from(step) * 3.0);
        let top = below
            .take_while(|top| top + LINE < height)
            .find(free)
            .unwrap_or(y + BELOW);
        taken.push([left, top, left + long, top + LINE]);
        let middle = top + LINE / 2.0;
        if middle - y > BELOW + LINE {
            let _ = writeln!(
                out,
                "{}</line>",
                line([x, y], [left - 2.0, middle], "leader", "#8a94a6")
            );
        }
        let _ = writeln!(
            out,
            "<text x=\"{left:.1}\" y=\"{middle:.1}\">{}</text>",
            escape_xml(&text)
        );
    }
}

fn origin(frame: &LinkFrame, camera: &Camera) -> [f64; 2] {
    let [x, y, _] = camera.project(frame.at.translation.vector.into());
    [x, y]
}

/// A line without its end tag.
fn line(from: [f64; 2], to: [f64; 2], class: &str, color: &str) -> String {
    let ([x1, y1], [x2, y2]) = (from, to);
    format!(
        "<line class=\"{class}\" stroke=\"{color}\" x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\">"
    )
}

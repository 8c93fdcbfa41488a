//! Wavefront OBJ and its material libraries.

use std::borrow::Cow;

use super::defect::Defect;
use super::draft::{Dependency, MeshBuilder};
use super::gltf::FileLoader;
use super::mtl::Colors;
use super::soup::MeshPoint;
use base::limits::MESH_FILES;

/// Read an OBJ file.
pub(super) fn read(
    bytes: &[u8],
    beside: FileLoader<'_>,
    draft: &mut MeshBuilder,
) -> Result<(), Defect> {
    let text = String::from_utf8_lossy(bytes);
    let mut colors = Colors::default();
    let mut points: Vec<MeshPoint> = Vec::new();
    for (number, line) in logical_lines(&text) {
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((&line, ""));
        match word {
            "v" => {
                let point = point(rest).ok_or_else(|| {
                    Defect::corrupt(format!("line {number}: `v` needs three numbers"))
                })?;
                points.push(point);
            }
            "f" => face(rest, &points, draft).map_err(|defect| Defect {
                message: format!("line {number}: {}", defect.message),
                ..defect
            })?,
            "mtllib" => {
                let name = rest.trim().to_owned();
                if draft.tinted {
                    colors.read(&name, beside);
                }
                draft.needs(Dependency {
                    name,
                    is_material_library: true,
                });
            }
            "usemtl" if draft.tinted => draft.soup.tint(colors.of(rest)),
            _ => {}
        }
    }
    Ok(())
}

/// The textures that a material library names.
pub(super) fn textures(bytes: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(bytes);
    let mut names: Vec<String> = Vec::new();
    for (_, line) in logical_lines(&text) {
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((&line, ""));
        let word = word.to_ascii_lowercase();
        let names_file = word.starts_with("map_")
            || matches!(word.as_str(), "bump" | "disp" | "decal" | "refl" | "norm");
        // options come before the name; a name without options may have blanks
        let rest = rest.trim();
        let name = if rest.starts_with('-') {
            rest.rsplit(char::is_whitespace).next()
        } else {
            Some(rest)
        };
        let name = name.unwrap_or_default().trim_matches('"').to_owned();
        let room = names.len() < MESH_FILES;
        if names_file && room && !name.is_empty() && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// Lines with their numbers, without comments; those that end with a backslash go on in the next one.
pub(super) fn logical_lines(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = (1..).zip(text.lines());
    std::iter::from_fn(move || {
        let (number, line) = lines.next()?;
        let mut line = Cow::Borrowed(without_comment(line));
        while let Some(head) = line.strip_suffix('\\') {
            let next = lines.next().map_or("", |(_, next)| without_comment(next));
            line = Cow::Owned(format!("{head} {next}"));
        }
        Some((number, line))
    })
}

fn without_comment(line: &str) -> &str {
    line.split('#').next().unwrap_or_default().trim()
}

fn point(text: &str) -> Option<MeshPoint> {
    let mut numbers = text.split_ascii_whitespace().map(|word| word.parse().ok());
    Some([numbers.next()??, numbers.next()??, numbers.next()??])
}

/// Take a polygon as a fan of triangles. One of one or two corners, which some exporters write, is a point or an edge: readers
/// draw nothing there.
fn face(text: &str, points: &[MeshPoint], draft: &mut MeshBuilder) -> Result<(), Defect> {
    let mut corners = text
        .split_ascii_whitespace()
        .map(|word| corner(word, points));
    let (Some(first), Some(second), Some(third)) = (corners.next(), corners.next(), corners.next())
    else {
        return Ok(());
    };
    let (first, mut before) = (first?, second?);
    for corner in std::iter::once(third).chain(corners) {
        let corner = corner?;
        draft.soup.push([first, before, corner])?;
        before = corner;
    }
    Ok(())
}

/// The point that `7/1/3` means: counted from 1, or backwards from the last one so far.
fn corner(word: &str, points: &[MeshPoint]) -> Result<MeshPoint, Defect> {
    let index = word.split('/').next().unwrap_or_default();
    let number: Option<i64> = index.parse().ok();
    let place = number.and_then(|number| match number {
        1.. => usize::try_from(number - 1).ok(),
        _ => points
            .len()
            .checked_sub(usize::try_from(number.unsigned_abs()).ok()?),
    });
    let found = place.and_then(|place| points.get(place));
    found.copied().ok_or_else(|| {
        Defect::corrupt(format!(
            "vertex index `{index:.20}` is out of range ({} vertices so far)",
            points.len()
        ))
    })
}

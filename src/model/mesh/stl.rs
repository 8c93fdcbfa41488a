//! STL, binary and as text.

use super::defect::Defect;
use super::draft::{MeshBuilder, MeshFormat};
use super::soup::MeshPoint;

/// Bytes in front of the number of triangles.
const HEADER: usize = 80;
/// Bytes of a triangle: normal, three corners, two unused bytes.
const TRIANGLE: usize = 50;
/// Numbers of the normal, which come first in a triangle.
const NORMAL: usize = 3;

/// Read a file that is called STL.
///
/// Binary files tell themselves by their size: many of them begin with the word `solid`, which should be a sign
/// of text.
pub(super) fn read(bytes: &[u8], draft: &mut MeshBuilder) -> Result<(), Defect> {
    let count = count(bytes);
    let solid = starts_with_solid(bytes);
    let fits = count.is_some_and(|count| size_for(count) == bytes.len() as u64);
    if !fits && solid && has_text_words(bytes) {
        draft.format = MeshFormat::StlAscii;
        return text(bytes, draft);
    }
    draft.format = MeshFormat::StlBinary { solid };
    let Some(count) = count else {
        let size = bytes.len();
        return Err(Defect::corrupt(format!(
            "it is too short for an STL file ({size} bytes)"
        )));
    };
    binary(bytes, count, draft)
}

/// The number of triangles that a binary file claims.
fn count(bytes: &[u8]) -> Option<u32> {
    let count = bytes.get(HEADER..HEADER + 4)?;
    Some(u32::from_le_bytes(count.try_into().ok()?))
}

fn size_for(count: u32) -> u64 {
    (HEADER + 4) as u64 + u64::from(count) * TRIANGLE as u64
}

fn starts_with_solid(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    text.get(..5)
        .is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

/// Whether a file has one of the words that follow `solid` in text.
fn has_text_words(bytes: &[u8]) -> bool {
    memchr::memmem::find(bytes, b"facet").is_some()
        || has_word(bytes, b"facet")
        || has_word(bytes, b"endsolid")
}

/// Whether a short file has a word in any case.
fn has_word(bytes: &[u8], word: &[u8]) -> bool {
    let head = bytes.get(..bytes.len().min(4096)).unwrap_or_default();
    head.windows(word.len())
        .any(|window| window.eq_ignore_ascii_case(word))
}

fn binary(bytes: &[u8], count: u32, draft: &mut MeshBuilder) -> Result<(), Defect> {
    let (expected, size) = (size_for(count), bytes.len() as u64);
    if size < expected {
        let message =
            format!("it should have {expected} bytes for {count} triangles but has {size}");
        return Err(Defect::corrupt(message));
    }
    if count > 0 && size > expected {
        let message = format!(
            "it has {} extra bytes after its {count} triangles",
            size - expected
        );
        draft.defect = Some(Defect::untidy(message));
    }
    let triangles = bytes
        .get(HEADER + 4..)
        .unwrap_or_default()
        .chunks_exact(TRIANGLE);
    for triangle in triangles.take(count as usize) {
        let mut numbers = triangle
            .as_chunks::<4>()
            .0
            .iter()
            .skip(NORMAL)
            .map(|bytes| f64::from(f32::from_le_bytes(*bytes)));
        let corners: [MeshPoint; 3] =
            std::array::from_fn(|_| std::array::from_fn(|_| numbers.next().unwrap_or(f64::NAN)));
        draft.soup.push(corners)?;
    }
    Ok(())
}

fn text(bytes: &[u8], draft: &mut MeshBuilder) -> Result<(), Defect> {
    let mut corners: Vec<MeshPoint> = Vec::new();
    for (number, line) in (1..).zip(bytes.split(|&byte| byte == b'\n')) {
        let mut words = line
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty());
        while let Some(word) = words.next() {
            if word.eq_ignore_ascii_case(b"solid") || word.eq_ignore_ascii_case(b"endsolid") {
                break; // a name follows
            }
            if word.eq_ignore_ascii_case(b"vertex") {
                let point = [(); 3].map(|()| words.next().and_then(coordinate));
                let [Some(x), Some(y), Some(z)] = point else {
                    return Err(Defect::corrupt(format!(
                        "line {number}: `vertex` needs three numbers"
                    )));
                };
                corners.push([x, y, z]);
            }
            if word.eq_ignore_ascii_case(b"endloop") {
                let Ok(triangle) = <[MeshPoint; 3]>::try_from(corners.as_slice()) else {
                    let count = corners.len();
                    return Err(Defect::corrupt(format!(
                        "line {number}: a facet has {count} vertices"
                    )));
                };
                draft.soup.push(triangle)?;
                corners.clear();
            }
        }
    }
    if corners.is_empty() {
        Ok(())
    } else {
        Err(Defect::corrupt("it ends in the middle of a facet"))
    }
}

fn coordinate(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

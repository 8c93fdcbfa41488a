//! STL files in the form that every program reads: binary, with a header that is not taken for text.

/// Bytes in front of the number of triangles.
const HEADER: usize = 80;
/// Bytes of a triangle.
const TRIANGLE: usize = 50;

/// The file as binary STL whose header does not begin with `solid`; none when it is that already, or no sound STL.
pub fn plain_stl(bytes: &[u8]) -> Option<Vec<u8>> {
    let solid = bytes
        .get(..5)
        .is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    let count = bytes
        .get(HEADER..HEADER + 4)
        .and_then(|count| count.try_into().ok())
        .map(u32::from_le_bytes);
    let fits = count.is_some_and(|count| HEADER + 4 + count as usize * TRIANGLE == bytes.len());
    match (fits, solid) {
        (true, true) => Some([b"stl  ".as_slice(), bytes.get(5..)?].concat()),
        (false, true) => binary(bytes),
        _ => None,
    }
}

/// Text as binary.
fn binary(text: &[u8]) -> Option<Vec<u8>> {
    let text = std::str::from_utf8(text).ok()?;
    let mut body = Vec::new();
    let mut count: u32 = 0;
    let mut normal = [0.0; 3];
    let mut corners: Vec<[f32; 3]> = Vec::new();
    for line in text.lines() {
        let words = line.split_ascii_whitespace();
        match words
            .clone()
            .next()
            .unwrap_or("")
            .to_ascii_lowercase()
            .as_str()
        {
            // a normal that was not computed counts as none
            "facet" => normal = three_numbers(words.clone().skip(2)).unwrap_or([0.0; 3]),
            "vertex" => corners.push(three_numbers(words.clone().skip(1))?),
            "endfacet" => {
                let [a, b, c] = <[[f32; 3]; 3]>::try_from(std::mem::take(&mut corners)).ok()?;
                let floats = [normal, a, b, c].into_iter().flatten();
                body.extend(floats.flat_map(f32::to_le_bytes));
                body.extend([0, 0]);
                count += 1;
            }
            _ => {}
        }
    }
    if count == 0 || !corners.is_empty() {
        return None;
    }
    let mut header = vec![b' '; HEADER];
    header.splice(..10, *b"binary stl");
    header.extend(count.to_le_bytes());
    header.extend(body);
    Some(header)
}

/// The finite numbers that three words are.
fn three_numbers<'a>(words: impl Iterator<Item = &'a str>) -> Option<[f32; 3]> {
    let mut numbers = words.map(|word| word.parse().ok().filter(|number: &f32| number.is_finite()));
    Some([numbers.next()??, numbers.next()??, numbers.next()??])
}

#[cfg(test)]
mod tests {
    use super::plain_stl;

    const TEXT: &str = "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   \
                        vertex 0 1.5e0 0\n  endloop\n endfacet\nendsolid a\n";

    #[test]
    fn text_becomes_binary() {
        let binary = plain_stl(TEXT.as_bytes()).unwrap();
        assert_eq!(binary.len(), 84 + 50);
        assert_eq!(binary[84 + 8..84 + 12], 1.0f32.to_le_bytes());
        assert_eq!(binary[84 + 12 + 28..84 + 12 + 32], 1.5f32.to_le_bytes());
        assert_eq!(plain_stl(&binary), None);
    }

    #[test]
    fn a_header_that_looks_like_text_is_changed_and_nothing_else() {
        let mut binary = plain_stl(TEXT.as_bytes()).unwrap();
        binary.splice(..5, *b"solid");
        let patched = plain_stl(&binary).unwrap();
        assert_eq!(
            (&patched[..5], &patched[5..]),
            (b"stl  ".as_slice(), &binary[5..])
        );
    }

    #[test]
    fn what_is_no_sound_stl_stays() {
        for text in [
            "",
            "solid",
            "solid a\nfacet normal 0 0 1\nvertex 1 2\nendfacet\n",
            "other",
        ] {
            assert_eq!(plain_stl(text.as_bytes()), None, "{text}");
        }
    }
}

//! "Did you mean".

/// The candidate closest to `word`, if any is close enough to be meant: at most a third of its letters
/// differ, and never more than three; of two letters, the second. The first of equals wins.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters: Vec<char> = word.chars().flat_map(char::to_lowercase).collect();
    let limit = if letters.len() == 2 { 1 } else { (letters.len() / 3).min(3) };
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let other: Vec<char> = candidate.chars().flat_map(char::to_lowercase).collect();
        if candidate == word || letters.len().abs_diff(other.len()) > limit {
            continue;
        }
        if letters.len() == 2 && (other.len() != 2 || letters.first() != other.first()) {
            continue;
        }
        let distance = distance(&letters, &other);
        if distance <= limit && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// How many letters of `a` are to be inserted, removed, replaced or swapped with their neighbour to get `b`.
pub fn edit_distance(a: &str, b: &str) -> usize {
    let letters = |text: &str| text.chars().collect::<Vec<char>>();
    distance(&letters(a), &letters(b))
}

/// Letters inserted, removed, replaced or swapped with their neighbour to get from `a` to `b`.
fn distance(a: &[char], b: &[char]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, &x) in a.iter().enumerate() {
        let mut next = vec![i + 1];
        for (j, &y) in b.iter().enumerate() {
            let at = |row: &[usize], column: usize| row.get(column).copied().unwrap_or(usize::MAX - 1);
            let mut cost = (at(&row, j) + usize::from(x != y)).min(at(&row, j + 1) + 1).min(at(&next, j) + 1);
            let swapped = i > 0 && j > 0 && a.get(i - 1) == Some(&y) && b.get(j - 1) == Some(&x);
            if swapped {
                cost = cost.min(at(&before, j - 1) + 1);
            }
            next.push(cost);
        }
        before = std::mem::replace(&mut row, next);
    }
    row.last().copied().unwrap_or(a.len())
}

#[cfg(test)]
mod tests {
    use super::{edit_distance, nearest};

    #[test]
    fn words() {
        let known = ["ur_description", "pr2_description", "xacro", "origin", "m0"];
        let table = [
            ("ur_descripton", Some("ur_description")),
            ("ur_descritpion", Some("ur_description")),
            ("Xacro", Some("xacro")),
            ("orgin", Some("origin")),
            ("roigin", Some("origin")),
            ("m1", Some("m0")),
            ("n0", None),
            ("xaxrp", None),
            ("moveit", None),
            ("xacro", None),
            ("", None),
        ];
        for (word, expected) in table {
            assert_eq!(nearest(word, known), expected, "{word}");
        }
        assert_eq!((edit_distance("orgin", "origin"), edit_distance("ab", "ba")), (1, 1));
        assert_eq!(nearest("abc", ["abd", "abe"]), Some("abd"));
        assert_eq!(nearest("ab", ["a", "b"]), None);
    }
}

//! "Did you mean".

/// Words longer than this are no names that anybody spells by hand.
const LONGEST: usize = 100;

/// The candidate closest to `word`, if any is close enough to be meant: at most a third of its letters
/// differ, and never more than three; of two letters, the second. The first of equals wins.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let (mut letters, mut other) = (Vec::new(), Vec::new());
    if !fold(word, &mut letters) {
        return None;
    }
    let counts = counts(&letters);
    let mut limit = if letters.len() == 2 {
        1
    } else {
        (letters.len() / 3).min(3)
    };
    let mut best = None;
    for candidate in candidates {
        // a letter takes one to four bytes
        let possible = letters.len() <= candidate.len() + limit
            && candidate.len() <= 4 * (letters.len() + limit);
        if candidate == word || !possible || !fold(candidate, &mut other) {
            continue;
        }
        if letters.len() == 2 && (other.len() != 2 || letters.first() != other.first()) {
            continue;
        }
        if far(counts, &other) > 2 * limit {
            continue;
        }
        if let Some(distance) = distance(&letters, &other, limit) {
            best = Some(candidate);
            if distance == 0 {
                break;
            }
            limit = distance - 1;
        }
    }
    best
}

/// Suggests names for several words that are none. Comparing takes time: after many comparisons nothing is suggested any more.
#[derive(Debug)]
pub struct Suggestions {
    /// How many names may still be compared.
    left: usize,
}

impl Default for Suggestions {
    fn default() -> Self {
        // a robot of 300 joints, none of which a file names right, is a tenth of it
        Self { left: 1_000_000 }
    }
}

impl Suggestions {
    /// Whether there is something left to spend.
    pub fn is_open(&self) -> bool {
        self.left > 0
    }

    /// The candidate that is [`nearest`] to a word.
    pub fn nearest<'a>(
        &mut self,
        word: &str,
        candidates: impl IntoIterator<Item = &'a str>,
    ) -> Option<&'a str> {
        let left = &mut self.left;
        let affordable = candidates.into_iter().take_while(|_| {
            let is_left = *left > 0;
            *left = left.saturating_sub(1);
            is_left
        });
        nearest(word, affordable)
    }
}

/// The small letters of a word; false when there are too many of them.
fn fold(word: &str, letters: &mut Vec<char>) -> bool {
    letters.clear();
    if word.is_ascii() {
        // nearly all names are
        let small = word
            .bytes()
            .map(|byte| char::from(byte.to_ascii_lowercase()));
        letters.extend(small.take(LONGEST + 1));
        return letters.len() <= LONGEST;
    }
    letters.extend(word.chars().flat_map(char::to_lowercase).take(LONGEST + 1));
    letters.len() <= LONGEST
}

/// How often letters occur, those that share the last bits of their codes together.
type Counts = [i16; 32];

fn counts(letters: &[char]) -> Counts {
    let mut counts = [0; 32];
    for &letter in letters {
        if let Some(count) = counts.get_mut(letter as usize % 32) {
            *count += 1;
        }
    }
    counts
}

/// How many letters at least are in one word only. One change of a letter adds two at most, so most words are told
/// apart at a glance.
fn far(mut counts: Counts, other: &[char]) -> usize {
    for &letter in other {
        if let Some(count) = counts.get_mut(letter as usize % 32) {
            *count -= 1;
        }
    }
    counts
        .iter()
        .map(|count| usize::from(count.unsigned_abs()))
        .sum()
}

/// Whether a name is `part` with further words in front or behind, joined by `_`.
pub(super) fn has_part(name: &str, part: &str) -> bool {
    let rest =
        |rest: Option<&str>, joint: fn(&str) -> bool| !part.is_empty() && rest.is_some_and(joint);
    rest(name.strip_prefix(part), |rest| rest.starts_with('_'))
        || rest(name.strip_suffix(part), |rest| rest.ends_with('_'))
}

/// Whether two similar names are meant to differ: in digits only, or in all letters of a word.
pub(super) fn is_another(a: &str, b: &str) -> bool {
    let (one, other): (Vec<&str>, Vec<&str>) = (a.split('_').collect(), b.split('_').collect());
    let mut pairs = one.iter().zip(&other).filter(|(one, other)| one != other);
    let (Some((one, other)), None, true) = (pairs.next(), pairs.next(), one.len() == other.len())
    else {
        return false;
    };
    without_digits(one).eq(without_digits(other))
        || !one.is_empty() && edit_distance(one, other) >= one.chars().count()
}

fn without_digits(word: &str) -> impl Iterator<Item = char> + '_ {
    word.chars().filter(|c| !c.is_ascii_digit())
}

/// The candidate that is almost surely meant by `word`, which is none of them: it differs by one slip of the fingers.
pub fn misspelled<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    candidates
        .into_iter()
        .find(|candidate| word != *candidate && is_slip(word, candidate))
}

/// Whether one name is the other with one slip of the fingers: two neighboring letters swapped, one doubled, dropped or
/// hit wrong, in a word long enough that both are hardly meant. A different digit or a plural makes another name.
fn is_slip(a: &str, b: &str) -> bool {
    /// Letters of a word that gains or loses one.
    const CHANGED: usize = 4;
    /// Letters of a word in which one is replaced.
    const REPLACED: usize = 5;
    // letters take at most four bytes
    if a.len().max(b.len()) > 4 * LONGEST || a.len().abs_diff(b.len()) > 4 {
        return false;
    }
    let (long, short) = if a.chars().count() < b.chars().count() {
        (letters(b), letters(a))
    } else {
        (letters(a), letters(b))
    };
    let same = long.iter().zip(&short).take_while(|(x, y)| x == y).count();
    let (left, right) = different(&long, &short);
    if left
        .iter()
        .chain(right)
        .any(|letter| !letter.is_alphabetic())
    {
        return false;
    }
    match (left, right) {
        ([x, y], [v, w]) => long.len() > 3 && (x, y) == (w, v),
        ([_], [_]) => word_around(&long, same) >= REPLACED,
        ([letter], []) => {
            let is_plural = *letter == 's' && long.get(same + 1).is_none_or(|next| *next == '_');
            let doubled = same.checked_sub(1).and_then(|before| long.get(before)) == Some(letter);
            word_around(&long, same) > CHANGED && (!is_plural || doubled)
        }
        _ => false,
    }
}

/// How many letters the word between underscores and digits has that position `at` belongs to.
fn word_around(name: &[char], at: usize) -> usize {
    let (before, after) = name.split_at_checked(at).unwrap_or((name, &[]));
    let letters = |letter: &&char| letter.is_alphabetic();
    before.iter().rev().take_while(letters).count() + after.iter().take_while(letters).count()
}

/// How many letters of `a` are to be inserted, removed, replaced or swapped with their neighbor to get `b`.
pub fn edit_distance(a: &str, b: &str) -> usize {
    let (a, b) = (letters(a), letters(b));
    let most = a.len().max(b.len());
    distance(&a, &b, most).unwrap_or(most)
}

fn letters(text: &str) -> Vec<char> {
    text.chars().collect()
}

/// Letters inserted, removed, replaced or swapped with their neighbor to get from `a` to `b`; none when these
/// are more than `most`.
fn distance(a: &[char], b: &[char], most: usize) -> Option<usize> {
    let (a, b) = different(a, b);
    if a.len().abs_diff(b.len()) > most {
        return None;
    }
    let mut before: Vec<usize> = Vec::new();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, &x) in a.iter().enumerate() {
        let mut next = vec![i + 1];
        for (j, &y) in b.iter().enumerate() {
            let mut cost = (cost_at(&row, j) + usize::from(x != y))
                .min(cost_at(&row, j + 1) + 1)
                .min(cost_at(&next, j) + 1);
            let swapped = i > 0 && j > 0 && a.get(i - 1) == Some(&y) && b.get(j - 1) == Some(&x);
            if swapped {
                cost = cost.min(cost_at(&before, j - 1) + 1);
            }
            next.push(cost);
        }
        // no later number is below the least of two rows
        if next.iter().chain(&row).all(|&cost| cost > most) {
            return None;
        }
        before = std::mem::replace(&mut row, next);
    }
    row.last().copied().filter(|&distance| distance <= most)
}

/// The cost in a column of a row; as good as endless outside of it.
#[inline]
fn cost_at(row: &[usize], column: usize) -> usize {
    row.get(column).copied().unwrap_or(usize::MAX - 1)
}

/// What lies between the letters that both begin with and those that both end with.
fn different<'a>(a: &'a [char], b: &'a [char]) -> (&'a [char], &'a [char]) {
    let same = a.iter().zip(b).take_while(|(x, y)| x == y).count();
    let (a, b) = (
        a.get(same..).unwrap_or_default(),
        b.get(same..).unwrap_or_default(),
    );
    let same = a
        .iter()
        .rev()
        .zip(b.iter().rev())
        .take_while(|(x, y)| x == y)
        .count();
    (
        a.get(..a.len() - same).unwrap_or_default(),
        b.get(..b.len() - same).unwrap_or_default(),
    )
}

#[cfg(test)]
mod tests {
    use super::{counts, distance, edit_distance, far, is_another, is_slip, nearest};

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
        assert_eq!(
            (edit_distance("orgin", "origin"), edit_distance("ab", "ba")),
            (1, 1)
        );
        assert_eq!(nearest("abc", ["abd", "abe"]), Some("abd"));
        assert_eq!(nearest("ab", ["a", "b"]), None);
        assert_eq!(
            nearest(&"x".repeat(2000), ["y".repeat(2000).as_str()]),
            None
        );
    }

    #[test]
    fn other_names() {
        for (name, other, expected) in [
            ("sr_description", "a1_description", true),
            ("ur5_description", "ur3_description", true),
            ("arm1", "arm2", true),
            ("arm_descripton", "arm_description", false),
            ("arm_description", "am_description", false),
            ("ram_description", "arm_description", false),
        ] {
            assert_eq!(is_another(name, other), expected, "{name} {other}");
        }
    }

    /// Words over few letters, so that many are near each other.
    #[test]
    fn a_bound_changes_no_distance_below_it() {
        let words: Vec<Vec<char>> = (0..3_usize.pow(5))
            .map(|n| {
                (0..5)
                    .map(|i| char::from(b'a' + (n / 3_usize.pow(i) % 3) as u8))
                    .collect()
            })
            .map(|word: Vec<char>| {
                word[..1 + word.iter().filter(|c| **c == 'a').count().min(4)].to_vec()
            })
            .collect();
        for (a, b) in words
            .iter()
            .zip(words.iter().rev())
            .chain(words.iter().zip(words.iter().skip(7)))
        {
            let exact = distance(a, b, 9).unwrap();
            for most in 0..6 {
                assert_eq!(
                    distance(a, b, most),
                    Some(exact).filter(|&exact| exact <= most),
                    "{a:?} {b:?}"
                );
                assert!(far(counts(a), b) <= 2 * exact, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn slips_of_the_fingers() {
        for (name, meant) in [
            ("preifx", "prefix"),
            ("M_IP", "M_PI"),
            ("masss", "mass"),
            ("naem", "name"),
            ("wheel_radus", "wheel_radius"),
            ("wheel_rsdius", "wheel_radius"),
            ("arm_1_loewr_limit", "arm_1_lower_limit"),
        ] {
            assert!(
                is_slip(name, meant) && is_slip(meant, name),
                "{name} {meant}"
            );
        }
        for (name, other) in [
            ("link_1", "link_2"),
            ("arm_x", "arm_y"),
            ("wheels", "wheel"),
            ("wheels_mass", "wheel_mass"),
            ("box_size", "box_side"),
            ("base_link", "baselink"),
            ("rear", "ear"),
            ("prefix", "suffix"),
            ("lr", "rl"),
            ("same", "same"),
        ] {
            assert!(
                !is_slip(name, other) && !is_slip(other, name),
                "{name} {other}"
            );
        }
    }
}

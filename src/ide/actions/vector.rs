//! Vectors of the wrong length, axes without a direction, and names that are taken.

use super::place::element_at;
use super::{Action, edit, fix};
use base::TextRange;
use vfs::SourceFile;
use xml::{Attr, Document};

/// How a vector gets its length, where the numbers that are there say so.
pub(super) fn length(source: &SourceFile, range: TextRange) -> Option<Action> {
    let (base, attr) = attribute_at(&source.document, range)?;
    let words = plain_numbers(&attr)?;
    let wanted = if matches!(attr.name(), "rgba" | "quat_xyzw") {
        4
    } else {
        3
    };
    let (title, new) = match (attr.name(), words.len()) {
        (_, n) if n > wanted => {
            let rest = words.get(wanted..)?.join(" ");
            (
                format!("remove `{rest}` from the end"),
                words.get(..wanted)?.join(" "),
            )
        }
        ("scale" | "size", 1) => {
            let new = vec![*words.first()?; wanted].join(" ");
            (format!("replace with `{new}`"), new)
        }
        ("rgba", 3) => ("add alpha `1`".to_owned(), format!("{} 1", words.join(" "))),
        ("xyz" | "rpy", n @ 1..) if n < wanted => {
            let new = [words.as_slice(), &vec!["0"; wanted - n]]
                .concat()
                .join(" ");
            (format!("replace with `{new}`"), new)
        }
        _ => return None,
    };
    Some(fix(
        title,
        vec![edit(source, attr.value_range().shift(base), new)],
    ))
}

/// Directions for an axis that has none.
pub(super) fn axis(source: &SourceFile, range: TextRange) -> Vec<Action> {
    let Some((base, attr)) = attribute_at(&source.document, range) else {
        return Vec::new();
    };
    if attr.name() != "xyz" || plain_numbers(&attr).is_none() {
        return Vec::new();
    }
    let place = attr.value_range().shift(base);
    let to = |axis: &str| {
        fix(
            format!("set axis to `{axis}`"),
            vec![edit(source, place, axis)],
        )
    };
    ["0 0 1", "0 1 0", "1 0 0"].map(to).to_vec()
}

/// A name for the second joint of one name. What refers to the name goes on to mean the first one.
pub(super) fn other_joint_name(source: &SourceFile, range: TextRange) -> Option<Action> {
    let (base, attr) =
        attribute_at(&source.document, range).filter(|(_, attr)| attr.name() == "name")?;
    let name = attr.raw();
    if name.is_empty() || name.contains(['$', '&']) {
        return None;
    }
    let text = source.document.text();
    let numbered = (2..1000).map(|number| format!("{name}_{number}"));
    let free = numbered
        .into_iter()
        .find(|free| !text.contains(&format!("\"{free}\"")))?;
    let place = attr.value_range().shift(base);
    Some(fix(
        format!("rename this joint to `{free}`"),
        vec![edit(source, place, free)],
    ))
}

/// The attribute that a finding is about, with where its item begins.
fn attribute_at(document: &Document, range: TextRange) -> Option<(u32, Attr<'_>)> {
    let (base, node) = element_at(document, range.start)?;
    let attr = node
        .attrs()
        .find(|attr| attr.range().shift(base).contains_range(range))?;
    Some((base, attr))
}

/// The words of a value that holds numbers only.
fn plain_numbers<'a>(attr: &Attr<'a>) -> Option<Vec<&'a str>> {
    let words: Vec<&str> = attr.raw().split_whitespace().collect();
    words
        .iter()
        .all(|word| word.parse::<f64>().is_ok())
        .then_some(words)
}

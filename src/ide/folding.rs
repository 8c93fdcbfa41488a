//! What can be folded: elements, comments, runs of properties and includes, regions.

use base::{Encoding, TextRange};
use xml::{Document, Node, NodeKind};

/// Lines that can be folded, the first stays visible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fold {
    /// First line, from 0.
    pub start: u32,
    /// Last line.
    pub end: u32,
    /// What is folded.
    pub kind: FoldKind,
}

/// What is folded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoldKind {
    /// An element, or a run of properties.
    Element,
    /// A comment of several lines.
    Comment,
    /// A run of includes.
    Includes,
    /// From `<!-- region x -->` to `<!-- endregion -->`.
    Region,
}

/// Everything that can be folded, in document order.
pub fn folds(document: &Document) -> Vec<Fold> {
    let mut found = Vec::new();
    if let (Some(root), Some(end)) = (document.root(), document.root_end_tag()) {
        add(
            document,
            TextRange::new(root.start_tag_range().start, end.start),
            FoldKind::Element,
            &mut found,
        );
    }
    let mut regions: Vec<u32> = Vec::new();
    let mut run: Option<(&str, TextRange)> = None;
    for (base, item) in document.parts() {
        for node in item.all_nodes() {
            let range = node.range().shift(base);
            match node.kind() {
                NodeKind::Element => {
                    if node.parent().is_none() {
                        run = extended(document, run, node, range, &mut found);
                    }
                    let content = node.end_tag().map_or(range.end, |tag| tag.start + base);
                    if Some(range.start) != document.root().map(|root| root.start_tag_range().start)
                        || base > 0
                    {
                        add(
                            document,
                            TextRange::new(range.start, content),
                            FoldKind::Element,
                            &mut found,
                        );
                    }
                }
                NodeKind::Comment => region(document, node, range, &mut regions, &mut found),
                _ => {}
            }
        }
    }
    flush(document, run, &mut found);
    found.sort_by_key(|fold| (fold.start, std::cmp::Reverse(fold.end)));
    found.dedup_by_key(|fold| (fold.start, fold.end));
    found
}

/// The largest of these, in their order: whatever holds one of them is among them too.
pub fn largest(mut folds: Vec<Fold>, most: usize) -> Vec<Fold> {
    if folds.len() > most {
        folds.sort_by_key(|fold| std::cmp::Reverse(fold.end - fold.start));
        folds.truncate(most);
        folds.sort_by_key(|fold| (fold.start, std::cmp::Reverse(fold.end)));
    }
    folds
}

/// A run of properties or of includes, with the next element.
fn extended<'a>(
    document: &Document,
    run: Option<(&'a str, TextRange)>,
    node: Node<'a>,
    range: TextRange,
    found: &mut Vec<Fold>,
) -> Option<(&'a str, TextRange)> {
    match run {
        Some((name, before)) if name == node.name() => {
            Some((name, TextRange::new(before.start, range.end)))
        }
        _ => {
            flush(document, run, found);
            matches!(
                node.name(),
                "xacro:property" | "xacro:include" | "xacro:arg"
            )
            .then(|| (node.name(), range))
        }
    }
}

fn flush(document: &Document, run: Option<(&str, TextRange)>, found: &mut Vec<Fold>) {
    if let Some((name, range)) = run {
        let kind = if name == "xacro:include" {
            FoldKind::Includes
        } else {
            FoldKind::Element
        };
        add(document, range, kind, found);
    }
}

fn region(
    document: &Document,
    node: Node<'_>,
    range: TextRange,
    open: &mut Vec<u32>,
    found: &mut Vec<Fold>,
) {
    let text = node.raw().trim();
    if text == "region" || text.starts_with("region ") {
        open.push(range.start);
    } else if text == "endregion" || text.starts_with("endregion ") {
        if let Some(start) = open.pop() {
            add(
                document,
                TextRange::new(start, range.end),
                FoldKind::Region,
                found,
            );
        }
    } else {
        add(document, range, FoldKind::Comment, found);
    }
}

fn add(document: &Document, range: TextRange, kind: FoldKind, found: &mut Vec<Fold>) {
    let [start, last] =
        [range.start, range.end].map(|offset| document.line_col(offset, Encoding::Utf8).line);
    // an end tag on a line of its own stays visible
    let end = if kind == FoldKind::Element && last > start + 1 {
        last - 1
    } else {
        last
    };
    if end > start {
        found.push(Fold { start, end, kind });
    }
}

//! A kinematic tree as a picture: links as boxes from left to right, joints on the lines between them.

use std::fmt::Write;

use super::tree::{LinkTree, kind};
use base::escape_xml;

/// Width of a character, in user units (a monospaced font of size 12).
const CHAR: f64 = 7.3;
/// Height of a box.
const BOX: f64 = 26.0;
/// Distance from row to row.
const ROW: f64 = 40.0;
/// Free space around the picture, and inside of boxes.
const MARGIN: f64 = 16.0;
const PADDING: f64 = 10.0;

const STYLE: &str = "\
text{font:12px ui-monospace,SFMono-Regular,Menlo,Consolas,monospace;dominant-baseline:central}\
.link rect{fill:#eef3fb;stroke:#4a6fa5}.link text{fill:#16243b;text-anchor:middle}\
.joint path{fill:none;stroke:#8a94a6}.joint text{fill:#5b6473;font-size:11px}\
.fixed path{stroke-dasharray:4 3}\
@media(prefers-color-scheme:dark){.link rect{fill:#1d2a40;stroke:#7ea3d8}.link text{fill:#e6edf7}\
.joint path{stroke:#7a8699}.joint text{fill:#a9b3c3}}";

/// A link that has its place.
struct LinkLayout {
    link: usize,
    depth: usize,
    row: f64,
    parent: Option<usize>,
    joint: Option<(String, String)>,
}

/// Draw a tree.
pub(super) fn draw(tree: &LinkTree<'_>) -> String {
    let placed = place(tree);
    let columns = columns(tree, &placed);
    let rows = placed.iter().map(|p| p.row).fold(0.0, f64::max) + 1.0;
    let total_width = placed
        .iter()
        .map(|p| left(&columns, p) + width(tree, p))
        .fold(0.0, f64::max)
        + MARGIN;
    let total_height = rows * ROW + 2.0 * MARGIN - (ROW - BOX);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{total_width:.0}\" height=\"{total_height:.0}\" \
         viewBox=\"0 0 {total_width:.0} {total_height:.0}\">\n<title>{}</title>\n<style>{STYLE}</style>\n",
        escape_xml(
            tree.robot
                .name
                .as_ref()
                .map_or("", |name| name.value.as_str())
        )
    );
    for child in &placed {
        let Some((parent, (joint, kind))) = child
            .parent
            .and_then(|p| placed.get(p))
            .zip(child.joint.as_ref())
        else {
            continue;
        };
        let (x0, y0) = (left(&columns, parent) + width(tree, parent), middle(parent));
        let (x1, y1) = (left(&columns, child), middle(child));
        let bend = columns.get(child.depth).map_or(x1, |column| column.bend);
        let class = if kind == "fixed" {
            "joint fixed"
        } else {
            "joint"
        };
        let _ = writeln!(
            out,
            "<g class=\"{class}\"><title>{0}: {1}</title><path d=\"M{x0:.1} {y0:.1}H{bend:.1}V{y1:.1}H{x1:.1}\"/>\
             <text x=\"{2:.1}\" y=\"{3:.1}\">{0} ({1})</text></g>",
            escape_xml(joint),
            escape_xml(kind),
            bend + 6.0,
            y1 - 9.0
        );
    }
    for link in &placed {
        let (x, w) = (left(&columns, link), width(tree, link));
        let y = middle(link) - BOX / 2.0;
        let _ = writeln!(
            out,
            "<g class=\"link\"><rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{w:.1}\" height=\"{BOX}\" rx=\"5\"/>\
             <text x=\"{:.1}\" y=\"{:.1}\">{}</text></g>",
            x + w / 2.0,
            y + BOX / 2.0,
            escape_xml(tree.link(link.link))
        );
    }
    out.push_str("</svg>\n");
    out
}

/// The left edge of the box of a link.
fn left(columns: &[Column], placed: &LinkLayout) -> f64 {
    columns.get(placed.depth).map_or(0.0, |column| column.left)
}

/// The width of the box of a link.
fn width(tree: &LinkTree<'_>, placed: &LinkLayout) -> f64 {
    length(tree.link(placed.link)) * CHAR + 2.0 * PADDING
}

/// The height at which the joints of a link begin and end.
fn middle(placed: &LinkLayout) -> f64 {
    MARGIN + placed.row * ROW + BOX / 2.0
}

/// Give each link a row: leaves one after the other, every other link halfway between its first and last child.
fn place(tree: &LinkTree<'_>) -> Vec<LinkLayout> {
    let mut placed = vec![LinkLayout {
        link: tree.root,
        depth: 0,
        row: 0.0,
        parent: None,
        joint: None,
    }];
    let mut open = vec![0];
    let mut children: Vec<Vec<usize>> = vec![Vec::new()];
    let mut order = Vec::new();
    while let Some(at) = open.pop() {
        order.push(at);
        let Some((link, depth)) = placed.get(at).map(|p| (p.link, p.depth)) else {
            continue;
        };
        for (joint, child) in tree.children(link) {
            let joint = Some((joint.shown().to_owned(), kind(joint).to_owned()));
            children
                .get_mut(at)
                .into_iter()
                .for_each(|list| list.push(placed.len()));
            placed.push(LinkLayout {
                link: child,
                depth: depth + 1,
                row: 0.0,
                parent: Some(at),
                joint,
            });
            children.push(Vec::new());
        }
        open.extend(children.get(at).into_iter().flatten().rev());
    }
    let mut leaves = 0.0;
    for &at in &order {
        if children.get(at).is_some_and(Vec::is_empty) {
            placed.get_mut(at).into_iter().for_each(|p| p.row = leaves);
            leaves += 1.0;
        }
    }
    // children come behind their parents in `order`
    for &at in order.iter().rev() {
        let Some(list) = children.get(at).filter(|list| !list.is_empty()) else {
            continue;
        };
        let middle = (row(&placed, list.first()) + row(&placed, list.last())) / 2.0;
        placed.get_mut(at).into_iter().for_each(|p| p.row = middle);
    }
    placed
}

fn row(placed: &[LinkLayout], number: Option<&usize>) -> f64 {
    number
        .and_then(|&number| placed.get(number))
        .map_or(0.0, |p| p.row)
}

/// Where the boxes of a depth begin, and where the lines to them bend.
struct Column {
    bend: f64,
    left: f64,
}

fn columns(tree: &LinkTree<'_>, placed: &[LinkLayout]) -> Vec<Column> {
    let depth = placed.iter().map(|p| p.depth).max().unwrap_or(0);
    let mut boxes = vec![0.0_f64; depth + 1];
    let mut labels = vec![0.0_f64; depth + 1];
    for p in placed {
        let label = p.joint.as_ref().map_or(0.0, |(joint, kind)| {
            (length(joint) + length(kind) + 3.0) * CHAR * 0.92
        });
        boxes
            .get_mut(p.depth)
            .into_iter()
            .for_each(|w| *w = w.max(length(tree.link(p.link)) * CHAR + 2.0 * PADDING));
        labels
            .get_mut(p.depth)
            .into_iter()
            .for_each(|w| *w = w.max(label));
    }
    let mut columns = Vec::new();
    let mut right = MARGIN;
    for (i, (width, label)) in boxes.into_iter().zip(labels).enumerate() {
        let bend = right + if i == 0 { 0.0 } else { 18.0 };
        let left = if i == 0 { right } else { bend + label + 18.0 };
        right = left + width;
        columns.push(Column { bend, left });
    }
    columns
}

fn length(text: &str) -> f64 {
    text.chars().count() as f64
}

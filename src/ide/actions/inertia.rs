//! The inertia of a solid body of even density, from its shape and mass.

use super::place::{enclosing, last_child, margin};
use super::{Action, ActionKind, edit};
use crate::Cx;
use base::{Span, TextRange};
use expand::{SourceRange, XId};
use model::{AttrValue, Body, Inertial, Link, Pose, ShapeKind, element_range};
use rules::Edit;
use xml::Node;

/// Write the inertia that follows from the geometry of the link at an offset: a box, a cylinder, a capsule or a sphere
/// with the mass that is given. The center of mass is the center of the shape. Nothing is offered where the numbers
/// differ from call to call.
pub(super) fn from_geometry(cx: &Cx<'_>, offset: u32) -> Option<Action> {
    let document = &cx.source.document;
    let (base, node) = enclosing(document, offset, "link")?;
    let place = node.range().shift(base);
    let links = place_of_links(cx, place);
    let mut all = links.map(|link| Some((solid(link)?, link)));
    let (numbers, link) = all.next()??;
    if !all.all(|other| other.is_some_and(|(other, _)| other == numbers)) {
        return None;
    }
    let source = child(node, "inertial")?;
    let body = body(link)?;
    let body_node = node
        .child_elements()
        .find(|child| is_at(cx, body.element, child.range().shift(base)))?;
    let given = link
        .inertial
        .as_ref()
        .and_then(|inertial| inertial.origin.as_ref());
    if !is_origin_written(body_node, body.origin.as_ref()) || !is_origin_written(source, given) {
        return None;
    }
    let mut edits = entries(cx, base, source, numbers);
    edits.extend(center(cx, base, source, child(body_node, "origin")));
    edits.sort_by_key(|edit| (edit.span.range.start, edit.span.range.end));
    let title = format!("compute inertia from the {}", shape_name(body)?);
    Some(Action {
        title,
        kind: ActionKind::Rewrite,
        edits,
    })
}

/// The links that the element at a place makes, one a call.
pub(super) fn place_of_links<'a>(cx: &Cx<'a>, place: TextRange) -> impl Iterator<Item = &'a Link> {
    let links = cx.robot.into_iter().flat_map(|robot| &robot.links);
    let own = *cx;
    links.filter(move |link| is_at(&own, link.element, place))
}

pub(super) fn is_at(cx: &Cx<'_>, element: XId, place: TextRange) -> bool {
    let span = cx.span(SourceRange::from(element_range(cx.expansion, element)));
    span == Some(Span {
        file: cx.source.id,
        range: place,
    })
}

pub(super) fn child<'a>(node: Node<'a>, name: &str) -> Option<Node<'a>> {
    node.child_elements().find(|child| child.name() == name)
}

/// Whether the text of an element has the origin that is there: one that a macro brings along has no text here.
pub(super) fn is_origin_written(node: Node<'_>, origin: Option<&Pose>) -> bool {
    child(node, "origin").is_some() == origin.is_some()
}

/// The body whose shape counts: the only collision, else the only visual.
pub(super) fn body(link: &Link) -> Option<&Body> {
    match (link.collisions.as_slice(), link.visuals.as_slice()) {
        ([one], _) | ([], [one]) => Some(one),
        _ => None,
    }
}

fn shape_name(body: &Body) -> Option<&'static str> {
    match body.shape()?.kind {
        ShapeKind::Box { .. } => Some("box"),
        ShapeKind::Cylinder { .. } => Some("cylinder"),
        ShapeKind::Capsule { .. } => Some("capsule"),
        ShapeKind::Sphere { .. } => Some("sphere"),
        _ => None,
    }
}

/// `ixx iyy izz` in kg m^2, from lengths in m and a mass in kg.
fn solid(link: &Link) -> Option<[f64; 3]> {
    let mass = link.inertial.as_ref().and_then(Inertial::mass)?;
    let [x, y, z] = match &body(link)?.shape()?.kind {
        ShapeKind::Box { size } => {
            let [x, y, z] = size
                .as_ref()?
                .numbers::<3>()?
                .map(|length| length * length / 12.0);
            [y + z, x + z, x + y]
        }
        ShapeKind::Cylinder { radius, length } => {
            let (r, l) = (positive(radius)?, positive(length)?);
            let across = r * r / 4.0 + l * l / 12.0;
            [across, across, r * r / 2.0]
        }
        ShapeKind::Capsule { radius, length } => capsule(positive(radius)?, positive(length)?),
        ShapeKind::Sphere { radius } => {
            let r = positive(radius)?;
            [0.4 * r * r; 3]
        }
        _ => return None,
    };
    let inertia = [mass * x, mass * y, mass * z];
    inertia
        .iter()
        .all(|entry| entry.is_finite() && *entry > 0.0)
        .then_some(inertia)
}

fn positive(text: &Option<AttrValue>) -> Option<f64> {
    text.as_ref()
        .and_then(AttrValue::number)
        .filter(|n| *n > 0.0)
}

/// The moments of a capsule for a mass of 1: those of its cylinder and of its half spheres, by their volumes.
fn capsule(r: f64, l: f64) -> [f64; 3] {
    let round = 4.0 * r / (3.0 * l + 4.0 * r);
    let straight = 1.0 - round;
    let along = straight * r * r / 2.0 + round * 0.4 * r * r;
    let across = straight * (r * r / 4.0 + l * l / 12.0)
        + round * (0.4 * r * r + l * l / 4.0 + 3.0 * l * r / 8.0);
    [across, across, along]
}

/// The element `inertia` with these numbers.
fn entries(cx: &Cx<'_>, base: u32, inertial: Node<'_>, [x, y, z]: [f64; 3]) -> Vec<Edit> {
    let [x, y, z] = [x, y, z].map(shown);
    let text =
        format!("<inertia ixx=\"{x}\" ixy=\"0\" ixz=\"0\" iyy=\"{y}\" iyz=\"0\" izz=\"{z}\"/>");
    let (range, text) = match child(inertial, "inertia") {
        Some(old) => (old.range().shift(base), text),
        None => last_child(cx.source, base, inertial, &text),
    };
    vec![edit(cx.source, range, text)]
}

/// The origin of the shape as that of the inertia.
fn center(cx: &Cx<'_>, base: u32, inertial: Node<'_>, shape: Option<Node<'_>>) -> Option<Edit> {
    let document = &cx.source.document;
    let new = shape.map(|origin| document.slice(origin.range().shift(base)));
    let old = child(inertial, "origin").map(|origin| origin.range().shift(base));
    match (old, new) {
        (Some(old), Some(new)) if document.slice(old) != new => Some(edit(cx.source, old, new)),
        (Some(old), None) => {
            let identity = "<origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>";
            (document.slice(old) != identity).then(|| edit(cx.source, old, identity))
        }
        (None, Some(new)) => {
            // in front of the first element, on a line like it
            let first = inertial.child_elements().next()?.range().start + base;
            let end = super::place::line_end(document);
            let text = format!("{new}{end}{}", margin(document, first));
            Some(edit(cx.source, TextRange::empty(first), text))
        }
        _ => None,
    }
}

/// A number with six digits that count, and none that do not.
pub(super) fn shown(number: f64) -> String {
    let rounded: f64 = format!("{number:.5e}").parse().unwrap_or(number);
    let plain = format!("{rounded}");
    if plain.len() <= 12 {
        plain
    } else {
        format!("{rounded:e}")
    }
}

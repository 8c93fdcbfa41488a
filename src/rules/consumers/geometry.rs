//! Shapes of visuals and collisions.
use super::facts::{ConstructCollector, RobotFacts, link_owner};
use expand::XId;
use model::{AttrValue, Body, Link, Shape, ShapeKind, Version};

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    for link in &facts.robot.links {
        for (bodies, prefix) in [(&link.visuals, ""), (&link.collisions, "collision-")] {
            for body in bodies {
                let mut at = |row: &str, element: XId| {
                    out.add(
                        &format!("{prefix}{row}"),
                        facts.at(element),
                        link_owner(link),
                    );
                };
                geometry(facts, body, &mut at);
                twice(facts, (link, body), out);
            }
        }
    }
}

fn geometry(facts: &RobotFacts<'_, '_>, body: &Body, at: &mut impl FnMut(&str, XId)) {
    let Some(geometry) = &body.geometry else {
        return at("geometry-missing", body.element);
    };
    let Some(shape) = geometry.shapes.first() else {
        return at("geometry-empty", geometry.element);
    };
    match &shape.kind {
        ShapeKind::Other => at("shape-unknown", shape.element),
        ShapeKind::Capsule { .. } => {
            let is_read = facts
                .version
                .is_some_and(|version| version >= Version::V1_1);
            at(
                if is_read { "capsule" } else { "capsule-1.0" },
                shape.element,
            );
        }
        ShapeKind::Mesh { .. } => {}
        _ if has_size(shape, |size| size < 0.0) => at("size-negative", shape.element),
        _ if !has_size(shape, |size| size == 0.0) => {}
        ShapeKind::Sphere { .. } => at("sphere-zero", shape.element),
        _ => at("size-zero", shape.element),
    }
}

/// Whether one of the sizes of a shape that are known is such a number.
fn has_size(shape: &Shape, is_such: fn(f64) -> bool) -> bool {
    let mut known = sizes(shape)
        .into_iter()
        .flatten()
        .filter(|text| text.is_known());
    known.any(|text| {
        text.words()
            .filter_map(|range| text.value.get(range).and_then(model::decimal))
            .any(is_such)
    })
}

fn sizes(shape: &Shape) -> [Option<&AttrValue>; 2] {
    match &shape.kind {
        ShapeKind::Box { size } => [size.as_ref(), None],
        ShapeKind::Sphere { radius } => [radius.as_ref(), None],
        ShapeKind::Cylinder { radius, length } | ShapeKind::Capsule { radius, length } => {
            [radius.as_ref(), length.as_ref()]
        }
        ShapeKind::Mesh { .. } | ShapeKind::Other => [None, None],
    }
}

/// What is there twice, of which consumers read one.
fn twice(facts: &RobotFacts<'_, '_>, (link, body): (&Link, &Body), out: &mut ConstructCollector) {
    let rows = [
        ("geometry", "two-geometries"),
        ("origin", "two-visual-origins"),
        ("material", "two-materials"),
    ];
    for (name, row) in rows {
        if let Some(second) = facts.children(body.element, name).nth(1) {
            out.add(row, facts.at(second), link_owner(link));
        }
    }
    let second = body
        .geometry
        .as_ref()
        .and_then(|geometry| geometry.shapes.get(1));
    if let Some(second) = second {
        out.add("two-shapes", facts.at(second.element), link_owner(link));
    }
}

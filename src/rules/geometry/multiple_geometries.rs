//! A second shape in one geometry.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::shapes::bodies;
use model::{Link, ShapeKind, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "GEO015",
    name: "multiple-geometries",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("multiple-geometries"),
    check: Check::Link(check),
};

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    for (body, _) in bodies(link) {
        let Some(geometry) = &body.geometry else {
            continue;
        };
        // a shape that URDF does not know has a rule of its own
        let mut shapes = geometry
            .shapes
            .iter()
            .filter(|shape| !matches!(shape.kind, ShapeKind::Other));
        if let (Some(first), Some(second)) = (shapes.next(), shapes.next()) {
            let message = format!(
                "`geometry` of link `{}` has more than one shape",
                link.shown()
            );
            out.report(tag_start(cx.expansion, second.element), message)
                .also(
                    tag_start(cx.expansion, first.element),
                    "parsers use this shape",
                )
                .help("put each shape in a separate <visual> or <collision>")
                .done();
        }
    }
}

//! A geometry without shape.
use super::super::context::{DocumentCx, RootKind};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::shapes::{bodies, is_taken_out};
use model::{Link, source_has_elements, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "GEO014",
    name: "empty-geometry",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("empty-geometry"),
    check: Check::Link(check),
};

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    for (body, _) in bodies(link) {
        let Some(geometry) = body
            .geometry
            .as_ref()
            .filter(|geometry| geometry.shapes.is_empty())
        else {
            continue;
        };
        // what xacro tags inside would have given may be lost
        cx.look_beyond();
        let certain =
            cx.kind == RootKind::Robot && cx.expansion.whole && cx.expansion.problems.is_empty();
        if certain || !source_has_elements(cx.expansion, geometry.element) {
            let message = format!("`geometry` of link `{}` is empty", link.shown());
            let origin = tag_start(cx.expansion, geometry.element);
            let is_meant = is_taken_out(&cx.expansion.tree, body.element, geometry.element);
            out.report(origin, message)
                .severity(if is_meant {
                    Severity::Info
                } else {
                    RULE.severity
                })
                .help("add a <box>, <cylinder>, <sphere> or <mesh>")
                .done();
        }
    }
}

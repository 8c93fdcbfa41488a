//! A collision that does not hold the visual.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::bodies::extent_of;
use model::{Bounds, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "GEO033",
    name: "collision-smaller-than-visual",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("collision-smaller-than-visual"),
    check: Check::Document(check),
};

/// What may stick out, meters.
const TOLERANCE: f64 = 0.01;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for link in cx.robot.into_iter().flat_map(|robot| &robot.links) {
        let (visual, collision) = (
            extent_of(cx, &link.visuals).bounds(),
            extent_of(cx, &link.collisions).bounds(),
        );
        let (Some(visual), Some(collision), Some(first)) =
            (visual, collision, link.collisions.first())
        else {
            continue;
        };
        let out_by = sticks_out(visual, collision);
        if out_by > TOLERANCE {
            let message = format!(
                "visual of link `{}` extends {out_by:.3} m beyond its collision geometry",
                link.shown()
            );
            let origin = tag_start(cx.expansion, first.element);
            out.report(origin, message)
                .help("enlarge the collision geometry so that it encloses the visual")
                .done();
        }
    }
}

/// How far a box sticks out of another one.
fn sticks_out(inner: Bounds, outer: Bounds) -> f64 {
    outer.outside(inner.min).max(outer.outside(inner.max))
}

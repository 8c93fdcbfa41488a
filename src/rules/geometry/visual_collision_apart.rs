//! A visual and a collision of one link that do not overlap.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::bodies::extent_of;
use super::collision_origin_mismatch::mismatch;
use super::mesh_scale_suspicious::is_scaled_wrong;
use model::{Bounds, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "GEO035",
    name: "visual-collision-apart",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("visual-collision-apart"),
    check: Check::Document(check),
};

/// The part of the smaller length that boxes share along an axis when they only touch.
const TOUCH: f64 = 0.01;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for link in cx.links() {
        let (visual, collision) = (
            extent_of(cx, &link.visuals).bounds(),
            extent_of(cx, &link.collisions).bounds(),
        );
        let (Some(visual), Some(collision), Some(first)) =
            (visual, collision, link.collisions.first())
        else {
            continue;
        };
        // markers show no part
        if visual.diagonal().min(collision.diagonal()) < MARKER {
            continue;
        }
        // the same shape at another place is a finding of its own
        if !is_apart(visual, collision) || is_scaled_wrong(cx, link) || mismatch(cx, link).is_some()
        {
            continue;
        }
        let message = format!(
            "visual and collision of link `{}` do not overlap",
            link.shown()
        );
        out.report(tag_start(cx.expansion, first.element), message)
            .help("correct the `origin` of one of them; both show the same part")
            .done();
    }
}

/// Smaller shapes stand for something else, meters.
const MARKER: f64 = 0.02;

/// Whether two boxes share no space.
fn is_apart(one: Bounds, other: Bounds) -> bool {
    let sizes = one
        .size()
        .into_iter()
        .zip(other.size())
        .map(|(a, b)| a.min(b));
    let shared = one
        .max
        .iter()
        .zip(&other.max)
        .zip(one.min.iter().zip(&other.min));
    let shared = shared
        .map(|((max, other_max), (min, other_min))| max.min(*other_max) - min.max(*other_min));
    shared
        .zip(sizes)
        .any(|(shared, size)| shared < 0.0 || size > 0.0 && shared < TOUCH * size)
}

//! Running the rules about files beside robots.
use super::beside::BesideCx;
use super::chosen::Chosen;
use super::finding::Finding;
use super::registry::all;
use super::rule::Check;
use super::sink::Sink;

/// What the rules say about a file beside robots.
pub fn check_beside(cx: &BesideCx<'_>, chosen: Chosen<'_>) -> Vec<Finding> {
    let Some(first) = all().next() else {
        return Vec::new();
    };
    let mut sink = Sink::new(cx.expansion, first);
    chosen.run(&mut sink, |rule, sink| match rule.check {
        Check::Beside(check) if !cx.robots.is_empty() => check(cx, sink),
        Check::Semantic(check) => check(cx, sink),
        _ => {}
    });
    sink.finish()
}

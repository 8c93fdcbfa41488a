//! A tool0 that is not where the flange is.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names::prefix_of;

pub(super) static RULE: Rule = Rule {
    code: "FRM015",
    name: "flange-tool0-offset",
    category: Category::Frames,
    severity: Severity::Info,
    default: Activation::Profiles(&["ros-industrial"]),
    since: "0.1",
    fix: None,
    docs: page("flange-tool0-offset"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for joint in cx.joints() {
        let Some((parent, child)) = joint.ends() else {
            continue;
        };
        let prefixes = (prefix_of(parent, "flange"), prefix_of(child, "tool0"));
        let (Some(flange), Some(tool)) = prefixes else {
            continue;
        };
        let Some(text) = joint
            .origin
            .as_ref()
            .and_then(|origin| origin.xyz.as_ref())
            .filter(|_| flange == tool)
        else {
            continue;
        };
        if text
            .numbers::<3>()
            .is_some_and(|numbers| numbers.iter().map(|n| n * n).sum::<f64>().sqrt() > 1e-6)
        {
            out.report(text.origin, format!("`{child}` is offset from `{parent}`"))
                .help("write xyz=\"0 0 0\" and put the offset in the tool; only the orientation of the frames may differ")
                .done();
        }
    }
}

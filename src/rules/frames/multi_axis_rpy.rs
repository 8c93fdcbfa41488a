//! The frame of a moving joint is turned about several axes.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::Joint;

pub(super) static RULE: Rule = Rule {
    code: "FRM014",
    name: "multi-axis-rpy",
    category: Category::Frames,
    severity: Severity::Info,
    default: Activation::Profiles(&["ros-industrial"]),
    since: "0.1",
    fix: None,
    docs: page("multi-axis-rpy"),
    check: Check::Joint(check),
};

fn check(_: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if !joint.joint_type().is_some_and(|kind| kind.has_axis()) {
        return;
    }
    let Some(text) = joint.origin.as_ref().and_then(|origin| origin.rpy.as_ref()) else {
        return;
    };
    let turned = text.numbers::<3>().map_or(0, |angles| {
        angles.iter().filter(|angle| angle.abs() > 1e-6).count()
    });
    if turned > 1 {
        let message = format!(
            "frame of joint `{}` is rotated about {turned} axes instead of one",
            joint.shown()
        );
        out.report(text.origin, message)
            .help("set two of the three angles to 0 and change `axis` instead")
            .done();
    }
}

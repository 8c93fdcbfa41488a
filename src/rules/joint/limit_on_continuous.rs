//! Position limits of a joint that has none.
use super::super::context::DocumentCx;
use super::super::edits::delete_attrs;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use model::{AttrValue, Joint, JointType, Limit, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "JNT017",
    name: "limit-on-continuous",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("limit-on-continuous"),
    check: Check::Joint(check),
};

/// One turn, with what rounding pi takes away, rad.
const FULL_TURN: f64 = std::f64::consts::TAU - 0.01;

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if !joint.is(&[JointType::Continuous]) {
        return;
    }
    let Some(limit) = &joint.limit else { return };
    let texts = [("lower", &limit.lower), ("upper", &limit.upper)];
    let written: Vec<_> = texts
        .into_iter()
        .filter_map(|(name, text)| Some((name, text.as_ref()?)))
        .collect();
    if written.is_empty() {
        return;
    }
    let names: Vec<&str> = written.iter().map(|(name, _)| *name).collect();
    let message = format!(
        "continuous joint `{}` has {}, which most programs ignore",
        joint.shown(),
        names.join(" and ")
    );
    let report = out
        .report(tag_start(cx.expansion, limit.element), message)
        .severity(if restricts(limit) && !is_any(joint) && !follows(cx, joint) {
            Severity::Warning
        } else {
            Severity::Info
        })
        .help("write type=\"revolute\", or remove the position limits; a continuous joint uses only effort and velocity");
    delete_attrs(report, cx.expansion, limit.element, &names).done();
}

/// Whether the type is computed: the same limits are for joints of other types.
fn is_any(joint: &Joint) -> bool {
    joint.kind.as_ref().is_some_and(|kind| !kind.is_literal())
}

/// Whether a joint only goes where another one with limits leads it.
fn follows(cx: &DocumentCx<'_>, joint: &Joint) -> bool {
    let leader = joint
        .mimic
        .as_ref()
        .and_then(|mimic| mimic.joint.as_ref()?.name());
    let mut joints = cx.joints().iter();
    let is_leader = |other: &&Joint| other.name.as_ref().and_then(AttrValue::name) == leader;
    leader.is_some()
        && joints
            .find(is_leader)
            .is_some_and(|found| !found.is(&[JointType::Continuous]))
}

/// Whether the limits leave less than a full turn: they are meant, and ignored. Limits of zero say nothing.
fn restricts(limit: &Limit) -> bool {
    let number = |text: &Option<AttrValue>| text.as_ref().and_then(AttrValue::number);
    let range = number(&limit.lower).zip(number(&limit.upper));
    range.is_some_and(|(lower, upper)| lower != upper && (upper - lower).abs() < FULL_TURN)
}

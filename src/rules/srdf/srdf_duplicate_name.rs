//! Two groups, states, end effectors or virtual joints of one name.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use model::AttrValue;
use project::{GroupState, Srdf};

pub(super) static RULE: Rule = Rule::semantic(
    "SRD009",
    "srdf-duplicate-name",
    Category::Srdf,
    Severity::Error,
    page("srdf-duplicate-name"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf() else { return };
    fn own(name: &Option<AttrValue>) -> (&str, Option<&AttrValue>) {
        ("", name.as_ref())
    }
    report(
        out,
        ("group", RULE.severity),
        srdf.groups.iter().map(|group| own(&group.name)),
    );
    // MoveIt takes the last one
    report(
        out,
        ("end effector", Severity::Warning),
        srdf.effectors.iter().map(|effector| own(&effector.name)),
    );
    // MoveIt takes one of them, for the root of the robot
    report(
        out,
        ("virtual joint", Severity::Info),
        srdf.virtual_joints.iter().map(|joint| own(&joint.name)),
    );
    report_states(srdf, out);
}

/// Report group states of one name. Where they are one pose, nobody takes the wrong one.
fn report_states(srdf: &Srdf, out: &mut Sink<'_>) {
    let mut first: FastMap<(&str, &str), &GroupState> = FastMap::default();
    for state in &srdf.states {
        let [group, own] = [&state.group, &state.name].map(|text| text.as_ref()?.name());
        let (Some(group), Some(own)) = (group, own) else {
            continue;
        };
        let (group, own) = (group.as_str(), own.as_str());
        let known = *first.entry((group, own)).or_insert(state);
        let severity = match pose(known) == pose(state) {
            true => Severity::Info,
            false => RULE.severity,
        };
        let both = [known, state].map(|state| (group, state.name.as_ref()));
        if !std::ptr::eq(known, state) {
            report(out, ("group state", severity), both.into_iter());
        }
    }
}

/// The joints of a group state, each with its value: 0 and 0.0 are one.
fn pose(state: &GroupState) -> Vec<(&str, String)> {
    let value = |text: &AttrValue| match text.number() {
        Some(number) => (number + 0.0).to_string(),
        None => text.value.to_string(),
    };
    let joints = state.joints.iter();
    let mut pose: Vec<_> = joints
        .map(|(joint, text)| {
            (
                joint.value.as_str(),
                text.as_ref().map_or(String::new(), value),
            )
        })
        .collect();
    pose.sort_unstable();
    pose
}

/// Report the names that are there twice in the same scope.
fn report<'a>(
    out: &mut Sink<'_>,
    (kind, severity): (&str, Severity),
    names: impl Iterator<Item = (&'a str, Option<&'a AttrValue>)>,
) {
    let mut first: FastMap<(&str, &str), &AttrValue> = FastMap::default();
    for (scope, text) in names {
        let Some((text, name)) = text.and_then(|text| Some((text, text.name()?))) else {
            continue;
        };
        let known = *first.entry((scope, name.as_str())).or_insert(text);
        if !std::ptr::eq(known, text) {
            let message = format!("duplicate {kind} name `{name}`");
            let first = format!("first {kind} named `{name}`");
            out.report(text.origin, message)
                .severity(severity)
                .also(known.origin, first)
                .help("use another name")
                .done();
        }
    }
}

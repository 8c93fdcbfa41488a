//! One interface of a joint in two ros2_control blocks, or a joint twice in one.
use std::cell::LazyCell;

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joints::is_before_jazzy;
use base::FastMap;
use model::{AttrValue, ControlJoint, Interface};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL007",
    name: "ros2-control-duplicate-joint",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-duplicate-joint"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut seen: FastMap<&str, Vec<(usize, &ControlJoint)>> = FastMap::default();
    let is_before_jazzy = LazyCell::new(|| is_before_jazzy(cx));
    let controls = cx
        .robot
        .into_iter()
        .flat_map(|robot| &robot.controls)
        .enumerate();
    for (block, joint) in
        controls.flat_map(|(i, control)| control.joints.iter().map(move |joint| (i, joint)))
    {
        let Some((text, name)) = joint
            .name
            .as_ref()
            .and_then(|text| Some((text, text.name()?)))
        else {
            continue;
        };
        let earlier = seen.entry(name.as_str()).or_default();
        if let Some((_, first)) = earlier.iter().find(|(other, _)| *other == block) {
            twice_in_block(text, first, out);
            continue;
        }
        let twice = earlier
            .iter()
            .filter(|(other, _)| *other != block)
            .find_map(|(first, other)| {
                let shared = shared(&other.commands, &joint.commands)
                    .map(|name| (name, RULE.severity, "command"));
                let shared = shared
                    .or_else(|| Some((shared_states(other, joint)?, Severity::Warning, "state")));
                shared.map(|shared| (other.name.as_ref(), *first, shared))
            });
        if let Some((Some(other), first, (interface, severity, kind))) = twice {
            // before Jazzy, the first block that has an interface provides it
            let severity = if *is_before_jazzy {
                Severity::Warning
            } else {
                severity
            };
            out.report(
                text.origin,
                format!("{kind} interface `{interface}` of joint `{name}` is in two ros2_control blocks"),
            )
            .group(Group::Name(format!("blocks {first} and {block}").into()))
            .also(other.origin, format!("joint `{name}` is in the first block here"))
            .severity(severity)
            .help("remove the interface from one of the blocks; only one hardware component can provide it")
            .done();
        }
        earlier.push((block, joint));
    }
}

/// A joint that a block lists twice: most likely one of the names was not changed after copying.
fn twice_in_block(name: &AttrValue, first: &ControlJoint, out: &mut Sink<'_>) {
    let Some(first) = &first.name else { return };
    out.report(
        name.origin,
        format!("joint `{}` is twice in one ros2_control block", name.value),
    )
    .severity(Severity::Warning)
    .also(
        first.origin,
        format!("joint `{}` is first here", name.value),
    )
    .help("rename one to the joint that is meant, or put all interfaces in one `joint` element")
    .done();
}

/// The name of an interface that both have.
fn shared<'a>(a: &'a [Interface], b: &[Interface]) -> Option<&'a str> {
    let names = a
        .iter()
        .filter_map(|interface| interface.name.as_ref()?.name());
    names
        .into_iter()
        .find(|name| b.iter().any(|interface| interface.is(name)))
        .map(|name| name.as_str())
}

fn shared_states<'a>(a: &'a ControlJoint, b: &ControlJoint) -> Option<&'a str> {
    shared(&a.states, &b.states)
}

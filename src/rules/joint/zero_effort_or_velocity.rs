//! Joints that may not move because effort or velocity is zero.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use expand::FileIdx;
use model::{AttrValue, Joint};

pub(super) static RULE: Rule = Rule {
    code: "JNT009",
    name: "zero-effort-or-velocity",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("zero-effort-or-velocity"),
    check: Check::Document(check),
};

/// The first such joint of a file.
struct First<'a> {
    joint: &'a Joint,
    name: &'static str,
    value: &'a AttrValue,
    others: usize,
}

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut order: Vec<FileIdx> = Vec::new();
    let mut files: FastMap<FileIdx, First<'_>> = FastMap::default();
    for joint in cx.joints().iter().filter(|joint| joint.is_driven()) {
        let Some((name, value)) = zero(joint) else {
            continue;
        };
        let Some(place) = cx.expansion.place(value.origin) else {
            continue;
        };
        match files.get_mut(&place.file) {
            Some(first) => first.others += 1,
            None => {
                order.push(place.file);
                files.insert(
                    place.file,
                    First {
                        joint,
                        name,
                        value,
                        others: 0,
                    },
                );
            }
        }
    }
    for First {
        joint,
        name,
        value,
        others,
    } in order.iter().filter_map(|file| files.get(file))
    {
        let more = match others {
            0 => String::new(),
            1 => " (and one more joint in this file)".to_owned(),
            others => format!(" (and {others} more joints in this file)"),
        };
        out.report(value.origin, format!("joint `{}` has zero {name}{more}", joint.shown()))
            .help(format!(
                "write the maximum {name}; planners and simulators that apply the limit cannot move the joint"
            ))
            .done();
    }
}

/// The effort or velocity of a joint that is zero.
fn zero(joint: &Joint) -> Option<(&'static str, &AttrValue)> {
    let limit = joint.limit.as_ref()?;
    let texts = [
        ("effort", limit.effort.as_ref()),
        ("velocity", limit.velocity.as_ref()),
    ];
    let mut zeros = texts
        .into_iter()
        .filter_map(|(name, text)| Some((name, text?)));
    zeros.find(|(_, text)| may_be_zero(&text.value) && text.number() == Some(0.0))
}

/// Whether a text may be a zero, at a glance: a number without an exponent that begins with another digit is none.
fn may_be_zero(text: &str) -> bool {
    !text.starts_with(|first| matches!(first, '1'..='9')) || text.contains(['e', 'E'])
}

//! Names that differ only in their case.
use ecow::EcoString;

use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "STR012",
    name: "names-differ-by-case",
    category: Category::Structure,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("names-differ-by-case"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    // of two such names one has a capital letter, or a letter of which nobody knows
    if cx.robot.is_none_or(|robot| !robot.naming().marks.capital) {
        return;
    }
    alike(
        "link",
        cx.links().iter().filter_map(|link| link.name.as_ref()),
        out,
    );
    alike(
        "joint",
        cx.joints().iter().filter_map(|joint| joint.name.as_ref()),
        out,
    );
}

fn alike<'a>(kind: &str, names: impl Iterator<Item = &'a AttrValue>, out: &mut Sink<'_>) {
    let mut first: FastMap<EcoString, &AttrValue> = FastMap::default();
    for text in names {
        let Some(name) = text.name() else { continue };
        let folded = name.to_lowercase();
        match first.get(&folded) {
            Some(earlier) if earlier.value != *name => out
                .report(
                    text.origin,
                    format!(
                        "{kind} names `{}` and `{name}` differ only in case",
                        earlier.value
                    ),
                )
                .also(earlier.origin, format!("{kind} `{}`", earlier.value))
                .help("rename one of them; TF is case-sensitive, other programs are not")
                .done(),
            Some(_) => {}
            None => {
                first.insert(folded, text);
            }
        }
    }
}

//! A macro that nothing calls.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::{mentions, unused};
use expand::SymbolKind;

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC013",
    name: "unused-macro",
    category: Category::Xacro,
    severity: Severity::Hint,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("unused-macro"),
    check: Check::WholeDocument(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let found = unused::in_root(cx, &[SymbolKind::Macro]);
    if found.is_empty() {
        return;
    }
    let Some(mentions) = mentions::everywhere(cx) else {
        return;
    };
    for (_, definition, place) in found {
        let name = definition.name.as_str();
        if mentions.iter().any(|file| file.tag(name)) {
            continue;
        }
        let message = format!("unused macro `{name}`");
        let report = out
            .report_in(place.file, place.range, message)
            .help("remove it, or start its name with `_`");
        match unused::removal(cx, definition) {
            Some(range) => {
                report
                    .fix(
                        Safety::Unsafe,
                        format!("remove macro `{name}`"),
                        place.file,
                        [(range, String::new())],
                    )
                    .done();
            }
            None => report.done(),
        }
    }
}

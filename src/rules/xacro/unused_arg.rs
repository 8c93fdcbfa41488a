//! An argument that nothing reads.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::{mentions, unused};
use expand::SymbolKind;

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC014",
    name: "unused-arg",
    category: Category::Xacro,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("unused-arg"),
    check: Check::WholeDocument(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let found = unused::in_root(cx, &[SymbolKind::Argument]);
    if found.is_empty() {
        return;
    }
    let Some(mentions) = mentions::everywhere(cx) else {
        return;
    };
    for (_, definition, place) in found
        .into_iter()
        .filter(|(_, found, _)| !mentions.iter().any(|file| file.word(&found.name)))
    {
        let message = format!("unused argument `{}`", definition.name);
        let help = "remove it here and in launch files that pass it";
        let report = out.report_in(place.file, place.range, message).help(help);
        match unused::removal(cx, definition) {
            Some(range) => {
                report
                    .fix(
                        Safety::Unsafe,
                        "remove the argument",
                        place.file,
                        [(range, String::new())],
                    )
                    .done();
            }
            None => report.done(),
        }
    }
}

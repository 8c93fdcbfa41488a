//! A property that nothing reads.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::{mentions, unused};
use expand::SymbolKind;

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC012",
    name: "unused-property",
    category: Category::Xacro,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("unused-property"),
    check: Check::WholeDocument(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let found = unused::in_root(cx, &[SymbolKind::Property, SymbolKind::BlockProperty]);
    if found.is_empty() {
        return;
    }
    let Some(mentions) = mentions::everywhere(cx) else {
        return;
    };
    for (_, definition, place) in found {
        let name = definition.name.as_str();
        let block = definition.kind == SymbolKind::BlockProperty;
        if mentions
            .iter()
            .any(|file| file.word(name) || block && file.block(name))
        {
            continue;
        }
        let message = format!("unused property `{name}`");
        let report = out
            .report_in(place.file, place.range, message)
            .help("remove it, or start its name with `_`");
        match unused::removal(cx, definition) {
            Some(range) => {
                report
                    .fix(
                        Safety::Unsafe,
                        format!("remove property `{name}`"),
                        place.file,
                        [(range, String::new())],
                    )
                    .done();
            }
            None => report.done(),
        }
    }
}

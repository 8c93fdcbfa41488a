//! A parameter that hides a property.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::source;
use base::FastMap;
use expand::{Definition, SymbolKind};

pub(super) static RULE: Rule = Rule {
    code: "XAC019",
    name: "shadowed-property",
    category: Category::Xacro,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("shadowed-property"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if !source::is_main(cx) {
        return;
    }
    let mut properties: FastMap<&str, &Definition> = FastMap::default();
    for (_, definition) in cx.expansion.index.symbols.iter() {
        match definition.kind {
            SymbolKind::Property if !definition.in_macro => {
                properties.entry(&definition.name).or_insert(definition);
            }
            SymbolKind::Parameter => {
                let hidden = properties.get(definition.name.as_str());
                let hidden = hidden.and_then(|hidden| source::place(cx.expansion, hidden.place));
                let place = source::place(cx.expansion, definition.place);
                if let (Some(place), Some(hidden)) = (place, hidden) {
                    let message =
                        format!("parameter `{0}` shadows property `{0}`", definition.name);
                    out.report_in(place.file, place.range, message)
                        .also_at(hidden, "property defined here")
                        .help("rename one of them")
                        .done();
                }
            }
            _ => {}
        }
    }
}

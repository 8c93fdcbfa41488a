//! Two visuals or two collisions of one name in a link.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use model::{AttrValue, Body, Link};

pub(in super::super) static RULE: Rule = Rule {
    code: "STR010",
    name: "duplicate-geometry-name",
    category: Category::Structure,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("duplicate-geometry-name"),
    check: Check::Link(check),
};

fn check(_: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    twice(link, "visual", &link.visuals, out);
    twice(link, "collision", &link.collisions, out);
}

fn twice(link: &Link, kind: &str, bodies: &[Body], out: &mut Sink<'_>) {
    let mut first: FastMap<&str, &AttrValue> = FastMap::default();
    for text in bodies.iter().filter_map(|body| body.name.as_ref()) {
        let Some(name) = text.name() else { continue };
        match first.get(name.as_str()) {
            Some(earlier) => out
                .report(
                    text.origin,
                    format!("duplicate {kind} name `{name}` in link `{}`", link.shown()),
                )
                .also(earlier.origin, format!("first {kind} named `{name}`"))
                .help("rename one of them, or remove the names")
                .done(),
            None => {
                first.insert(name, text);
            }
        }
    }
}

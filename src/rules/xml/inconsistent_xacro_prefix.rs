//! xacro's namespace bound to a prefix other than `xacro`.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::is_xacro_uri;
use base::TextRange;
use facts::is_keyword;
use xml::Attr;

pub(in super::super) static RULE: Rule = Rule {
    code: "XML004",
    name: "inconsistent-xacro-prefix",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("inconsistent-xacro-prefix"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    for attr in cx.root_attrs() {
        let Some(prefix) = attr
            .name()
            .strip_prefix("xmlns:")
            .filter(|&prefix| prefix != "xacro")
        else {
            continue;
        };
        if is_xacro_uri(attr.raw()) {
            let edits = renamed(cx, attr, prefix);
            let mut names = cx
                .elements()
                .filter_map(|(_, node)| node.name().strip_prefix(prefix)?.strip_prefix(':'));
            // beside the right prefix, it may stand for what programs read: no tag of xacro is lost
            let has_both = cx.root_attrs().any(|attr| attr.name() == "xmlns:xacro");
            let is_lost = |name: &str| !has_both || is_keyword(name) || cx.macros().contains(name);
            let severity = if names.any(is_lost) {
                Severity::Error
            } else {
                Severity::Info
            };
            let message = format!(
                "the xacro namespace has the prefix `{prefix}`, so xacro ignores `{prefix}:` elements"
            );
            out.report_in(cx.file, attr.range(), message)
                .severity(severity)
                .help("write xmlns:xacro=\"...\" and `xacro:` elements; xacro does not use namespaces")
                .fix(Safety::Unsafe, "rename the prefix to `xacro`", cx.file, edits)
                .done();
        }
    }
}

/// The declaration and all tags and attributes with the prefix.
fn renamed(cx: &FileCx<'_>, declaration: Attr<'_>, prefix: &str) -> Vec<(TextRange, String)> {
    let end = declaration.name_range().end;
    let mut places = vec![TextRange::new(end - prefix.len() as u32, end)];
    for (base, node) in cx.elements() {
        let tags = [Some(node.name_range()), node.end_name_range()]
            .into_iter()
            .flatten();
        let attrs = node
            .attrs()
            .filter(|attr| has_prefix(attr.name(), prefix))
            .map(|attr| attr.name_range());
        let names = tags
            .filter(|_| has_prefix(node.name(), prefix))
            .chain(attrs);
        places.extend(
            names.map(|name| {
                TextRange::new(name.start, name.start + prefix.len() as u32).shift(base)
            }),
        );
    }
    places
        .into_iter()
        .map(|range| (range, "xacro".to_owned()))
        .collect()
}

fn has_prefix(name: &str, prefix: &str) -> bool {
    name.strip_prefix(prefix)
        .is_some_and(|rest| rest.starts_with(':'))
}

//! A property whose value is replaced before anything reads it.
use super::super::context::{DocumentCx, elements_where};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::{source, unused};
use base::{FastMap, FastSet, TextRange};
use expand::{Definition, DefinitionId, FileIdx, FileRange, SymbolKind};
use xml::Node;

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC016",
    name: "redefined-property",
    category: Category::Xacro,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("redefined-property"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if !source::is_main(cx) {
        return;
    }
    let mut last: FastMap<(FileIdx, &str), (DefinitionId, FileRange, Node<'_>)> =
        FastMap::default();
    let properties = || {
        let all = cx.expansion.index.symbols.iter();
        all.filter(|(_, found)| found.kind == SymbolKind::Property)
    };
    // nearly all are used, and only others are of interest
    let unused = properties().filter(|&(id, _)| !unused::is_used(cx, id));
    let names: FastSet<&str> = unused.map(|(_, found)| found.name.as_str()).collect();
    if names.is_empty() {
        return;
    }
    for (id, definition) in properties().filter(|(_, found)| names.contains(found.name.as_str())) {
        let Some((place, node)) = plain(cx, definition) else {
            continue;
        };
        let key = (place.file, definition.name.as_str());
        let earlier = last.insert(key, (id, place, node));
        let Some((earlier, first, first_node)) = earlier else {
            continue;
        };
        if !unused::is_used(cx, earlier)
            && first.range.end < place.range.start
            && source::macro_around(first_node) == source::macro_around(node)
            && !mentioned_between(cx, first, place, node, &definition.name)
            && !included_between(cx, first, place)
        {
            let is_same = match (written(first_node), written(node)) {
                (Some(one), Some(two)) => one == two || are_close(&one, &two),
                _ => false,
            };
            out.report_in(
                place.file,
                place.range,
                format!(
                    "property `{}` is redefined before it is used",
                    definition.name
                ),
            )
            .severity(if is_same {
                Severity::Info
            } else {
                Severity::Warning
            })
            .also_at(first, "this value is never read")
            .help("remove one of them, or rename it")
            .done();
        }
    }
}

/// The place and tag of a definition that holds in any case: in no conditional, and with a value alone.
fn plain<'a>(cx: &DocumentCx<'a>, definition: &Definition) -> Option<(FileRange, Node<'a>)> {
    let node = source::definition_tag(cx.expansion, definition)?;
    let special = ["default", "scope", "lazy_eval", "remove"]
        .iter()
        .any(|name| node.attr(name).is_some());
    let plain = node.name() == "xacro:property" && !special && !source::is_conditional(node);
    let place = source::place(cx.expansion, definition.place)?;
    plain.then_some((place, node))
}

/// The value that a tag spells out.
fn written(node: Node<'_>) -> Option<String> {
    Some(node.attr("value")?.raw().trim().to_owned())
}

/// Whether two texts are the same number, but for how it was rounded.
fn are_close(one: &str, two: &str) -> bool {
    const TOLERANCE: f64 = 1e-4;
    let (Ok(one), Ok(two)) = (one.parse::<f64>(), two.parse::<f64>()) else {
        return false;
    };
    (one - two).abs() <= TOLERANCE * one.abs()
}

/// Whether a file is included between two definitions: it may read the first one, in another branch or in the macros that
/// it defines.
fn included_between(cx: &DocumentCx<'_>, first: FileRange, second: FileRange) -> bool {
    let Some(file) = cx.expansion.files.get(second.file) else {
        return true;
    };
    let between = TextRange::new(first.range.end, second.range.start);
    let mut nodes = elements_where(&file.source.document, |marks| marks.include);
    nodes.any(|(base, node)| {
        node.name() == "xacro:include" && between.contains_range(node.name_range().shift(base))
    })
}

/// Whether an expression between two definitions, or in the second one, mentions the name: a branch not taken
/// here may read it.
fn mentioned_between(
    cx: &DocumentCx<'_>,
    first: FileRange,
    second: FileRange,
    node: Node<'_>,
    name: &str,
) -> bool {
    let Some(file) = cx.expansion.files.get(second.file) else {
        return true;
    };
    let end = second.range.end + node.start_tag_range().len();
    let between = TextRange::new(first.range.end, end);
    let text = file.source.document.slice(between);
    text.split('$').skip(1).any(|part| {
        let end = part.find(['"', '\n']).unwrap_or(part.len());
        let words = part
            .get(..end)
            .unwrap_or_default()
            .split(|c: char| !c.is_alphanumeric() && c != '_');
        words.into_iter().any(|word| word == name)
    })
}

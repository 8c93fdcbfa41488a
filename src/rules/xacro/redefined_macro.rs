//! A macro that replaces another one of its name.
use std::cell::LazyCell;
use std::collections::BTreeMap;

use super::super::context::DocumentCx;
use super::super::finding::{Edit, Fix};
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::source::{self, Inclusion};
use base::{FastMap, FastSet, Span, TextRange};
use expand::{DefinitionId, Detail, FileIdx, FileRange, SymbolKind, UseKind};
use xml::{Node, NodeKind};

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC017",
    name: "redefined-macro",
    category: Category::Xacro,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("redefined-macro"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if !source::is_main(cx) {
        return;
    }
    let inclusions = source::inclusions(cx.expansion, cx.world);
    let spaces = namespaces(&inclusions);
    let mut first: FastMap<(&str, &str), (FileRange, Node<'_>, DefinitionId)> = FastMap::default();
    let called = LazyCell::new(|| called(cx));
    for (id, definition) in cx
        .expansion
        .index
        .symbols
        .iter()
        .filter(|(_, found)| found.kind == SymbolKind::Macro)
    {
        let node = source::definition_tag(cx.expansion, definition);
        let place = source::place(cx.expansion, definition.place);
        let (Some(node), Some(place)) = (node, place) else {
            continue;
        };
        let Some(space) = spaces.get(&place.file) else {
            continue;
        };
        if source::is_conditional(node) || source::macro_around(node).is_some() {
            continue;
        }
        let name = definition.name.as_str();
        let earlier = first.insert((space.as_str(), name), (place, node, id));
        if let Some((earlier, _, first)) =
            earlier.filter(|(_, earlier, _)| !is_same(*earlier, node))
        {
            // calls of both, each before the next is defined, take turns on purpose
            let is_meant = called.contains(&first) || !called.contains(&id);
            out.report_in(place.file, place.range, format!("macro `{name}` is redefined"))
                .severity(if is_meant { Severity::Info } else { RULE.severity })
                .also_at(earlier, "first defined here")
                .help("rename one of them, or include one file with ns=\"...\"; later calls use the second macro")
                .done();
        }
    }
}

/// The macros that something calls.
fn called(cx: &DocumentCx<'_>) -> FastSet<DefinitionId> {
    let uses = cx.expansion.index.symbols.uses.iter();
    uses.filter(|used| used.kind == UseKind::Call)
        .map(|used| used.definition)
        .collect()
}

/// Whether two macros are written with the same words, whatever the blanks, comments and XML style.
fn is_same(a: Node<'_>, b: Node<'_>) -> bool {
    let mut open = vec![(a, b)];
    while let Some((a, b)) = open.pop() {
        let (inner_a, inner_b) = (content(a), content(b));
        let same_text = a.kind() != NodeKind::Text || words(a.raw()) == words(b.raw());
        if a.kind() != b.kind() || a.name() != b.name() || attributes(a) != attributes(b) {
            return false;
        }
        if !same_text || inner_a.len() != inner_b.len() {
            return false;
        }
        open.extend(inner_a.into_iter().zip(inner_b));
    }
    true
}

/// The elements and texts inside an element, comments and blanks left out.
fn content(node: Node<'_>) -> Vec<Node<'_>> {
    let matters = |child: &Node<'_>| match child.kind() {
        NodeKind::Element => true,
        NodeKind::Text => !child.raw().trim().is_empty(),
        _ => false,
    };
    node.children().filter(matters).collect()
}

/// The attributes of an element in any order.
fn attributes(node: Node<'_>) -> BTreeMap<String, Vec<String>> {
    node.attrs()
        .map(|attr| match attr.name() {
            "params" => (attr.name().to_owned(), in_order(words(attr.raw()))),
            name => (name.to_owned(), words(attr.raw())),
        })
        .collect()
}

/// Parameters in the order of their names, since calls give them by name; but for blocks, which calls give in their order.
fn in_order(mut params: Vec<String>) -> Vec<String> {
    params.sort_by_key(|param| (!param.starts_with('*')).then(|| param.clone()));
    params
}

fn words(text: &str) -> Vec<String> {
    text.split_whitespace().map(str::to_owned).collect()
}

/// The namespace that each file's macros go into; files that are included into several, or only sometimes,
/// are left out.
fn namespaces(inclusions: &[Inclusion<'_>]) -> FastMap<FileIdx, String> {
    let mut spaces: FastMap<FileIdx, String> = FastMap::from_iter([(FileIdx(0), String::new())]);
    let mut doubtful: FastSet<FileIdx> = FastSet::default();
    for inclusion in inclusions {
        let outer =
            spaces.contains_key(&inclusion.tag.file) && !doubtful.contains(&inclusion.tag.file);
        let certain = outer
            && !source::is_conditional(inclusion.node)
            && source::macro_around(inclusion.node).is_none();
        let known = spaces
            .entry(inclusion.target)
            .or_insert_with(|| inclusion.namespace.clone());
        if !certain || *known != inclusion.namespace {
            doubtful.insert(inclusion.target);
        }
    }
    spaces.retain(|file, _| !doubtful.contains(file));
    spaces
}

/// Where a call was meant, the name of the macro goes into the tags.
pub(in super::super) fn fix(cx: &ProblemCx<'_>) -> Option<Fix> {
    let Some(Detail::Called(called)) = &cx.problem.detail else {
        return None;
    };
    let (document, span) = (cx.document, cx.span);
    let call = format!("xacro:{called}");
    let place = document.item_at(span.range.start);
    let at = |node: &Node<'_>| node.start_tag_range().shift(place.start).start == span.range.start;
    let node = place.item.all_nodes().find(at)?;
    let name = node.attrs().next().filter(|attr| attr.name() == "name")?;
    let tag = TextRange::new(node.name_range().start, name.range().end).shift(place.start);
    let end = node.end_name_range()?.shift(place.start);
    let edits = [tag, end].map(|range| Edit {
        span: Span { range, ..span },
        content: call.clone(),
    });
    Some(Fix {
        safety: Safety::Unsafe,
        message: format!("call macro `{called}`"),
        edits: edits.into(),
    })
}

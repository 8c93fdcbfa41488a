//! A parameter that its macro does not use.
use std::cell::LazyCell;
use std::collections::BTreeSet;

use ecow::EcoString;

use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::words::MentionedWords;
use super::{source, unused};
use base::{FastMap, FastSet};
use expand::{
    Definition, DefinitionId, FileIdx, Problem, ProblemKind, SourceRange, SymbolKind, UseKind,
};
use facts::{is_keyword, parts_where};
use xml::{Node, NodeKind};

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC015",
    name: "unused-macro-param",
    category: Category::Xacro,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("unused-macro-param"),
    check: Check::WholeDocument(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if !source::is_main(cx) {
        return;
    }
    let forwards = LazyCell::new(|| Forwards::of(cx));
    let blocks = LazyCell::new(|| Blocks::of(cx));
    let misspelled = LazyCell::new(|| misspelled(cx));
    let mut bodies: FastMap<DefinitionId, Option<MentionedWords>> = FastMap::default();
    for (id, definition) in cx.expansion.index.symbols.iter() {
        let Some(of) = definition
            .of
            .filter(|_| !unused::is_used(cx, id) && !definition.name.starts_with('_'))
        else {
            continue;
        };
        let body = bodies
            .entry(of)
            .or_insert_with(|| body(cx, of, &forwards, &misspelled));
        if body
            .as_ref()
            .is_some_and(|body| !is_mentioned(body, definition, &forwards))
        {
            report(cx, (of, definition), &blocks, out);
        }
    }
}

/// What the body of a macro mentions; none, when that cannot be told: it is empty, includes a file, calls what
/// is not known, or a name in it is misspelled.
fn body(
    cx: &DocumentCx<'_>,
    of: DefinitionId,
    forwards: &Forwards,
    misspelled: &Misspelled,
) -> Option<MentionedWords> {
    let place = cx.expansion.index.symbols.get(of)?.place;
    let (base, node) = source::tag(cx.expansion, place)?;
    let (file, range) = (
        source::place(cx.expansion, place)?.file,
        node.range().shift(base),
    );
    let mut inside = misspelled.range((file, range.start)..(file, range.end));
    if inside.next().is_some() {
        return None;
    }
    if holds_unprefixed_insert(node) {
        // what it would insert is used as soon as the prefix is there
        return None;
    }
    node.children().find(|child| {
        matches!(child.kind(), NodeKind::Element | NodeKind::Text) && !is_blank(*child)
    })?;
    let body = MentionedWords::inside(node);
    let known = |tag: &EcoString| {
        is_keyword(tag)
            || forwards
                .macros
                .contains(tag.rsplit('.').next().unwrap_or(tag))
    };
    (!body.tags.contains("include") && body.tags.iter().all(known)).then_some(body)
}

/// Where names are undefined, in the order of the texts.
type Misspelled = BTreeSet<(FileIdx, u32)>;

fn misspelled(cx: &DocumentCx<'_>) -> Misspelled {
    let is_undefined = |found: &&Problem| {
        matches!(
            found.kind,
            ProblemKind::UndefinedProperty | ProblemKind::UndefinedBlock
        )
    };
    let undefined = cx.expansion.problems.iter().filter(is_undefined);
    undefined
        .map(|found| (found.place.file, found.place.range.start))
        .collect()
}

/// The blocks that macros take, and what calls them.
struct Blocks {
    /// Where the parameters of a macro that take a block stand.
    taken: FastMap<DefinitionId, Vec<u32>>,
    calls: FastMap<DefinitionId, Vec<SourceRange>>,
}

impl Blocks {
    fn of(cx: &DocumentCx<'_>) -> Self {
        let symbols = &cx.expansion.index.symbols;
        let (mut taken, mut calls) = (FastMap::default(), FastMap::default());
        for (_, block) in symbols.iter() {
            if let (SymbolKind::BlockParameter, Some(of)) = (block.kind, block.of) {
                let places: &mut Vec<u32> = taken.entry(of).or_default();
                places.push(block.place.range.start);
            }
        }
        for used in symbols
            .uses
            .iter()
            .filter(|used| used.kind == UseKind::Call)
        {
            let places: &mut Vec<SourceRange> = calls.entry(used.definition).or_default();
            places.push(used.place);
        }
        Self { taken, calls }
    }
}

fn holds_unprefixed_insert(node: Node<'_>) -> bool {
    let mut open: Vec<Node<'_>> = node.children().collect();
    while let Some(node) = open.pop() {
        if node.name() == "insert_block" {
            return true;
        }
        open.extend(node.children());
    }
    false
}

fn is_blank(node: Node<'_>) -> bool {
    node.kind() == NodeKind::Text && node.raw().trim().is_empty()
}

fn is_mentioned(body: &MentionedWords, param: &Definition, forwards: &Forwards) -> bool {
    let name = param.name.as_str();
    match param.kind {
        SymbolKind::BlockParameter => body.computed || body.blocks.contains(name),
        _ => body.word(name) || is_forwarded(body, name, forwards),
    }
}

/// Whether the body calls a macro that takes a parameter of this name from its caller.
fn is_forwarded(body: &MentionedWords, name: &str, forwards: &Forwards) -> bool {
    let mut tags = body
        .tags
        .iter()
        .map(|tag| tag.rsplit('.').next().unwrap_or(tag));
    body.computed
        || tags.any(|tag| {
            forwards
                .forwards
                .contains(&(tag.to_owned(), name.to_owned()))
        })
}

/// The macros of all files, and the parameters that they take from their callers.
#[derive(Default)]
struct Forwards {
    macros: FastSet<String>,
    /// Macro and parameter.
    forwards: FastSet<(String, String)>,
}

impl Forwards {
    fn of(cx: &DocumentCx<'_>) -> Self {
        let mut found = Self::default();
        let documents = cx.expansion.files.iter().map(|file| &file.source.document);
        let items = documents.flat_map(|document| parts_where(document, |marks| marks.macro_tag));
        let macros = items
            .flat_map(|(_, item)| item.all_nodes())
            .filter(|node| node.name() == "xacro:macro");
        for node in macros {
            let Some(name) = node.attr("name") else {
                continue;
            };
            let name = name.raw().trim_start_matches("xacro:");
            found.macros.insert(name.to_owned());
            let params = node.attr("params").map_or("", |params| params.raw());
            for (param, value) in params
                .split_whitespace()
                .filter_map(|word| word.split_once('='))
            {
                if value.starts_with('^') {
                    found
                        .forwards
                        .insert((name.to_owned(), param.trim_end_matches(':').to_owned()));
                }
            }
        }
        found
    }
}

/// Whether the body of a macro has links or joints, or calls macros that may have; others often take the block that goes
/// with them, and need none.
fn places_parts(cx: &DocumentCx<'_>, of: DefinitionId) -> bool {
    let found = cx
        .expansion
        .index
        .symbols
        .get(of)
        .and_then(|owner| source::tag(cx.expansion, owner.place));
    let mut open: Vec<Node<'_>> = found.map(|(_, node)| node).into_iter().collect();
    while let Some(node) = open.pop() {
        let may_place = node
            .name()
            .strip_prefix("xacro:")
            .is_some_and(|tag| tag == "include" || !is_keyword(tag));
        if may_place
            || matches!(
                node.name(),
                "link" | "joint" | "inertial" | "visual" | "collision"
            )
        {
            return true;
        }
        open.extend(node.children());
    }
    false
}

/// Whether something is lost with a block: the calls write more than poses that move nothing, or there are none yet.
fn is_missed(
    cx: &DocumentCx<'_>,
    (of, param): (DefinitionId, &Definition),
    blocks: &Blocks,
) -> bool {
    let taken = blocks.taken.get(&of).into_iter().flatten();
    let index = taken
        .filter(|start| **start < param.place.range.start)
        .count();
    let calls = blocks.calls.get(&of).into_iter().flatten();
    let tags = calls.filter_map(|call| source::tag(cx.expansion, *call));
    let mut given = tags.map(|(_, node)| {
        let mut elements = node
            .children()
            .filter(|child| child.kind() == NodeKind::Element);
        elements.nth(index).is_some_and(moves_nothing)
    });
    let first = given.next();
    first.is_none() || first == Some(false) || given.any(|nothing| !nothing)
}

/// Whether an element is an `origin` of zeros.
fn moves_nothing(node: Node<'_>) -> bool {
    let is_zero = |word: &str| word.parse() == Ok(0.0);
    node.name() == "origin"
        && node
            .attrs()
            .all(|attr| attr.raw().split_ascii_whitespace().all(is_zero))
}

fn report(
    cx: &DocumentCx<'_>,
    (of, param): (DefinitionId, &Definition),
    blocks: &Blocks,
    out: &mut Sink<'_>,
) {
    let Some(place) = source::place(cx.expansion, param.place) else {
        return;
    };
    let owner = cx
        .expansion
        .index
        .symbols
        .get(of)
        .map_or("", |owner| owner.name.as_str());
    // with a block, what callers write is lost, such as a pose
    let (what, verb, severity) = match param.kind {
        SymbolKind::BlockParameter
            if places_parts(cx, of) && is_missed(cx, (of, param), blocks) =>
        {
            ("block", "inserted", Severity::Warning)
        }
        SymbolKind::BlockParameter => ("block", "inserted", Severity::Info),
        _ => ("parameter", "used", Severity::Info),
    };
    let message = format!("{what} `{}` of macro `{owner}` is never {verb}", param.name);
    out.report_in(place.file, place.range, message)
        .severity(severity)
        .help("remove it from the macro and its calls, or start its name with `_`")
        .done();
}

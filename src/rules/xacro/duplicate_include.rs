//! A file that is included twice.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::source::{self, Inclusion};
use base::{FastMap, FastSet, TextRange};
use expand::{FileIdx, FileRange, FrameId, XId};
use xml::{Node, NodeKind};

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC010",
    name: "duplicate-include",
    category: Category::Xacro,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("duplicate-include"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if !source::is_main(cx) {
        return;
    }
    let inclusions = source::inclusions(cx.expansion, cx.world);
    if inclusions.len() < 2 {
        return;
    }
    let emitting = emitting(cx);
    let mut reported: FastSet<FileIdx> = FastSet::default();
    let mut first_of: FastMap<(FileIdx, &str), &Inclusion<'_>> = FastMap::default();
    // branches and macros may exclude each other
    let always = |found: &&Inclusion<'_>| {
        !source::is_conditional(found.node) && source::macro_around(found.node).is_none()
    };
    let mut seen: FastSet<FileRange> = FastSet::default();
    for later in inclusions
        .iter()
        .filter(always)
        .filter(|found| seen.insert(found.tag))
    {
        let first = *first_of
            .entry((later.target, later.namespace.as_str()))
            .or_insert(later);
        if first.tag == later.tag || depends_on_arguments(first, later) {
            continue;
        }
        let one_file = first.tag.file == later.tag.file && first.within == later.within;
        let emits = emitting.contains(&later.frame);
        let parametrised = emits && (!one_file || between(cx, first, later).any(is_property));
        // of many files that need one library, one pair says it all
        if parametrised || !one_file && !reported.insert(later.target) {
            continue;
        }
        // an include in front of each use is a habit that changes nothing; in one list, it is a slip
        let between = || between(cx, first, later);
        let is_habit = !emits && between().any(|node| node.name() != "xacro:include");
        let is_repeated = !one_file || is_habit && !between().any(is_property);
        report(cx, first, later, (one_file, emits, is_repeated), out);
    }
}

/// Whether two tags name one file only because of the arguments that are given now.
fn depends_on_arguments(first: &Inclusion<'_>, later: &Inclusion<'_>) -> bool {
    const ARGUMENTS: [&str; 4] = ["$(arg ", "$(optenv ", "$(env ", "xacro.arg("];
    let [first, later] =
        [first, later].map(|inclusion| inclusion.node.attr("filename").map(|name| name.raw()));
    let mut names = [first, later].into_iter().flatten();
    first != later && names.any(|name| ARGUMENTS.iter().any(|word| name.contains(word)))
}

/// The frames of includes that give elements.
fn emitting(cx: &DocumentCx<'_>) -> FastSet<FrameId> {
    let tree = &cx.expansion.tree;
    let mut frames = FastSet::default();
    let mut open: Vec<XId> = tree.elements(cx.element).collect();
    while let Some(element) = open.pop() {
        let mut frame = tree.get(element).origin.frame;
        while frames.insert(frame) {
            let Some(around) = cx.expansion.frames.get(frame) else {
                break;
            };
            frame = around.call.frame;
        }
        open.extend(tree.elements(element));
    }
    frames
}

/// The elements between two tags of one file.
fn between<'a>(
    cx: &DocumentCx<'a>,
    first: &Inclusion<'_>,
    later: &Inclusion<'_>,
) -> impl Iterator<Item = Node<'a>> {
    let file = cx.expansion.files.get(later.tag.file);
    let between = TextRange::new(
        first.tag.range.end,
        later.tag.range.start.max(first.tag.range.end),
    );
    let parts = file
        .into_iter()
        .flat_map(|file| file.source.document.parts());
    let nodes = parts.flat_map(|(base, item)| item.all_nodes().map(move |node| (base, node)));
    nodes
        .filter(move |(base, node)| {
            node.kind() == NodeKind::Element
                && between.contains_range(node.name_range().shift(*base))
        })
        .map(|(_, node)| node)
}

/// Whether an element sets a property: the second include may then mean something else.
fn is_property(node: Node<'_>) -> bool {
    node.name() == "xacro:property"
}

fn report(
    cx: &DocumentCx<'_>,
    first: &Inclusion<'_>,
    later: &Inclusion<'_>,
    (one_file, emits, is_repeated): (bool, bool, bool),
    out: &mut Sink<'_>,
) {
    let severity = match is_repeated {
        true => Severity::Info,
        false => RULE.severity,
    };
    let name = source::file_name(cx.expansion, later.target);
    let report = out
        .report_in(
            later.tag.file,
            later.tag.range,
            format!("duplicate include of `{name}`"),
        )
        .also_at(first.tag, "first included here")
        .severity(severity);
    if !one_file {
        return report
            .help("remove one include if nothing is redefined between them; the definitions are repeated")
            .done();
    }
    if emits {
        return report
            .help("remove one of the includes; the content is in the robot twice")
            .done();
    }
    let Some(file) = cx.expansion.files.get(later.tag.file) else {
        return;
    };
    let element = later.node.range();
    let start = later.tag.range.start - (later.node.name_range().start - 1 - element.start);
    let range = TextRange::new(start, start + element.len());
    let removal = source::removal(&file.source.document, range);
    report
        .help("remove this include; everything it defines is already defined")
        .fix(
            Safety::Safe,
            "remove the include",
            later.tag.file,
            [(removal, String::new())],
        )
        .done();
}

//! An include that gives nothing anybody uses.
use super::super::context::{DocumentCx, RootKind};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::mentions;
use super::source::{self, Inclusion};
use base::{FastSet, IdVec, TextRange};
use expand::{FileIdx, FrameId, SourceRange, SymbolKind, XKind};

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC011",
    name: "unused-include",
    category: Category::Xacro,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("unused-include"),
    check: Check::WholeDocument(check),
};

/// Each include is compared with all files, so more than these are not judged.
const MOST: usize = 200;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if !source::is_main(cx) || cx.kind != RootKind::Robot {
        return;
    }
    let inclusions = source::inclusions(cx.expansion, cx.world);
    if inclusions.is_empty() || inclusions.len() > MOST {
        return;
    }
    let giving = giving(cx);
    // what a library includes may be for others
    for inclusion in inclusions
        .iter()
        .filter(|inclusion| inclusion.tag.file == FileIdx(0))
    {
        let files = subtree(inclusion, &inclusions);
        let once = inclusions
            .iter()
            .filter(|other| other.target == inclusion.target)
            .count()
            == 1;
        if once
            && giving.get(inclusion.frame) == Some(&false)
            && !may_give_nodes(cx, inclusion)
            && !is_used(cx, &files)
        {
            report(cx, inclusion, out);
        }
    }
}

/// The files that come in with an include.
fn subtree(inclusion: &Inclusion<'_>, all: &[Inclusion<'_>]) -> FastSet<FileIdx> {
    let mut frames = vec![inclusion.frame];
    let mut files = FastSet::from_iter([inclusion.target]);
    for other in all {
        if frames.contains(&other.within) {
            frames.push(other.frame);
            files.insert(other.target);
        }
    }
    files
}

/// Of each step of the expansion: whether an element of the document comes from it.
fn giving(cx: &DocumentCx<'_>) -> IdVec<FrameId, bool> {
    let (tree, frames) = (&cx.expansion.tree, &cx.expansion.frames);
    let mut giving = IdVec::from(vec![false; frames.len()]);
    let below = tree
        .below(cx.element)
        .map(|id| tree.get(id))
        .filter(|node| node.kind == XKind::Element);
    for node in std::iter::once(tree.get(cx.element)).chain(below) {
        if let Some(gives) = giving.get_mut(node.origin.frame) {
            *gives = true;
        }
    }
    // a step comes behind the one around it
    for (id, frame) in frames.iter_ids().rev() {
        if giving.get(id) == Some(&true)
            && let Some(around) = giving.get_mut(frame.call.frame)
        {
            *around = true;
        }
    }
    giving
}

/// Whether an element of the document could come from one of the branches of an include.
fn may_give_nodes(cx: &DocumentCx<'_>, inclusion: &Inclusion<'_>) -> bool {
    let Some(file) = cx.expansion.files.get(inclusion.target) else {
        return true;
    };
    let mut elements = file
        .source
        .document
        .items()
        .filter_map(|(_, item)| item.element());
    elements.any(|element| {
        !matches!(
            element.name(),
            "xacro:macro" | "xacro:property" | "xacro:arg" | "xacro:include"
        )
    })
}

/// Whether other files use what some files define.
fn is_used(cx: &DocumentCx<'_>, files: &FastSet<FileIdx>) -> bool {
    let symbols = &cx.expansion.index.symbols;
    let Some(mentions) = mentions::outside(cx, files) else {
        return true;
    };
    let mut any = false;
    for (id, definition) in symbols
        .iter()
        .filter(|(_, definition)| is_inside(cx, files, definition.place))
    {
        any = true;
        let named = match definition.kind {
            SymbolKind::Macro => mentions.clone().any(|file| file.tag(&definition.name)),
            SymbolKind::BlockProperty => mentions.clone().any(|file| file.block(&definition.name)),
            SymbolKind::Parameter | SymbolKind::BlockParameter => continue,
            _ => mentions.clone().any(|file| file.word(&definition.name)),
        };
        if named
            || symbols
                .uses_of(id)
                .any(|used| !is_inside(cx, files, used.place))
        {
            return true;
        }
    }
    // a file that defines nothing at all is a place to fill in later
    !any
}

fn is_inside(cx: &DocumentCx<'_>, files: &FastSet<FileIdx>, at: SourceRange) -> bool {
    source::place(cx.expansion, at).is_some_and(|place| files.contains(&place.file))
}

fn report(cx: &DocumentCx<'_>, inclusion: &Inclusion<'_>, out: &mut Sink<'_>) {
    let Some(file) = cx.expansion.files.get(inclusion.tag.file) else {
        return;
    };
    let name = source::file_name(cx.expansion, inclusion.target);
    let element = inclusion.node.range();
    let start = inclusion.tag.range.start - (inclusion.node.name_range().start - 1 - element.start);
    let removal = source::removal(
        &file.source.document,
        TextRange::new(start, start + element.len()),
    );
    out.report_in(
        inclusion.tag.file,
        inclusion.tag.range,
        format!("unused include `{name}`"),
    )
    .help("remove the include")
    .fix(
        Safety::Unsafe,
        "remove the include",
        inclusion.tag.file,
        [(removal, String::new())],
    )
    .done();
}

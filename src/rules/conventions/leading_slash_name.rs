//! A name that begins with a slash.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::names;
use base::FastSet;
use expand::{BindingId, BindingKind, Piece};
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "CNV003",
    name: "leading-slash-name",
    category: Category::Conventions,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("leading-slash-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if cx.robot.is_none_or(|robot| !robot.naming().marks.slash) {
        return;
    }
    for (named, name) in cx.robot.into_iter().flat_map(names::names) {
        let Some(rest) = name.value.strip_prefix('/') else {
            continue;
        };
        if follows_empty_argument(cx, name) {
            continue;
        }
        let new = rest.trim_start_matches('/');
        let report = out
            .report(
                name.origin,
                format!(
                    "name of {} `{}` starts with a slash",
                    named.word(),
                    name.value
                ),
            )
            .help("remove the slash; tf2 rejects frame names that start with a slash");
        match names::rename(cx, named, &name.value, new).filter(|_| !new.is_empty()) {
            Some(edits) => {
                report
                    .edits(
                        Safety::Unsafe,
                        format!("rename to `{new}` everywhere"),
                        edits,
                    )
                    .done();
            }
            None => report.done(),
        }
    }
}

/// Whether the slash stands behind an argument that is empty here: who runs the file gives it.
fn follows_empty_argument(cx: &DocumentCx<'_>, name: &AttrValue) -> bool {
    let is_first = |piece: &&Piece| piece.out.start == 0;
    let first: Vec<Piece> = name.pieces.iter().filter(is_first).cloned().collect();
    cx.expansion.empty_argument(&first).is_some() || follows_argument(cx, &first)
}

/// Whether empty text comes from an argument.
fn follows_argument(cx: &DocumentCx<'_>, first: &[Piece]) -> bool {
    let expansion = cx.expansion;
    let empty = first.iter().filter(|piece| piece.out.is_empty());
    let mut reads: Vec<BindingId> = empty
        .flat_map(|piece| expansion.index.read_in(piece.reads).iter().copied())
        .collect();
    let mut seen = FastSet::default();
    while let Some(read) = reads.pop() {
        let Some(binding) = expansion
            .index
            .bindings
            .get(read)
            .filter(|_| seen.insert(read))
        else {
            continue;
        };
        if binding.kind == BindingKind::Argument {
            return true;
        }
        reads.extend(expansion.index.read_in(binding.reads));
    }
    false
}

//! What is shown beside the text under the pointer.

mod consumers;
mod elements;
mod expression;
mod files;
mod numbers;
mod page;
mod robot;
mod settled;
mod symbols;

pub(super) use elements::condition;
pub(super) use expression::{call_label, package_at};
pub(super) use robot::limits;
pub use settled::hover_while_typing;
pub use symbols::declared_argument;

use super::context::Cx;
use super::locate::{NodePart, locate};
use crate::text_names::{TextNames, may_be_name};
use base::TextRange;
use rules::RuleEnv;

/// A text about a piece of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// Markdown of at most 25 lines.
    pub markdown: String,
    /// What it is about.
    pub range: TextRange,
}

/// The value of the whole expression that begins at an offset of the file.
pub fn value_of(cx: &Cx<'_>, offset: u32) -> Option<String> {
    let at = locate(&cx.source.document, offset);
    Some(expression::whole(cx, &at)?.finish())
}

/// What there is to say about the text at an offset of the file; `names` are those of the robot that it belongs to.
pub fn hover(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    names: impl Fn() -> TextNames,
    offset: u32,
) -> Option<Hover> {
    let document = &cx.source.document;
    let at = locate(document, offset);
    if matches!(at.part, NodePart::Verbatim) {
        return None;
    }
    let found = symbols::about(cx, &at)
        .or_else(|| {
            // the names of all texts are read for it
            let names = may_be_name(&at).then(&names)?;
            symbols::by_text(cx, world, &names, &at)
        })
        .or_else(|| expression::about(cx, world, &at))
        .or_else(|| files::about(cx, world, &at))
        .or_else(|| robot::about(cx, world, &at))
        .or_else(|| numbers::about(cx, &at))
        .or_else(|| elements::about(cx, &at));
    let found = consumers::add(cx, world, offset, found);
    found.map(|(range, page)| Hover {
        markdown: page.finish(),
        range,
    })
}

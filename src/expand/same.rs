//! What is the same in two expansions of the same root.
use std::path::Path;
use std::sync::Arc;

use super::expansion::Expansion;
use super::journal::Change;
use super::origin::SrcId;
use super::plain::is_same_value;
use super::scope::{Binding, Block, PropertyState};
use xml::Item;

/// Whether an item is the same object in the same file in both expansions, with the same header in front.
pub(super) fn is_same_source(before: &Expansion, now: &Expansion, src: SrcId) -> bool {
    let Some((item, header, path)) = seen(now, src) else {
        return false;
    };
    seen(before, src).is_some_and(|(old_item, old_header, old_path)| {
        Arc::ptr_eq(item, old_item) && Arc::ptr_eq(header, old_header) && path == old_path
    })
}

/// Whether a binding says the same now as another one then.
pub(super) fn is_same_binding(
    before: &Expansion,
    then: &Binding,
    expansion: &Expansion,
    now: &Binding,
) -> bool {
    then.info == now.info
        && match (&then.state, &now.state) {
            (PropertyState::Ready(then), PropertyState::Ready(now)) => is_same_value(then, now),
            (PropertyState::Lazy(then, from), PropertyState::Lazy(now, at)) => {
                then == now
                    && (from.origin, from.is_attr) == (at.origin, at.is_attr)
                    && is_same_source(before, expansion, at.origin.src)
            }
            (
                PropertyState::Block(Block::Source(then)),
                PropertyState::Block(Block::Source(now)),
            ) => then == now && is_same_source(before, expansion, now.src),
            _ => false,
        }
}

/// Whether a change that one expansion made is the same as that of another.
pub(super) fn is_same_change(
    (change, now): (&Change, &Expansion),
    (other, before): (&Change, &Expansion),
) -> bool {
    match (change, other) {
        (
            Change::Property { name, new, .. },
            Change::Property {
                name: other,
                new: then,
                ..
            },
        ) => name == other && is_same_binding(before, then, now, new),
        (
            Change::Forced {
                name,
                info,
                value,
                reads,
                ..
            },
            Change::Forced {
                name: other,
                info: at,
                value: then,
                reads: read,
                ..
            },
        ) => name == other && (info, reads) == (at, read) && is_same_value(value, then),
        (Change::Macro { new, .. }, Change::Macro { new: then, .. }) => {
            (&new.name, new.body, new.origin, new.definition)
                == (&then.name, then.body, then.origin, then.definition)
                && is_same_source(before, now, new.body.src)
        }
        (
            Change::Argument { name, value },
            Change::Argument {
                name: other,
                value: then,
            },
        ) => (name, value) == (other, then),
        (
            Change::Declared { info, definition },
            Change::Declared {
                info: other,
                definition: then,
            },
        ) => (info, definition) == (other, then),
        _ => false,
    }
}

/// An item, the header of its file, and the path of the file.
fn seen(expansion: &Expansion, src: SrcId) -> Option<(&Arc<Item>, &Arc<Item>, &Path)> {
    let source = expansion.sources.get(src)?;
    let file = expansion.files.get(source.file)?;
    let header = expansion.sources.get(file.first_source)?;
    Some((&source.item, &header.item, &file.source.path))
}

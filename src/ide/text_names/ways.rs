//! How the expansion of a robot comes to a text: the conditions, calls and includes on the way.

use std::sync::Arc;

use super::{Class, TextDefinitionId, TextNames};
use base::{FastSet, FileId, Span, TextRange};
use expand::SymbolKind;
use vfs::SourceFile;
use xml::{Document, Node, NodeKind};

/// The files of a robot as they are now.
pub type Documents<'a> = &'a dyn Fn(FileId) -> Option<Arc<SourceFile>>;

/// Calls and includes that are followed to one text.
const MOST_STEPS: usize = 32;

impl TextNames {
    /// The starts of the conditions that have to be taken for a text to be evaluated, as far as the texts say: those around it, and
    /// around the calls and includes that lead there. None when nothing does.
    pub fn way(&self, documents: Documents<'_>, root: FileId, to: Span) -> Option<Vec<Span>> {
        let mut found: Vec<Span> = Vec::new();
        let (mut at, mut seen) = (to, FastSet::default());
        for _ in 0..MOST_STEPS {
            if !seen.insert(at) {
                return None;
            }
            let document = documents(at.file)?;
            let around = conditions(&document.document, at.range).into_iter();
            found.extend(around.map(|range| Span {
                file: at.file,
                range,
            }));
            match self.macro_around(at) {
                Some((id, whole)) => at = self.call_of(documents, id, whole)?,
                None if at.file == root => {
                    found.sort_unstable_by_key(|span| (span.file, span.range.start));
                    found.dedup();
                    return Some(found);
                }
                None => at = *self.included_at.get(&at.file)?.first()?,
            }
        }
        None
    }

    /// The innermost macro that a text stands in, with its element.
    fn macro_around(&self, at: Span) -> Option<(TextDefinitionId, Span)> {
        let macros = self
            .given
            .iter_ids()
            .filter(|(_, given)| given.kind == SymbolKind::Macro);
        let around = macros
            .map(|(id, given)| (id, given.whole))
            .filter(|(_, whole)| {
                whole.file == at.file
                    && whole.range.start < at.range.start
                    && at.range.end <= whole.range.end
            });
        around.min_by_key(|(_, whole)| whole.range.len())
    }

    /// The call of a macro that the fewest conditions stand around.
    fn call_of(&self, documents: Documents<'_>, of: TextDefinitionId, whole: Span) -> Option<Span> {
        let name = &self.given.get(of)?.name;
        let calls = self
            .used
            .iter()
            .filter(|used| used.class == Class::Macro && !used.is_end);
        let calls = calls.filter(|used| used.name == *name);
        let outside = calls.filter(|used| {
            used.span.file != whole.file || !whole.range.contains_range(used.span.range)
        });
        let calls = outside.filter(|used| self.macros(&used.called(), &used.scopes).contains(&of));
        calls.map(|used| used.span).min_by_key(|span| {
            documents(span.file).map_or(0, |file| conditions(&file.document, span.range).len())
        })
    }
}

/// The conditions around a range, outermost first.
fn conditions(document: &Document, range: TextRange) -> Vec<TextRange> {
    let place = document.item_at(range.start);
    let holds = |node: &Node<'_>| {
        let own = node.range().shift(place.start);
        node.kind() == NodeKind::Element && own.start < range.start && range.end <= own.end
    };
    let around = place.item.all_nodes().filter(holds);
    let around = around.filter(|node| matches!(node.name(), "xacro:if" | "xacro:unless"));
    // what decides a condition is evaluated whether it is taken or not
    let around = around.filter(|node| {
        !node
            .start_tag_range()
            .shift(place.start)
            .contains_range(range)
    });
    around.map(|node| node.range().shift(place.start)).collect()
}

/// Values of attributes that hold a text and stand elsewhere than at the known places.
pub fn further_places(
    names: &TextNames,
    documents: Documents<'_>,
    text: &str,
    known: &[Span],
) -> Vec<Span> {
    let mut files: Vec<FileId> = names.files.iter().copied().collect();
    files.sort_unstable();
    let mut found = Vec::new();
    for file in files {
        let Some(source) = documents(file) else {
            continue;
        };
        for (base, item) in source.document.parts() {
            if !item.text().contains(text) {
                continue;
            }
            let attrs = item
                .all_nodes()
                .flat_map(|node| node.attrs())
                .filter(|attr| attr.raw().contains(text));
            let spans = attrs.map(|attr| Span {
                file,
                range: attr.value_range().shift(base),
            });
            found.extend(spans.filter(|span| {
                let mut known = known.iter();
                !known.any(|known| known.file == file && span.range.contains_range(known.range))
            }));
        }
    }
    found
}

//! Names of xacro while somebody types in a large robot: said without expanding it again, when all that the answer
//! rests on is as it was.

use std::path::Path;
use std::sync::Arc;

use super::super::context::Cx;
use super::super::expressions::{ExprText, parsed, path_to};
use super::super::locate::{LocatedNode, locate};
use super::Hover;
use super::expression::{function, shown};
use super::page::{Page, code};
use super::symbols::comment_above;
use base::{Encoding, FastSet, IdVec, counted};
use expand::{DefinitionId, FileIdx, SourceItem, SrcId, SymbolKind, UseKind, parse_params};
use expr::ast::ExprKind;
use expr::{Value, names};
use facts::{FactKind, FactsOf, MentionKind, facts_of};
use vfs::SourceFile;
use xml::Item;

/// Bindings that a value may rest on.
const MOST_BINDINGS: usize = 64;

/// What there is to say about the name of a property, or of nothing at all, at an offset of the file, which is newer
/// than the expansion. `current` gives files as they are now. None: that takes a new expansion.
pub fn hover_while_typing(
    cx: &Cx<'_>,
    offset: u32,
    current: impl Fn(&Path) -> Option<Arc<SourceFile>>,
) -> Option<Hover> {
    let at = locate(&cx.source.document, offset);
    let text = ExprText::at(&cx.source.document, &at)?;
    let token = text.token_at(offset)?;
    let (expr, start) = parsed(token)?;
    let path = path_to(expr, text.offset(offset).saturating_sub(start));
    let part = path.last()?;
    let ExprKind::Name(name) = &part.kind else {
        return None;
    };
    let is_free = names(expr).iter().any(|free| free.range == part.range);
    if !is_free || function(&path).is_some() || !is_of_the_file(cx, &at, name) {
        return None;
    }
    let changes = Changes::of(cx, current);
    let named = text.range(part.range.shift(start));
    let (page, range) = match changes.only_property(name)? {
        Some(id) => (changes.property(id, name)?, named),
        None => {
            let mut page = Page::titled(format!("{} = {}", code(name), shown(&Value::Unknown)));
            page.add("the value is unknown");
            let is_whole = std::ptr::eq(*part, expr);
            (
                page,
                if is_whole {
                    text.range(token.range())
                } else {
                    named
                },
            )
        }
    };
    Some(Hover {
        markdown: page.finish(),
        range,
    })
}

/// Whether a name at a place means the same as anywhere in the file, and the place is come by: not under a condition,
/// and in a macro only when it is called and has no parameter of that name.
fn is_of_the_file(cx: &Cx<'_>, at: &LocatedNode<'_>, name: &str) -> bool {
    let mut around = at.node;
    while let Some(node) = around {
        let is_settled = match node.name() {
            "xacro:if" | "xacro:unless" | "xacro:property" | "xacro:include" => false,
            "xacro:macro" => {
                let params = node
                    .attr("params")
                    .map_or(Some(Vec::new()), |params| parse_params(params.raw()));
                let own =
                    |params: Vec<expand::MacroParam>| params.iter().all(|param| param.name != name);
                params.is_some_and(own)
                    && node
                        .attr("name")
                        .is_some_and(|name| is_called(cx, name.raw()))
            }
            _ => true,
        };
        if !is_settled {
            return false;
        }
        around = node.parent();
    }
    true
}

fn is_called(cx: &Cx<'_>, name: &str) -> bool {
    let symbols = &cx.expansion.index.symbols;
    let mut named = symbols
        .iter()
        .filter(|(_, known)| known.kind == SymbolKind::Macro && known.name == name);
    let only = named.next().filter(|_| named.next().is_none());
    only.is_some_and(|(id, _)| symbols.uses_of(id).any(|used| used.kind == UseKind::Call))
}

/// The files of an expansion as they are now, and what is new in them.
struct Changes<'a, 'c> {
    cx: &'c Cx<'a>,
    files: IdVec<FileIdx, Option<Arc<SourceFile>>>,
    /// Items of edited files that the expansion knows, by their addresses.
    kept: FastSet<*const Item>,
    /// Items that it does not know.
    new: Vec<Arc<Item>>,
}

impl<'a, 'c> Changes<'a, 'c> {
    fn of(cx: &'c Cx<'a>, current: impl Fn(&Path) -> Option<Arc<SourceFile>>) -> Self {
        let known: FastSet<*const Item> = cx
            .expansion
            .sources
            .iter()
            .map(|source| Arc::as_ptr(&source.item))
            .collect();
        let (mut files, mut kept, mut new) = (IdVec::default(), FastSet::default(), Vec::new());
        for file in &cx.expansion.files {
            let now = current(&file.source.path);
            if let Some(now) = now.as_ref().filter(|now| !Arc::ptr_eq(now, &file.source)) {
                for (_, item) in now.document.parts() {
                    if known.contains(&Arc::as_ptr(item)) {
                        kept.insert(Arc::as_ptr(item));
                    } else {
                        new.push(item.clone());
                    }
                }
            }
            files.push(now);
        }
        Self {
            cx,
            files,
            kept,
            new,
        }
    }

    /// The only property of a name; or that nothing has that name. None when that is not certain.
    fn only_property(&self, name: &str) -> Option<Option<DefinitionId>> {
        if self.new.iter().any(|item| gives(item, name)) || !self.cx.expansion.whole {
            return None;
        }
        let symbols = &self.cx.expansion.index.symbols;
        let named = symbols.iter().filter(|(_, known)| known.name == name);
        let mut given = named.filter(|(_, known)| {
            matches!(
                known.kind,
                SymbolKind::Property | SymbolKind::BlockProperty | SymbolKind::Namespace
            )
        });
        let Some((id, known)) = given.next() else {
            return Some(None);
        };
        let is_plain = known.kind == SymbolKind::Property && !known.conditional && !known.in_macro;
        (is_plain && given.next().is_none()).then_some(Some(id))
    }

    /// What there is to say about a property whose value rests on nothing that changed.
    fn property(&self, id: DefinitionId, name: &str) -> Option<Page> {
        let expansion = self.cx.expansion;
        let known = expansion.index.symbols.get(id)?;
        let base = self.base_now(known.place.src)?;
        let value = self.value(id)?;
        let mut page = Page::titled(format!("**property** {} = {}", code(name), shown(value)));
        let source = expansion.sources.get(known.place.src)?;
        let file = self.files.get(source.file)?.as_ref()?;
        let line = file
            .document
            .line_col(base + known.place.range.start, Encoding::Utf8)
            .line
            + 1;
        let place = format!("{}:{line}", file.path.file_name()?.to_string_lossy());
        page.add(format!(
            "defined in {place}, used {}",
            counted(self.uses(id, name), "time")
        ));
        page.add(comment_above(self.cx, id).unwrap_or_default());
        Some(page)
    }

    /// The value of a property that was given once.
    fn value(&self, id: DefinitionId) -> Option<&'a Value> {
        let bindings = &self.cx.expansion.index.bindings;
        let mut given = bindings
            .iter_ids()
            .filter(|(_, info)| info.definition == Some(id));
        let (binding, info) = given.next().filter(|_| given.next().is_none())?;
        let (mut open, mut seen) = (vec![binding], FastSet::default());
        while let Some(binding) = open.pop() {
            let info = bindings
                .get(binding)
                .filter(|_| seen.len() < MOST_BINDINGS)?;
            if seen.insert(binding) {
                if info.origin.is_some_and(|origin| !self.is_kept(origin.src)) {
                    return None;
                }
                open.extend(self.cx.expansion.index.read_in(info.reads));
            }
        }
        info.value.as_ref().filter(|value| !value.is_unknown())
    }

    /// How often a property is used.
    fn uses(&self, id: DefinitionId, name: &str) -> usize {
        let before = self
            .cx
            .expansion
            .index
            .symbols
            .all_uses()
            .filter(|used| used.definition == id);
        let kept = before.filter(|used| self.is_kept(used.place.src)).count();
        let facts = self.new.iter().map(facts_of);
        let named = |facts: FactsOf<'_>| {
            facts
                .mentions()
                .filter(|found| found.kind == MentionKind::Name && found.name == name)
                .count()
        };
        kept + facts.map(named).sum::<usize>()
    }

    /// Whether an item of the expansion is as it was.
    fn is_kept(&self, src: SrcId) -> bool {
        self.versions(src).is_some_and(|(source, before, now)| {
            Arc::ptr_eq(now, before) || self.kept.contains(&Arc::as_ptr(&source.item))
        })
    }

    /// An item of the expansion, and its file as it was and as it is.
    fn versions(&self, src: SrcId) -> Option<(&SourceItem, &Arc<SourceFile>, &Arc<SourceFile>)> {
        let source = self.cx.expansion.sources.get(src)?;
        let before = self.cx.expansion.files.get(source.file)?;
        let now = self.files.get(source.file)?.as_ref()?;
        Some((source, &before.source, now))
    }

    /// Where an item of the expansion stands now; none when it was edited.
    fn base_now(&self, src: SrcId) -> Option<u32> {
        let (source, before, now) = self.versions(src)?;
        if Arc::ptr_eq(now, before) {
            return Some(source.base);
        }
        let mut parts = now.document.parts();
        parts
            .find(|(_, item)| Arc::ptr_eq(item, &source.item))
            .map(|(base, _)| base)
    }
}

/// Whether a text may give something the name, or brings in what may.
fn gives(item: &Arc<Item>, name: &str) -> bool {
    let facts = facts_of(item);
    facts.of(FactKind::Include).next().is_some()
        || facts
            .of(FactKind::Property)
            .any(|fact| fact.name == name || fact.name.contains('$'))
}

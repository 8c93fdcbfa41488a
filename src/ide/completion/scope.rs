//! The names that can be used in a file: what the files of its context give, as they are now.
//!
//! Read off the texts, not off an expansion, so that it holds while a text is broken.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use base::FastSet;
use expand::{Expansion, MacroParam, parse_params};
use facts::{Fact, FactKind, facts_of};
use model::Robot;
use packages::Packages;
use rules::is_semantic_file;
use rules::schema::{ElementSpec, robot, semantic_robot};
use vfs::{SourceFile, Vfs};
use workspace::{admitted_files, named_file};
use xml::{Attr, Entities, Item, Node, NodeKind};

/// What the answer may be taken from.
#[derive(Clone, Copy)]
pub struct CompletionSources<'a> {
    /// The file that is edited, as it is now.
    pub source: &'a SourceFile,
    /// The root file of its context.
    pub root: &'a Path,
    /// Expansions of the root, the newest first; they may be older than the texts.
    pub expansions: &'a [(&'a Expansion, Option<&'a Robot>)],
    /// Files as they are now.
    pub vfs: &'a Vfs,
    /// Packages by name.
    pub packages: &'a Packages,
    /// Folders that may be listed, besides those of packages.
    pub folders: &'a [PathBuf],
    /// Files that are robots.
    pub roots: &'a [PathBuf],
    /// For an SRDF: the robots that it is for.
    pub described: &'a [(&'a Expansion, &'a Robot)],
}

/// A file of the context.
pub(super) struct InScope {
    pub source: Arc<SourceFile>,
    /// Namespaces it is included under, each with its dot.
    pub namespace: String,
}

/// The files of a context.
pub struct CompletionScope<'a> {
    pub(super) sources: CompletionSources<'a>,
    pub(super) files: Vec<InScope>,
    /// Whether the edited file is SRDF.
    pub(super) is_semantic: bool,
}

/// A macro that can be called.
pub(super) struct MacroInfo {
    /// Its name, with its namespaces.
    pub name: String,
    pub params: Vec<MacroParam>,
    /// The comment above it.
    pub comment: String,
    /// The file that defines it.
    pub file: Arc<Path>,
    /// Its element.
    pub item: Arc<Item>,
    pub node: xml::NodeId,
}

/// A property that can be read, or a block that can be inserted. What there is to say about it is read off its
/// element when it is asked for: a robot has thousands, and a list shows some.
pub(super) struct PropertyInfo {
    /// Its name, with its namespaces.
    pub name: EcoString,
    /// Whether it is a block.
    pub is_block: bool,
    /// Index of its file.
    pub file: usize,
    /// Whether it belongs to the macro that is edited.
    pub local: bool,
    item: Arc<Item>,
    node: xml::NodeId,
}

impl PropertyInfo {
    /// Its value as written; none for a block.
    pub fn value(&self) -> Option<String> {
        let value = written_value(self.item.node(self.node))?;
        Some(value.value(&Entities::default()).into_owned())
    }

    /// The comment above it.
    pub fn comment(&self) -> String {
        comment_above(self.item.node(self.node))
    }
}

/// The attribute that gives a property its value.
fn written_value(node: Node<'_>) -> Option<Attr<'_>> {
    node.attr("value").or_else(|| node.attr("default"))
}

impl<'a> CompletionScope<'a> {
    const MOST_FILES: usize = 1000;

    /// The files of a context: the root and what it includes, the edited file, what the last expansion read.
    pub fn new(sources: CompletionSources<'a>) -> Self {
        let is_semantic = is_semantic_file(&sources.source.path, &sources.source.document);
        let mut scope = Self {
            sources,
            files: Vec::new(),
            is_semantic,
        };
        let mut seen = FastSet::default();
        let own = &sources.source.path;
        let mut open = vec![(sources.root.to_path_buf(), String::new())];
        while let Some((path, namespace)) = open.pop() {
            if scope.files.len() < Self::MOST_FILES
                && seen.insert((path.clone(), namespace.clone()))
            {
                open.extend(scope.add(&path, namespace));
            }
        }
        let read = sources
            .expansions
            .iter()
            .flat_map(|(expansion, _)| &expansion.files);
        let read = read.map(|file| file.source.path.to_path_buf());
        for path in [own.to_path_buf()].into_iter().chain(read) {
            let mut open = vec![path];
            while let Some(path) = open.pop() {
                if !scope.has(&path) && scope.files.len() < Self::MOST_FILES {
                    open.extend(
                        scope
                            .add(&path, String::new())
                            .into_iter()
                            .map(|(path, _)| path),
                    );
                }
            }
        }
        scope
    }

    fn has(&self, path: &Path) -> bool {
        self.files.iter().any(|file| *file.source.path == *path)
    }

    /// The root element of files such as the edited one.
    pub(super) fn root_spec(&self) -> &'static ElementSpec {
        if self.is_semantic {
            semantic_robot()
        } else {
            robot()
        }
    }

    /// The robots whose links and joints are named: of an SRDF, those that it is for.
    pub(super) fn robots(&self) -> impl Iterator<Item = (&'a Expansion, &'a Robot)> {
        let own = self.sources.expansions.iter().filter(|_| !self.is_semantic);
        let own = own.filter_map(|(expansion, robot)| Some((*expansion, (*robot)?)));
        own.chain(self.sources.described.iter().copied())
    }

    /// Add a file; what it includes, as far as its text says.
    fn add(&mut self, path: &Path, namespace: String) -> Vec<(PathBuf, String)> {
        let named = *path == *self.sources.root || *path == *self.sources.source.path;
        if !named && !self.may_list(path.parent().unwrap_or(path)) {
            // an include may point anywhere; what no package and no workspace holds is not told
            return Vec::new();
        }
        let Ok(source) = self.sources.vfs.document(path) else {
            return Vec::new();
        };
        let mut found = Vec::new();
        for (_, item) in source.document.parts() {
            for fact in facts_of(item).of(FactKind::Include) {
                let (packages, vfs) = (self.sources.packages, self.sources.vfs);
                let paths = match named_file(&fact.name, &source.path, packages, vfs) {
                    Some(path) => vec![path],
                    None => admitted_files(&fact.name, &source.path, packages, vfs),
                };
                let name = item
                    .node(fact.node)
                    .attr("ns")
                    .map(|ns| format!("{namespace}{}.", ns.raw()));
                let name = name.unwrap_or_else(|| namespace.clone());
                found.extend(paths.into_iter().map(|path| (path, name.clone())));
            }
        }
        self.files.push(InScope { source, namespace });
        found
    }

    /// The files that the edited file includes by itself, as far as its text says.
    pub(super) fn included_here(&self) -> FastSet<PathBuf> {
        let (packages, vfs) = (self.sources.packages, self.sources.vfs);
        let own = self.sources.source;
        let names = own.document.parts().flat_map(|(_, item)| {
            facts_of(item)
                .of(FactKind::Include)
                .map(|fact| fact.name.clone())
                .collect::<Vec<_>>()
        });
        names
            .filter_map(|name| named_file(&name, &own.path, packages, vfs))
            .collect()
    }

    /// All items with the index of their file.
    pub(super) fn items(&self) -> impl Iterator<Item = (usize, &InScope, &Arc<Item>)> {
        let files = self.files.iter().enumerate();
        files.flat_map(|(index, file)| {
            file.source
                .document
                .parts()
                .map(move |(_, item)| (index, file, item))
        })
    }

    /// The namespaces of a file, each with its dot, as they are written in the edited file: those around that are not.
    fn namespace_here<'n>(&self, namespace: &'n str) -> &'n str {
        let edited = self
            .files
            .iter()
            .filter(|file| file.source.path == self.sources.source.path);
        let own = edited.filter_map(|file| namespace.strip_prefix(file.namespace.as_str()));
        own.min_by_key(|rest| rest.len()).unwrap_or(namespace)
    }

    /// The macros that can be called, each name once: the last definition counts.
    pub(super) fn macros(&self) -> Vec<MacroInfo> {
        self.macros_named(|_| true)
    }

    /// The macros whose name, without namespaces, is wanted.
    fn macros_named(&self, is_wanted: impl Fn(&str) -> bool) -> Vec<MacroInfo> {
        let mut found: Vec<MacroInfo> = Vec::new();
        for (_, file, item) in self.items() {
            let facts = facts_of(item);
            let wanted = |fact: &&Fact| is_wanted(fact.name.trim_start_matches("xacro:"));
            for fact in facts.of(FactKind::Macro).filter(wanted) {
                let node = item.node(fact.node);
                let params = node
                    .attr("params")
                    .map(|attr| attr.value(&Entities::default()).into_owned());
                found.push(MacroInfo {
                    name: format!(
                        "{}{}",
                        self.namespace_here(&file.namespace),
                        fact.name.trim_start_matches("xacro:")
                    ),
                    params: params
                        .and_then(|text| parse_params(&text))
                        .unwrap_or_default(),
                    comment: comment_above(node),
                    file: file.source.path.clone(),
                    item: item.clone(),
                    node: fact.node,
                });
            }
        }
        found.reverse();
        let mut seen: FastSet<String> = FastSet::default();
        found.retain(|info| !info.name.is_empty() && seen.insert(info.name.clone()));
        found
    }

    /// The macro that a tag `xacro:name` calls.
    pub(super) fn called(&self, tag: &str) -> Option<MacroInfo> {
        let name = tag.strip_prefix("xacro:")?;
        let (namespace, last) = name.rsplit_once('.').unwrap_or(("", name));
        let mut macros = self.macros_named(|given| given == last || given == name);
        if let Some(known) = macros.iter().position(|info| info.name == name) {
            return Some(macros.swap_remove(known));
        }
        // a namespace whose file is computed: the macro, when only one has that name
        if namespace.is_empty() {
            return None;
        }
        let first = macros.pop()?;
        macros
            .iter()
            .all(|other| Arc::ptr_eq(&other.item, &first.item))
            .then_some(first)
    }

    /// The properties that can be read at `offset` of the edited file, in the order of the text.
    pub(super) fn properties(&self, offset: u32) -> Vec<PropertyInfo> {
        let edited = &self.sources.source.document;
        let place = edited.item_at(offset.saturating_sub(1));
        let inside = offset.saturating_sub(place.start);
        let mut found = Vec::new();
        for (file, in_scope, item) in self.items() {
            for fact in facts_of(item).of(FactKind::Property) {
                let node = item.node(fact.node);
                let here =
                    Arc::ptr_eq(item, place.item) && macro_around(node) == macro_at(item, inside);
                let handed_on = node.attr("scope").is_some();
                if fact.in_macro && !here && !handed_on {
                    continue;
                }
                let name = match self.namespace_here(&in_scope.namespace) {
                    "" => fact.name.clone(),
                    namespace => ecow::eco_format!("{namespace}{}", fact.name),
                };
                let is_block = written_value(node).is_none();
                let local = fact.in_macro && here;
                let item = item.clone();
                found.push(PropertyInfo {
                    name,
                    is_block,
                    file,
                    local,
                    item,
                    node: fact.node,
                });
            }
        }
        found
    }

    /// The arguments of the context with their defaults; the value of the last expansion comes first.
    pub(super) fn arguments(&self) -> Vec<(String, Option<String>)> {
        let known = self
            .sources
            .expansions
            .iter()
            .flat_map(|(expansion, _)| &expansion.arguments);
        let known = known.map(|(name, value)| (name.to_string(), Some(value.to_string())));
        let declared = self.items().flat_map(|(_, _, item)| {
            let read = |fact: &Fact| {
                let default = item.node(fact.node).attr("default");
                let default = default.map(|attr| attr.value(&Entities::default()).into_owned());
                (fact.name.to_string(), default)
            };
            facts_of(item)
                .of(FactKind::Argument)
                .map(read)
                .collect::<Vec<_>>()
        });
        let mut seen: FastSet<String> = FastSet::default();
        let all = known
            .chain(declared)
            .filter(|(name, _)| !name.is_empty() && seen.insert(name.clone()));
        all.collect()
    }

    /// The names of a kind that stand as they are in the texts: no expression in them, outside of macros.
    pub(super) fn plain_names(&self, kind: FactKind) -> Vec<(EcoString, Arc<Path>)> {
        let mut found = Vec::new();
        for (_, file, item) in self.items() {
            let facts = facts_of(item);
            let plain = facts
                .of(kind)
                .filter(|fact| !fact.in_macro && !fact.name.contains('$'));
            found.extend(plain.map(|fact| (fact.name.clone(), file.source.path.clone())));
        }
        found
    }

    /// The computed names of a kind in the other macros of the file: a library often names in one macro what another one made.
    pub(super) fn patterns_beside(&self, kind: FactKind, offset: u32) -> Vec<EcoString> {
        let document = &self.sources.source.document;
        let place = document.item_at(offset.saturating_sub(1));
        if macro_at(place.item, offset.saturating_sub(place.start)).is_none() {
            return Vec::new();
        }
        let mut found = Vec::new();
        for (base, item) in document.parts() {
            let facts = facts_of(item);
            let computed = facts
                .of(kind)
                .filter(|fact| fact.in_macro && fact.name.contains('$'));
            let others = computed.filter(|fact| !fact.range.shift(base).touches(offset));
            found.extend(others.map(|fact| fact.name.clone()));
        }
        found
    }

    /// The names of a kind that stand around `offset` as they are written: those of the macro around, and outside of
    /// macros those with something computed in them, which the robot knows under other names. What is typed at `offset`
    /// is none.
    pub(super) fn patterns(&self, kind: FactKind, offset: u32) -> Vec<EcoString> {
        let document = &self.sources.source.document;
        let place = document.item_at(offset.saturating_sub(1));
        let around = macro_at(place.item, offset.saturating_sub(place.start));
        let mut found = Vec::new();
        for (base, item) in document.parts() {
            if around.is_some() && !Arc::ptr_eq(item, place.item) {
                continue;
            }
            let facts = facts_of(item);
            let own = facts.of(kind).filter(|fact| match around {
                Some(_) => macro_around(item.node(fact.node)) == around,
                None => !fact.in_macro && fact.name.contains('$'),
            });
            let others = own.filter(|fact| !fact.range.shift(base).touches(offset));
            found.extend(others.map(|fact| fact.name.clone()));
        }
        found
    }
}

/// The outermost macro element around a node.
pub(super) fn macro_around(node: Node<'_>) -> Option<u32> {
    let around = std::iter::successors(node.parent(), |node| node.parent());
    around
        .filter(|node| node.name() == "xacro:macro")
        .last()
        .map(|node| node.id().0)
}

/// The outermost macro element around an offset of an item.
pub(super) fn macro_at(item: &Item, inside: u32) -> Option<u32> {
    let around = |node: &Node<'_>| {
        let range = node.range();
        node.name() == "xacro:macro" && range.start < inside && inside <= range.end
    };
    item.all_nodes().find(around).map(|node| node.id().0)
}

/// The text of the comment that stands directly above an element.
pub fn comment_above(node: Node<'_>) -> String {
    let before: Vec<Node<'_>> = match node.parent() {
        Some(parent) => parent
            .children()
            .take_while(|other| *other != node)
            .collect(),
        None => node
            .item()
            .nodes()
            .take_while(|other| *other != node)
            .collect(),
    };
    let near = before.iter().enumerate().rev();
    let near = near.take_while(|(at, other)| match other.kind() {
        NodeKind::Text => other.raw().trim().is_empty() && other.raw().matches('\n').count() < 2,
        kind => kind == NodeKind::Comment && !ends_a_line(&before, *at),
    });
    let mut comments: Vec<&str> = near
        .filter(|(_, other)| other.kind() == NodeKind::Comment)
        .map(|(_, node)| node.raw().trim())
        .collect();
    comments.reverse();
    comments.retain(|text| !text.starts_with("xacro-lint:"));
    comments.join("\n")
}

/// Whether a comment stands behind something on the same line and at the end of that line: it is about what it stands behind.
fn ends_a_line(siblings: &[Node<'_>], at: usize) -> bool {
    let breaks = |node: &Node<'_>| node.kind() == NodeKind::Text && node.raw().contains('\n');
    let before = at.checked_sub(1).and_then(|before| siblings.get(before));
    !before.is_some_and(breaks) && siblings.get(at + 1).is_some_and(breaks)
}

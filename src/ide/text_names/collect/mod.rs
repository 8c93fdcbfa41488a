//! Reading the definitions and uses of names off the texts of a robot, in the order of evaluation.

mod record;

use std::sync::Arc;

use ecow::EcoString;

use super::files::IncludedFiles;
use super::{
    Class, Guard, Reading, TextDefinition, TextDefinitionId, TextNames, TextScope, TextScopeId,
    UsedId,
};
use base::{FastMap, FastSet, FileId, IdVec, Span, TextRange};
use expand::{Expansion, SymbolKind, UseKind, parse_params};
use facts::{FactsOf, facts_of, is_keyword};
use rules::RuleEnv;
use vfs::SourceFile;
use xml::{Attr, Entities, Item, Node, NodeKind, source_offset};

/// Includes inside of includes that are followed.
const MOST_DEEP: u32 = 100;

impl TextNames {
    /// The names of the robot that was expanded, with those in its branches that were not.
    pub fn of(expansion: &Expansion, world: RuleEnv<'_>) -> Self {
        let files = IncludedFiles::new(expansion, world);
        let mut names = Self {
            scopes: IdVec::from(vec![TextScope::Top]),
            ..Self::default()
        };
        if let Some(root) = files.root() {
            let mut reader = NameCollector {
                names: &mut names,
                files: &files,
                seen: FastMap::default(),
                several: FastSet::default(),
                readings: FastMap::default(),
                known: FastMap::default(),
                known_uses: FastMap::default(),
                order: 0,
            };
            let at = NodeScope {
                scope: TextScopeId::TOP,
                guard: Guard::default(),
                is_sure: true,
                is_in_body: false,
            };
            reader.file(&root, at, 0);
            let (several, readings) = (reader.several, reader.readings);
            names.readings = readings;
            names.several = several;
        }
        for (id, given) in names.given.iter_ids() {
            names
                .by_name
                .entry((Class::of(given.kind), given.name.clone()))
                .or_default()
                .push(id);
        }
        names.connect();
        names
    }

    /// Work out what the bodies of macros and blocks see.
    fn connect(&mut self) {
        let calls = self
            .used
            .iter_ids()
            .filter(|(_, used)| used.class == Class::Macro && !used.is_end);
        let mut entered: FastMap<TextScope, Vec<TextScopeId>> = FastMap::default();
        let mut calls_of: FastMap<TextDefinitionId, Vec<UsedId>> = FastMap::default();
        for (call, used) in calls {
            for of in self.macros(&used.called(), &used.scopes) {
                calls_of.entry(of).or_default().push(call);
                entered
                    .entry(TextScope::Callers(of))
                    .or_default()
                    .extend(&used.scopes);
                // a macro of a namespace sees that, and not who calls it
                let own = self.given.get(of).map_or(&[][..], |given| &given.scopes);
                let seen = if used.of.is_empty() {
                    &used.scopes[..]
                } else {
                    own
                };
                entered.entry(TextScope::Body(of)).or_default().extend(seen);
            }
        }
        self.calls_of = calls_of;
        self.set_times();
        self.set_entered(entered);
        let mut entered: FastMap<TextScope, Vec<TextScopeId>> = FastMap::default();
        for used in self.used.iter().filter(|used| used.kind == UseKind::Insert) {
            for of in self.candidates(used, None) {
                entered
                    .entry(TextScope::Body(of))
                    .or_default()
                    .extend(&used.scopes);
            }
        }
        self.set_entered(entered);
    }

    fn set_entered(&mut self, mut entered: FastMap<TextScope, Vec<TextScopeId>>) {
        for (id, scope) in self.scopes.iter_ids() {
            if let Some(mut from) = entered.remove(scope) {
                from.sort_unstable();
                from.dedup();
                self.entered_from.insert(id, from);
            }
        }
    }
}

struct NameCollector<'a> {
    names: &'a mut TextNames,
    files: &'a IncludedFiles<'a>,
    /// Files with the scopes that they were read in, and the condition around that.
    seen: FastMap<(FileId, TextScopeId), Guard>,
    /// Files that several conditions bring in.
    several: FastSet<FileId>,
    /// Where each file is read.
    readings: FastMap<FileId, Vec<Reading>>,
    /// Definitions by place.
    known: FastMap<Span, TextDefinitionId>,
    /// Uses by place.
    known_uses: FastMap<Span, UsedId>,
    order: u32,
}

/// Where a node stands.
#[derive(Clone, Copy)]
struct NodeScope {
    scope: TextScopeId,
    /// The innermost condition around it.
    guard: Guard,
    /// Whether it is evaluated whenever the conditions around it are taken.
    is_sure: bool,
    is_in_body: bool,
}

/// An element around the current node: its end, and what holds inside.
type OpenElement = (u32, NodeScope);

/// The part of a document that is read.
struct ReadSection<'a> {
    source: &'a Arc<SourceFile>,
    base: u32,
    facts: &'a FactsOf<'a>,
    depth: u32,
}

impl ReadSection<'_> {
    fn span(&self, range: TextRange) -> Span {
        Span {
            file: self.source.id,
            range: range.shift(self.base),
        }
    }
}

impl NameCollector<'_> {
    fn file(&mut self, source: &Arc<SourceFile>, at: NodeScope, depth: u32) {
        let key = (source.id, at.scope);
        let reading = Reading {
            scope: at.scope,
            guard: at.guard,
            order: self.order,
        };
        self.readings.entry(source.id).or_default().push(reading);
        if let Some(&first) = self.seen.get(&key) {
            if !self.names.is_within(at.guard, first) {
                self.several.insert(source.id);
            }
            return;
        }
        if depth > MOST_DEEP {
            return;
        }
        self.seen.insert(key, at.guard);
        self.names.files.insert(source.id);
        for (base, item) in source.document.parts() {
            if item.text().contains("xacro:") || item.text().contains('$') {
                let facts = facts_of(item);
                let part = ReadSection {
                    source,
                    base,
                    facts: &facts,
                    depth,
                };
                self.item(&part, item, at);
            }
        }
    }

    fn item(&mut self, part: &ReadSection<'_>, item: &Item, outer: NodeScope) {
        let mut sites = part.facts.sites().iter().peekable();
        let mut open: Vec<OpenElement> = Vec::new();
        for node in item.all_nodes() {
            let range = node.range();
            while open.last().is_some_and(|(end, _)| *end <= range.start) {
                open.pop();
            }
            let at = open.last().map_or(outer, |(_, at)| *at);
            if node.kind() == NodeKind::Element {
                let inside = self.element(part, node, at);
                let end = node.start_tag_range().end;
                while let Some(site) = sites.next_if(|site| site.range.start < end) {
                    self.site(part, node, site, at, inside);
                }
                open.extend(inside.map(|inside| (range.end, inside)));
            } else {
                while let Some(site) = sites.next_if(|site| site.range.start < range.end) {
                    self.mentions(part, site, at, None);
                }
            }
        }
    }

    /// Read an element; answers with what holds inside of it when that is something else.
    fn element(
        &mut self,
        part: &ReadSection<'_>,
        node: Node<'_>,
        at: NodeScope,
    ) -> Option<NodeScope> {
        match node.name() {
            "xacro:if" | "xacro:unless" => {
                let guard = self.guard(at.guard);
                return Some(NodeScope { guard, ..at });
            }
            "xacro:property" => return self.property(part, node, at),
            "xacro:macro" => return self.macro_definition(part, node, at),
            "xacro:arg" => {
                self.give(
                    part,
                    node,
                    SymbolKind::Argument,
                    named(node, "name")?,
                    NodeScope {
                        scope: TextScopeId::TOP,
                        ..at
                    },
                );
            }
            "xacro:include" => self.include(part, node, at),
            "xacro:insert_block" => {
                let name = named(node, "name")?;
                self.uses(part, UseKind::Insert, Class::Block, name, at, "");
            }
            "xacro:call" => {
                let (name, range) = named(node, "macro")?;
                self.call(part, node, &name, range, at);
            }
            name => {
                let called = name
                    .strip_prefix("xacro:")
                    .filter(|called| !is_keyword(called))?;
                let end = node.name_range().end;
                let range = TextRange::new(end - called.len() as u32, end);
                self.call(part, node, called, range, at);
                if let Some(end) = node
                    .end_name_range()
                    .filter(|end| end.len() == node.name_range().len())
                {
                    let first = self.names.used.len();
                    self.tag(
                        part,
                        called,
                        TextRange::new(end.end - called.len() as u32, end.end),
                        at,
                    );
                    self.names
                        .used
                        .iter_mut()
                        .skip(first)
                        .for_each(|used| used.is_end = true);
                }
            }
        }
        None
    }

    fn property(
        &mut self,
        part: &ReadSection<'_>,
        node: Node<'_>,
        at: NodeScope,
    ) -> Option<NodeScope> {
        let name = named(node, "name")?;
        if node
            .attr("remove")
            .is_some_and(|remove| matches!(remove.raw(), "true" | "True" | "1"))
        {
            self.uses(part, UseKind::Read, Class::Value, name, at, "");
            return None;
        }
        let has_value = node.attr("value").is_some() || node.attr("default").is_some();
        let kind = if has_value {
            SymbolKind::Property
        } else {
            SymbolKind::BlockProperty
        };
        let is_sure = at.is_sure && node.attr("default").is_none();
        let scope = node.attr("scope").map_or("", |scope| scope.raw());
        let own = match scope {
            "global" => NodeScope {
                scope: TextScopeId::TOP,
                is_sure: is_sure && !at.is_in_body,
                ..at
            },
            _ => NodeScope { is_sure, ..at },
        };
        let id = self.give(part, node, kind, name, own);
        if let Some(given) = self.names.given.get_mut(id) {
            given.handed_out = scope == "parent";
        }
        (!has_value).then(|| NodeScope {
            scope: self.scope(TextScope::Body(id)),
            is_sure: true,
            is_in_body: true,
            ..at
        })
    }

    fn macro_definition(
        &mut self,
        part: &ReadSection<'_>,
        node: Node<'_>,
        at: NodeScope,
    ) -> Option<NodeScope> {
        let (name, range) = named(node, "name")?;
        let bare: EcoString = name.trim_start_matches("xacro:").into();
        let range = TextRange::new(range.end - bare.len() as u32, range.end);
        let of = self.give(part, node, SymbolKind::Macro, (bare, range), at);
        let (body, callers) = (
            self.scope(TextScope::Body(of)),
            self.scope(TextScope::Callers(of)),
        );
        let inside = NodeScope {
            scope: body,
            is_sure: true,
            is_in_body: true,
            ..at
        };
        if let Some(attr) = node.attr("params") {
            self.params(part, attr, of, inside, callers);
        }
        Some(inside)
    }

    fn params(
        &mut self,
        part: &ReadSection<'_>,
        attr: Attr<'_>,
        of: TextDefinitionId,
        inside: NodeScope,
        callers: TextScopeId,
    ) {
        let entities = Entities::default();
        let text = attr.value(&entities);
        for param in parse_params(&text).unwrap_or_default() {
            let name: EcoString = param.name.trim_start_matches('*').into();
            let [start, end] = [param.range.end - name.len() as u32, param.range.end]
                .map(|at| source_offset(attr.raw(), &entities, true, at as usize) as u32);
            let range = TextRange::new(start, end).shift(attr.value_range().start);
            let kind = if param.is_block() {
                SymbolKind::BlockParameter
            } else {
                SymbolKind::Parameter
            };
            let span = part.span(range);
            let id = self.add(TextDefinition {
                kind,
                name: name.clone(),
                span,
                whole: span,
                of: Some(of),
                scopes: vec![inside.scope],
                handed_out: false,
                order: self.order,
                is_sure: true,
                guard: inside.guard,
                is_in_body: true,
            });
            debug_assert!(self.names.given.get(id).is_some());
            if param.forward {
                let at = NodeScope {
                    scope: callers,
                    ..inside
                };
                self.uses(part, UseKind::Read, Class::Value, (name, range), at, "");
            }
        }
    }

    fn include(&mut self, part: &ReadSection<'_>, node: Node<'_>, at: NodeScope) {
        let Some(filename) = node.attr("filename") else {
            return;
        };
        let scope = match named(node, "ns") {
            Some((name, range)) => {
                self.give(part, node, SymbolKind::Namespace, (name.clone(), range), at);
                let outer = self.names.namespace(at.scope);
                let path = if outer.is_empty() {
                    name
                } else {
                    ecow::eco_format!("{outer}.{name}")
                };
                self.scope(TextScope::Namespace(path, at.scope))
            }
            None => at.scope,
        };
        let name = node.name_range();
        let tag = part.span(TextRange::new(name.start - 1, name.end));
        let filename = filename.value(&Entities::default()).into_owned();
        let read = self.files.of(part.source, tag, &filename);
        for file in &read {
            self.included(file, tag, NodeScope { scope, ..at }, part.depth);
        }
        // other arguments would read these instead: as if each had a condition around it
        for file in self.files.alternatives(part.source, &filename) {
            if !read.iter().any(|read| read.id == file.id) {
                let guard = self.guard(at.guard);
                self.included(&file, tag, NodeScope { scope, guard, ..at }, part.depth);
            }
        }
    }

    fn included(&mut self, file: &Arc<SourceFile>, tag: Span, at: NodeScope, depth: u32) {
        self.names.included_at.entry(file.id).or_default().push(tag);
        self.file(file, at, depth + 1);
    }

    /// A condition within another one.
    fn guard(&mut self, outer: Guard) -> Guard {
        self.names.guards.push(outer);
        Guard(self.names.guards.len() as u32)
    }
}

/// The name that an attribute gives, where it is written out.
fn named(node: Node<'_>, attr: &str) -> Option<(EcoString, TextRange)> {
    let attr = node.attr(attr)?;
    let plain = !attr.raw().is_empty() && !attr.raw().contains(['$', '&']);
    plain.then(|| (attr.raw().into(), attr.value_range()))
}

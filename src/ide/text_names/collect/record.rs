//! Writing down definitions and uses, each once, with the scopes that they stand in.

use ecow::EcoString;

use super::super::{Class, TextDefinition, TextDefinitionId, TextScope, TextScopeId, TextUse};
use super::{NameCollector, NodeScope, ReadSection};
use base::TextRange;
use expand::{SymbolKind, UseKind};
use facts::{MentionKind, Site};
use xml::Node;

impl NameCollector<'_> {
    /// A call: the names in its tag, and the parameters that it gives.
    pub(super) fn call(
        &mut self,
        part: &ReadSection<'_>,
        node: Node<'_>,
        called: &str,
        range: TextRange,
        at: NodeScope,
    ) {
        self.tag(part, called, range, at);
        let given = node.attrs().filter(|attr| {
            !(attr.name().contains(':') || node.name() == "xacro:call" && attr.name() == "macro")
        });
        for attr in given {
            let name = (attr.name().into(), attr.name_range());
            self.uses(part, UseKind::Given, Class::Value, name, at, called);
        }
    }

    /// The name of a macro, with the namespaces in front of it.
    pub(super) fn tag(
        &mut self,
        part: &ReadSection<'_>,
        called: &str,
        range: TextRange,
        at: NodeScope,
    ) {
        let (path, last) = called.rsplit_once('.').unwrap_or(("", called));
        let own = TextRange::new(range.end - last.len() as u32, range.end);
        self.uses(
            part,
            UseKind::Call,
            Class::Macro,
            (last.into(), own),
            at,
            path,
        );
        let mut start = range.start;
        let mut before = String::new();
        for name in path.split('.').filter(|name| !name.is_empty()) {
            let own = TextRange::new(start, start + name.len() as u32);
            self.uses(
                part,
                UseKind::Read,
                Class::Value,
                (name.into(), own),
                at,
                &before,
            );
            start = own.end + 1;
            before = if before.is_empty() {
                name.to_owned()
            } else {
                format!("{before}.{name}")
            };
        }
    }

    /// The names in an attribute of an element.
    pub(super) fn site(
        &mut self,
        part: &ReadSection<'_>,
        node: Node<'_>,
        site: &Site,
        at: NodeScope,
        inside: Option<NodeScope>,
    ) {
        match node.name() {
            // neither is evaluated
            "xacro:macro" | "xacro:insert_block" if is_value(node, "name", site) => {}
            "xacro:macro" if is_value(node, "params", site) => {
                let of = inside.and_then(|inside| match self.names.scopes.get(inside.scope) {
                    Some(TextScope::Body(of)) => Some(*of),
                    _ => None,
                });
                let callers = of.map_or(at.scope, |of| self.scope(TextScope::Callers(of)));
                self.mentions(
                    part,
                    site,
                    NodeScope {
                        scope: callers,
                        ..at
                    },
                    None,
                );
            }
            "xacro:property" => {
                let at_once = node.attr("lazy_eval").is_some() || node.attr("scope").is_some();
                let own = node.attr("name").map(|name| part.span(name.value_range()));
                let own = own.and_then(|span| self.known.get(&span).copied());
                let is_later = !at_once && !is_value(node, "name", site);
                self.mentions(part, site, at, own.filter(|_| is_later));
            }
            _ => self.mentions(part, site, at, None),
        }
    }

    pub(super) fn mentions(
        &mut self,
        part: &ReadSection<'_>,
        site: &Site,
        at: NodeScope,
        lazy_in: Option<TextDefinitionId>,
    ) {
        let mut path = String::new();
        let first = self.names.used.len();
        for mention in &site.mentions {
            let name = (mention.name.clone(), mention.range);
            match mention.kind {
                MentionKind::Package => {}
                MentionKind::Argument => {
                    self.uses(part, UseKind::Read, Class::Argument, name, at, "")
                }
                MentionKind::Name => {
                    path = mention.name.to_string();
                    self.uses(part, UseKind::Read, Class::Value, name, at, "");
                }
                MentionKind::Member => {
                    self.uses(part, UseKind::Read, Class::Value, name, at, &path);
                    path = format!("{path}.{}", mention.name);
                }
            }
        }
        self.names
            .used
            .iter_mut()
            .skip(first)
            .for_each(|used| used.lazy_in = lazy_in);
    }

    pub(super) fn scope(&mut self, scope: TextScope) -> TextScopeId {
        let scopes = &mut self.names.scopes;
        let known = scopes.position(|known| *known == scope);
        known.unwrap_or_else(|| scopes.push(scope))
    }

    pub(super) fn give(
        &mut self,
        part: &ReadSection<'_>,
        node: Node<'_>,
        kind: SymbolKind,
        (name, range): (EcoString, TextRange),
        at: NodeScope,
    ) -> TextDefinitionId {
        self.add(TextDefinition {
            kind,
            name,
            span: part.span(range),
            whole: part.span(node.range()),
            of: None,
            scopes: vec![at.scope],
            handed_out: false,
            order: self.order,
            is_sure: at.is_sure,
            guard: at.guard,
            is_in_body: at.is_in_body,
        })
    }

    /// Add a definition, or the scopes of one that is known.
    pub(super) fn add(&mut self, given: TextDefinition) -> TextDefinitionId {
        self.order += 1;
        let next = self.names.given.next_id();
        let id = *self.known.entry(given.span).or_insert(next);
        match self.names.given.get_mut(id) {
            Some(known) => {
                add_scopes(&mut known.scopes, &given.scopes);
                if known.guard != given.guard {
                    self.several.insert(given.span.file);
                }
            }
            None => {
                self.names.given.push(given);
            }
        }
        id
    }

    pub(super) fn uses(
        &mut self,
        part: &ReadSection<'_>,
        kind: UseKind,
        class: Class,
        (name, range): (EcoString, TextRange),
        at: NodeScope,
        of: &str,
    ) {
        self.order += 1;
        let span = part.span(range);
        let next = self.names.used.next_id();
        let id = *self.known_uses.entry(span).or_insert(next);
        match self.names.used.get_mut(id) {
            Some(known) => {
                add_scopes(&mut known.scopes, &[at.scope]);
                if known.guard != at.guard {
                    self.several.insert(span.file);
                }
            }
            None => {
                self.names.used.push(TextUse {
                    kind,
                    class,
                    name,
                    span,
                    scopes: vec![at.scope],
                    of: of.into(),
                    order: self.order,
                    guard: at.guard,
                    lazy_in: None,
                    is_end: false,
                });
            }
        }
    }
}

/// Whether names stand in the attribute of the name.
fn is_value(node: Node<'_>, name: &str, site: &Site) -> bool {
    node.attr(name)
        .is_some_and(|attr| attr.value_range() == site.range)
}

fn add_scopes(known: &mut Vec<TextScopeId>, more: &[TextScopeId]) {
    for scope in more {
        if !known.contains(scope) {
            known.push(*scope);
        }
    }
}

//! From a use to the definitions that it may mean.

use std::collections::{BTreeMap, BTreeSet};

use ecow::EcoString;

use super::{
    Class, EvaluationPoint, Guard, Meaning, NameText, Reading, TextDefinition, TextDefinitionId,
    TextNames, TextScope, TextScopeId, TextUse,
};
use base::{FastMap, FastSet, Span};
use expand::{SymbolKind, UseKind};

impl TextNames {
    /// What a use means.
    pub(super) fn meaning(&self, used: &TextUse) -> Meaning<'_> {
        let mut found = self.candidates(used, Some(used.order));
        found = self.latest(used, found, &mut { MOST_CALLS });
        let mut given: Vec<&TextDefinition> =
            found.iter().filter_map(|&id| self.given.get(id)).collect();
        match (given.len(), given.pop()) {
            (1, Some(one)) => Meaning::One(one),
            (_, Some(last)) => Meaning::OneOf(given.into_iter().chain([last]).collect()),
            (_, None) => Meaning::Unknown,
        }
    }

    /// All definitions that a use may mean; with `order`, a definition in front of it in its own scope hides those of
    /// outer ones.
    pub(super) fn candidates(
        &self,
        used: &TextUse,
        order: Option<u32>,
    ) -> BTreeSet<TextDefinitionId> {
        self.among(self.named(used.class, &used.name), used, order)
    }

    /// The ones of some definitions that a use would mean if it had their name.
    fn among(
        &self,
        named: &[TextDefinitionId],
        used: &TextUse,
        order: Option<u32>,
    ) -> BTreeSet<TextDefinitionId> {
        let given = |id: &TextDefinitionId| self.given.get(*id);
        if used.kind == UseKind::Given {
            let mut macros: BTreeSet<TextDefinitionId> =
                self.macros(&used.of, &used.scopes).into_iter().collect();
            if order.is_some() {
                macros = self.at_that_time(used, macros);
            }
            let is_it = |given: &TextDefinition| {
                given.kind == SymbolKind::Parameter
                    && given.of.is_some_and(|of| macros.contains(&of))
            };
            return named
                .iter()
                .copied()
                .filter(|id| given(id).is_some_and(is_it))
                .collect();
        }
        match used.class {
            Class::Argument => named.iter().copied().collect(),
            Class::Macro => self
                .called(named, &used.of, &used.scopes)
                .into_iter()
                .collect(),
            _ if !used.of.is_empty() => self.members(named, used).into_iter().collect(),
            _ => {
                let (mut seen, mut found) = (FastSet::default(), BTreeSet::new());
                let order = order.filter(|_| used.lazy_in.is_none());
                used.scopes.iter().for_each(|&scope| {
                    self.visible((scope, used.seen()), named, order, &mut seen, &mut found)
                });
                found
            }
        }
    }

    fn named(&self, class: Class, name: &EcoString) -> &[TextDefinitionId] {
        self.by_name
            .get(&(class, name.clone()))
            .map_or(&[], Vec::as_slice)
    }

    /// The ones of these definitions that can be seen from a scope.
    fn visible(
        &self,
        (scope, at): (TextScopeId, EvaluationPoint),
        named: &[TextDefinitionId],
        order: Option<u32>,
        seen: &mut FastSet<TextScopeId>,
        found: &mut BTreeSet<TextDefinitionId>,
    ) {
        if named.is_empty() || !seen.insert(scope) {
            return;
        }
        let mut is_hidden = false;
        for &id in named {
            let Some(given) = self
                .given
                .get(id)
                .filter(|given| self.reaches(given, scope))
            else {
                continue;
            };
            found.insert(id);
            is_hidden |= self.is_sure(given, at)
                && !given.handed_out
                && order.is_none_or(|order| given.order < order);
        }
        if !is_hidden {
            let outer = self.around(scope).into_iter();
            outer.for_each(|outer| self.visible((outer, at), named, None, seen, found));
        }
    }

    /// Whether a definition belongs to a scope.
    fn reaches(&self, given: &TextDefinition, scope: TextScopeId) -> bool {
        if !given.handed_out {
            return given.scopes.contains(&scope);
        }
        given
            .scopes
            .iter()
            .any(|&own| self.around(own).contains(&scope))
    }

    /// The scopes that a scope sees.
    fn around(&self, scope: TextScopeId) -> Vec<TextScopeId> {
        match self.scopes.get(scope) {
            Some(TextScope::Namespace(_, outer)) => vec![*outer],
            Some(TextScope::Body(of) | TextScope::Callers(of)) => {
                match self.entered_from.get(&scope) {
                    Some(from) => from.clone(),
                    // nobody comes by: where it is defined
                    None => self
                        .given
                        .get(*of)
                        .map(|given| given.scopes.clone())
                        .unwrap_or_default(),
                }
            }
            Some(TextScope::Top) | None => Vec::new(),
        }
    }

    /// Of definitions in the scope of the use: the last one in front of it, and those behind that which a condition
    /// may leave out.
    pub(super) fn latest(
        &self,
        used: &TextUse,
        found: BTreeSet<TextDefinitionId>,
        left: &mut u32,
    ) -> BTreeSet<TextDefinitionId> {
        let given = |id: &TextDefinitionId| self.given.get(*id);
        let is_sure =
            |id: &TextDefinitionId| given(id).is_some_and(|given| self.is_sure(given, used.seen()));
        if used.class == Class::Argument {
            // the first one counts; macros are called later
            let outside = found
                .iter()
                .copied()
                .find(|id| given(id).is_some_and(|given| !given.is_in_body));
            return match outside.filter(is_sure) {
                Some(first) => BTreeSet::from([first]),
                None => found,
            };
        }
        if used.class == Class::Macro {
            return self.at_that_time(used, found);
        }
        let own = self.in_front(used, &found);
        if own.is_empty() {
            return match self.at_each_call(used, &found, left) {
                Some(found) => found,
                None => self.at_the_calls(used, found),
            };
        }
        let sure = own.iter().filter(|(_, (_, is_sure))| *is_sure);
        let last = sure.max_by_key(|(_, (order, _))| *order);
        let since = last.map_or(0, |(_, (order, _))| *order);
        let later = |id: &TextDefinitionId| own.get(id).is_some_and(|(order, _)| *order >= since);
        let in_scope =
            |id: &TextDefinitionId| given(id).is_some_and(|given| self.is_in_scope(given, used));
        if used.lazy_in.is_some() {
            // it is evaluated later, when others may have been defined; those in front of a sure one are gone
            let end = self.last_use(used);
            let left = found.into_iter().filter(|id| {
                let is_gone = own.contains_key(id) && !later(id)
                    || in_scope(id) && given(id).is_some_and(|own| own.order >= end);
                !is_gone
            });
            return self.at_the_calls(used, left.collect());
        }
        let last_given = last.and_then(|(id, _)| given(id));
        if last_given.is_none_or(|last| last.span.file != used.span.file) {
            let all = found.iter().copied().filter(in_scope).collect();
            if let Some(found) = self.at_each_reading(used, &all) {
                return found;
            }
        }
        match last {
            Some(_) => found.into_iter().filter(later).collect(),
            None => {
                let left = found
                    .into_iter()
                    .filter(|id| !in_scope(id) || own.contains_key(id));
                self.at_the_calls(used, left.collect())
            }
        }
    }

    /// Whether a definition is made in the scope of a use, by its own text.
    fn is_in_scope(&self, given: &TextDefinition, used: &TextUse) -> bool {
        !given.handed_out && given.scopes == used.scopes
    }

    /// The ones of some definitions that are made in the scope of a use and in front of it, be it by a macro that is called
    /// there and hands them out: with the order in which they are made, and whether they are sure to be.
    fn in_front(
        &self,
        used: &TextUse,
        found: &BTreeSet<TextDefinitionId>,
    ) -> BTreeMap<TextDefinitionId, (u32, bool)> {
        let order = |given: &TextDefinition| {
            if given.handed_out {
                return self.handed_out_order(given, used);
            }
            let is_own = self.is_in_scope(given, used) && given.order < used.order;
            is_own.then(|| (given.order, self.is_sure(given, used.seen())))
        };
        let found = found.iter().filter_map(|&id| {
            let order = self.given.get(id).and_then(order)?;
            Some((id, order))
        });
        found.collect()
    }

    /// Whether a definition is made whenever something is evaluated.
    pub(super) fn is_sure(&self, given: &TextDefinition, at: EvaluationPoint) -> bool {
        if !given.is_sure {
            return false;
        }
        let own = given.span.file;
        let Some(readings) = self.several(own) else {
            // of a file that is read at several places, no condition around those is sure
            let guard = match self.several(at.file) {
                Some(_) => Guard::default(),
                None => at.guard,
            };
            return self.is_within(guard, given.guard);
        };
        if at.file == own {
            // whatever brings the file in brings in both
            return self.is_within(at.guard, given.guard);
        }
        let (Some(first), None) = (readings.first(), self.several(at.file)) else {
            return false;
        };
        let is_outside = given.guard == first.guard;
        let one_scope = readings.iter().all(|reading| reading.scope == first.scope);
        let is_read =
            |reading: &Reading| reading.order < at.order && self.is_within(at.guard, reading.guard);
        is_outside && one_scope && readings.iter().any(is_read)
    }

    /// Whether a condition is one, or stands in it.
    pub(super) fn is_within(&self, mut guard: Guard, outer: Guard) -> bool {
        let around = |guard: Guard| self.guards.get(guard.0.checked_sub(1)? as usize).copied();
        while guard != outer {
            match around(guard) {
                Some(next) => guard = next,
                None => return false,
            }
        }
        true
    }

    /// The macros that `name`, with namespaces, calls in these scopes.
    pub(super) fn macros(&self, name: &str, scopes: &[TextScopeId]) -> Vec<TextDefinitionId> {
        let (path, last) = name.rsplit_once('.').unwrap_or(("", name));
        self.called(self.named(Class::Macro, &last.into()), path, scopes)
    }

    /// The ones of some macros that a call in these scopes reaches, with `path` in front of their name.
    fn called(
        &self,
        named: &[TextDefinitionId],
        path: &str,
        scopes: &[TextScopeId],
    ) -> Vec<TextDefinitionId> {
        let wanted: Vec<EcoString> = scopes
            .iter()
            .map(|&scope| joined(&self.namespace(scope), path))
            .collect();
        let is_it = |id: &&TextDefinitionId| {
            let given = self.given.get(**id);
            given.is_some_and(|given| {
                given
                    .scopes
                    .iter()
                    .any(|&own| wanted.contains(&self.namespace(own)))
            })
        };
        let found: Vec<TextDefinitionId> = named.iter().filter(is_it).copied().collect();
        // a body may be called from a namespace that its text knows nothing of
        if found.is_empty() && path.is_empty() {
            named.to_vec()
        } else {
            found
        }
    }

    /// The ones of some definitions that `ns.name` means: those of the include into `ns`.
    fn members(&self, named: &[TextDefinitionId], used: &TextUse) -> Vec<TextDefinitionId> {
        let inner = used
            .scopes
            .iter()
            .map(|&scope| joined(&self.namespace(scope), &used.of));
        let paths: Vec<EcoString> = inner.chain([used.of.clone()]).collect();
        let in_it = |scope: &TextScopeId| {
            let scope = self.scopes.get(*scope);
            matches!(scope, Some(TextScope::Namespace(path, _)) if paths.contains(path))
        };
        let is_it = |id: &&TextDefinitionId| {
            self.given
                .get(**id)
                .is_some_and(|given| given.scopes.iter().any(in_it))
        };
        named.iter().filter(is_it).copied().collect()
    }

    /// The namespaces around a scope, joined by dots; of a macro those that it is defined in.
    pub(super) fn namespace(&self, scope: TextScopeId) -> EcoString {
        let mut scope = Some(scope);
        for _ in 0..MOST_STEPS {
            match scope.and_then(|scope| self.scopes.get(scope)) {
                Some(TextScope::Namespace(path, _)) => return path.clone(),
                Some(TextScope::Body(of) | TextScope::Callers(of)) => {
                    scope = self
                        .given
                        .get(*of)
                        .and_then(|given| given.scopes.first().copied());
                }
                Some(TextScope::Top) | None => break,
            }
        }
        EcoString::new()
    }

    /// All texts of the names that belong together with those at some places: definitions that one use may mean, and
    /// the uses that may mean them. Whoever renames one has to rename all.
    pub fn together(&self, places: &[Span]) -> Vec<NameText> {
        let names = self.names_at(places);
        let mut groups = Groups::default();
        for (id, given) in self.given.iter_ids() {
            if names.contains(&given.name) {
                groups.join(given.span, id);
            }
        }
        for used in self.used.iter().filter(|used| names.contains(&used.name)) {
            for id in self.candidates(used, None) {
                groups.join(used.span, id);
            }
        }
        let wanted: FastSet<TextDefinitionId> = places
            .iter()
            .filter_map(|place| groups.of_place(*place))
            .collect();
        let mut found = Vec::new();
        for given in self
            .given
            .iter()
            .filter(|given| names.contains(&given.name))
        {
            if groups.has(&wanted, given.span) {
                found.push(NameText {
                    span: given.span,
                    is_definition: true,
                    is_end: false,
                });
            }
        }
        for used in self.used.iter().filter(|used| names.contains(&used.name)) {
            if groups.has(&wanted, used.span) && !found.iter().any(|known| known.span == used.span)
            {
                found.push(NameText {
                    span: used.span,
                    is_definition: false,
                    is_end: used.is_end,
                });
            }
        }
        found
    }

    /// Where a name would mean something else if those at some places were called `new`.
    pub fn clash(&self, places: &[Span], new: &str) -> Option<Span> {
        let new: EcoString = new.into();
        let group: Vec<TextDefinitionId> = self
            .given
            .iter_ids()
            .filter(|(_, given)| places.contains(&given.span))
            .map(|(id, _)| id)
            .collect();
        let class = Class::of(self.given.get(*group.first()?)?.kind);
        let others = self.named(class, &new);
        let both: Vec<TextDefinitionId> = group.iter().chain(others).copied().collect();
        let of_class = self.used.iter().filter(|used| used.class == class);
        let mut asked = of_class.filter(|used| places.contains(&used.span) || used.name == new);
        let other = asked.find(|used| {
            let meant = self.among(&both, used, None);
            if places.contains(&used.span) {
                meant.iter().any(|id| others.contains(id))
            } else {
                meant.iter().any(|id| group.contains(id))
            }
        });
        other.map(|used| used.span)
    }

    fn names_at(&self, places: &[Span]) -> FastSet<EcoString> {
        let given = self
            .given
            .iter()
            .filter(|given| places.contains(&given.span))
            .map(|given| given.name.clone());
        let used = self
            .used
            .iter()
            .filter(|used| places.contains(&used.span))
            .map(|used| used.name.clone());
        given.chain(used).collect()
    }
}

const MOST_STEPS: usize = 32;
/// Calls that are followed back from one use.
const MOST_CALLS: u32 = 200;

fn joined(outer: &str, inner: &str) -> EcoString {
    match (outer, inner) {
        ("", path) | (path, "") => path.into(),
        (outer, inner) => ecow::eco_format!("{outer}.{inner}"),
    }
}

/// Definitions that belong together, joined by the places that mean them.
#[derive(Default)]
struct Groups {
    parents: FastMap<TextDefinitionId, TextDefinitionId>,
    places: FastMap<Span, TextDefinitionId>,
}

impl Groups {
    fn root(&self, mut id: TextDefinitionId) -> TextDefinitionId {
        while let Some(&parent) = self.parents.get(&id) {
            id = parent;
        }
        id
    }

    fn join(&mut self, place: Span, id: TextDefinitionId) {
        let id = self.root(id);
        let known = self.places.insert(place, id).map(|known| self.root(known));
        if let Some(known) = known.filter(|known| *known != id) {
            self.parents.insert(known, id);
        }
    }

    fn of_place(&self, place: Span) -> Option<TextDefinitionId> {
        self.places.get(&place).map(|&id| self.root(id))
    }

    /// Whether a place is in one of some groups.
    fn has(&self, groups: &FastSet<TextDefinitionId>, place: Span) -> bool {
        self.of_place(place)
            .is_some_and(|group| groups.contains(&group))
    }
}

//! When macros are called, and which of several definitions of one count then.

use std::collections::BTreeSet;

use super::{
    Class, EvaluationPoint, TextDefinition, TextDefinitionId, TextNames, TextScope, TextScopeId,
    TextUse,
};
use base::{FastMap, FastSet};
use expand::UseKind;

/// Calls inside of calls that are followed back.
const MOST_CALLS: u32 = 8;
/// Calls that are followed back from one use.
const MOST_STEPS: u32 = 200;
/// The first time and the last of what is never evaluated.
const NEVER: (u32, u32) = (u32::MAX, 0);

fn wider(one: (u32, u32), other: (u32, u32)) -> (u32, u32) {
    (one.0.min(other.0), one.1.max(other.1))
}

impl TextNames {
    /// Of macros with one name, those that count when a use is evaluated: the last one that is sure to be defined then,
    /// and those behind it.
    pub(super) fn at_that_time(
        &self,
        used: &TextUse,
        found: BTreeSet<TextDefinitionId>,
    ) -> BTreeSet<TextDefinitionId> {
        if found.len() < 2 {
            return found;
        }
        if let Some(own) = self.defined_on_the_way(used, &found, &mut { MOST_STEPS }) {
            return own;
        }
        let given = |id: &TextDefinitionId| self.given.get(*id);
        let (first, last) = self.time(used.order, &used.scopes);
        let sure = found.iter().filter(|id| self.is_before(**id, first));
        let at = EvaluationPoint {
            order: first,
            ..used.seen()
        };
        let sure = sure.filter(|id| given(id).is_some_and(|given| self.is_sure(given, at)));
        let Some(since) = sure.filter_map(|id| Some(given(id)?.order)).max() else {
            return found;
        };
        found
            .into_iter()
            .filter(|&id| self.is_before(id, last) && !self.is_before(id, since))
            .collect()
    }

    fn is_before(&self, id: TextDefinitionId, time: u32) -> bool {
        self.given.get(id).is_some_and(|given| given.order < time)
    }

    /// When the value that a use stands in is evaluated at the latest: when the property is last used, as far as that happens in
    /// the scope of the property.
    pub(super) fn last_use(&self, used: &TextUse) -> u32 {
        let property = used.lazy_in.and_then(|id| self.given.get(id));
        let Some(property) = property else {
            return u32::MAX;
        };
        let same = self.used.iter().filter(|other| {
            other.class == Class::Value
                && other.name == property.name
                && other.order > property.order
        });
        let last = same.filter_map(|other| {
            let is_here = other.lazy_in.is_none()
                && other.kind != UseKind::Given
                && other.scopes == property.scopes;
            let means_it = |given: &&TextDefinition| given.span == property.span;
            if is_here {
                self.meaning(other)
                    .all()
                    .iter()
                    .any(means_it)
                    .then_some(other.order)
            } else {
                Some(u32::MAX)
            }
        });
        last.max().unwrap_or(u32::MAX)
    }

    /// Of definitions with one name that the body around a use does not make: those that its callers would mean in its place. None
    /// where a caller is not known.
    pub(super) fn at_each_call(
        &self,
        used: &TextUse,
        found: &BTreeSet<TextDefinitionId>,
        left: &mut u32,
    ) -> Option<BTreeSet<TextDefinitionId>> {
        if found.len() < 2 {
            return None;
        }
        let mut counting = BTreeSet::new();
        for &scope in &used.scopes {
            let calls = self.calls_of.get(&self.macro_of(scope)?)?;
            for call in calls.iter().filter_map(|&id| self.used.get(id)) {
                *left = left.checked_sub(1)?;
                // a macro of a namespace sees that, and not who calls it
                if !call.of.is_empty() {
                    return None;
                }
                let there = TextUse {
                    kind: used.kind,
                    class: used.class,
                    name: used.name.clone(),
                    ..call.clone()
                };
                let seen = self.candidates(&there, Some(there.order));
                let meant = self.latest(&there, seen, left);
                counting.extend(meant.intersection(found));
            }
        }
        (!counting.is_empty()).then_some(counting)
    }

    /// Of definitions with one name, those that count while the macro around a use is called. What stands outside of macros is evaluated in
    /// the order of its text: what follows the last call comes too late, and the last one that is sure in front of the first call
    /// hides those in front of it.
    pub(super) fn at_the_calls(
        &self,
        used: &TextUse,
        found: BTreeSet<TextDefinitionId>,
    ) -> BTreeSet<TextDefinitionId> {
        let is_in_macro = used.scopes.iter().all(|&scope| self.is_called(scope));
        if found.len() < 2 || !is_in_macro {
            return found;
        }
        let (first, last) = self.time(used.order, &used.scopes);
        let at = EvaluationPoint {
            order: first,
            ..used.seen()
        };
        let given = |id: &TextDefinitionId| self.given.get(*id);
        let outside: Vec<&TextDefinition> = found
            .iter()
            .filter_map(given)
            .filter(|given| !given.is_in_body && !given.handed_out)
            .collect();
        let counts = |given: &TextDefinition| {
            let is_outside = outside.iter().any(|other| other.span == given.span);
            !is_outside || given.order < last && !self.is_hidden(given, &outside, at)
        };
        let counting = |id: &TextDefinitionId| given(id).is_some_and(counts);
        found.iter().copied().filter(counting).collect()
    }

    /// Whether a later one of some definitions in the same scope is sure to count instead.
    fn is_hidden(
        &self,
        given: &TextDefinition,
        all: &[&TextDefinition],
        at: EvaluationPoint,
    ) -> bool {
        let later = given.order + 1..at.order;
        let mut hiding = all
            .iter()
            .filter(|other| other.scopes == given.scopes && later.contains(&other.order));
        hiding.any(|other| self.is_sure(other, at))
    }

    /// Whether a scope is that of a macro with known calls.
    fn is_called(&self, scope: TextScopeId) -> bool {
        match self.scopes.get(scope) {
            Some(TextScope::Body(of) | TextScope::Callers(of)) => self.called_at.contains_key(of),
            _ => false,
        }
    }

    /// Of macros with one name, those that the body around a use, or the bodies that call it, define in front of it: from the last one
    /// that is sure on, with those that macros define which are called in between. None when no body on the way there is sure to define
    /// one.
    fn defined_on_the_way(
        &self,
        used: &TextUse,
        found: &BTreeSet<TextDefinitionId>,
        left: &mut u32,
    ) -> Option<BTreeSet<TextDefinitionId>> {
        let given = |id: &TextDefinitionId| self.given.get(*id);
        let own = found.iter().filter_map(given);
        let own = own.filter_map(|given| self.own_order(given, used));
        let since = own
            .filter(|(_, is_sure)| *is_sure)
            .map(|(order, _)| order)
            .max();
        let mut counting = match since {
            Some(_) => BTreeSet::new(),
            None => self.defined_by_callers(used, found, left)?,
        };
        let since = since.unwrap_or(0);
        let is_called = |scope: &TextScopeId| {
            self.macro_of(*scope).is_some_and(|of| {
                self.is_called_between((since, used), of, &mut FastSet::default())
            })
        };
        let counts = |given: &TextDefinition| match self.own_order(given, used) {
            Some((order, _)) => order >= since,
            None => given.scopes.iter().any(is_called),
        };
        counting.extend(
            found
                .iter()
                .copied()
                .filter(|id| given(id).is_some_and(counts)),
        );
        Some(counting)
    }

    /// When a macro that hands out a definition is last called in the scope of a use and in front of it, and whether the definition is
    /// sure to be made then.
    pub(super) fn handed_out_order(
        &self,
        given: &TextDefinition,
        used: &TextUse,
    ) -> Option<(u32, bool)> {
        let makers = given.scopes.iter().filter_map(|&own| self.macro_of(own));
        let calls = makers.filter_map(|of| Some((of, self.calls_of.get(&of)?)));
        let calls = calls.flat_map(|(of, calls)| calls.iter().map(move |&call| (of, call)));
        let calls = calls.filter_map(|(of, call)| Some((of, self.used.get(call)?)));
        let in_front =
            calls.filter(|(_, call)| call.scopes == used.scopes && call.order < used.order);
        let (of, call) = in_front.max_by_key(|(_, call)| call.order)?;
        let guard = self.given.get(of)?.guard;
        let is_sure = given.is_sure
            && given.guard == guard
            && call.span.file == used.span.file
            && self.is_within(used.guard, call.guard);
        Some((call.order, is_sure))
    }

    /// When the body around a use last defines something in front of it, itself or by an include, and whether it is sure to.
    fn own_order(&self, given: &TextDefinition, used: &TextUse) -> Option<(u32, bool)> {
        let included = self.included_order(given, used);
        if included.is_some_and(|(_, is_sure)| is_sure) {
            return included;
        }
        let is_own = given.is_in_body && given.scopes == used.scopes && given.order < used.order;
        if is_own {
            return Some((given.order, self.is_sure(given, used.seen())));
        }
        included
    }

    /// Whether the body around a use calls a macro in front of it, but behind a place, be it through others.
    fn is_called_between(
        &self,
        within: (u32, &TextUse),
        of: TextDefinitionId,
        seen: &mut FastSet<TextDefinitionId>,
    ) -> bool {
        let (since, used) = within;
        if !seen.insert(of) {
            return false;
        }
        let mut calls = self
            .calls_of
            .get(&of)
            .into_iter()
            .flatten()
            .filter_map(|&id| self.used.get(id));
        calls.any(|call| {
            let is_there = call.scopes == used.scopes && (since..used.order).contains(&call.order);
            let mut around = call.scopes.iter().filter_map(|&scope| self.macro_of(scope));
            is_there || around.any(|outer| self.is_called_between(within, outer, seen))
        })
    }

    /// The macro whose body a scope is.
    fn macro_of(&self, scope: TextScopeId) -> Option<TextDefinitionId> {
        match self.scopes.get(scope) {
            Some(TextScope::Body(of)) => Some(*of),
            _ => None,
        }
    }

    /// The same for what stands in the body of a macro: what counts where that is called. None when one call says nothing, or
    /// stands in no body.
    fn defined_by_callers(
        &self,
        used: &TextUse,
        found: &BTreeSet<TextDefinitionId>,
        left: &mut u32,
    ) -> Option<BTreeSet<TextDefinitionId>> {
        *left = left.checked_sub(1)?;
        let mut counting = BTreeSet::new();
        for &scope in &used.scopes {
            let calls = self.calls_of.get(&self.macro_of(scope)?)?;
            for call in calls.iter().filter_map(|&id| self.used.get(id)) {
                counting.extend(self.defined_on_the_way(call, found, left)?);
            }
        }
        Some(counting)
    }

    /// When something in these scopes is evaluated, the first time and the last, as places in the order of evaluation: what stands in
    /// a macro when that is called.
    fn time(&self, order: u32, scopes: &[TextScopeId]) -> (u32, u32) {
        let mut found = NEVER;
        for scope in scopes {
            let of = match self.scopes.get(*scope) {
                Some(TextScope::Body(of) | TextScope::Callers(of)) => Some(of),
                _ => None,
            };
            let time = of.map_or(Some((order, order)), |of| self.called_at.get(of).copied());
            found = wider(found, time.unwrap_or(NEVER));
        }
        if found == NEVER {
            (order, u32::MAX)
        } else {
            found
        }
    }

    /// Work out when macros are called, of which the calls are known.
    pub(super) fn set_times(&mut self) {
        let macros: Vec<TextDefinitionId> = self.calls_of.keys().copied().collect();
        // a call in a macro is made when that is called: what one round adds, the next hands on
        for _ in 0..MOST_CALLS {
            let mut found: FastMap<TextDefinitionId, (u32, u32)> = FastMap::default();
            for of in &macros {
                let own = self
                    .calls_of
                    .get(of)
                    .into_iter()
                    .flatten()
                    .filter_map(|id| self.used.get(*id));
                let times = own.map(|used| self.time(used.order, &used.scopes));
                found.insert(*of, times.fold(NEVER, wider));
            }
            if found == self.called_at {
                break;
            }
            self.called_at = found;
        }
    }
}

//! Files that are read more than once: what they mean at each time.

use std::collections::BTreeSet;

use super::{EvaluationPoint, Reading, TextDefinition, TextDefinitionId, TextNames, TextUse};
use base::FileId;

impl TextNames {
    /// Where a file is read that several conditions bring in.
    pub(super) fn several(&self, file: FileId) -> Option<&[Reading]> {
        let readings = self.readings.get(&file);
        readings
            .filter(|_| self.several.contains(&file))
            .map(Vec::as_slice)
    }

    /// Of definitions in the scope of a use whose file several conditions bring in, each with one in front of it: those.
    pub(super) fn at_each_reading(
        &self,
        used: &TextUse,
        all: &BTreeSet<TextDefinitionId>,
    ) -> Option<BTreeSet<TextDefinitionId>> {
        let given = |id: &TextDefinitionId| self.given.get(*id);
        let mut found = BTreeSet::new();
        for reading in self.several(used.span.file)? {
            let is_in_front = |id: &&TextDefinitionId| {
                let own = given(id);
                own.is_some_and(|own| own.span.file != used.span.file && own.order < reading.order)
            };
            let in_front: Vec<TextDefinitionId> = all.iter().filter(is_in_front).copied().collect();
            let is_sure = |id: &&TextDefinitionId| {
                given(id).is_some_and(|own| {
                    let at = EvaluationPoint {
                        file: own.span.file,
                        guard: reading.guard,
                        order: reading.order,
                    };
                    self.is_sure(own, at)
                })
            };
            let order = |id: &TextDefinitionId| given(id).map_or(0, |own| own.order);
            let since = in_front.iter().filter(is_sure).map(order).max()?;
            found.extend(in_front.into_iter().filter(|id| order(id) >= since));
        }
        let is_beside = |id: &&TextDefinitionId| {
            let own = given(id);
            own.is_some_and(|own| own.span.file == used.span.file && own.order < used.order)
        };
        found.extend(all.iter().filter(is_beside).copied());
        Some(found)
    }

    /// When the body around a use last includes the file of a definition in front of it, and whether that is sure to make it.
    pub(super) fn included_order(
        &self,
        given: &TextDefinition,
        used: &TextUse,
    ) -> Option<(u32, bool)> {
        let readings = self.readings.get(&given.span.file)?;
        let is_own = |reading: &&Reading| {
            used.scopes == [reading.scope]
                && given.scopes.contains(&reading.scope)
                && reading.order < used.order
        };
        let reading = readings.iter().rfind(is_own)?;
        // conditions in the file are those of the first time that it was read
        let first = readings.first()?;
        let is_sure = given.is_sure
            && first.guard == given.guard
            && given.span.file != used.span.file
            && self.is_within(used.guard, reading.guard);
        Some((reading.order, is_sure))
    }
}

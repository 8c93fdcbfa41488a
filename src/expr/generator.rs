//! Comprehensions and generator expressions.

use std::sync::Arc;

use ecow::EcoVec;

use super::ast::{CompKind, Comprehension, Expr, ExprKind};
use super::interp::{ClosureContext, Interp};
use super::iter::{Iter, IterKind, IterState};
use super::stop::{Eval, Stop};
use super::value::{Dict, DictMap, Key, List, Locals, Set, SetMap, Value};

/// A generator between two of its items.
#[derive(Debug)]
pub(crate) struct Generator {
    comprehension: Arc<Comprehension>,
    context: ClosureContext,
    /// One per `for` that is under way, outermost first.
    cursors: Vec<IterState>,
}

impl Interp<'_> {
    /// A comprehension; a generator only gets ready.
    pub(crate) fn comprehension(&mut self, comprehension: &Arc<Comprehension>) -> Eval {
        let Some(first) = comprehension.clauses.first() else {
            return Ok(Value::Unknown);
        };
        let source = self.eval(&first.iter)?;
        let cursor = self
            .iter(&source)
            .map_err(|stop| stop.at(self.place(first.iter.range)))?;
        // About the size of the variables and the result.
        self.budget.items(6)?;
        let frame = Arc::new(Locals::new(self.env.clone(), true, Vec::new()));
        if comprehension.kind == CompKind::Generator {
            let context = ClosureContext {
                env: Some(frame),
                ..self.context()
            };
            let comprehension = Arc::clone(comprehension);
            let generator = Generator {
                comprehension,
                context,
                cursors: vec![cursor],
            };
            let cursor = IterState::Generator(Box::new(generator));
            return Ok(Value::Iter(Iter::new(IterKind::Generator, cursor)));
        }
        let outer = self.env.replace(frame);
        let result = self.gather(comprehension, vec![cursor]);
        self.env = outer;
        result
    }

    fn gather(&mut self, comprehension: &Comprehension, mut cursors: Vec<IterState>) -> Eval {
        let mut list = EcoVec::new();
        let mut set = SetMap::default();
        let mut dict = DictMap::default();
        while self.advance(comprehension, &mut cursors)? {
            self.budget.items(1)?;
            let element = self.eval(&comprehension.element)?;
            match (comprehension.kind, &comprehension.value) {
                (CompKind::Dict, Some(value)) => {
                    let value = self.eval(value)?;
                    dict.insert(Key::new(element)?, value);
                }
                (CompKind::Set, _) => {
                    set.insert(Key::new(element)?);
                }
                _ => list.push(element),
            }
        }
        Ok(match comprehension.kind {
            CompKind::Set => Value::Set(Set::new(set, false)),
            CompKind::Dict => Value::Dict(Dict::new(dict, false)),
            CompKind::List | CompKind::Generator => Value::List(List::new(list, false)),
        })
    }

    /// Bind the variables for the next element; false when there is none.
    fn advance(
        &mut self,
        comprehension: &Comprehension,
        cursors: &mut Vec<IterState>,
    ) -> Eval<bool> {
        while let Some(cursor) = cursors.last_mut() {
            let Some(item) = self.next(cursor)? else {
                cursors.pop();
                continue;
            };
            let depth = cursors.len();
            let Some(clause) = comprehension.clauses.get(depth - 1) else {
                return Ok(false);
            };
            self.assign(&clause.target, item)
                .map_err(|stop| stop.at(self.place(clause.target.range)))?;
            if !self.all_hold(&clause.conditions)? {
                continue;
            }
            let Some(inner) = comprehension.clauses.get(depth) else {
                return Ok(true);
            };
            let source = self.eval(&inner.iter)?;
            let cursor = self
                .iter(&source)
                .map_err(|stop| stop.at(self.place(inner.iter.range)))?;
            cursors.push(cursor);
        }
        Ok(false)
    }

    fn all_hold(&mut self, conditions: &[Expr]) -> Eval<bool> {
        for condition in conditions {
            let value = self.eval(condition)?;
            if !self.truth(&value)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    pub(super) fn next_generated(&mut self, generator: &mut Generator) -> Eval<Option<Value>> {
        let Generator {
            comprehension,
            context,
            cursors,
        } = generator;
        self.inside(context.clone(), |interp| {
            if interp.advance(comprehension, cursors)? {
                interp.eval(&comprehension.element).map(Some)
            } else {
                Ok(None)
            }
        })
    }

    /// Bind the target of a `for`, spreading tuples.
    fn assign(&mut self, target: &Expr, value: Value) -> Eval<()> {
        let targets = match &target.kind {
            ExprKind::Name(name) => {
                if let Some(frame) = &self.env {
                    frame.set(name, value);
                }
                return Ok(());
            }
            ExprKind::Tuple(targets) | ExprKind::List(targets) => targets,
            ExprKind::Starred(inner) => return self.assign(inner, value),
            _ => return Ok(()),
        };
        let star = targets
            .iter()
            .position(|target| matches!(target.kind, ExprKind::Starred(_)));
        let items = self.unpacked(&value, targets.len(), star)?;
        let mut items = items.into_iter();
        let spare = items.len().saturating_sub(targets.len() - 1);
        for (i, target) in targets.iter().enumerate() {
            let item = if star == Some(i) {
                Value::list(items.by_ref().take(spare).collect::<Vec<_>>())
            } else {
                items.next().unwrap_or_default()
            };
            self.assign(target, item)?;
        }
        Ok(())
    }

    /// As many items as `count` targets need; `star` is the place of a starred one.
    fn unpacked(&mut self, value: &Value, count: usize, star: Option<usize>) -> Eval<Vec<Value>> {
        let mut cursor = self.iter(value).map_err(|stop| match stop {
            Stop::Unknown => Stop::Unknown,
            _ => Stop::typ(format!(
                "cannot unpack non-iterable {} object",
                value.type_name()
            )),
        })?;
        let mut items = Vec::new();
        while let Some(item) = self.next(&mut cursor)? {
            if star.is_none() && items.len() == count {
                return Err(Stop::value(format!(
                    "too many values to unpack (expected {count})"
                )));
            }
            self.budget.items(1)?;
            items.push(item);
        }
        let (needed, at_least) = if star.is_some() {
            (count - 1, "at least ")
        } else {
            (count, "")
        };
        if items.len() < needed {
            let got = items.len();
            return Err(Stop::value(format!(
                "not enough values to unpack (expected {at_least}{needed}, got {got})"
            )));
        }
        Ok(items)
    }
}

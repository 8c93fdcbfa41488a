//! Iterators.

use std::sync::{Arc, Mutex, PoisonError};

use ecow::EcoVec;

use super::generator::Generator;
use super::host::ErrorKind;
use super::interp::Interp;
use super::ops;
use super::stop::{Eval, Stop};
use super::value::{Dict, List, Str, Value, ViewKind};

/// What kind of iterator a program sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum IterKind {
    Map,
    Filter,
    Zip,
    Enumerate,
    Reversed,
    Generator,
    /// The iterator type of a container.
    Other(&'static str),
}

/// A Python iterator.
#[derive(Clone, Debug)]
pub struct Iter(Arc<IterObject>);

#[derive(Debug)]
struct IterObject {
    kind: IterKind,
    /// Taken out while the iterator runs.
    cursor: Mutex<Option<IterState>>,
}

impl Drop for IterObject {
    fn drop(&mut self) {
        super::value::drop_iteratively(self.take());
    }
}

impl IterObject {
    fn take(&self) -> Option<IterState> {
        self.cursor
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take()
    }
}

impl Iter {
    pub(crate) fn new(kind: IterKind, cursor: IterState) -> Self {
        Self(Arc::new(IterObject {
            kind,
            cursor: Mutex::new(Some(cursor)),
        }))
    }

    pub(crate) fn kind(&self) -> IterKind {
        self.0.kind
    }

    pub(crate) fn address(&self) -> usize {
        Arc::as_ptr(&self.0) as usize
    }
}

/// A place in something that is iterated.
#[derive(Debug)]
pub(crate) enum IterState {
    /// Items that cannot change any more.
    Items(EcoVec<Value>, usize),
    /// A list, which may grow or shrink meanwhile.
    List(List, usize),
    /// A list backwards; so many items are left.
    ListBack(List, usize),
    /// Characters from a byte offset on.
    Chars(Str, usize),
    Bytes(EcoVec<u8>, usize),
    Range {
        next: i128,
        step: i128,
        left: u128,
    },
    /// A dict that must not change its size.
    Entries {
        dict: Dict,
        kind: ViewKind,
        index: usize,
        len: usize,
    },
    Map {
        function: Value,
        sources: Vec<IterState>,
    },
    Filter {
        function: Value,
        source: Box<IterState>,
    },
    Zip {
        sources: Vec<IterState>,
        strict: bool,
    },
    Enumerate {
        count: Value,
        source: Box<IterState>,
    },
    Generator(Box<Generator>),
    Shared(Iter),
    Done,
}

impl Interp<'_> {
    /// Python's `iter()`.
    pub(crate) fn iter(&mut self, value: &Value) -> Eval<IterState> {
        Ok(match value {
            Value::Unknown => return Err(Stop::Unknown),
            Value::Scope(_) | Value::Module(_) => entries(&self.entries(value)?, ViewKind::Keys),
            Value::List(list) => IterState::List(list.clone(), 0),
            Value::Tuple(tuple) => IterState::Items(tuple.snapshot(), 0),
            Value::Str(text) => IterState::Chars(text.clone(), 0),
            Value::Bytes(bytes) => IterState::Bytes(bytes.clone(), 0),
            Value::Range(range) => IterState::Range {
                next: range.start,
                step: range.step,
                left: range.len(),
            },
            Value::Dict(dict) => entries(dict, ViewKind::Keys),
            Value::View(view) => entries(&view.dict, view.kind),
            Value::Set(set) => IterState::Items(set.ordered().into_iter().collect(), 0),
            Value::Iter(iter) => IterState::Shared(iter.clone()),
            other => {
                return Err(Stop::typ(format!(
                    "'{}' object is not iterable",
                    other.type_name()
                )));
            }
        })
    }

    /// The next item, if there is one.
    pub(crate) fn next(&mut self, cursor: &mut IterState) -> Eval<Option<Value>> {
        self.budget.step()?;
        let item = match cursor {
            IterState::Items(items, at) => advance(at, |i| items.get(i).cloned()),
            IterState::List(list, at) => advance(at, |i| list.get(i)),
            IterState::ListBack(list, left) => {
                *left = (*left).saturating_sub(1).min(list.len());
                let item = list.snapshot().get(*left).cloned();
                if *left == 0 {
                    *cursor = IterState::Done;
                }
                item
            }
            IterState::Chars(text, at) => {
                let c = text.get(*at..).and_then(|rest| rest.chars().next());
                *at += c.map_or(0, char::len_utf8);
                c.map(|c| Value::Str(c.into()))
            }
            IterState::Bytes(bytes, at) => {
                advance(at, |i| bytes.get(i).map(|&b| Value::Int(i64::from(b))))
            }
            IterState::Range { next, step, left } => {
                if *left == 0 {
                    return Ok(None);
                }
                let item = *next;
                *left -= 1;
                *next = next.saturating_add(*step);
                Some(Value::wide(item))
            }
            IterState::Entries {
                dict,
                kind,
                index,
                len,
            } => {
                if dict.len() != *len {
                    let message = "dictionary changed size during iteration";
                    return Err(Stop::new(ErrorKind::Runtime, message));
                }
                advance(index, |i| entry(dict, *kind, i))
            }
            IterState::Done => None,
            other => return self.next_nested(other),
        };
        Ok(item)
    }

    /// Iterators over other iterators.
    fn next_nested(&mut self, cursor: &mut IterState) -> Eval<Option<Value>> {
        self.down()?;
        let result = match cursor {
            IterState::Map { function, sources } => self.next_map(function, sources),
            IterState::Filter { function, source } => self.next_filtered(function, source),
            IterState::Zip { sources, strict } => self.next_zipped(sources, *strict),
            IterState::Enumerate { count, source } => self.next_counted(count, source),
            IterState::Shared(iter) => self.next_shared(iter),
            IterState::Generator(generator) => self.next_generated(generator),
            _ => Ok(None),
        };
        self.up();
        if !matches!(result, Ok(Some(_)))
            && !matches!(cursor, IterState::Shared(_) | IterState::Map { .. })
        {
            *cursor = IterState::Done;
        }
        result
    }

    fn next_map(&mut self, function: &Value, sources: &mut [IterState]) -> Eval<Option<Value>> {
        let mut args = Vec::with_capacity(sources.len());
        for source in sources {
            match self.next(source)? {
                Some(item) => args.push(item),
                None => return Ok(None),
            }
        }
        self.apply(function, args).map(Some)
    }

    fn next_filtered(&mut self, function: &Value, source: &mut IterState) -> Eval<Option<Value>> {
        while let Some(item) = self.next(source)? {
            let keep = match function {
                Value::None => self.truth(&item)?,
                function => {
                    let answer = self.apply(function, vec![item.clone()])?;
                    self.truth(&answer)?
                }
            };
            if keep {
                return Ok(Some(item));
            }
        }
        Ok(None)
    }

    fn next_zipped(&mut self, sources: &mut [IterState], strict: bool) -> Eval<Option<Value>> {
        let mut items = EcoVec::with_capacity(sources.len());
        let count = sources.len();
        for (i, source) in sources.iter_mut().enumerate() {
            match self.next(source)? {
                Some(_) if strict && i > 0 && items.is_empty() => return Err(uneven(i, "longer")),
                Some(item) => items.push(item),
                None if strict && !items.is_empty() => return Err(uneven(i, "shorter")),
                None if strict && i + 1 < count => {}
                None => return Ok(None),
            }
        }
        Ok((!items.is_empty()).then(|| Value::Tuple(super::value::Tuple::new(items))))
    }

    fn next_counted(&mut self, count: &mut Value, source: &mut IterState) -> Eval<Option<Value>> {
        let Some(item) = self.next(source)? else {
            return Ok(None);
        };
        let next = ops::binary(self, super::ast::BinOp::Add, count, &Value::Int(1))?;
        let index = std::mem::replace(count, next);
        Ok(Some(Value::tuple_from([index, item])))
    }

    fn next_shared(&mut self, iter: &Iter) -> Eval<Option<Value>> {
        let Some(mut cursor) = iter.0.take() else {
            return Err(Stop::value("generator already executing"));
        };
        let result = self.next(&mut cursor);
        *iter.0.cursor.lock().unwrap_or_else(PoisonError::into_inner) = Some(cursor);
        result
    }

    /// All items of something that can be iterated.
    pub(crate) fn collect(&mut self, value: &Value) -> Eval<EcoVec<Value>> {
        match value {
            Value::Tuple(tuple) => return Ok(tuple.snapshot()),
            Value::List(list) => {
                self.budget.steps(list.len() as u64)?;
                return Ok(list.items());
            }
            Value::Range(range) => self.budget.clone().items(range.len())?,
            _ => {}
        }
        let mut cursor = self.iter(value)?;
        let mut items = EcoVec::new();
        while let Some(item) = self.next(&mut cursor)? {
            self.budget.items(1)?;
            items.push(item);
        }
        Ok(items)
    }
}

fn advance<T>(at: &mut usize, get: impl FnOnce(usize) -> Option<T>) -> Option<T> {
    let item = get(*at)?;
    *at += 1;
    Some(item)
}

fn uneven(i: usize, how: &str) -> Stop {
    let others = if i == 1 {
        "argument 1".to_owned()
    } else {
        format!("arguments 1-{i}")
    };
    Stop::value(format!("zip() argument {} is {how} than {others}", i + 1))
}

fn entries(dict: &Dict, kind: ViewKind) -> IterState {
    IterState::Entries {
        dict: dict.clone(),
        kind,
        index: 0,
        len: dict.len(),
    }
}

fn entry(dict: &Dict, kind: ViewKind, index: usize) -> Option<Value> {
    let map = dict.snapshot();
    let (key, value) = map.get_index(index)?;
    Some(match kind {
        ViewKind::Keys => key.value().clone(),
        ViewKind::Values => value.clone(),
        ViewKind::Items => Value::tuple_from([key.value().clone(), value.clone()]),
    })
}

//! Letting go of deeply nested values without recursing as deep as they are.

use std::cell::RefCell;

use super::Value;

/// How many containers may be dropped inside each other before the rest is put aside.
const MAX_NESTED_DROPS: u32 = 32;

#[derive(Default)]
struct Yard {
    depth: u32,
    waiting: Vec<Grave>,
}

/// The contents of a container that is being dropped.
type Grave = Box<dyn std::any::Any>;

thread_local! {
    static YARD: RefCell<Yard> = RefCell::default();
}

/// Drop `contents`, which may hold other containers, with bounded recursion.
///
/// Called from the `drop` of every container. Beyond a certain nesting the contents only join a
/// queue that the outermost drop works off.
pub(crate) fn bury<T: 'static>(contents: T) {
    let deep = YARD.try_with(|yard| {
        let mut yard = yard.borrow_mut();
        yard.depth += 1;
        yard.depth > MAX_NESTED_DROPS
    });
    match deep {
        Ok(true) => put_aside(Box::new(contents)),
        _ => drop(contents),
    }
    let outermost = YARD.try_with(|yard| {
        let mut yard = yard.borrow_mut();
        yard.depth -= 1;
        yard.depth == 0 && !yard.waiting.is_empty()
    });
    if outermost == Ok(true) {
        work_off();
    }
}

fn put_aside(grave: Grave) {
    let mut grave = Some(grave);
    let stored = YARD.try_with(|yard| {
        if let Some(grave) = grave.take() {
            yard.borrow_mut().waiting.push(grave);
        }
    });
    // Without a yard (the thread is ending) the contents are dropped right here.
    if stored.is_err() {
        drop(grave);
    }
}

fn work_off() {
    let next = || YARD.try_with(|yard| yard.borrow_mut().waiting.pop()).ok().flatten();
    while let Some(grave) = next() {
        // Counts as nested, so that drops inside it queue up here instead of starting another loop.
        let _ = YARD.try_with(|yard| yard.borrow_mut().depth += 1);
        drop(grave);
        let _ = YARD.try_with(|yard| yard.borrow_mut().depth -= 1);
    }
}

/// Whether dropping `value` may drop further containers.
pub(super) fn is_nested(value: &Value) -> bool {
    !matches!(
        value,
        Value::Unknown
            | Value::None
            | Value::Ellipsis
            | Value::Bool(_)
            | Value::Int(_)
            | Value::Big(_)
            | Value::Float(_)
            | Value::Complex(..)
            | Value::Str(_)
            | Value::Bytes(_)
            | Value::Range(_)
            | Value::Type(_)
            | Value::Builtin(_)
            | Value::Date(_)
            | Value::Scope(_)
            | Value::Module(_)
    )
}

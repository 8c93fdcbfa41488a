//! Letting go of deeply nested values without recursing as deep as they are.

use std::cell::RefCell;

use super::Value;

/// How many containers may be dropped inside each other before the rest is put aside.
const MAX_NESTED_DROPS: u32 = 32;

#[derive(Default)]
struct DropQueue {
    depth: u32,
    waiting: Vec<Contents>,
}

/// The contents of a container that is being dropped.
type Contents = Box<dyn std::any::Any>;

thread_local! {
    static QUEUE: RefCell<DropQueue> = RefCell::default();
}

/// Drop `contents`, which may hold other containers, with bounded recursion.
///
/// Called from the `drop` of every container. Beyond a certain nesting the contents only join a
/// queue that the outermost drop works off.
pub(crate) fn drop_iteratively<T: 'static>(contents: T) {
    let deep = QUEUE.try_with(|queue| {
        let mut queue = queue.borrow_mut();
        queue.depth += 1;
        queue.depth > MAX_NESTED_DROPS
    });
    match deep {
        Ok(true) => put_aside(Box::new(contents)),
        _ => drop(contents),
    }
    let outermost = QUEUE.try_with(|queue| {
        let mut queue = queue.borrow_mut();
        queue.depth -= 1;
        queue.depth == 0 && !queue.waiting.is_empty()
    });
    if outermost == Ok(true) {
        work_off();
    }
}

fn put_aside(contents: Contents) {
    let mut contents = Some(contents);
    let stored = QUEUE.try_with(|queue| {
        if let Some(contents) = contents.take() {
            queue.borrow_mut().waiting.push(contents);
        }
    });
    // Without a queue (the thread is ending) the contents are dropped right here.
    if stored.is_err() {
        drop(contents);
    }
}

fn work_off() {
    while let Ok(Some(contents)) = QUEUE.try_with(|queue| queue.borrow_mut().waiting.pop()) {
        // Counts as nested, so that drops inside it queue up here instead of starting another loop.
        let _ = QUEUE.try_with(|queue| queue.borrow_mut().depth += 1);
        drop(contents);
        let _ = QUEUE.try_with(|queue| queue.borrow_mut().depth -= 1);
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

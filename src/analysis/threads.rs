//! Threads on which several robots are expanded at once.
use std::sync::OnceLock;

use expand::{LARGE_STACK, on_large_thread};
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Do the same with each item, on all processors where there are several items; the results in the order of the items.
pub(super) fn map_all<T: Send, R: Send>(items: Vec<T>, run: impl Fn(T) -> R + Sync) -> Vec<R> {
    if items.len() < 2 {
        return items.into_iter().map(run).collect();
    }
    let all = || items.into_par_iter().map(&run).collect();
    match large_stacks() {
        Some(pool) => pool.install(all),
        None => all(),
    }
}

/// Threads with large stacks, as many as there are processors; none where the system gives none. They are started once: a
/// server would start them at each edit.
fn large_stacks() -> Option<&'static ThreadPool> {
    static POOL: OnceLock<Option<ThreadPool>> = OnceLock::new();
    let start = || {
        let pool = ThreadPoolBuilder::new().stack_size(LARGE_STACK);
        pool.start_handler(|_| on_large_thread()).build().ok()
    };
    POOL.get_or_init(start).as_ref()
}

//! Threads on which several robots are expanded at once.
use expand::{LARGE_STACK, on_large_thread};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Threads with large stacks, as many as there are processors; none where the system gives none.
pub(super) fn large_stacks() -> Option<ThreadPool> {
    let pool = ThreadPoolBuilder::new().stack_size(LARGE_STACK);
    pool.start_handler(|_| on_large_thread()).build().ok()
}

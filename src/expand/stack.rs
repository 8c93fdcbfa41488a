//! Threads whose stack fits the deepest nesting the limits admit.

use std::cell::Cell;
use std::io;
use std::sync::{Arc, Mutex, PoisonError};

/// Bytes of such a stack; what is not touched is never taken.
const SIZE: usize = 512 << 20;

thread_local! {
    static IS_LARGE: Cell<bool> = const { Cell::new(false) };
}

/// Run something on a thread with a large stack: this one, where it is one, else a new one; here all the same
/// where the system gives none.
pub(super) fn on_large_stack<T: Send>(work: impl Fn() -> T + Sync) -> T {
    if IS_LARGE.get() {
        return work();
    }
    std::thread::scope(|scope| {
        let run = || {
            IS_LARGE.set(true);
            work()
        };
        let thread = std::thread::Builder::new().name("expand".into()).stack_size(SIZE);
        match thread.spawn_scoped(scope, run) {
            Ok(thread) => thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            Err(_) => work(),
        }
    })
}

/// Start a thread that expansions need not leave; an ordinary one where the system gives no large stack.
///
/// # Errors
/// When the system starts no thread at all.
pub fn spawn_on_large_stack(name: &str, work: impl FnOnce() + Send + 'static) -> io::Result<()> {
    let work = Arc::new(Mutex::new(Some(work)));
    let start = |size: Option<usize>| {
        let work = work.clone();
        let builder = std::thread::Builder::new().name(name.to_owned());
        let builder = size.into_iter().fold(builder, std::thread::Builder::stack_size);
        let run = move || {
            IS_LARGE.set(size.is_some());
            let work = work.lock().unwrap_or_else(PoisonError::into_inner).take();
            work.into_iter().for_each(|work| work());
        };
        builder.spawn(run).map(drop)
    };
    start(Some(SIZE)).or_else(|_| start(None))
}

/// Threads with large stacks, as many as there are processors; none where the system gives none.
pub fn large_stacks() -> Option<rayon::ThreadPool> {
    let pool = rayon::ThreadPoolBuilder::new().stack_size(SIZE);
    pool.start_handler(|_| IS_LARGE.set(true)).build().ok()
}

#[cfg(test)]
mod tests {
    use super::{IS_LARGE, large_stacks, on_large_stack, spawn_on_large_stack};

    #[test]
    fn one_thread_is_enough() {
        let within = || on_large_stack(|| std::thread::current().id());
        let (outer, inner) = on_large_stack(|| (std::thread::current().id(), within()));
        assert_eq!(outer, inner);
        assert_ne!(outer, std::thread::current().id());
        assert!(!IS_LARGE.get());
        let (tell, told) = std::sync::mpsc::channel();
        spawn_on_large_stack("test", move || tell.send(IS_LARGE.get()).unwrap()).unwrap();
        assert!(told.recv().unwrap());
        let pool = large_stacks().unwrap();
        assert!(pool.install(|| IS_LARGE.get()));
    }
}

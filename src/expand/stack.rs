//! Stacks that fit the deepest nesting the limits admit.
//!
//! The first thread of a program goes as far as its own stack is good for and leaves for a larger one only there:
//! for most robots no thread is started. Of other threads nothing is known, and expansions leave them at once.
use std::cell::Cell;
use std::io;
use std::sync::{Arc, Mutex, PoisonError};

/// Bytes of a large stack; what is not touched is never taken.
pub const LARGE_STACK: usize = 512 << 20;
/// Bytes that nested elements may take of the first thread's stack; an expression takes two megabytes more at most.
const SHARE: usize = 1 << 20;
/// A first thread with fewer bytes of stack is left at once; this is what systems give.
const USUAL: usize = 8 << 20;

thread_local! {
    /// The address that nested elements of this thread must not come below; stacks grow downwards.
    static FLOOR: Cell<usize> = const { Cell::new(usize::MAX) };
}

/// Say that this is the first thread of a program, whose stack may grow to so many bytes.
pub fn on_first_thread(stack: usize) {
    if stack >= USUAL {
        FLOOR.set(here().saturating_sub(SHARE));
    }
}

/// Whether this thread has too little of its stack left for nested elements.
pub(super) fn is_short() -> bool {
    here() < FLOOR.get()
}

/// About where the stack of this thread has come to.
fn here() -> usize {
    let local = 0u8;
    std::ptr::from_ref(std::hint::black_box(&local)).addr()
}

/// Run something here where the stack is good for it, else on a new thread with a large one; here all the same where
/// the system gives none.
pub(super) fn with_stack<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    if is_short() {
        on_large_stack(work)
    } else {
        work()
    }
}

#[cold]
fn on_large_stack<T: Send, W: FnOnce() -> T + Send>(work: W) -> T {
    let mut work = Some(work);
    let given = &mut work;
    let done = std::thread::scope(move |scope| {
        let run = move || {
            FLOOR.set(0);
            given.take().map(|work| work())
        };
        let thread = std::thread::Builder::new()
            .name("expand".into())
            .stack_size(LARGE_STACK);
        let thread = thread.spawn_scoped(scope, run).ok()?;
        thread
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    });
    done.or_else(|| {
        // no thread: go on here, and do not ask again at each element
        let floor = FLOOR.replace(0);
        let result = work.map(|work| work());
        FLOOR.set(floor);
        result
    })
    .unwrap_or_else(|| unreachable!("work is done by the thread or here"))
}

/// Start a thread that expansions need not leave; an ordinary one where the system gives no large stack.
///
/// # Errors
/// When the system starts no thread at all.
pub fn spawn_on_large_stack(name: &str, work: impl FnOnce() + Send + 'static) -> io::Result<()> {
    let work = Arc::new(Mutex::new(Some(work)));
    spawn(name, work.clone(), Some(LARGE_STACK)).or_else(|_| spawn(name, work, None))
}

/// Start a thread with a stack of `size`, or an ordinary one, that does the work unless it is taken.
fn spawn(
    name: &str,
    work: Arc<Mutex<Option<impl FnOnce() + Send + 'static>>>,
    size: Option<usize>,
) -> io::Result<()> {
    let builder = std::thread::Builder::new().name(name.to_owned());
    let builder = size
        .into_iter()
        .fold(builder, std::thread::Builder::stack_size);
    let run = move || {
        FLOOR.set(if size.is_some() { 0 } else { usize::MAX });
        let work = work.lock().unwrap_or_else(PoisonError::into_inner).take();
        work.into_iter().for_each(|work| work());
    };
    builder.spawn(run).map(drop)
}

/// Say that this thread was started with [`LARGE_STACK`]: expansions need not leave it.
pub fn on_large_thread() {
    FLOOR.set(0);
}

#[cfg(test)]
mod tests {
    use std::thread::{self, ThreadId};

    use super::{
        LARGE_STACK, USUAL, on_first_thread, on_large_thread, spawn_on_large_stack, with_stack,
    };

    /// The threads that work comes to at each of some levels of nesting.
    fn threads(levels: usize) -> Vec<ThreadId> {
        let room = std::hint::black_box([0u8; 16 << 10]);
        let mut below = if levels == 0 {
            Vec::new()
        } else {
            with_stack(|| threads(levels - 1))
        };
        below.push(thread::current().id());
        std::hint::black_box(room);
        below
    }

    #[test]
    fn one_thread_is_enough() {
        let mut seen = with_stack(|| threads(500));
        seen.dedup();
        assert_eq!(seen.len(), 1, "a large stack is not left");
        assert_ne!(seen, [thread::current().id()], "a stack of unknown size is");
    }

    #[test]
    fn the_first_thread_is_left_where_nesting_is_deep() {
        let run = || {
            let own = thread::current().id();
            on_first_thread(USUAL - 1);
            assert!(
                !with_stack(|| threads(0)).contains(&own),
                "a small one is left at once"
            );
            on_first_thread(USUAL);
            assert_eq!(threads(20), [own; 21]);
            let mut seen = threads(500);
            seen.dedup();
            assert_eq!(seen.len(), 2);
            assert_eq!(seen.last(), Some(&own));
        };
        thread::Builder::new()
            .stack_size(USUAL)
            .spawn(run)
            .unwrap()
            .join()
            .unwrap();
    }

    #[test]
    fn large_stacks_are_not_left() {
        let stays = || with_stack(|| thread::current().id()) == thread::current().id();
        let (tell, told) = std::sync::mpsc::channel();
        spawn_on_large_stack("test", move || tell.send(stays()).unwrap()).unwrap();
        assert!(told.recv().unwrap());
        let told_so = move || {
            on_large_thread();
            stays()
        };
        let thread = thread::Builder::new().stack_size(LARGE_STACK);
        assert!(thread.spawn(told_so).unwrap().join().unwrap());
        assert!(!stays());
    }
}

//! A bar that says how far a check is, when it takes long enough for people to wonder.

use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::time::{Duration, Instant};

use super::io::Io;
use analysis::Progress;

/// From then on the bar is shown.
const PATIENCE: Duration = Duration::from_millis(500);
/// Time between two pictures of the bar.
const PERIOD: Duration = Duration::from_millis(100);
/// Width of the bar in characters.
const WIDTH: usize = 30;

/// Run `work`; on a terminal, with a bar.
pub(super) fn watched<T: Send>(
    io: &mut Io<'_>,
    progress: &Progress,
    work: impl FnOnce() -> T + Send,
) -> T {
    if !io.terminal {
        return work();
    }
    let begin = Instant::now();
    let mut drawn = false;
    let (done, result) = sync_channel(1);
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let value = work();
            // nobody waits any more only when this thread itself is being unwound
            let _ = done.send(());
            value
        });
        while result.recv_timeout(PERIOD) == Err(RecvTimeoutError::Timeout) {
            if begin.elapsed() >= PATIENCE {
                let (done, all) = progress.get();
                io.flash(&bar(done, all));
                drawn = true;
            }
        }
        if drawn {
            io.flash("");
        }
        worker
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

/// `[=====     ] 5/10`
fn bar(done: usize, all: usize) -> String {
    let filled = (done * WIDTH).checked_div(all).unwrap_or(0).min(WIDTH);
    format!(
        "[{}{}] {done}/{all}",
        "=".repeat(filled),
        " ".repeat(WIDTH - filled)
    )
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::super::io::Io;
    use super::{bar, watched};
    use analysis::Progress;

    /// What is written to the terminal while work takes this many milliseconds.
    fn shown(terminal: bool, milliseconds: u64) -> String {
        let (mut out, mut err, mut stdin) = (Vec::new(), Vec::new(), std::io::empty());
        let mut io = Io::plain(&mut out, &mut err, &mut stdin);
        io.terminal = terminal;
        let work = || {
            std::thread::sleep(Duration::from_millis(milliseconds));
            7
        };
        assert_eq!(watched(&mut io, &Progress::default(), work), 7);
        String::from_utf8(err).unwrap()
    }

    #[test]
    fn only_for_long_work_on_a_terminal() {
        assert_eq!(shown(false, 700), "");
        assert_eq!(shown(true, 0), "");
        let long = shown(true, 1200);
        assert!(
            long.contains("] 0/0") && long.ends_with("\r\u{1b}[K"),
            "{long:?}"
        );
    }

    #[test]
    fn bars() {
        assert_eq!(bar(0, 0), format!("[{}] 0/0", " ".repeat(30)));
        assert_eq!(
            bar(1, 2),
            format!("[{}{}] 1/2", "=".repeat(15), " ".repeat(15))
        );
        assert_eq!(bar(2, 2), format!("[{}] 2/2", "=".repeat(30)));
    }
}

//! `xacro-lint check --watch`: check again whenever something that was read changes.
//!
//! The files are looked at twice a second. That needs no service of the system, works on network drives and in
//! containers, where notifications get lost, and costs a few milliseconds for a workspace.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::io::Io;
use super::render::{shown_path, visible};
use super::text::counted;

/// What a run depended on, with what it was like.
pub(super) type WatchedFiles = BTreeMap<PathBuf, u64>;

/// One run: its exit code and the state of the files it read.
pub(super) struct Round {
    pub(super) code: u8,
    pub(super) state: WatchedFiles,
}

/// Run, wait for a change, run again. A first run that failed (exit code 2) is the only one; later ones may, since files
/// come and go while a branch is checked out. `wait` pauses between two looks; the end comes when it says false.
pub(super) fn watch(
    io: &mut Io<'_>,
    cwd: &Path,
    mut run: impl FnMut(&mut Io<'_>) -> Round,
    mut look: impl FnMut(&WatchedFiles) -> WatchedFiles,
    mut wait: impl FnMut() -> bool,
) -> u8 {
    let mut round = run(io);
    if round.state.is_empty() || round.code == 2 {
        return round.code;
    }
    loop {
        let present = round.state.values().filter(|state| **state != 0).count();
        io.line(&format!(
            "watching {}; press Ctrl-C to stop",
            counted(present, "file")
        ));
        io.flush();
        let (now, changed) = loop {
            if !wait() {
                return round.code;
            }
            let now = look(&round.state);
            if let Some(changed) = difference(&round.state, &now) {
                break (now, changed);
            }
        };
        if io.color_out {
            io.out("\u{1b}[H\u{1b}[2J\u{1b}[3J");
        }
        io.line(&visible(&format!("{} changed", shown_path(&changed, cwd))));
        io.flush();
        round = run(io);
        if round.state.is_empty() {
            round.state = now;
        }
    }
}

/// A file that differs.
fn difference(before: &WatchedFiles, now: &WatchedFiles) -> Option<PathBuf> {
    let differs = |(path, state): &(&PathBuf, &u64)| before.get(*path) != Some(state);
    let gone = before.keys().find(|path| !now.contains_key(*path));
    now.iter()
        .find(differs)
        .map(|(path, _)| path)
        .or(gone)
        .cloned()
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::collections::BTreeMap;
    use std::path::Path;

    use super::super::io::Io;
    use super::{Round, WatchedFiles, watch};

    #[test]
    fn runs_again_when_something_changes() {
        let (mut out, mut err, mut stdin) = (Vec::new(), Vec::new(), std::io::empty());
        let mut io = Io::plain(&mut out, &mut err, &mut stdin);
        let tick = Cell::new(0u64);
        let state =
            || -> WatchedFiles { BTreeMap::from([("/ws/a.xacro".into(), 1 + tick.get() / 2)]) };
        let mut runs = 0;
        let run = |io: &mut Io<'_>| {
            runs += 1;
            io.out(&format!("run {runs}\n"));
            Round {
                code: runs,
                state: state(),
            }
        };
        let wait = || {
            tick.set(tick.get() + 1);
            tick.get() < 6
        };
        let code = watch(&mut io, Path::new("/ws"), run, |_| state(), wait);
        assert_eq!(code, 3);
        assert_eq!(String::from_utf8(out).unwrap(), "run 1\nrun 2\nrun 3\n");
        let watching = "watching 1 file; press Ctrl-C to stop\n";
        let expected = format!("{watching}a.xacro changed\n{watching}a.xacro changed\n{watching}");
        assert_eq!(String::from_utf8(err).unwrap(), expected);
    }
}

//! Other processes, as far as `/proc` tells, and the pipe to the one that started us.

use std::fs::File;
use std::io;

/// Whether a process runs. Where there is no `/proc`, every process counts as running.
pub fn is_process_alive(process: u32) -> bool {
    if !cfg!(target_os = "linux") {
        return true;
    }
    let Ok(stat) = std::fs::read_to_string(format!("/proc/{process}/stat")) else { return false };
    // `1234 (name) S ...`; a name may hold brackets
    let state = stat.rsplit(')').next().unwrap_or("").trim_start();
    !state.starts_with(['Z', 'X'])
}

/// Standard output, without the buffer of the standard library that cuts what is written behind line ends.
///
/// # Errors
/// When it was closed.
pub fn unbuffered_stdout() -> io::Result<File> {
    #[cfg(unix)]
    let stdout = std::os::fd::AsFd::as_fd(&io::stdout()).try_clone_to_owned();
    #[cfg(windows)]
    let stdout = std::os::windows::io::AsHandle::as_handle(&io::stdout()).try_clone_to_owned();
    stdout.map(File::from)
}

#[cfg(test)]
mod tests {
    use super::is_process_alive;

    #[test]
    fn this_process_runs() {
        assert!(is_process_alive(std::process::id()));
        assert!(!cfg!(target_os = "linux") || !is_process_alive(u32::MAX));
    }
}

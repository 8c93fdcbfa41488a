//! Other processes, as far as `/proc` tells, and the pipe to the one that started us.

use std::fs::File;
use std::io;

/// Whether a process runs. Where there is no `/proc`, every process counts as running.
pub fn is_process_alive(process: u32) -> bool {
    if !cfg!(target_os = "linux") {
        return true;
    }
    let Ok(stat) = std::fs::read_to_string(format!("/proc/{process}/stat")) else {
        return false;
    };
    // `1234 (name) S ...`; a name may hold brackets
    let state = stat.rsplit(')').next().unwrap_or("").trim_start();
    !state.starts_with(['Z', 'X'])
}

/// The bytes that the stack of the first thread may grow to, where `/proc` tells; none elsewhere.
pub fn first_stack() -> Option<usize> {
    if !cfg!(target_os = "linux") {
        return None;
    }
    stack_limit(&std::fs::read_to_string("/proc/self/limits").ok()?)
}

/// The soft limit in a text like `/proc/self/limits`.
fn stack_limit(limits: &str) -> Option<usize> {
    let line = limits
        .lines()
        .find_map(|line| line.strip_prefix("Max stack size"))?;
    match line.split_whitespace().next()? {
        "unlimited" => Some(usize::MAX),
        bytes => bytes.parse().ok(),
    }
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
    #[cfg(not(any(unix, windows)))]
    let stdout: io::Result<File> = Err(io::ErrorKind::Unsupported.into());
    stdout.map(File::from)
}

#[cfg(test)]
mod tests {
    use super::{first_stack, is_process_alive, stack_limit};

    #[test]
    fn this_process_runs() {
        assert!(is_process_alive(std::process::id()));
        assert!(!cfg!(target_os = "linux") || !is_process_alive(u32::MAX));
    }

    #[test]
    fn limits_of_the_stack() {
        let limits = |soft: &str| {
            format!(
                "Limit    Soft Limit  Hard Limit  Units\nMax stack size   {soft}   unlimited  bytes\n"
            )
        };
        for (soft, expected) in [
            ("8388608", Some(8 << 20)),
            ("unlimited", Some(usize::MAX)),
            ("?", None),
        ] {
            assert_eq!(stack_limit(&limits(soft)), expected);
        }
        assert_eq!(
            stack_limit("Max cpu time   unlimited   unlimited   seconds"),
            None
        );
        assert_eq!(first_stack().is_some(), cfg!(target_os = "linux"));
    }
}

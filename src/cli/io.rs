//! Where a command writes to: the streams of the process, or buffers in tests.

use std::io::{Read, Write};

use base::limits::STDIN_BYTES;
use vfs::Environment;

/// The streams of a command.
pub struct Io<'a> {
    /// Results.
    pub out: &'a mut dyn Write,
    /// Messages.
    pub err: &'a mut dyn Write,
    /// Read for `-`.
    pub stdin: &'a mut dyn Read,
    /// Whether messages may be colored.
    pub color: bool,
    /// Whether results may be colored.
    pub color_out: bool,
    /// Whether results go to a terminal.
    pub out_is_terminal: bool,
    /// Whether a person reads results, not a program or a log.
    pub is_read: bool,
    /// Whether all goes to a terminal, where a line can be written over.
    pub terminal: bool,
    /// Why results could not be written, once that has happened.
    failed: Option<std::io::Error>,
}

impl<'a> Io<'a> {
    /// Streams without colors, none of them a terminal; a person reads them.
    pub fn plain(out: &'a mut dyn Write, err: &'a mut dyn Write, stdin: &'a mut dyn Read) -> Self {
        Self {
            out,
            err,
            stdin,
            color: false,
            color_out: false,
            out_is_terminal: false,
            is_read: true,
            terminal: false,
            failed: None,
        }
    }
}

/// Whether a stream gets colors: a terminal does, unless the environment says otherwise.
pub fn has_colors(env: &Environment, is_terminal: bool) -> bool {
    let value = |name: &str| env.var(name).filter(|value| !value.is_empty());
    if value("NO_COLOR").is_some() {
        return false;
    }
    let mut forcing = ["CLICOLOR_FORCE", "FORCE_COLOR"]
        .into_iter()
        .filter_map(value);
    if forcing.any(|value| value != "0") {
        return true;
    }
    is_terminal && value("TERM") != Some("dumb") && value("CLICOLOR") != Some("0")
}

/// The text of standard input; nothing is cut.
///
/// # Errors
/// Those of the system, and one for an input that is too large.
pub(super) fn all_of(stdin: &mut dyn Read) -> std::io::Result<String> {
    let mut bytes = Vec::new();
    stdin.take(STDIN_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > STDIN_BYTES {
        let why = format!(
            "input is larger than {} MB; pass the file name instead",
            STDIN_BYTES / 1_000_000
        );
        return Err(std::io::Error::other(why));
    }
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

impl Io<'_> {
    /// Write to the result stream. A reader that went away is no error of ours.
    pub fn out(&mut self, text: &str) {
        let written = self.out.write_all(text.as_bytes());
        self.note(written);
    }

    /// Remember that results were lost.
    fn note(&mut self, written: std::io::Result<()>) {
        let lost = written
            .err()
            .filter(|error| error.kind() != std::io::ErrorKind::BrokenPipe);
        self.failed = self.failed.take().or(lost);
    }

    /// The exit code of a command that ended with `code`: that of an error when its results could not be written.
    pub(super) fn finish(&mut self, code: u8) -> u8 {
        let flushed = self.out.flush();
        self.note(flushed);
        match self.failed.take() {
            None => code,
            Some(error) => {
                self.line(&format!("error: cannot write to standard output: {error}"));
                2
            }
        }
    }

    /// Write a line to the message stream.
    pub fn line(&mut self, text: &str) {
        let _ = writeln!(self.err, "{text}");
    }

    /// Write over the last line of a terminal.
    pub(super) fn flash(&mut self, text: &str) {
        let _ = write!(self.err, "\r\u{1b}[K{text}");
        let _ = self.err.flush();
    }

    /// Let the reader see what was written so far.
    pub(super) fn flush(&mut self) {
        let flushed = self.out.flush();
        self.note(flushed);
        let _ = self.err.flush();
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::has_colors;
    use vfs::Environment;

    #[test]
    fn colors_are_as_the_environment_wants_them() {
        for (vars, on_terminal, in_pipe) in [
            (vec![], true, false),
            (vec![("NO_COLOR", "1"), ("FORCE_COLOR", "1")], false, false),
            (vec![("NO_COLOR", "")], true, false),
            (vec![("TERM", "dumb")], false, false),
            (vec![("CLICOLOR", "0")], false, false),
            (vec![("CLICOLOR_FORCE", "1")], true, true),
            (vec![("CLICOLOR_FORCE", "0")], true, false),
            (vec![("FORCE_COLOR", "1"), ("TERM", "dumb")], true, true),
        ] {
            let pairs = vars
                .iter()
                .map(|(name, value)| ((*name).to_owned(), (*value).to_owned()));
            let env = Environment {
                vars: BTreeMap::from_iter(pairs),
                cwd: "/".into(),
                ..Environment::default()
            };
            assert_eq!(
                (has_colors(&env, true), has_colors(&env, false)),
                (on_terminal, in_pipe),
                "{vars:?}"
            );
        }
    }
}

//! Where a command writes to: the streams of the process, or buffers in tests.

use std::io::{Read, Write};

use crate::base::limits::STDIN_BYTES;

/// The streams of a command.
pub struct Io<'a> {
    /// Results.
    pub out: &'a mut dyn Write,
    /// Messages.
    pub err: &'a mut dyn Write,
    /// Read for `-`.
    pub stdin: &'a mut dyn Read,
    /// Whether messages may be coloured.
    pub color: bool,
    /// Whether results may be coloured.
    pub color_out: bool,
    /// Whether all goes to a terminal, where a line can be written over.
    pub terminal: bool,
}

impl<'a> Io<'a> {
    /// Streams without colours, none of them a terminal.
    pub fn plain(out: &'a mut dyn Write, err: &'a mut dyn Write, stdin: &'a mut dyn Read) -> Self {
        Self { out, err, stdin, color: false, color_out: false, terminal: false }
    }
}

/// The text of standard input; nothing is cut.
///
/// # Errors
/// Those of the system, and one for an input that is too large.
pub(super) fn all_of(stdin: &mut dyn Read) -> std::io::Result<String> {
    let mut bytes = Vec::new();
    stdin.take(STDIN_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > STDIN_BYTES {
        let why =
            format!("it has more than {} MB, the limit: name the file instead", STDIN_BYTES / 1_000_000);
        return Err(std::io::Error::other(why));
    }
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

impl Io<'_> {
    /// Write to the result stream. A reader that went away is no error of ours.
    pub fn out(&mut self, text: &str) {
        let _ = self.out.write_all(text.as_bytes());
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
        let _ = self.out.flush();
        let _ = self.err.flush();
    }
}

//! Where a command writes to: the streams of the process, or buffers in tests.

use std::io::Write;

/// The streams of a command.
pub struct Io<'a> {
    /// Results.
    pub out: &'a mut dyn Write,
    /// Messages.
    pub err: &'a mut dyn Write,
    /// Read for `-`.
    pub stdin: &'a mut dyn std::io::Read,
    /// Whether messages may be coloured.
    pub color: bool,
    /// Whether results may be coloured.
    pub color_out: bool,
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
}

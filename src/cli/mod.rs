//! `xacro-lint`: the command line.

mod expand;
mod io;
mod options;
mod render;

pub use io::Io;

use crate::vfs::Environment;

/// Run a command line (without the program's name); the result is the exit code.
pub fn run(args: &[String], env: &Environment, io: &mut Io<'_>) -> u8 {
    match args.split_first() {
        Some((command, rest)) if command == "expand" => expand::run(rest, env, io),
        _ => {
            io.line("usage: xacro-lint expand <input>");
            2
        }
    }
}

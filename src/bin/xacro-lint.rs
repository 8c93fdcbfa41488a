//! `xacro-lint`: the command line.

use std::io::{IsTerminal, Write};
use std::process::ExitCode;

use xacro_lsp::cli::{self, Io};
use xacro_lsp::expand::on_first_thread;
use xacro_lsp::vfs::{Environment, first_stack};

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args_os()
        .skip(1)
        .map(|a| a.to_string_lossy().into_owned())
        .collect();
    let env = Environment::capture();
    let color = cli::has_colors(&env, std::io::stderr().is_terminal());
    // where results are piped on, nothing is drawn between them
    let terminal = std::io::stderr().is_terminal() && std::io::stdout().is_terminal();
    let color_out = cli::has_colors(&env, std::io::stdout().is_terminal());
    // not locked: the language server reads and writes them on threads of its own
    let mut out = std::io::BufWriter::with_capacity(1 << 16, std::io::stdout());
    let mut err = std::io::BufWriter::new(std::io::stderr());
    let mut stdin = std::io::stdin();
    let mut io = Io::plain(&mut out, &mut err, &mut stdin);
    (io.color, io.color_out, io.terminal) = (color, color_out, terminal);
    io.out_is_terminal = std::io::stdout().is_terminal();
    io.is_read = io.out_is_terminal;
    if let Some(stack) = first_stack() {
        on_first_thread(stack);
    }
    let code = cli::run(&args, &env, &mut io);
    let _ = out.flush();
    let _ = err.flush();
    ExitCode::from(code)
}

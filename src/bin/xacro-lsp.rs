//! `xacro-lsp`: the name under which editors start the language server. The server is a command of `xacro-lint`, which
//! lies beside this program: `xacro-lsp --stdio` is `xacro-lint server --stdio`.

// the one program that is ever started: the server itself, beside this file, whatever the workspace holds
#![allow(clippy::disallowed_methods)]

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

fn main() -> ExitCode {
    let problem = match program() {
        Ok(program) => {
            let mut server = Command::new(&program);
            server.arg("server").args(std::env::args_os().skip(1));
            match serve(&mut server) {
                Ok(code) => return code,
                Err(error) => format!("`{}` cannot be started: {error}", program.display()),
            }
        }
        Err(problem) => problem,
    };
    let _ = writeln!(std::io::stderr(), "xacro-lsp: {problem}");
    ExitCode::from(2)
}

/// Where the server is: beside this program, or beside the file that this name is a link to.
fn program() -> Result<PathBuf, String> {
    let own =
        std::env::current_exe().map_err(|error| format!("its own path is unknown: {error}"))?;
    let name = format!("xacro-lint{}", std::env::consts::EXE_SUFFIX);
    let real = own.canonicalize().unwrap_or_else(|_| own.clone());
    for file in [&own, &real] {
        let program = file.with_file_name(&name);
        if program.is_file() {
            return Ok(program);
        }
    }
    let folder = real.parent().unwrap_or(&real);
    Err(format!(
        "the server is the program `{name}`, which is not in {}: install both together",
        folder.display()
    ))
}

/// Become the server: the editor's process is then the server itself, and its signals arrive there.
#[cfg(unix)]
fn serve(server: &mut Command) -> std::io::Result<ExitCode> {
    Err(std::os::unix::process::CommandExt::exec(server))
}

/// Run the server with the streams of this process, and end as it does.
#[cfg(not(unix))]
fn serve(server: &mut Command) -> std::io::Result<ExitCode> {
    let code = server.status()?.code().unwrap_or(1);
    Ok(ExitCode::from(u8::try_from(code).unwrap_or(1)))
}

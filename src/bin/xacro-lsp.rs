//! `xacro-lsp`: the language server on standard input and output.

use std::io::Write;
use std::process::ExitCode;

use xacro_lsp::server;
use xacro_lsp::vfs::Environment;

const USAGE: &str = "usage: xacro-lsp [--stdio | --version | --help]\n\n\
    The language server for xacro and URDF. Editors start it and speak with it on standard input and output.\n";

fn main() -> ExitCode {
    let mut out = std::io::stdout();
    for argument in std::env::args_os().skip(1) {
        let text = match argument.to_str() {
            Some("--stdio") => continue,
            Some("--version" | "-V") => format!("xacro-lsp {}\n", env!("CARGO_PKG_VERSION")),
            Some("--help" | "-h") => USAGE.to_owned(),
            _ => {
                let _ =
                    write!(std::io::stderr(), "xacro-lsp: unknown option `{}`\n{USAGE}", argument.display());
                return ExitCode::from(2);
            }
        };
        let _ = out.write_all(text.as_bytes());
        return ExitCode::SUCCESS;
    }
    // reading standard input may keep a thread busy for ever: end the process, not only this function
    std::process::exit(i32::from(server::run(Environment::capture())))
}

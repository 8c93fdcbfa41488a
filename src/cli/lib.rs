//! `xacro-lint`: the command line.

mod args;
mod assets;
mod calls;
mod check;
mod check_args;
mod config;
mod consumers;
mod deps;
mod diff;
mod expand;
mod explain;
mod fingerprints;
mod format;
mod io;
mod listing;
mod mcp;
mod options;
mod packages;
mod picture;
mod prepare;
#[cfg(feature = "preview")]
mod preview;
mod progress;
mod reference;
mod render;
mod sarif;
mod services;
mod svg;
mod test;
mod text;
mod tree;
mod watch;

pub use io::{Io, has_colors};
pub use reference::reference;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};

use args::{Arguments, Command};
use check_args::CheckArgs;
use vfs::Environment;

/// Run a command line (without the program's name); the result is the exit code. What was printed is written when this
/// comes back; results that could not be written are an error.
pub fn run(args: &[String], env: &Environment, io: &mut Io<'_>) -> u8 {
    let code = command(args, env, io);
    io.finish(code)
}

fn command(args: &[String], env: &Environment, io: &mut Io<'_>) -> u8 {
    // `expand` has the option grammar of xacro, which clap does not know
    if let Some((command, rest)) = args.split_first()
        && command == "expand"
    {
        return expand::run(rest, env, io);
    }
    if let Some((command, rest)) = args.split_first()
        && command == "check"
        && let Some(options) = CheckArgs::of_paths(rest)
    {
        return check::run(&options, env, io);
    }
    if let [only] = args
        && (only == "--version" || only == "-V")
    {
        // asked by tools again and again: no option needs to be known for it
        io.out(concat!("xacro-lint ", env!("CARGO_PKG_VERSION"), "\n"));
        return 0;
    }
    let name = std::iter::once("xacro-lint").chain(args.iter().map(String::as_str));
    match Arguments::try_parse_from(name) {
        Ok(arguments) => dispatch(arguments.command, env, io),
        Err(error) => {
            let text = error.render();
            let wanted = matches!(
                error.kind(),
                ErrorKind::DisplayHelp | ErrorKind::DisplayVersion
            );
            let color = if wanted { io.color_out } else { io.color };
            let text = if color {
                text.ansi().to_string()
            } else {
                text.to_string()
            };
            if wanted {
                io.out(&text);
                return 0;
            }
            io.line(text.trim_end());
            2
        }
    }
}

fn dispatch(command: Command, env: &Environment, io: &mut Io<'_>) -> u8 {
    match command {
        Command::Check(options) => check::run(&options, env, io),
        Command::Fix(options) => check::run(&check::fixing(options), env, io),
        Command::Test(options) => test::run(&options, env, io),
        Command::Format(options) => format::run(&options, env, io),
        Command::Expand { args } => expand::run(&args, env, io),
        Command::Tree(options) => tree::run(&options, env, io),
        Command::Consumers(options) => consumers::run(&options, env, io),
        Command::Render(options) => picture::run(&options, env, io),
        #[cfg(feature = "preview")]
        Command::Preview(options) => preview::run(&options, env, io),
        Command::Calls(options) => calls::run(&options, env, io),
        Command::Packages(options) => packages::run(&options, env, io),
        Command::Deps(options) => deps::run(&options, env, io),
        Command::Explain { rule } => explain::explain(rule.as_deref(), io),
        Command::Rules(options) => explain::rules(&options, io),
        Command::Config(options) => config::run(&options, env, io),
        #[cfg(feature = "lsp")]
        Command::Server(options) => serve(&options, env, io),
        Command::Mcp(options) => mcp::run(&options, env, io),
        Command::Completions { shell } => completions(shell, io),
    }
}

/// Serve an editor until it is gone. The server reads and writes the streams of the process itself.
#[cfg(feature = "lsp")]
fn serve(options: &args::ServerArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    if options.version {
        io.out(concat!("xacro-lsp ", env!("CARGO_PKG_VERSION"), "\n"));
        return 0;
    }
    server::run(env.clone())
}

/// Print a script for a shell.
fn completions(shell: clap_complete::Shell, io: &mut Io<'_>) -> u8 {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "xacro-lint", &mut script);
    let script = String::from_utf8_lossy(&script).into_owned();
    io.out(&match shell {
        // the hyphen in the name becomes the mark that separates subcommands, in half of the places
        clap_complete::Shell::Bash => script.replace("xacro__subcmd__lint", "xacro__lint"),
        _ => script,
    });
    0
}

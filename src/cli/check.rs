//! `xacro-lint check`.

use std::path::{Path, PathBuf};

use super::args::{CheckArgs, FailLevel, Format};
use super::io::Io;
use super::options::mappings;
use super::render::{shown_path, visible};
use super::{json, text};
use crate::analysis::{CheckOptions, Overrides, Report, Session, Setup};
use crate::rules::{self, Severity};
use crate::vfs::Environment;

/// Largest input that is read from standard input, in bytes.
const MOST_INPUT: u64 = 20_000_000;

/// Run `check`.
pub(super) fn run(args: &CheckArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let options = match prepare(args) {
        Ok(options) => options,
        Err(message) => return usage(io, &message),
    };
    let setup = Setup {
        about: options.paths.iter().chain(&options.entries).next().cloned().unwrap_or_default(),
        package_path: args.package_path.iter().map(PathBuf::from).collect(),
        overrides: overrides(args),
        ..Setup::default()
    };
    let session = match Session::new(env, setup) {
        Ok(session) => session,
        Err(error) => return usage(io, &format!("{}: {}", error.path.display(), error.strerror)),
    };
    if let Some(name) = &args.stdin_filename
        && let Err(error) = read_stdin(name, &session, io)
    {
        return usage(io, &format!("standard input cannot be read: {error}"));
    }
    if args.show_files {
        for file in session.files(&options) {
            io.out(&format!("{}\n", visible(&shown_path(&file, &env.cwd))));
        }
        return warn_about_config(&session, env, io);
    }
    let report = session.check(&options);
    if !report.unreadable.is_empty() {
        for unreadable in &report.unreadable {
            let path = visible(&shown_path(&unreadable.path, &env.cwd));
            io.line(&format!("error: {path}: {}", unreadable.error.strerror));
        }
        return 2;
    }
    print(&report, args, env, io);
    exit_code(&report, args)
}

/// Put standard input in the place of a file.
fn read_stdin(name: &Path, session: &Session, io: &mut Io<'_>) -> std::io::Result<()> {
    let mut input = Vec::new();
    std::io::Read::read_to_end(&mut std::io::Read::take(&mut *io.stdin, MOST_INPUT), &mut input)?;
    session.vfs.set_buffer(name, Some(String::from_utf8_lossy(&input).into_owned()));
    Ok(())
}

/// Say what in the configuration has no effect.
pub(super) fn warn_about_config(session: &Session, env: &Environment, io: &mut Io<'_>) -> u8 {
    for warning in session.config_warnings() {
        let text = warning.to_string().replace(&format!("{}/", env.cwd.display()), "");
        io.line(&visible(&format!("warning: {text}")));
    }
    0
}

fn prepare(args: &CheckArgs) -> Result<CheckOptions, String> {
    let (mapped, paths): (Vec<&String>, Vec<&String>) =
        args.paths.iter().partition(|path| path.contains(":="));
    let mut paths: Vec<PathBuf> = paths.into_iter().map(PathBuf::from).collect();
    paths.extend(args.stdin_filename.clone());
    if paths.is_empty() && args.entry.is_empty() {
        paths.push(".".into());
    }
    let arguments = mappings(mapped.into_iter().map(String::as_str)).map_err(|error| error.message())?;
    if args.statistics && matches!(args.format, Format::Json | Format::Github) {
        return Err("--statistics goes with --format text or concise".to_owned());
    }
    let selectors = [&args.select, &args.extend_select, &args.ignore].into_iter().flatten();
    let mut unknown =
        selectors.filter(|selector| *selector != "ALL" && rules::find(selector).next().is_none());
    match unknown.next() {
        Some(unknown) => Err(rules::unknown_selector(unknown)),
        None => Ok(CheckOptions {
            paths,
            entries: args.entry.clone(),
            args: arguments,
            ..CheckOptions::default()
        }),
    }
}

fn overrides(args: &CheckArgs) -> Overrides {
    let given = |list: &Vec<String>| (!list.is_empty()).then(|| list.clone());
    Overrides {
        config: args.config.clone(),
        select: given(&args.select),
        extend_select: given(&args.extend_select),
        ignore: given(&args.ignore),
        profiles: given(&args.profile),
        ..Overrides::default()
    }
}

fn usage(io: &mut Io<'_>, message: &str) -> u8 {
    io.line(&format!("error: {}", visible(message)));
    2
}

fn print(report: &Report, args: &CheckArgs, env: &Environment, io: &mut Io<'_>) {
    let hints = args.show.is_some();
    match args.format {
        Format::Json => io.out(&json::findings(report, &env.cwd)),
        Format::Github => text::github(report, &env.cwd, hints, io),
        Format::Text | Format::Concise if args.statistics => text::statistics(report, io),
        Format::Concise => text::concise(report, &env.cwd, hints, io),
        Format::Text => text::full(report, &env.cwd, hints, io),
    }
    if report.roots.is_empty() {
        io.line("warning: no xacro or URDF file was found");
    }
}

fn exit_code(report: &Report, args: &CheckArgs) -> u8 {
    let least = match args.fail_level {
        FailLevel::Error => Severity::Error,
        FailLevel::Warning => Severity::Warning,
        FailLevel::Info => Severity::Info,
    };
    let fails = report.findings.iter().any(|finding| finding.severity >= least);
    u8::from(fails && !args.exit_zero)
}

//! `xacro-lint check`.

use std::path::PathBuf;
use std::sync::Arc;

use super::args::{CheckArgs, FailLevel, Format};
use super::expand::package_options;
use super::io::Io;
use super::options::{UsageError, mappings};
use super::{json, text};
use crate::analysis::{CheckOptions, Report, Session};
use crate::rules::{Selection, SelectionOptions, Severity};
use crate::vfs::Environment;

/// Largest file that is read, in bytes.
pub(super) const MAX_FILE_BYTES: u64 = 20 << 20;

/// Run `check`.
pub(super) fn run(args: &CheckArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let (options, selection) = match prepare(args) {
        Ok(prepared) => prepared,
        Err(message) => return usage(io, &message),
    };
    let session = Session::new(env, MAX_FILE_BYTES, package_options(&args.package_path, env, false));
    if let Some(name) = &args.stdin_filename {
        let mut input = Vec::new();
        let read =
            std::io::Read::read_to_end(&mut std::io::Read::take(&mut *io.stdin, MAX_FILE_BYTES), &mut input);
        if let Err(error) = read {
            return usage(io, &format!("standard input cannot be read: {error}"));
        }
        session.vfs.set_buffer(name, Some(String::from_utf8_lossy(&input).into_owned()));
    }
    if args.show_files {
        for file in session.files(&options) {
            io.out(&format!("{}\n", super::render::visible(&super::render::shown_path(&file, &env.cwd))));
        }
        return 0;
    }
    let selection = Arc::new(selection);
    let report = session.check(&options, &|_| selection.clone());
    if !report.unreadable.is_empty() {
        for unreadable in &report.unreadable {
            let path = super::render::visible(&super::render::shown_path(&unreadable.path, &env.cwd));
            io.line(&format!("error: {path}: {}", unreadable.error.strerror));
        }
        return 2;
    }
    print(&report, args, env, io);
    exit_code(&report, args)
}

/// The options of the check, and the rules that run.
fn prepare(args: &CheckArgs) -> Result<(CheckOptions, Selection), String> {
    let (mapped, paths): (Vec<&String>, Vec<&String>) =
        args.paths.iter().partition(|path| path.contains(":="));
    let mut paths: Vec<PathBuf> = paths.into_iter().map(PathBuf::from).collect();
    paths.extend(args.stdin_filename.clone());
    if paths.is_empty() && args.entry.is_empty() {
        paths.push(".".into());
    }
    let arguments = mappings(mapped.into_iter().map(String::as_str)).map_err(|error| match error {
        UsageError::Mapping(message) | UsageError::Usage(message) => message,
        UsageError::Help => String::new(),
    })?;
    let machine = matches!(args.format, Format::Json | Format::Github);
    if args.statistics && machine {
        return Err("--statistics goes with --format text or concise".to_owned());
    }
    let (selection, unknown) = Selection::new(&SelectionOptions {
        select: (!args.select.is_empty()).then(|| args.select.clone()),
        extend_select: args.extend_select.clone(),
        ignore: args.ignore.clone(),
        profiles: args.profile.clone(),
        severity: Vec::new(),
    });
    if let Some(unknown) = unknown.first() {
        return Err(unknown.to_string());
    }
    let entries = args.entry.clone();
    Ok((CheckOptions { paths, entries, args: arguments, ..CheckOptions::default() }, selection))
}

fn usage(io: &mut Io<'_>, message: &str) -> u8 {
    io.line(&format!("error: {}", super::render::visible(message)));
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

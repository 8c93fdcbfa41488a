//! `xacro-lint check` and `xacro-lint fix`.

use std::path::{Path, PathBuf};

use super::args::{CheckArgs, FailLevel, Format};
use super::diff::unified;
use super::io::Io;
use super::options::mappings;
use super::render::{shown_path, visible};
use super::{json, sarif, services, text};
use crate::analysis::{Baseline, CheckOptions, Fixed, Overrides, Report, Session, Setup};
use crate::rules::{self, Safety, Severity};
use crate::vfs::{Environment, write_atomically};

/// Largest input that is read from standard input, in bytes.
const MOST_INPUT: u64 = 20_000_000;

/// The arguments of `fix` as those of `check`.
pub(super) fn fixing(args: CheckArgs) -> CheckArgs {
    CheckArgs { fix: true, ..args }
}

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
    if let Some(name) = stdin_name(args)
        && let Err(error) = read_stdin(&name, &session, io)
    {
        return usage(io, &format!("standard input cannot be read: {error}"));
    }
    if args.show_files {
        for file in session.files(&options) {
            io.out(&format!("{}\n", visible(&shown_path(&file, &env.cwd))));
        }
        return warn_about_config(&session, env, io);
    }
    let baseline = match args.baseline.as_deref().map(|path| read_baseline(path, &session)).transpose() {
        Ok(baseline) => baseline,
        Err(message) => return usage(io, &message),
    };
    Run { args, session: &session, options: &options, env, baseline }.all(io)
}

fn read_baseline(path: &Path, session: &Session) -> Result<(Baseline, PathBuf), String> {
    let named = |why: &str| format!("{}: {why}", path.display());
    let file = session.vfs.text(path).map_err(|error| named(&error.strerror))?;
    let baseline = Baseline::from_json(&file.text).map_err(|why| named(&why))?;
    let folder = file.path.parent().map(Path::to_owned).unwrap_or_default();
    Ok((baseline, folder))
}

/// The name that standard input is checked under.
fn stdin_name(args: &CheckArgs) -> Option<PathBuf> {
    let dash = args.paths.iter().any(|path| path == "-").then(|| PathBuf::from("-"));
    args.stdin_filename.clone().or(dash)
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
    let paths = paths.into_iter().filter(|path| *path != "-");
    let mut paths: Vec<PathBuf> = paths.map(PathBuf::from).collect();
    paths.extend(stdin_name(args));
    if paths.is_empty() && args.entry.is_empty() {
        paths.push(".".into());
    }
    let arguments = mappings(mapped.into_iter().map(String::as_str)).map_err(|error| error.message())?;
    contradictions(args)?;
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

/// Options that do not go together.
fn contradictions(args: &CheckArgs) -> Result<(), String> {
    let for_people = matches!(args.format, Format::Text | Format::Concise);
    let message = if args.statistics && !for_people {
        "--statistics goes with --format text or concise"
    } else if args.diff && !for_people {
        "--diff prints a diff, whatever the format: leave --format out"
    } else if args.unsafe_fixes && !args.fix && !args.diff {
        "--unsafe-fixes goes with --fix or --diff"
    } else if args.fix && !args.diff && stdin_name(args).is_some() {
        "standard input cannot be fixed in place: use --diff"
    } else {
        return Ok(());
    };
    Err(message.to_owned())
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

/// One run, set up.
struct Run<'a> {
    args: &'a CheckArgs,
    session: &'a Session,
    options: &'a CheckOptions,
    env: &'a Environment,
    /// Findings that are known, and the folder that their files are named from.
    baseline: Option<(Baseline, PathBuf)>,
}

impl Run<'_> {
    fn all(&self, io: &mut Io<'_>) -> u8 {
        if !self.args.fix && !self.args.diff {
            let report = self.session.check(self.options);
            return self.conclude(report, "", io);
        }
        let most = if self.args.unsafe_fixes { Safety::Unsafe } else { Safety::Safe };
        let fixed = self.session.fix(self.options, most);
        if self.args.diff {
            return self.diff(fixed, io);
        }
        for file in &fixed.files {
            if let Err(error) = self.session.vfs.rewrite(&file.path, &file.before, &file.after) {
                return usage(io, &format!("{}: cannot be written: {error}", self.shown(&file.path)));
            }
        }
        let done = if fixed.count > 0 { format!("fixed {}", fixed_in(&fixed)) } else { String::new() };
        self.conclude(fixed.into_left(), &done, io)
    }

    fn shown(&self, path: &Path) -> String {
        shown_path(path, &self.env.cwd)
    }

    fn diff(&self, fixed: Fixed, io: &mut Io<'_>) -> u8 {
        if self.unreadable(&fixed.found, io) {
            return 2;
        }
        for file in &fixed.files {
            io.out(&unified(file, &self.env.cwd));
        }
        io.line(&match fixed.count {
            0 => "nothing to fix".to_owned(),
            _ => format!("would fix {}", fixed_in(&fixed)),
        });
        let mut found = fixed.found;
        self.subtract_known(&mut found, io);
        exit_code(&found, self.args)
    }

    fn unreadable(&self, report: &Report, io: &mut Io<'_>) -> bool {
        for unreadable in &report.unreadable {
            let path = visible(&self.shown(&unreadable.path));
            io.line(&format!("error: {path}: {}", unreadable.error.strerror));
        }
        !report.unreadable.is_empty()
    }

    fn subtract_known(&self, report: &mut Report, io: &mut Io<'_>) {
        let Some((baseline, folder)) = &self.baseline else { return };
        let known = baseline.subtract(report, folder);
        if known > 0 {
            io.line(&format!("note: {} of the baseline not shown", text::counted(known, "finding")));
        }
        let gone = baseline.len() - known;
        if gone > 0 {
            io.line(&format!(
                "note: {} of the baseline did not occur: --write-baseline writes it anew",
                text::counted(gone, "finding")
            ));
        }
    }

    fn write_baseline(&self, report: &Report, path: &Path, io: &mut Io<'_>) -> u8 {
        let path = self.session.vfs.absolute(path);
        let baseline = Baseline::of(report, path.parent().unwrap_or(&path));
        if let Err(error) = write_atomically(&path, baseline.to_json().as_bytes()) {
            return usage(io, &format!("{}: cannot be written: {error}", self.shown(&path)));
        }
        io.line(&format!("wrote {} to {}", text::counted(baseline.len(), "finding"), self.shown(&path)));
        0
    }

    /// Print a report, and what was (`done`) or could be fixed.
    fn conclude(&self, mut report: Report, done: &str, io: &mut Io<'_>) -> u8 {
        if self.unreadable(&report, io) {
            return 2;
        }
        if let Some(path) = &self.args.write_baseline {
            return self.write_baseline(&report, path, io);
        }
        self.subtract_known(&mut report, io);
        self.print(&report, io);
        let is_text = self.args.format == Format::Text && !self.args.statistics;
        if is_text {
            let could = self.could_be_fixed(&report);
            for line in [done, &could].into_iter().filter(|line| !line.is_empty()) {
                io.out(&format!("{line}\n"));
            }
        } else if !done.is_empty() {
            io.line(done);
        }
        if report.roots.is_empty() {
            io.line("warning: no xacro or URDF file was found");
        }
        exit_code(&report, self.args)
    }

    fn could_be_fixed(&self, report: &Report) -> String {
        let (safe, other) = self.session.fixable(self.options, report);
        match (safe, other) {
            (0, 0) => String::new(),
            (safe, 0) => format!("{safe} can be fixed with --fix"),
            (0, other) => format!("{other} can be fixed with --fix --unsafe-fixes"),
            (safe, other) => format!("{safe} can be fixed with --fix, {other} more with --unsafe-fixes"),
        }
    }

    fn print(&self, report: &Report, io: &mut Io<'_>) {
        let (hints, cwd) = (self.args.show.is_some(), &self.env.cwd);
        match self.args.format {
            Format::Json => io.out(&json::findings(report, cwd)),
            Format::Sarif => io.out(&sarif::document(report, cwd)),
            Format::Github => io.out(&services::github(report, cwd, hints)),
            Format::Gitlab => io.out(&services::gitlab(report, cwd, hints)),
            Format::Junit => io.out(&services::junit(report, cwd, hints, least(self.args))),
            Format::Text | Format::Concise if self.args.statistics => text::statistics(report, io),
            Format::Concise => text::concise(report, cwd, hints, io),
            Format::Text => text::full(report, cwd, hints, io),
        }
    }
}

/// `3 findings in 2 files`
fn fixed_in(fixed: &Fixed) -> String {
    format!("{} in {}", text::counted(fixed.count, "finding"), text::counted(fixed.files.len(), "file"))
}

/// The least severity that makes the run fail.
fn least(args: &CheckArgs) -> Severity {
    match args.fail_level {
        FailLevel::Error => Severity::Error,
        FailLevel::Warning => Severity::Warning,
        FailLevel::Info => Severity::Info,
    }
}

fn exit_code(report: &Report, args: &CheckArgs) -> u8 {
    let fails = report.findings.iter().any(|finding| finding.severity >= least(args));
    u8::from(fails && !args.exit_zero)
}

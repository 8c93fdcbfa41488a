//! `xacro-lint check` and `xacro-lint fix`.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::check_args::{CheckArgs, OutputFormat, Show};
use super::consumers::counted_line;
use super::diff::unified;
use super::io::Io;
use super::listing::{FindingList, incomplete, least_shown, wants_all};
use super::options::with_assignment;
use super::prepare::{Prepared, prepare};
use super::progress::watched;
use super::render::{shown_path, visible};
use super::watch::{Round, WatchedFiles, watch};
use super::{sarif, services, text};
use analysis::{Baseline, CheckOptions, FixOptions, Fixed, Report, Session};
use rules::Safety;
use vfs::{Environment, write_atomically};

/// The arguments of `fix` as those of `check`.
pub(super) fn fixing(args: CheckArgs) -> CheckArgs {
    CheckArgs { fix: true, ..args }
}

/// Time between two looks at the files of `--watch`.
const PERIOD: Duration = Duration::from_millis(500);

/// Run `check`.
pub(super) fn run(args: &CheckArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    if !args.watch {
        return once(args, env, io).code;
    }
    let look = |known: &WatchedFiles| match prepare(args, env, &mut std::io::empty()) {
        Ok(prepared) => prepared.state(known.keys().cloned().collect()),
        Err(_) => known.clone(),
    };
    let wait = || {
        std::thread::sleep(PERIOD);
        true
    };
    watch(io, &env.cwd, |io| once(args, env, io), look, wait)
}

/// One check.
fn once(args: &CheckArgs, env: &Environment, io: &mut Io<'_>) -> Round {
    let mut prepared = match prepare(args, env, &mut io.stdin) {
        Ok(prepared) => prepared,
        Err(message) => {
            return Round {
                code: usage(io, &message),
                state: WatchedFiles::default(),
            };
        }
    };
    for warning in &prepared.warnings {
        io.line(&visible(&format!("warning: settings: {warning}")));
    }
    // it takes as long as a third of the check
    prepared.options.count_consumers &= io.is_read;
    let Prepared {
        session, options, ..
    } = &prepared;
    let parts = analysis::robots_of_parts(session, options).filter(|_| !args.changed);
    let (options, part_of) = parts
        .as_ref()
        .map_or((options, &[] as &[PathBuf]), |(options, robots)| {
            (options, robots)
        });
    if args.show_files {
        for file in analysis::files_to_check(session, options) {
            io.out(&format!("{}\n", visible(&shown_path(&file, &env.cwd))));
        }
        return Round {
            code: warn_about_config(session, env, io),
            state: WatchedFiles::default(),
        };
    }
    let (code, reads) = CheckRun {
        args,
        prepared: &prepared,
        session,
        options,
        part_of,
        env,
    }
    .all(io);
    if args.watch {
        return Round {
            code,
            state: prepared.state(reads),
        };
    }
    // the process ends behind this: it need not take everything apart first
    std::mem::forget(prepared);
    Round {
        code,
        state: WatchedFiles::default(),
    }
}

/// Say what in the configuration has no effect; the exit code: 2 when it cannot be read.
pub(super) fn warn_about_config(session: &Session, env: &Environment, io: &mut Io<'_>) -> u8 {
    for warning in session.config_warnings() {
        let text = warning
            .to_string()
            .replace(&format!("{}/", vfs::slashed(&env.cwd)), "");
        io.line(&visible(&format!("warning: {text}")));
    }
    let mut code = 0;
    for error in session.unreadable_configs() {
        code = usage(
            io,
            &format!("{}: {}", shown_path(&error.path, &env.cwd), error.reason()),
        );
    }
    code
}

fn usage(io: &mut Io<'_>, message: &str) -> u8 {
    io.line(&format!("error: {}", visible(message)));
    2
}

/// One run, set up.
struct CheckRun<'a> {
    args: &'a CheckArgs,
    session: &'a Session,
    options: &'a CheckOptions,
    part_of: &'a [PathBuf],
    env: &'a Environment,
    prepared: &'a Prepared,
}

impl CheckRun<'_> {
    /// The exit code, and what was read.
    fn all(&self, io: &mut Io<'_>) -> (u8, BTreeSet<PathBuf>) {
        let (session, options) = (self.session, self.options);
        if !self.args.fix && !self.args.diff {
            let mut report = watched(io, &options.progress, || analysis::check(session, options));
            let reads = std::mem::take(&mut report.reads);
            self.warn_about_arguments(&report, io);
            return (self.finish(report, "", io), reads);
        }
        let most = if self.args.unsafe_fixes {
            Safety::Unsafe
        } else {
            Safety::Safe
        };
        let how = FixOptions {
            most,
            shown: least_shown(self.args),
        };
        let fixed = watched(io, &options.progress, || {
            analysis::fix(session, options, how)
        });
        if self.args.diff {
            return (self.diff(fixed, io), BTreeSet::new());
        }
        let mut fixed = fixed;
        let files = fixed.files.len();
        fixed.files.retain(|file| {
            match session.vfs.rewrite(&file.path, &file.before, &file.after) {
                Ok(()) => true,
                Err(error) => {
                    usage(
                        io,
                        &format!("cannot write {}: {error}", self.shown(&file.path)),
                    );
                    false
                }
            }
        });
        let failed = fixed.files.len() < files;
        let done = self.done(&fixed);
        let mut left = fixed.into_left();
        let reads = std::mem::take(&mut left.reads);
        let code = self.finish(left, &done, io);
        (if failed { 2 } else { code }, reads)
    }

    /// Name the arguments of the command line that no robot knows: xacro ignores them without a word.
    fn warn_about_arguments(&self, report: &Report, io: &mut Io<'_>) {
        for (name, near) in
            analysis::undeclared_arguments(self.session, &report.roots, &self.options.args)
        {
            let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
            io.line(&visible(&format!(
                "warning: unknown argument `{name}`{near}"
            )));
        }
    }

    /// What was fixed, and what came to light by it.
    fn done(&self, fixed: &Fixed) -> String {
        let revealed = match fixed.revealed() {
            0 => String::new(),
            count => format!("; {} appeared after fixing", text::counted(count, "error")),
        };
        match fixed.count {
            0 if fixed.hidden > 0 || fixed.taken_back > 0 => {
                format!("fixed nothing{}", not_made(fixed))
            }
            0 => String::new(),
            _ => format!("fixed {}{revealed}{}", fixed_in(fixed), taken_back(fixed)),
        }
    }

    fn shown(&self, path: &Path) -> String {
        shown_path(path, &self.env.cwd)
    }

    fn diff(&self, fixed: Fixed, io: &mut Io<'_>) -> u8 {
        if self.unreadable(&fixed.found, io) {
            return 2;
        }
        for file in &fixed.files {
            io.out(&unified(file, &self.env.cwd, io.out_is_terminal));
        }
        io.line(&match fixed.count {
            0 => format!("nothing to fix{}", not_made(&fixed)),
            _ => format!("would fix {}{}", fixed_in(&fixed), not_made(&fixed)),
        });
        let mut found = fixed.found;
        self.subtract_known(&mut found, io);
        exit_code(&found, self.args)
    }

    fn unreadable(&self, report: &Report, io: &mut Io<'_>) -> bool {
        for unreadable in &report.unreadable {
            let path = visible(&self.shown(&unreadable.path));
            let complaint = format!("error: {path}: {}", unreadable.error.reason());
            io.line(&with_assignment(&complaint, &path));
        }
        !report.unreadable.is_empty()
    }

    fn subtract_known(&self, report: &mut Report, io: &mut Io<'_>) {
        let Some((baseline, folder)) = &self.prepared.baseline else {
            return;
        };
        let files: BTreeSet<PathBuf> = report
            .files
            .values()
            .map(|file| file.path.to_path_buf())
            .collect();
        let paths = self
            .options
            .paths
            .iter()
            .map(|path| self.session.vfs.absolute(path));
        let folders: Vec<PathBuf> = paths.filter(|path| self.session.vfs.is_dir(path)).collect();
        // of a change, only some findings are reported
        let checked = |path: &Path| {
            !self.args.changed
                && (files.contains(path) || folders.iter().any(|folder| path.starts_with(folder)))
        };
        let (known, gone) = baseline.subtract(report, folder, checked);
        if known > 0 {
            io.line(&format!(
                "note: {} from the baseline not shown",
                text::counted(known, "finding")
            ));
        }
        if gone > 0 {
            let is_whole = folders.iter().any(|checked| folder.starts_with(checked));
            let advice = if is_whole {
                ": update it with --write-baseline"
            } else {
                ""
            };
            let gone = text::counted(gone, "finding");
            io.line(&format!(
                "note: {gone} from the baseline no longer found{advice}"
            ));
        }
    }

    fn write_baseline(&self, report: &Report, path: &Path, io: &mut Io<'_>) -> u8 {
        let path = self.session.vfs.absolute(path);
        let baseline = Baseline::of(report, path.parent().unwrap_or(&path));
        if let Err(error) = write_atomically(&path, baseline.to_json().as_bytes()) {
            return usage(io, &format!("cannot write {}: {error}", self.shown(&path)));
        }
        io.line(&format!(
            "wrote {} to {}",
            text::counted(baseline.len(), "finding"),
            self.shown(&path)
        ));
        0
    }

    /// Print a report, and what was (`done`) or could be fixed.
    fn finish(&self, mut report: Report, done: &str, io: &mut Io<'_>) -> u8 {
        report.part_of = self.part_of.to_vec();
        if self.unreadable(&report, io) {
            return 2;
        }
        if let Some(path) = &self.args.write_baseline {
            return self.write_baseline(&report, path, io);
        }
        self.subtract_known(&mut report, io);
        for skipped in &report.skipped {
            let path = visible(&self.shown(&skipped.path));
            io.line(&format!(
                "warning: {path} was not checked: {}",
                skipped.reason
            ));
        }
        if report.roots.is_empty()
            && report.compared.is_empty()
            && report.skipped.is_empty()
            && !self.args.changed
        {
            io.line("warning: no xacro or URDF files found");
        }
        let code = exit_code(&report, self.args);
        if let Some(incomplete) = incomplete(&report).filter(|_| self.args.require_packages) {
            io.line(&visible(&format!("error: {incomplete}")));
        }
        let for_people = matches!(self.args.format, OutputFormat::Text | OutputFormat::Concise);
        if for_people && self.args.statistics {
            text::statistics(&report, io);
            self.say(done, io);
            return code;
        }
        let could = if for_people {
            self.could_be_fixed(&report)
        } else {
            String::new()
        };
        let report = if wants_all(self.args) {
            report
        } else {
            analysis::grouped(report)
        };
        match self.args.format {
            OutputFormat::Text => self.draw(&report, done, &could, io),
            OutputFormat::Concise => self.list(&report, done, &could, io),
            _ => {
                self.print(&report, io);
                self.say(done, io);
            }
        }
        code
    }

    fn say(&self, done: &str, io: &mut Io<'_>) {
        if !done.is_empty() {
            io.line(done);
        }
    }

    /// Findings with their source text, and a summary.
    fn draw(&self, report: &Report, done: &str, could: &str, io: &mut Io<'_>) {
        let listing = FindingList::of(report, self.args);
        text::full(&listing, report, &self.session.packages, &self.env.cwd, io);
        let consumers = counted_line(report, &self.options.args, &self.env.cwd);
        for line in listing.footer(done, could).into_iter().chain(consumers) {
            io.out(&format!("{line}\n"));
        }
    }

    /// Findings of one line, for programs too: what is said beside them goes elsewhere.
    fn list(&self, report: &Report, done: &str, could: &str, io: &mut Io<'_>) {
        let listing = FindingList::of(report, self.args);
        text::concise(&listing, report, &self.env.cwd, io);
        self.say(done, io);
        for line in listing.note(could) {
            io.line(&format!("note: {line}"));
        }
    }

    fn could_be_fixed(&self, report: &Report) -> String {
        // what is left then would cause new errors, or cannot be written
        if self.args.fix && self.args.unsafe_fixes {
            return String::new();
        }
        let (safe, other) =
            analysis::fixable(self.session, self.options, report, least_shown(self.args));
        // what is left by `--fix` could not be proved to be safe
        let (safe, other) = if self.args.fix {
            (0, safe + other)
        } else {
            (safe, other)
        };
        match (safe, other) {
            (0, 0) => String::new(),
            (safe, 0) => format!("{safe} fixable with --fix"),
            (0, other) => format!("{other} fixable with --fix --unsafe-fixes"),
            (safe, other) => format!("{safe} fixable with --fix, {other} more with --unsafe-fixes"),
        }
    }

    /// Findings for programs.
    fn print(&self, report: &Report, io: &mut Io<'_>) {
        let (hints, cwd) = (
            matches!(self.args.show, Some(Show::Hint | Show::All)),
            &self.env.cwd,
        );
        match self.args.format {
            OutputFormat::Json => io.out(&analysis::to_json(report, cwd)),
            OutputFormat::Sarif => io.out(&sarif::document(report, cwd)),
            OutputFormat::Github => io.out(&services::github(report, cwd, hints)),
            OutputFormat::Gitlab => io.out(&services::gitlab(report, cwd, hints)),
            OutputFormat::Junit => io.out(&services::junit(
                report,
                cwd,
                hints,
                self.args.fail_level.severity(),
            )),
            OutputFormat::Text | OutputFormat::Concise => {}
        }
    }
}

/// `3 findings in 2 files`
fn fixed_in(fixed: &Fixed) -> String {
    format!(
        "{} in {}",
        text::counted(fixed.count, "finding"),
        text::counted(fixed.files.len(), "file")
    )
}

/// `; 2 fixes may change a robot: --unsafe-fixes; 1 finding that is not shown can be fixed: --show hint`
fn not_made(fixed: &Fixed) -> String {
    let mut said = match fixed.unproved {
        0 => String::new(),
        1 => "; 1 more fix with --unsafe-fixes, which may change the robot".to_owned(),
        count => format!("; {count} more fixes with --unsafe-fixes, which may change the robot"),
    };
    said.push_str(&taken_back(fixed));
    match fixed.hidden {
        0 => {}
        1 => said.push_str("; 1 hidden finding is fixable (--show hint)"),
        count => said.push_str(&format!(
            "; {count} hidden findings are fixable (--show hint)"
        )),
    }
    said
}

/// That fixes were taken back.
fn taken_back(fixed: &Fixed) -> String {
    match fixed.taken_back {
        0 => String::new(),
        1 => "; 1 fix was not made because it would cause new errors".to_owned(),
        count => format!("; {count} fixes were not made because they would cause new errors"),
    }
}

fn exit_code(report: &Report, args: &CheckArgs) -> u8 {
    let fails = report
        .findings
        .iter()
        .any(|finding| finding.severity >= args.fail_level.severity());
    let lacks = args.require_packages && !report.incomplete.is_empty();
    u8::from((fails || lacks) && !args.exit_zero)
}

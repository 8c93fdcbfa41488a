//! `xacro-lint expand`: a drop-in for `xacro`.

use std::cell::LazyCell;
use std::mem::ManuallyDrop;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::assets::{AssetPaths, rename};
use super::diff::unified;
use super::io::{Io, all_of};
use super::options::{self, ExpandOptions, UsageError};
use super::render::{
    AnnotatedRange, ProblemReport, ShownFile, render, shown_path, visible, visible_name,
};
use super::text::{is_shown, level};
use analysis::FixedFile;
use base::limits::DRAWN_PROBLEMS;
use base::paths::HERE;
use base::{Encoding, IdVec};
use expand::{
    Expansion, FileIdx, FileRange, FileUse, Problem, Request, Severity, Sources, Written, expand,
    write, write_mapped,
};
use ide::source_map;
use packages::{PackageOptions, Packages, UNQUOTED};
use vfs::{Environment, LoadError, Vfs};
use workspace::config::Config;
use workspace::is_ignored_by_git;

const USAGE: &str = "usage: xacro-lint expand [options] <input> [name:=value ...]";
const HELP: &str = "\
Expand a xacro file exactly as xacro does and print the result.

options:
  -o FILE              write output to FILE instead of stdout
  --check FILE         write nothing; exit with 1 and print the changes if the
                       output differs from FILE
  --deps               print the included and loaded files
  --root-dir DIR       folder for relative paths
  --package-path DIR   search this folder for packages first (repeatable)
  --source-map FILE    write the source location of each output line (JSON)
  --strip-protocols    name meshes and textures by absolute paths instead of
                       package://, file:// and model://
  --relative-paths     name them by paths relative to the output
  --copy-assets-to DIR copy them to DIR and name the copies
  -q                   quiet: no locations after warnings
  -v, --verbosity N    accepted for compatibility
  -i, --inorder        accepted for compatibility
  -h, --help           print this help

`-` as input reads standard input. Exit status: 0 on success, 1 if --check finds
a difference, 2 on errors.
";

/// Run `expand`; the exit code is xacro's.
pub fn run(args: &[String], env: &Environment, io: &mut Io<'_>) -> u8 {
    let options = match options::parse(args) {
        Ok(options) => options,
        Err(UsageError::Help) => {
            io.out(&format!("{USAGE}\n\n{HELP}"));
            return 0;
        }
        Err(UsageError::Usage(message)) => {
            io.line(&format!("{USAGE}\n\nxacro-lint: error: {message}"));
            return 2;
        }
        Err(UsageError::Mapping(message)) => {
            io.line(&format!("RuntimeError: {message}"));
            return 1;
        }
    };
    if options.in_order {
        io.line(
            "xacro: in-order processing became default in ROS Melodic. You can drop the option.",
        );
    }
    run_with(&options, env, io)
}

fn run_with(options: &ExpandOptions, env: &Environment, io: &mut Io<'_>) -> u8 {
    let vfs = Arc::new(Vfs::of(env, Config::default().limits.file_bytes()));
    let root = env.cwd.join(options.root_dir.as_deref().unwrap_or(""));
    // of a configuration only the limits count here: what comes out is as with the reference
    let config = Config::for_file(&vfs, &root.join(&options.input)).config;
    vfs.set_max_file_bytes(config.limits.file_bytes());
    let limits = config.limits.expansion();
    let file = match read_stdin(options, env, &vfs, io) {
        Ok(file) => file,
        Err(message) => {
            io.line(&format!("error: {message}"));
            return 2;
        }
    };
    let packages = Packages::new(
        vfs.clone(),
        env,
        package_options(&options.package_path, env, true),
    );
    let request = Request {
        file,
        args: options.args.clone(),
        root_dir: options
            .root_dir
            .as_deref()
            .map(|root| HERE.slashed(root).into_owned()),
        probe: false,
        last: true,
        limits,
        ..Request::default()
    };
    // the process ends behind this: it need not take everything apart first
    let (vfs, packages) = (ManuallyDrop::new(vfs), ManuallyDrop::new(packages));
    let mut expansion = ManuallyDrop::new(expand(
        Sources {
            vfs: &vfs,
            packages: &packages,
            env,
        },
        &request,
    ));
    for line in &expansion.messages {
        io.line(&visible_name(line));
    }
    if let Some(error) = &expansion.root_error {
        io.line(&format!("error: {}", unreadable(error, &request)));
        return 2;
    }
    report(&expansion, options, &packages, &env.cwd, io);
    if expansion.has_errors() {
        let xml = expansion.problems.iter().any(|p| p.kind.is_about_text());
        // above verbosity 1 the reference ends in a stack trace
        return if options.verbosity > 1 && !xml { 1 } else { 2 };
    }
    if options.deps {
        return deliver(&deps(&expansion), options, env, io);
    }
    if options.assets.are_given()
        && let Err(problem) = rename_assets(&mut expansion, options, &vfs, &packages, env, io)
    {
        io.line(&visible(&format!("error: {problem}")));
        return 2;
    }
    let written = match &options.source_map {
        None => write(&expansion.tree, &request.file),
        Some(file) => {
            let written = write_mapped(&expansion.tree, &request.file);
            if let Err(error) = save_map(&expansion, &written, &env.cwd.join(file)) {
                io.line(&visible(&format!(
                    "error: Failed to write the source map: {error}: '{file}'"
                )));
                return 2;
            }
            written
        }
    };
    match &options.check {
        Some(file) => check(&written.text, file, &vfs, env, io),
        None => deliver(&written.text, options, env, io),
    }
}

/// Give meshes and textures names that work elsewhere, and say which keep theirs.
fn rename_assets(
    expansion: &mut Expansion,
    options: &ExpandOptions,
    vfs: &Vfs,
    packages: &Packages,
    env: &Environment,
    io: &mut Io<'_>,
) -> Result<(), String> {
    let file = options
        .output
        .as_ref()
        .or(options.check.as_ref())
        .map(|file| env.cwd.join(file));
    let output = file.as_deref().and_then(Path::parent).unwrap_or(&env.cwd);
    let places = AssetPaths {
        vfs,
        packages,
        cwd: &env.cwd,
        output,
    };
    for complaint in rename(expansion, &options.assets, &places)? {
        io.line(&visible(&format!("warning: {complaint}")));
    }
    Ok(())
}

/// Compare the result with what a file holds. Line ends do not count, nor does the name of the source in the banner: it
/// depends on the folder in which the command was run.
fn check(text: &str, file: &str, vfs: &Vfs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let path = env.cwd.join(file);
    let old = match vfs.text(&path) {
        Ok(old) => old,
        Err(error) => {
            io.line(&visible(&format!(
                "error: cannot read {file}: {}",
                error.reason()
            )));
            return 2;
        }
    };
    let before = old.text.replace("\r\n", "\n");
    let after = with_banner_of(&before, text);
    if before == after {
        return 0;
    }
    let changes = FixedFile {
        path: Arc::from(path),
        before,
        after,
    };
    io.out(&unified(&changes, &env.cwd, io.out_is_terminal));
    let command = "the same command with -o instead of --check";
    io.line(&visible(&format!(
        "error: {file} is out of date; to update it, run {command}"
    )));
    1
}

/// A document with the banner line that another one has.
fn with_banner_of(other: &str, text: &str) -> String {
    const MARK: &str = "autogenerated by xacro from ";
    let line = |text: &str| {
        text.lines()
            .take(BANNER_LINES)
            .find(|line| line.contains(MARK))
            .map(str::to_owned)
    };
    match line(other).zip(line(text)) {
        Some((theirs, ours)) => text.replacen(&ours, &theirs, 1),
        None => text.to_owned(),
    }
}

/// The lines among which the banner is.
const BANNER_LINES: usize = 5;

/// Put standard input in the place of a file; the name to expand.
fn read_stdin(
    options: &ExpandOptions,
    env: &Environment,
    vfs: &Vfs,
    io: &mut Io<'_>,
) -> Result<String, String> {
    const NAME: &str = "<stdin>";
    if options.input != "-" {
        return Ok(HERE.slashed(&options.input).into_owned());
    }
    let text = all_of(io.stdin).map_err(|error| format!("cannot read standard input: {error}"))?;
    let root = options.root_dir.as_deref().unwrap_or("");
    vfs.set_buffer(&env.cwd.join(root).join(NAME), Some(text));
    Ok(NAME.to_owned())
}

/// How packages are looked up by a command.
pub fn package_options(
    explicit: &[String],
    env: &Environment,
    environment_first: bool,
) -> PackageOptions {
    PackageOptions {
        explicit: explicit.iter().map(|dir| env.cwd.join(dir)).collect(),
        environment_first,
        ignored_by_git: is_ignored_by_git,
        ..PackageOptions::default()
    }
}

fn unreadable(error: &LoadError, request: &Request) -> String {
    let root = request.root_dir.as_deref().unwrap_or(".");
    let name = if HERE.is_absolute(&request.file) {
        request.file.clone()
    } else {
        format!("{root}/{}", request.file)
    };
    let LoadError {
        strerror, errno, ..
    } = error;
    visible(&format!(
        "{strerror}: {name} [Errno {errno}] {strerror}: '{name}'"
    ))
}

/// Print the problems of an expansion under the headlines of the reference.
fn report(
    expansion: &Expansion,
    options: &ExpandOptions,
    packages: &Packages,
    cwd: &Path,
    io: &mut Io<'_>,
) {
    let files = LazyCell::new(|| shown_files(expansion, packages, cwd));
    let belongs = LazyCell::new(|| {
        let around = packages.around(expansion.files.first().map(|root| &*root.source.path));
        expansion
            .files
            .iter()
            .map(|file| around.hold(&file.source.path))
            .collect::<IdVec<FileIdx, bool>>()
    });
    let (mut errors, mut drawn) = (0, 0);
    for problem in &expansion.problems {
        if problem.reference.is_empty() && problem.severity == Severity::Warning {
            continue;
        }
        let concealed;
        let problem = match belongs.get(problem.place.file) {
            Some(false) => {
                concealed = unquoted(problem);
                &concealed
            }
            _ => problem,
        };
        errors += usize::from(problem.severity == Severity::Error);
        if options.verbosity < 1 && problem.severity == Severity::Warning {
            io.line(&visible(&format!("warning: {}", problem.reference)));
            continue;
        }
        drawn += 1;
        if drawn > DRAWN_PROBLEMS {
            continue;
        }
        match as_report(problem, &files) {
            Some(report) => io.line(&render(&report, io.color)),
            None => io.line(&visible(&format!("error: {}", located(problem, &files)))),
        }
        io.line("");
    }
    if errors > 1 {
        io.line(&format!("error: {errors} errors, no output written"));
    }
}

/// A problem without the words that may quote its file.
fn unquoted(problem: &Problem) -> Problem {
    Problem {
        message: UNQUOTED.to_owned(),
        reference: UNQUOTED.to_owned(),
        help: None,
        replacement: None,
        ..problem.clone()
    }
}

/// The files of an expansion, and whether their text may be shown.
type ShownFiles<'e> = IdVec<FileIdx, (ShownFile<'e>, bool)>;

fn shown_files<'e>(expansion: &'e Expansion, packages: &Packages, cwd: &Path) -> ShownFiles<'e> {
    let around = packages.around(expansion.files.first().map(|root| &*root.source.path));
    let shown = |(index, FileUse { source, .. }): (usize, &'e FileUse)| {
        // the root file may have any name
        let is_drawn = is_shown(&source.path, &around) || index == 0 && around.hold(&source.path);
        (
            ShownFile {
                source,
                path: shown_path(&source.path, cwd),
            },
            is_drawn,
        )
    };
    expansion.files.iter().enumerate().map(shown).collect()
}

/// A message in front of which its file stands.
fn located(problem: &Problem, files: &ShownFiles<'_>) -> String {
    let path = files
        .get(problem.place.file)
        .map_or("", |(file, _)| &file.path);
    format!("{path}: {}", problem.message)
}

/// A problem as it is drawn; none when nothing of the text that led to it may be shown.
fn as_report<'a>(problem: &Problem, files: &'a ShownFiles<'a>) -> Option<ProblemReport<'a>> {
    // the first line is what people search for; the others repeat what the snippet shows
    let title = problem.reference.lines().next().unwrap_or(&problem.message);
    let trace = problem.trace.iter().chain(&problem.more_calls);
    let (place, message) = match drawn(problem.place, files) {
        Some(_) => (problem.place, problem.message.clone()),
        None => {
            let caller = problem
                .trace
                .iter()
                .find(|step| drawn(step.place, files).is_some())?;
            (caller.place, located(problem, files))
        }
    };
    Some(ProblemReport {
        level: level(problem.severity),
        id: None,
        url: None,
        title: title.trim_end().to_owned(),
        primary: mark(place, &message, files)?,
        trace: trace
            .filter_map(|step| mark(step.place, &step.message, files))
            .collect(),
        places: Vec::new(),
        help: problem.help.as_ref().map(|help| help.replace('\n', " ")),
    })
}

/// A place with a message in one line; none when its file may not be shown.
fn mark<'a>(
    place: FileRange,
    message: &str,
    files: &'a ShownFiles<'a>,
) -> Option<AnnotatedRange<'a>> {
    Some(AnnotatedRange {
        file: drawn(place, files)?,
        range: place.range,
        label: message.replace('\n', " "),
    })
}

/// The file of a place, when its text may be shown.
fn drawn<'a>(place: FileRange, files: &'a ShownFiles<'a>) -> Option<&'a ShownFile<'a>> {
    files
        .get(place.file)
        .filter(|(_, is_drawn)| *is_drawn)
        .map(|(file, _)| file)
}

/// Write the map of an expansion; files are named by path, columns count characters.
fn save_map(expansion: &Expansion, written: &Written, path: &Path) -> std::io::Result<()> {
    let name = |file: &FileUse| vfs::slashed(&file.source.path);
    let map = source_map(expansion, written, Encoding::Utf32, name);
    let text = serde_json::to_string(&map)?;
    vfs::write_atomically(path, text.as_bytes())
}

/// What `--deps` prints: each name once, blanks between, no line feed.
fn deps(expansion: &Expansion) -> String {
    let mut names: Vec<&str> = Vec::new();
    for name in &expansion.includes {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    names.join(" ")
}

fn deliver(text: &str, options: &ExpandOptions, env: &Environment, io: &mut Io<'_>) -> u8 {
    let Some(output) = &options.output else {
        io.out(text);
        return 0;
    };
    let path: PathBuf = env.cwd.join(output);
    match vfs::write_atomically(&path, text.as_bytes()) {
        Ok(()) => 0,
        Err(error) => {
            io.line(&visible(&format!(
                "error: Failed to open output: {error}: '{output}'"
            )));
            2
        }
    }
}

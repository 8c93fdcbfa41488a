//! `xacro-lint format`.

use std::path::Path;
use std::sync::Arc;

use super::args::FormatArgs;
use super::check::warn_about_config;
use super::diff::unified;
use super::io::{Io, all_of};
use super::render::{shown_path, visible};
use super::text::counted;
use analysis::{CheckOptions, FixedFile, Session, Setup, apply};
use vfs::Environment;

/// What became of the files.
#[derive(Default)]
struct FormatCounts {
    changed: usize,
    same: usize,
    /// Files that could not be formatted.
    failed: usize,
}

/// Format files, or say which would change.
pub(super) fn run(args: &FormatArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let setup = Setup {
        about: args.paths.first().cloned().unwrap_or_default(),
        ..Setup::default()
    };
    let session = match Session::new(env, setup) {
        Ok(session) => session,
        Err(error) => return usage(io, &error.to_string()),
    };
    let is_input = args.paths.iter().any(|path| path == Path::new("-"));
    if is_input && let Err(error) = read_input(&session, io) {
        return usage(io, &format!("cannot read standard input: {error}"));
    }
    let options = CheckOptions {
        paths: args.paths.clone(),
        ..CheckOptions::default()
    };
    if let Some(missing) = args
        .paths
        .iter()
        .find(|path| session.vfs.text(path).is_err() && !is_dir(&session, path))
    {
        return usage(
            io,
            &format!("cannot read {}", visible(&vfs::slashed(missing))),
        );
    }
    let mut done = FormatCounts::default();
    for path in analysis::files_to_check(&session, &options)
        .into_iter()
        .filter(|path| !session.settings(path).excludes(path))
    {
        one(args, &session, &path, env, io, &mut done);
    }
    let code = warn_about_config(&session, env, io);
    if !is_input {
        io.line(&summary(args, &done));
    }
    match done {
        _ if code > 0 => code,
        FormatCounts { failed: 1.., .. } => 2,
        FormatCounts { changed: 1.., .. } if args.check || args.diff => 1,
        _ => 0,
    }
}

fn usage(io: &mut Io<'_>, message: &str) -> u8 {
    io.line(&format!("error: {}", visible(message)));
    2
}

fn is_dir(session: &Session, path: &Path) -> bool {
    session.vfs.is_dir(path)
}

/// Put standard input in the place of a file.
fn read_input(session: &Session, io: &mut Io<'_>) -> std::io::Result<()> {
    session
        .vfs
        .set_buffer(Path::new("-"), Some(all_of(io.stdin)?));
    Ok(())
}

/// Format one file.
fn one(
    args: &FormatArgs,
    session: &Session,
    path: &Path,
    env: &Environment,
    io: &mut Io<'_>,
    done: &mut FormatCounts,
) {
    let shown = visible(&shown_path(path, &env.cwd));
    let Ok(source) = session.vfs.document(path) else {
        done.failed += 1;
        return io.line(&format!("error: cannot read {shown}"));
    };
    let document = &source.document;
    if !document.errors().is_empty() {
        done.failed += 1;
        return io.line(&format!(
            "error: {shown} not formatted because of syntax errors"
        ));
    }
    let config = &session.settings(path).config.format;
    let edits = ide::format(document, &ide::indentation(document), config);
    let before = document.text();
    let after = apply(&before, &edits);
    let is_input = path.file_name().is_some_and(|name| name == "-");
    let (same, file) = (
        before == after,
        FixedFile {
            path: Arc::from(path),
            before,
            after,
        },
    );
    if args.diff {
        io.out(&unified(&file, &env.cwd, io.out_is_terminal));
    } else if args.check && !same {
        io.out(&format!("{shown}\n"));
    } else if is_input && !args.check {
        io.out(&file.after);
    } else if !same && let Err(error) = session.vfs.rewrite(path, &file.before, &file.after) {
        done.failed += 1;
        return io.line(&format!("error: cannot write {shown}: {error}"));
    }
    done.changed += usize::from(!same);
    done.same += usize::from(same);
}

fn summary(args: &FormatArgs, done: &FormatCounts) -> String {
    let verb = if args.check || args.diff {
        "would format"
    } else {
        "formatted"
    };
    match (done.changed, done.same) {
        (0, 0) => "warning: no xacro or URDF files found".to_owned(),
        (0, same) => format!("nothing to format in {}", counted(same, "file")),
        (changed, 0) => format!("{verb} {}", counted(changed, "file")),
        (changed, same) => format!("{verb} {}, {same} unchanged", counted(changed, "file")),
    }
}

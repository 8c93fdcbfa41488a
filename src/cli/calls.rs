//! `xacro-lint calls`.

use std::path::{Path, PathBuf};

use serde_json::json;

use super::args::{CallsArgs, Plain};
use super::check::warn_about_config;
use super::io::Io;
use super::render::{shown_path, visible, visible_name};
use analysis::{Session, Setup};
use base::counted;
use vfs::Environment;
use workspace::RobotCall;
use workspace::launch::{CallArgument, Why};

/// List the calls of robots: where they stand, the description, and the arguments as far as they are known.
pub(super) fn run(args: &CallsArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let package_path = args.package_path.iter().map(PathBuf::from).collect();
    let folders = std::path::absolute(&args.path)
        .ok()
        .filter(|path| path.is_dir());
    let folders = folders.into_iter().collect();
    let setup = Setup {
        about: args.path.clone(),
        folders,
        package_path,
        ..Setup::default()
    };
    let session = match Session::new(env, setup) {
        Ok(session) => session,
        Err(error) => {
            io.line(&format!("error: {error}"));
            return 2;
        }
    };
    warn_about_config(&session, env, io);
    if !session.vfs.exists(&args.path) {
        io.line(&format!(
            "error: {}: No such file or directory",
            visible(&vfs::slashed(&args.path))
        ));
        return 2;
    }
    let calls = session.robot_calls(&args.path);
    match args.format {
        Plain::Text => table(&calls, &session, &env.cwd, io),
        Plain::Json => {
            let list = calls.iter().map(|call| object(call, &session, &env.cwd));
            io.out(&format!("{:#}\n", serde_json::Value::Array(list.collect())));
        }
    }
    0
}

/// The first line and column of a call, from 1.
fn position(call: &RobotCall, session: &Session) -> (usize, usize) {
    let text = session.vfs.text(&call.call.caller);
    let before = text
        .as_ref()
        .ok()
        .and_then(|file| file.text.get(..call.call.range.start as usize));
    let before = before.unwrap_or("");
    let line = before.rsplit('\n').next().unwrap_or("");
    (before.matches('\n').count() + 1, line.chars().count() + 1)
}

fn description(call: &RobotCall, session: &Session, cwd: &Path) -> String {
    match &call.target {
        Some(path) if session.vfs.is_file(path) => shown_path(path, cwd),
        _ => call.call.file.shown(),
    }
}

fn table(calls: &[RobotCall], session: &Session, cwd: &Path, io: &mut Io<'_>) {
    for call in calls {
        let (line, column) = position(call, session);
        let caller = shown_path(&call.call.caller, cwd);
        let through = call
            .call
            .through
            .iter()
            .map(|path| format!(" from {}", shown_path(path, cwd)));
        let place = format!("{caller}:{line}:{column}{}", through.collect::<String>());
        let missing = call
            .target
            .as_ref()
            .is_some_and(|path| !session.vfs.is_file(path));
        let missing = if missing { " (not found)" } else { "" };
        io.out(&format!("{}\n", visible_name(&place)));
        io.out(&format!(
            "  {}{missing}\n",
            visible_name(&description(call, session, cwd))
        ));
        for argument in &call.call.args {
            io.out(&format!("    {}\n", visible_name(&shown(argument))));
        }
        if call.call.open {
            io.out("    further arguments are not known\n");
        }
    }
    let values: usize = calls.iter().map(|call| call.call.args.len()).sum();
    let known: usize = calls.iter().map(|call| call.call.known()).sum();
    let files = calls
        .iter()
        .map(|call| &call.call.caller)
        .collect::<std::collections::BTreeSet<_>>()
        .len();
    let summary = format!(
        "{} in {}; {known} of {} known",
        counted(calls.len(), "call"),
        counted(files, "file"),
        counted(values, "argument value"),
    );
    io.line(&format!("note: {summary}"));
}

/// An argument with its value, or why this is not known.
fn shown(argument: &CallArgument) -> String {
    let (name, value) = (&argument.name, argument.value.shown());
    match argument.value.why() {
        None => format!("{name}:={value}"),
        Some(why) => format!("{name}:={value}  ({})", reason(why)),
    }
}

fn reason(why: &Why) -> String {
    match why {
        Why::Computed => "computed".to_owned(),
        Why::Required(name) => format!("required argument `{name}` of the launch file"),
        Why::Decided(name) => format!("depends on a condition on `{name}`"),
    }
}

fn object(call: &RobotCall, session: &Session, cwd: &Path) -> serde_json::Value {
    let (line, column) = position(call, session);
    let arguments = call.call.args.iter().map(|argument| {
        let value = argument.value.is_known().then(|| argument.value.shown());
        let unknown = argument.value.why().map(reason);
        json!({"name": argument.name, "value": value, "unknown": unknown})
    });
    let through: Vec<String> = call
        .call
        .through
        .iter()
        .map(|path| shown_path(path, cwd))
        .collect();
    json!({
        "caller": shown_path(&call.call.caller, cwd),
        "line": line,
        "column": column,
        "through": through,
        "file": description(call, session, cwd),
        "found": call.target.as_ref().is_some_and(|path| session.vfs.is_file(path)),
        "arguments": arguments.collect::<Vec<_>>(),
        "complete": !call.call.open,
    })
}

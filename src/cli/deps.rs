//! `xacro-lint deps`.

use std::path::Path;

use serde_json::{Value, json};

use super::args::{DepsArgs, Plain};
use super::io::Io;
use super::render::{shown_path, visible};
use super::tree::ExpandedRobot;
use analysis::Session;
use expand::{Expansion, Read, Severity};
use vfs::Environment;

/// Print what an expansion depends on.
pub(super) fn run(args: &DepsArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let ExpandedRobot {
        file,
        session,
        expansion,
        ..
    } = match ExpandedRobot::of(&args.file, &args.package_path, env, io) {
        Ok(expanded) => expanded,
        Err(message) => {
            io.line(&format!("error: {}", visible(&message)));
            return 2;
        }
    };
    match args.format {
        Plain::Text => {
            for read in expansion.record.iter() {
                if let Read::File(path, _) = read {
                    io.out(&visible(&format!("{}\n", shown_path(path, &env.cwd))));
                }
            }
            let beside = if args.beside {
                analysis::files_beside(&session, Path::new(&file))
            } else {
                Vec::new()
            };
            for (path, _) in beside {
                io.out(&visible(&format!("{}\n", shown_path(&path, &env.cwd))));
            }
        }
        Plain::Json => {
            let mut found = everything(&expansion);
            if let Value::Object(entries) = &mut found {
                entries.insert("beside".to_owned(), beside(&session, &file));
            }
            io.out(&format!("{found:#}\n"));
        }
    }
    let errors = expansion
        .problems
        .iter()
        .filter(|p| p.severity == Severity::Error)
        .count();
    if errors > 0 {
        io.line(&format!(
            "warning: {errors} errors; the list may be incomplete (run `xacro-lint check`)"
        ));
    }
    u8::from(errors > 0)
}

/// The files beside a robot, for JSON.
pub(super) fn beside(session: &Session, file: &str) -> Value {
    let files = analysis::files_beside(session, Path::new(file)).into_iter();
    files
        .map(|(path, kind)| json!({"path": path, "kind": kind}))
        .collect()
}

fn everything(expansion: &Expansion) -> Value {
    let mut lists: [(&str, Vec<Value>); 6] = [
        "files",
        "missing",
        "globs",
        "packages",
        "environment",
        "arguments",
    ]
    .map(|name| (name, Vec::new()));
    let [
        (_, files),
        (_, missing),
        (_, globs),
        (_, packages),
        (_, variables),
        (_, arguments),
    ] = &mut lists;
    for read in expansion.record.iter() {
        match read {
            Read::File(path, _) => files.push(json!(path)),
            Read::Missing(path) => missing.push(json!(path)),
            Read::Glob(pattern, found) => globs.push(json!({"pattern": pattern, "files": found})),
            Read::Package(name, path) => packages.push(json!({"name": name, "path": path})),
            Read::Env(name, value) => variables.push(json!({"name": name, "value": value})),
            Read::Arg(name, value) => arguments.push(json!({"name": name, "value": value})),
        }
    }
    Value::Object(
        lists
            .into_iter()
            .map(|(name, list)| (name.to_owned(), Value::Array(list)))
            .collect(),
    )
}

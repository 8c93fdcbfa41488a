//! `xacro-lint packages`.

use std::path::{Path, PathBuf};

use serde_json::json;

use super::args::{PackagesArgs, Plain};
use super::check::warn_about_config;
use super::io::Io;
use super::render::{shown_path, visible, visible_name};
use analysis::{Session, Setup};
use packages::PackageEntry;
use vfs::Environment;

/// Print the packages that can be found, with the step of the look-up that gave each.
pub(super) fn run(args: &PackagesArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let package_path = args.package_path.iter().map(PathBuf::from).collect();
    let setup = Setup {
        about: args.from.clone(),
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
    let vfs = &session.vfs;
    if !vfs.exists(&args.from) {
        io.line(&format!(
            "error: {}: No such file or directory",
            visible(&vfs::slashed(&args.from))
        ));
        return 2;
    }
    // the look-up starts from a file
    let from = if vfs.is_dir(&args.from) {
        args.from.join("_")
    } else {
        args.from.clone()
    };
    let entries = session.packages.all(&from);
    match args.format {
        Plain::Text => table(&entries, &env.cwd, io),
        Plain::Json => {
            let list: Vec<_> = entries
                .iter()
                .map(|entry| {
                    let (path, step) = (vfs::slashed(&entry.path), entry.step.to_string());
                    json!({"name": entry.name, "path": path, "step": step, "shadowed": entry.shadowed})
                })
                .collect();
            io.out(&format!("{:#}\n", serde_json::Value::Array(list)));
        }
    }
    0
}

fn table(entries: &[PackageEntry], cwd: &Path, io: &mut Io<'_>) {
    let (mut names, mut steps) = (0, 0);
    for entry in entries {
        names = names.max(entry.name.chars().count());
        steps = steps.max(entry.step.to_string().chars().count());
    }
    for entry in entries {
        let path = shown_path(&entry.path, cwd);
        let path = if path.is_empty() { "." } else { &path };
        let shadowed = if entry.shadowed { "  (shadowed)" } else { "" };
        let step = entry.step.to_string();
        let line = format!("{:names$}  {step:steps$}  {path}{shadowed}", entry.name);
        io.out(&format!("{}\n", visible_name(&line)));
    }
}

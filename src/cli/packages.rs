//! `xacro-lint packages`.

use std::path::Path;
use std::sync::Arc;

use serde_json::json;

use super::args::{PackagesArgs, Plain};
use super::check::MAX_FILE_BYTES;
use super::expand::package_options;
use super::io::Io;
use super::render::{shown_path, visible};
use crate::vfs::{Environment, Vfs};
use crate::workspace::{Entry, Packages};

/// Print the packages that can be found, with the step of the look-up that gave each.
pub(super) fn run(args: &PackagesArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let vfs = Arc::new(Vfs::with_cwd(MAX_FILE_BYTES, env.cwd.clone()));
    let packages = Packages::new(vfs.clone(), env, package_options(&args.package_path, env, false));
    if !vfs.exists(&args.from) {
        io.line(&format!("error: {}: No such file or directory", visible(&args.from.to_string_lossy())));
        return 2;
    }
    // the look-up starts from a file
    let from = if vfs.is_dir(&args.from) { args.from.join("_") } else { args.from.clone() };
    let entries = packages.all(&from);
    match args.format {
        Plain::Text => table(&entries, &env.cwd, io),
        Plain::Json => {
            let list: Vec<_> = entries
                .iter()
                .map(|entry| {
                    let (path, step) = (entry.path.to_string_lossy(), entry.step.to_string());
                    json!({"name": entry.name, "path": path, "step": step, "shadowed": entry.shadowed})
                })
                .collect();
            io.out(&format!("{:#}\n", serde_json::Value::Array(list)));
        }
    }
    0
}

fn table(entries: &[Entry], cwd: &Path, io: &mut Io<'_>) {
    let width =
        |text: &dyn Fn(&Entry) -> String| entries.iter().map(|e| text(e).chars().count()).max().unwrap_or(0);
    let names = width(&|entry| entry.name.clone());
    let steps = width(&|entry| entry.step.to_string());
    for entry in entries {
        let path = shown_path(&entry.path, cwd);
        let path = if path.is_empty() { "." } else { &path };
        let shadowed = if entry.shadowed { "  (shadowed)" } else { "" };
        let step = entry.step.to_string();
        io.out(&visible(&format!("{:names$}  {step:steps$}  {path}{shadowed}\n", entry.name)));
    }
}

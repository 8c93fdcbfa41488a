//! The calls of robots below a folder: those of each launch file by itself, and those under the arguments that other launch
//! files include it with.

use std::path::{Path, PathBuf};

use base::FastMap;
use base::limits::{CALLER_CALLS, LAUNCH_INCLUDES};

use super::{Callers, GivenArg, Uses, search};
use crate::Packages;
use crate::config::Axes;
use crate::launch::{self, Call, Context, LaunchFile, Word, calls_in, included};
use std::sync::Arc;

/// A call, and the description that it names.
#[derive(Clone, Debug)]
pub struct RobotCall {
    /// What the launch file says.
    pub call: Call,
    /// The description, whether or not it is there; none where the name or the package is not known.
    pub target: Option<PathBuf>,
}

impl Callers {
    /// All calls in the sources around a file, in the order of the paths of the files that call.
    pub fn calls(&self, file: &Path, packages: &Packages) -> Arc<Vec<RobotCall>> {
        let Some(top) = packages.sources_around(file) else { return Arc::default() };
        self.calls_below(&top, packages)
    }

    /// All calls below a folder.
    pub fn calls_below(&self, top: &Path, packages: &Packages) -> Arc<Vec<RobotCall>> {
        let uses = self.below.get(top.to_owned(), || Arc::new(search(&packages.vfs, top)));
        self.called.get(top.to_owned(), || Arc::new(all(&uses, packages)))
    }
}

impl Callers {
    /// The arguments of each call of the description `file` whose launch file names it somehow, also through other launch files.
    pub fn given(&self, file: &Path, packages: &Packages) -> Vec<Vec<GivenArg>> {
        let all = self.calls(file, packages);
        let calls = all.iter().filter(|call| call.target.as_deref() == Some(file));
        let given = |RobotCall { call, .. }: &RobotCall| {
            let args = call.args.iter().map(|argument| GivenArg {
                name: argument.name.clone(),
                value: argument.value.value(packages, &call.caller),
            });
            args.collect()
        };
        calls.map(given).collect()
    }

    /// The arguments of the description `file` that launch files pass on from an argument of theirs with declared choices,
    /// with the values that these choices give.
    pub fn choices(&self, file: &Path, packages: &Packages) -> Axes {
        let mut axes = Axes::new();
        let mut launch_files: Vec<PathBuf> = Vec::new();
        for call in self.calls(file, packages).iter().filter(|call| call.target.as_deref() == Some(file)) {
            if !launch_files.contains(&call.call.caller) {
                launch_files.push(call.call.caller.clone());
            }
        }
        let read = |path: &PathBuf| launch::read(path, &packages.vfs.text(path).ok()?.text);
        for launch_file in launch_files.iter().filter_map(read) {
            let mut calls = 0;
            for declared in &launch_file.declared {
                let Some(choices) = &declared.choices else { continue };
                for choice in choices {
                    calls += 1;
                    if calls > CALLER_CALLS {
                        return axes;
                    }
                    let value = (declared.name.clone(), Word::plain(choice));
                    let context = Context { values: vec![value], ..Context::default() };
                    add_chosen(&mut axes, &launch_file, &declared.name, &context, |call| {
                        target(call, packages).as_deref() == Some(file)
                    });
                }
            }
        }
        axes
    }
}

/// Add the values of the arguments that depend on the argument `name` of a launch file, which has a value in `context`.
fn add_chosen(
    axes: &mut Axes,
    launch_file: &LaunchFile,
    name: &str,
    context: &Context,
    is_meant: impl Fn(&Call) -> bool,
) {
    const OTHER: &str = "\u{fffd}";
    let other = Context { values: vec![(name.to_owned(), Word::plain(OTHER))], ..Context::default() };
    let others = calls_in(launch_file, &other);
    for call in calls_in(launch_file, context).iter().filter(|call| is_meant(call)) {
        let same = others.iter().find(|other| other.range == call.range);
        for argument in &call.args {
            let depends = same.and_then(|same| same.args.iter().find(|own| own.name == argument.name));
            let depends = depends.is_some_and(|own| own.value.shown().contains(OTHER));
            let Some(value) = argument.value.literal().filter(|_| depends) else { continue };
            match axes.iter_mut().find(|(known, _)| *known == argument.name) {
                Some((_, values)) if values.contains(&value) => {}
                Some((_, values)) => values.push(value),
                None => axes.push((argument.name.clone(), vec![value])),
            }
        }
    }
}

/// The calls of all launch files, and of those again that others include with further arguments.
fn all(uses: &Uses, packages: &Packages) -> Vec<RobotCall> {
    let read = |path: &PathBuf| launch::read(path, &packages.vfs.text(path).ok()?.text);
    let files: Vec<LaunchFile> = uses.scripts.iter().filter_map(read).collect();
    let by_path: FastMap<&Path, &LaunchFile> = files.iter().map(|file| (file.path.as_path(), file)).collect();
    let mut found: Vec<Call> = Vec::new();
    for file in &files {
        found.extend(calls_in(file, &Context::default()));
    }
    for file in &files {
        through(file, &Context::default(), &by_path, packages, &mut found);
    }
    found.truncate(CALLER_CALLS);
    found.sort_by(|a, b| (&a.caller, a.range.start, &a.through).cmp(&(&b.caller, b.range.start, &b.through)));
    found.into_iter().map(|call| RobotCall { target: target(&call, packages), call }).collect()
}

/// The calls of the files that a launch file includes.
fn through(
    file: &LaunchFile,
    context: &Context,
    by_path: &FastMap<&Path, &LaunchFile>,
    packages: &Packages,
    found: &mut Vec<Call>,
) {
    if context.through.len() >= LAUNCH_INCLUDES || found.len() > CALLER_CALLS {
        return;
    }
    for (name, context) in included(file, context) {
        let Some(path) = name.path(packages, &file.path) else { continue };
        let path = packages.present(&path).into_owned();
        let Some(inner) = by_path.get(path.as_path()).filter(|inner| !context.through.contains(&inner.path))
        else {
            continue;
        };
        for call in calls_in(inner, &context) {
            if !found.iter().any(|known| known.caller == call.caller && known.is_same(&call)) {
                found.push(call);
            }
        }
        through(inner, &context, by_path, packages, found);
    }
}

/// The description that a call names, as it is in the source tree.
fn target(call: &Call, packages: &Packages) -> Option<PathBuf> {
    let path = call.file.path(packages, &call.caller)?;
    Some(packages.present(&path).into_owned())
}

//! What launch files declare that their arguments may be, and which values they give that are not among these.

use std::path::PathBuf;

use base::limits::CALLER_CALLS;
use base::{FastMap, TextRange};

use super::Callers;
use super::called::target;
use crate::config::Axes;
use crate::launch::{
    self, CommandWord, LaunchCall, LaunchContext, LaunchFile, calls_in, values_given,
};
use packages::Packages;
use std::path::Path;
use std::sync::Arc;

/// A value that the choices of an argument of a launch file rule out.
#[derive(Clone, Debug)]
pub struct Excluded {
    /// The file that gives it.
    pub giver: PathBuf,
    /// What gives it: a declaration or an include.
    pub range: TextRange,
    /// The name of the argument.
    pub name: String,
    /// A value that is none of its choices.
    pub value: String,
    /// The values that it may have.
    pub choices: Vec<String>,
}

impl Callers {
    /// The arguments of the description `file` that launch files pass on from an argument of theirs with declared choices,
    /// with the values that these choices give.
    pub fn choices(&self, file: &Path) -> Axes {
        let mut axes = Axes::new();
        let mut launch_files: Vec<PathBuf> = Vec::new();
        for call in self
            .calls(file)
            .iter()
            .filter(|call| call.target.as_deref() == Some(file))
        {
            if !launch_files.contains(&call.call.caller) {
                launch_files.push(call.call.caller.clone());
            }
        }
        let read = |path: &PathBuf| launch::read(path, &self.packages.vfs().text(path).ok()?.text);
        for launch_file in launch_files.iter().filter_map(read) {
            let mut calls = 0;
            for declared in &launch_file.declared {
                let Some(choices) = &declared.choices else {
                    continue;
                };
                for choice in choices {
                    calls += 1;
                    if calls > CALLER_CALLS {
                        return axes;
                    }
                    let value = (declared.name.clone(), CommandWord::plain(choice));
                    let context = LaunchContext {
                        values: vec![value],
                        ..LaunchContext::default()
                    };
                    add_chosen(&mut axes, &launch_file, &declared.name, &context, |call| {
                        target(call, &self.packages).as_deref() == Some(file)
                    });
                }
            }
        }
        axes
    }

    /// The values below a folder that launch files give to arguments, their own or those of files that they include, and that
    /// the choices there rule out.
    pub fn excluded_values(&self, top: &Path) -> Arc<Vec<Excluded>> {
        self.called_below(top).excluded.clone()
    }
}

/// The values that launch files give and that choices rule out.
pub(super) fn excluded(
    files: &[LaunchFile],
    by_path: &FastMap<&Path, &LaunchFile>,
    packages: &Packages,
) -> Vec<Excluded> {
    let mut found = Vec::new();
    for file in files {
        for given in values_given(file) {
            let path = || {
                given
                    .to
                    .as_ref()
                    .and_then(|name| name.path(packages, &file.path))
            };
            let to = match &given.to {
                None => Some(file),
                Some(_) => {
                    path().and_then(|path| by_path.get(packages.present(&path).as_ref()).copied())
                }
            };
            let Some(choices) = to.and_then(|to| to.choices_of(&given.name)) else {
                continue;
            };
            if !choices.contains(&given.value) {
                let (giver, range) = (file.path.clone(), given.range);
                found.push(Excluded {
                    giver,
                    range,
                    name: given.name,
                    value: given.value,
                    choices,
                });
            }
        }
    }
    found
}

/// Add the values of the arguments that depend on the argument `name` of a launch file, which has a value in `context`.
fn add_chosen(
    axes: &mut Axes,
    launch_file: &LaunchFile,
    name: &str,
    context: &LaunchContext,
    is_meant: impl Fn(&LaunchCall) -> bool,
) {
    const OTHER: &str = "\u{fffd}";
    let other = LaunchContext {
        values: vec![(name.to_owned(), CommandWord::plain(OTHER))],
        ..LaunchContext::default()
    };
    let others = calls_in(launch_file, &other);
    for call in calls_in(launch_file, context)
        .iter()
        .filter(|call| is_meant(call))
    {
        let same = others.iter().find(|other| other.range == call.range);
        for argument in &call.args {
            let depends =
                same.and_then(|same| same.args.iter().find(|own| own.name == argument.name));
            let depends = depends.is_some_and(|own| own.value.shown().contains(OTHER));
            let Some(value) = argument.value.literal().filter(|_| depends) else {
                continue;
            };
            match axes.iter_mut().find(|(known, _)| *known == argument.name) {
                Some((_, values)) if values.contains(&value) => {}
                Some((_, values)) => values.push(value),
                None => axes.push((argument.name.clone(), vec![value])),
            }
        }
    }
}

//! Which files are expanded, and with which arguments.
use std::path::Path;

use super::check_task::{CheckReason, CheckTask};
use workspace::Callers;
use workspace::config::{Axes, Root, Variant};

/// The runs of one file of a configured root.
pub(super) fn variants(callers: &Callers, root: &Root, file: &Path) -> Vec<Variant> {
    root.variants(&choices(callers, root, file))
}

/// The arguments that a root takes from launch files, with their values.
pub(super) fn choices(callers: &Callers, root: &Root, file: &Path) -> Axes {
    if root.launch_choices {
        callers.choices(file)
    } else {
        Axes::new()
    }
}

/// The expansions of one file of a configured root; `args` go over all others.
pub(super) fn tasks_of(
    callers: &Callers,
    root: &Root,
    file: &Path,
    args: &[(String, String)],
) -> Vec<CheckTask> {
    let task = |variant: Variant| {
        let args = variant
            .args
            .into_iter()
            .chain(args.iter().cloned())
            .collect();
        CheckTask {
            preset: variant.preset,
            ..CheckTask::new(file.to_path_buf(), CheckReason::Root, args)
        }
    };
    variants(callers, root, file)
        .into_iter()
        .map(task)
        .collect()
}

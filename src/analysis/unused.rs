//! What is wrong in files that nothing in a workspace uses: in repositories of others that were copied into it, and in settings of
//! controllers.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::beside::{
    Sort, beside_around, beside_settings, is_for_manager, is_in_launched, is_named_as_launched,
    is_one_of_several, is_settings, sort,
};
use super::check_task::CheckReason;
use super::includers::{is_for_tests, is_unused_copy};
use super::options::CheckOptions;
use super::root_result::RootResult;
use super::session::Session;
use super::texts::says;
use super::uses::is_named_in_use;
use super::walk::is_launch;
use base::{FastMap, FastSet, FileId};
use project::{Controller, YamlSettings};
use rules::{Finding, Severity, Trait, named};
use workspace::has_name;

/// What a launch file has that loads settings of MoveIt or of controllers.
const LOADS: [&str; 4] = [
    ".srdf",
    ".yaml",
    "MoveItConfigsBuilder",
    "robot_description_semantic",
];

/// The files that were read for robots which this workspace uses; none when nothing in it was copied from others. What is
/// wrong in the other robots are infos.
pub(super) fn read_for_used(
    session: &Session,
    options: &CheckOptions,
    results: &mut [RootResult],
) -> Option<FastSet<PathBuf>> {
    let folders = options.paths.iter().map(|path| session.vfs.absolute(path));
    let has_copies = |folder: PathBuf| {
        session.vfs.is_dir(&folder) && session.callers.has_copies(&folder.join("_"))
    };
    // an editor asks about the files that it shows
    if !options.entries.is_empty() || !folders.into_iter().any(has_copies) {
        return None;
    }
    let asked = asked(session, options);
    let mut used = FastSet::default();
    for result in results {
        if result.task.reason == CheckReason::Walked && is_other(session, &result.task.file, &asked)
        {
            for finding in &mut result.findings {
                finding.severity = finding.severity.min(Severity::Info);
            }
            continue;
        }
        used.insert(result.task.file.clone());
        used.extend(result.reads.iter().cloned());
    }
    Some(used)
}

/// Whether a file belongs to a repository of others that nothing in the workspace leads to, and that nobody asks for.
fn is_other(session: &Session, file: &Path, asked: &[PathBuf]) -> bool {
    // settings are found by names that are put together
    let is_unused = |file: &Path| {
        if sort(file).is_some() {
            session.callers.is_in_unused_package(file)
        } else {
            is_unused_copy(session, file)
        }
    };
    session
        .callers
        .copied_with(file)
        .is_some_and(|copy| !asked.iter().any(|path| path.starts_with(&copy)))
        && is_unused(file)
}

/// What is wrong in settings of controllers is an info where no text names the file, and others name such a file of the same
/// package; in an SRDF, where nothing reads it, or only tests do. Not when somebody asks for the file.
pub(super) fn settle_settings(
    session: &Session,
    options: &CheckOptions,
    findings: &mut Vec<Finding>,
) {
    findings.retain(|finding| {
        finding.rule != named::CONTROLLER_WITHOUT_PARAMETERS || !is_spawned_with(session, finding)
    });
    if !options.entries.is_empty() {
        return;
    }
    let asked: FastSet<PathBuf> = options
        .paths
        .iter()
        .map(|path| session.vfs.absolute(path))
        .collect();
    lower_in(session, findings, |file| {
        let is_idle = || {
            is_left_behind(session, file)
                || is_unread(session, file)
                || sort(file) == Some(Sort::Srdf) && session.callers.read_srdf_without_moveit(file)
                || is_for_tests(session, file)
                || is_outside_the_build(session, file)
        };
        !asked.contains(file) && is_idle()
    });
    for finding in findings
        .iter_mut()
        .filter(|finding| finding.severity > Severity::Info)
    {
        let file = session.vfs.path(finding.span.file);
        let is_about_controller = finding.rule.has(Trait::Controller)
            || finding.rule == named::CONTROLLER_WITHOUT_PARAMETERS;
        let is_idle = if is_about_controller {
            is_never_started(session, &file, finding) || is_without_hardware(session, &file)
        } else if finding.rule == named::KINEMATICS_UNKNOWN_GROUP {
            // MoveIt finds no file of another name by itself
            !file.ends_with("kinematics.yaml") && session.callers.leave_yaml_alone(&file)
        } else if finding.rule == named::MOVEIT_UNKNOWN_CONTROLLER {
            is_listed_elsewhere(session, &file, finding)
        } else if finding.rule == named::SRDF_ROBOT_NAME {
            is_named_as_launched(session, &file)
        } else {
            finding.rule == named::SRDF_UNKNOWN_LINK && is_in_launched(session, &file, finding)
        };
        if is_idle && !asked.contains(&*file) {
            finding.severity = Severity::Info;
        }
    }
}

/// Whether a launch file that names the controller of a finding gives a spawner a file of parameters.
fn is_spawned_with(session: &Session, finding: &Finding) -> bool {
    const FILES: [&str; 4] = ["--param-file", "'-p'", "\"-p\"", " -p "];
    let file = session.vfs.path(finding.span.file);
    let name = finding.message.split('`').nth(1).unwrap_or_default();
    let gives = |path: &PathBuf| {
        session.vfs.text(path).is_ok_and(|text| {
            has_name(&text.text, name) && FILES.iter().any(|word| text.text.contains(word))
        })
    };
    session.callers.starters(&file).iter().any(gives)
}

/// Whether a finding is about a controller that nothing starts, while others of the same file are started by their names.
fn is_never_started(session: &Session, file: &Path, finding: &Finding) -> bool {
    let Some(settings) = beside_settings(session, file) else {
        return false;
    };
    let is_before =
        |controller: &&Controller| controller.name.range.start <= finding.span.range.start;
    let own = settings
        .controllers
        .iter()
        .filter(is_before)
        .max_by_key(|one| one.name.range.start);
    let own = if finding.rule == named::CONTROLLER_WITHOUT_PARAMETERS {
        // the file holds nothing of it but its name in a list
        finding.message.split('`').nth(1)
    } else {
        own.map(|own| own.name.name.as_str())
    };
    let Some(own) = own else {
        return false;
    };
    let mut starters = session.callers.starters(file);
    let name = |path: &Path| path.file_name()?.to_str().map(str::to_owned);
    let names_it = |path: &PathBuf| name(file).is_some_and(|name| says(&session.vfs, path, &name));
    if is_one_of_several(session, file) {
        // files of one name are told apart by their folders
        let folder = file.parent().and_then(name);
        starters.retain(|path| {
            names_it(path)
                && folder
                    .as_ref()
                    .is_none_or(|name| says(&session.vfs, path, name))
        });
    } else if starters.iter().any(names_it) {
        // another controller manager may have a controller of that name
        starters.retain(names_it);
    }
    !any_says(session, &starters, own)
        && settings
            .controllers
            .iter()
            .any(|other| any_says(session, &starters, &other.name.name))
}

/// Whether nothing loads settings for ROS 2, and no description of their package has hardware for controllers.
fn is_without_hardware(session: &Session, file: &Path) -> bool {
    let package = session
        .packages
        .containing(file)
        .map(|package| package.folder);
    let Some(folder) = package.filter(|_| session.packages.is_for_ament(file)) else {
        return false;
    };
    let all = session.callers.descriptions(file);
    let mut own = all.iter().filter(|other| other.starts_with(&folder));
    session.callers.leave_yaml_alone(file)
        && !own.any(|robot| says(&session.vfs, robot, "ros2_control"))
}

fn any_says(session: &Session, files: &[PathBuf], name: &str) -> bool {
    files.iter().any(|path| says(&session.vfs, path, name))
}

/// Whether another file of the workspace lists the controller that a finding is about: it is for another controller manager.
fn is_listed_elsewhere(session: &Session, file: &Path, finding: &Finding) -> bool {
    let text = session.vfs.text(file);
    let name = text
        .map(|text| finding.span.range.slice(&text.text).to_owned())
        .unwrap_or_default();
    let name = name
        .rsplit('/')
        .next()
        .unwrap_or_default()
        .trim_matches(['"', '\''])
        .to_owned();
    let around = beside_around(session, file);
    let lists = |other: &PathBuf| {
        let settings = beside_settings(session, other);
        settings.is_some_and(|settings| settings.listed.iter().any(|one| one.name.name == name))
    };
    around
        .iter()
        .filter(|other| *other != file && is_settings(other))
        .any(lists)
}

/// Whether launch files load robots beside an SRDF, and no text says anything of it.
fn is_unread(session: &Session, file: &Path) -> bool {
    let package = session
        .packages
        .containing(file)
        .map(|package| package.folder);
    // what the setup assistant of MoveIt writes is found by its name
    let is_plain =
        package.is_some_and(|folder| !session.vfs.is_file(&folder.join(".setup_assistant")));
    sort(file) == Some(Sort::Srdf)
        && is_plain
        && session.callers.leave_srdf_alone(file)
        && session.callers.load_another(file)
}

/// Whether nobody names a file of a package that is not built, or of one for ROS 2 whose launch files are all for ROS 1.
fn is_outside_the_build(session: &Session, file: &Path) -> bool {
    let is_idle = || session.packages.is_never_built(file) || is_launched_by_ros1(session, file);
    is_idle() && !is_named_in_use(session, file)
}

/// Whether a package of the setup assistant is for ROS 2, launch files for ROS 1 would read its settings, and nothing else does.
fn is_launched_by_ros1(session: &Session, file: &Path) -> bool {
    let package = session.packages.containing(file);
    let Some(folder) = package.map(|package| package.folder) else {
        return false;
    };
    // elsewhere a program may find settings by a name that it computes
    if !session.vfs.is_file(&folder.join(".setup_assistant")) {
        return false;
    }
    let launches = folder.join("launch");
    let all = session.vfs.list_dir(&launches);
    let files = all.iter().map(|entry| launches.join(&entry.name));
    let (old, new): (Vec<PathBuf>, Vec<PathBuf>) = files
        .filter(|path| is_launch(path))
        .partition(|path| session.callers.is_launch_of_ros1(path));
    // a program may compute the name
    let may_load = |path: &PathBuf| {
        session
            .packages
            .is_text(path, |text| LOADS.iter().any(|word| text.contains(word)))
    };
    !old.is_empty() && !new.iter().any(may_load) && !session.callers.build_package_for_moveit(file)
}

/// Whether a file lists controllers or configures them and no text names it, while texts name another one of its package.
fn is_left_behind(session: &Session, file: &Path) -> bool {
    let folder = session
        .packages
        .containing(file)
        .map(|package| package.folder);
    // what the setup assistant of MoveIt writes is found by its name
    let folder = folder.filter(|folder| !session.vfs.is_file(&folder.join(".setup_assistant")));
    let Some(folder) = folder else {
        return false;
    };
    let holds = |settings: Arc<YamlSettings>| !settings.controllers.is_empty();
    let is_own = is_for_manager(session, file) || beside_settings(session, file).is_some_and(holds);
    if !is_own || session.callers.mention_file(file) {
        return false;
    }
    let around = beside_around(session, file);
    let mut others = around
        .iter()
        .filter(|other| *other != file && other.starts_with(&folder));
    others.any(|other| is_for_manager(session, other) && session.callers.mention_file(other))
}

/// What is wrong in such a repository is an info where nothing in the workspace leads to the file. Not when somebody asks for
/// a file or folder of that repository.
pub(super) fn settle_copies(
    session: &Session,
    options: &CheckOptions,
    used: &FastSet<PathBuf>,
    findings: &mut [Finding],
) {
    let asked = asked(session, options);
    let is_unused = |file: &Path| !used.contains(file) && is_other(session, file, &asked);
    lower_in(session, findings, is_unused);
}

/// Make infos of what is wrong in some files.
fn lower_in(session: &Session, findings: &mut [Finding], is_unused: impl Fn(&Path) -> bool) {
    let mut known: FastMap<FileId, bool> = FastMap::default();
    for finding in findings
        .iter_mut()
        .filter(|finding| finding.severity > Severity::Info)
    {
        let file = finding.span.file;
        if *known
            .entry(file)
            .or_insert_with(|| is_unused(&session.vfs.path(file)))
        {
            finding.severity = Severity::Info;
        }
    }
}

/// The files and folders that somebody asks for.
fn asked(session: &Session, options: &CheckOptions) -> Vec<PathBuf> {
    options
        .paths
        .iter()
        .map(|path| session.vfs.absolute(path))
        .collect()
}

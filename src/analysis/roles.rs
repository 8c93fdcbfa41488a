//! What a file is for: a robot of its own, or a part of others.
//!
//! Much of what is wrong in a file by itself is right in the file that includes it: names that are defined there, links
//! that are added there. So such findings are judged by the role of the file.
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use ecow::EcoString;

use super::check_task::{CheckReason, CheckTask};
use super::declared::KnownArguments;
use super::graph;
use super::includers::{included_around, includers, is_included};
use super::session::Session;
use base::FastSet;
use expand::{Expansion, Outside, ProblemKind};
use model::Robot;
use rules::{Finding, RootKind, Severity, is_plain_urdf, missing_robot_name, named, needs_names};

/// What a file is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// It is expanded by itself.
    Root,
    /// Other files include it, and nothing expands it by itself.
    Part,
    /// Nothing says so.
    Unknown,
}

/// What becomes of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FindingAction {
    Keep,
    /// It has another severity.
    Set(Severity),
    /// It may be right elsewhere: worth a note, once in a file.
    Note,
    Drop,
}

/// An expansion of a file that was checked.
pub(super) struct CheckedExpansion<'a> {
    pub(super) task: &'a CheckTask,
    pub(super) kind: RootKind,
    pub(super) expansion: &'a Expansion,
    pub(super) robot: Option<&'a Robot>,
}

/// Of findings that hold only as long as a file stands alone, keep what is true in its role.
pub(super) fn settle_by_role(
    session: &Session,
    checked: &CheckedExpansion<'_>,
    findings: &mut Vec<Finding>,
) {
    if !findings.iter().any(depends_on_role) {
        return;
    }
    let role = role(session, checked, findings);
    let is_alone = checked.task.reason == CheckReason::Alone;
    let mut noted = FastSet::default();
    findings.retain_mut(|finding| match verdict(role, finding) {
        // what has no value here: the answer to whether the file works
        FindingAction::Note if is_alone && finding.outside == Some(Outside::Environment) => true,
        FindingAction::Keep
            if role == Role::Root && may_get_elsewhere(session, checked.task, finding) =>
        {
            finding.severity = finding.severity.min(Severity::Info);
            noted.insert((
                finding.rule.code,
                finding.span.file,
                finding.message.clone(),
            ))
        }
        FindingAction::Keep => true,
        FindingAction::Drop => false,
        FindingAction::Set(severity) => {
            finding.severity = finding.severity.min(severity);
            true
        }
        FindingAction::Note => {
            finding.severity = finding.severity.min(Severity::Info);
            noted.insert((
                finding.rule.code,
                finding.span.file,
                finding.message.clone(),
            ))
        }
    });
}

/// What to report of a file that is a robot but for its name: it gives one tree, which is of more than one link unless the
/// file is checked by itself, and nothing includes it.
pub(super) fn nameless(session: &Session, checked: &CheckedExpansion<'_>) -> Option<Finding> {
    let CheckedExpansion {
        task,
        kind,
        expansion,
        robot,
    } = *checked;
    let robot = robot.filter(|robot| kind == RootKind::Library && robot.lacks_only_a_name())?;
    let is_tree = (!robot.joints.is_empty() || task.reason == CheckReason::Alone)
        && robot.names_are_known()
        && above_fragment(robot).is_none()
        && robot.kinematics().roots(robot).len() == 1;
    let is_open = !expansion.whole || !is_tree || is_included(session, &task.file);
    if is_open {
        None
    } else {
        missing_robot_name(expansion, robot)
    }
}

fn role(session: &Session, checked: &CheckedExpansion<'_>, findings: &[Finding]) -> Role {
    match role_by_itself(session, checked, findings) {
        Role::Root
            if checked.task.reason == CheckReason::Walked
                && is_for_another(session, &checked.task.file) =>
        {
            Role::Part
        }
        role => role,
    }
}

/// The role of a file, whatever launch files give to other robots.
fn role_by_itself(session: &Session, checked: &CheckedExpansion<'_>, findings: &[Finding]) -> Role {
    let CheckedExpansion {
        task,
        kind,
        expansion,
        robot,
    } = *checked;
    if task.reason == CheckReason::Root {
        return Role::Root;
    }
    let document = expansion.files.first().map(|file| &file.source.document);
    let gives_robot = kind == RootKind::Robot || document.is_some_and(graph::gives_robot);
    if is_included(session, &task.file) {
        return if gives_robot && session.callers.name(&task.file) {
            Role::Root
        } else {
            Role::Part
        };
    }
    if task.reason == CheckReason::Alone {
        return Role::Root;
    }
    // a file in xacro without content is one that somebody has yet to write
    if !is_plain_urdf(&task.file)
        && robot.is_some_and(|robot| robot.links.is_empty() && robot.joints.is_empty())
        && !document.is_some_and(graph::gives_robot)
        && !session.callers.name(&task.file)
    {
        return Role::Unknown;
    }
    let missing = robot.and_then(above_fragment);
    // whoever names the file together with the link attaches it there
    let is_whole = |link: &EcoString| {
        has_misspelled_link(findings)
            || session.callers.name(&task.file) && !session.callers.mention(&task.file, link)
    };
    if gives_robot && missing.is_none_or(is_whole) {
        Role::Root
    } else {
        Role::Unknown
    }
}

/// Whether what a robot lacks may come from somewhere else: nobody in the workspace names the file, and it is of a
/// package, so that others may give its arguments, or other files define the property that it reads.
fn may_get_elsewhere(session: &Session, task: &CheckTask, finding: &Finding) -> bool {
    if matches!(task.reason, CheckReason::Root | CheckReason::Alone) || finding.fix.is_some() {
        return false;
    }
    let name = || {
        let source = session.vfs.document(&session.vfs.path(finding.span.file));
        source.map(|source| source.document.slice(finding.span.range))
    };
    let is_undefined_arg = finding.problem == Some(ProblemKind::UndefinedArg);
    if is_undefined_arg && name().is_ok_and(|name| is_key_beside(session, &task.file, &name)) {
        return true;
    }
    let is_open = match (&finding.outside, finding.problem) {
        (Some(Outside::Argument(_)), Some(ProblemKind::UndefinedArg)) => {
            session.packages.containing(&task.file).is_some()
        }
        (Some(Outside::Includer), Some(ProblemKind::UndefinedProperty)) => {
            name().is_ok_and(|name| {
                included_around(session, &task.file).is_some_and(|all| all.defines(&name))
            })
        }
        _ => false,
    };
    // a table of files in a page leaves nothing out
    is_open
        && match finding.problem {
            Some(ProblemKind::UndefinedArg) => {
                !session.callers.load(&task.file) && !session.callers.tell_to_use(&task.file)
            }
            // who only writes of a file does not expand it
            _ => {
                !session.callers.name(&task.file)
                    || !is_expanded(session, &task.file)
                        && name().is_ok_and(|name| is_defined_above(session, &task.file, &name))
            }
        }
}

/// Whether a YAML file of its package has a key of that name, beside keys with the names of other arguments of the robot: a program
/// reads it for xacro.
fn is_key_beside(session: &Session, file: &Path, name: &str) -> bool {
    /// With fewer other arguments, the key may be about anything.
    const OTHERS: usize = 2;
    let Some(package) = session.packages.containing(file) else {
        return false;
    };
    let keys = |text: &str| -> FastSet<String> {
        let keys = text.lines().filter_map(|line| line.split_once(':'));
        keys.map(|(key, _)| key.trim_start_matches([' ', '-']).trim_end().to_owned())
            .collect()
    };
    let known = KnownArguments::of(session, file).names;
    let has_keys = |text: &str| {
        let keys = keys(text);
        let others = known
            .iter()
            .filter(|other| *other != name && keys.contains(other.as_str()));
        keys.contains(name) && others.count() >= OTHERS
    };
    let around = session.callers.beside(file);
    let mut own = around.iter().filter(|path| {
        let ending = path.extension().and_then(OsStr::to_str);
        path.starts_with(&package.folder) && matches!(ending, Some("yaml" | "yml"))
    });
    own.any(|path| session.packages.is_text(path, has_keys))
}

/// Whether a launch file expands a file by itself.
fn is_called(session: &Session, file: &Path) -> bool {
    let calls = session.callers.calls(file);
    calls
        .iter()
        .any(|call| call.target.as_deref() == Some(file))
}

/// Whether a text runs xacro on a file by itself.
fn is_expanded(session: &Session, file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    is_called(session, file) || session.callers.quote(file, &format!("xacro {name}"))
}

/// Whether a file that includes this one, whatever the condition around the include, defines a property.
fn is_defined_above(session: &Session, file: &Path, name: &str) -> bool {
    let mut open = includers(session, file);
    let mut seen: FastSet<PathBuf> = FastSet::default();
    while let Some(file) = open.pop() {
        let defines = session.vfs.document(&file).is_ok_and(|source| {
            let nodes = source
                .document
                .parts()
                .flat_map(|(_, item)| item.all_nodes());
            let mut properties = nodes.filter(|node| node.name() == "xacro:property");
            properties.any(|node| node.attr("name").is_some_and(|own| own.raw() == name))
        });
        if defines {
            return true;
        }
        let above = includers(session, &file);
        if seen.insert(file) {
            open.extend(above.into_iter().filter(|file| !seen.contains(file)));
        }
    }
    false
}

/// Whether a launch file gives a file to another robot, which includes what it is given.
fn is_for_another(session: &Session, file: &Path) -> bool {
    if is_passed(session, file) {
        return true;
    }
    if is_called(session, file) {
        return false;
    }
    let included = included_around(session, file);
    let mut given = included.iter().flat_map(|all| all.given());
    given.any(|name| session.callers.quote(file, &format!("{name}:=")))
}

/// Whether a launch file gives a file to another robot, as the value of an argument.
fn is_passed(session: &Session, file: &Path) -> bool {
    let calls = session.callers.calls(file);
    let mut others = calls
        .iter()
        .filter(|call| call.target.as_deref() != Some(file));
    others.any(|call| {
        call.call.args.iter().any(|argument| {
            let value = argument.value.path(&session.packages, &call.call.caller);
            value.as_deref() == Some(file)
        })
    })
}

/// Whether a finding may be false in a file that is not expanded by itself, or with other arguments.
fn depends_on_role(finding: &Finding) -> bool {
    // the file that includes a part says the name
    let is_of_whole = finding.rule == named::MISSING_ROBOT_NAME;
    finding.outside.is_some() || needs_names(finding.rule) || is_of_whole
}

fn verdict(role: Role, finding: &Finding) -> FindingAction {
    let is_misspelled = finding.fix.is_some() && !finding.probed;
    match (&finding.outside, role) {
        (None, _) if !depends_on_role(finding) => FindingAction::Keep,
        (None, Role::Root | Role::Unknown) if finding.rule == named::MISSING_ROBOT_NAME => {
            FindingAction::Keep
        }
        (Some(Outside::File), _) => FindingAction::Keep,
        (Some(Outside::Environment), _) => FindingAction::Note,
        (_, Role::Part) => FindingAction::Drop,
        (Some(Outside::Argument(_)), _) if is_misspelled => FindingAction::Keep,
        (_, Role::Unknown) => FindingAction::Note,
        (None, Role::Root) => FindingAction::Keep,
        (Some(_), Role::Root) if finding.probed => FindingAction::Note,
        (Some(Outside::Argument(_)), Role::Root) => match finding.problem {
            Some(ProblemKind::UndefinedArg) => FindingAction::Keep,
            // the robot works as soon as the argument is given
            Some(ProblemKind::UseBeforeDefinition) => FindingAction::Set(Severity::Warning),
            _ => FindingAction::Note,
        },
        (Some(Outside::Includer), Role::Root) => FindingAction::Keep,
    }
}

/// A link that a robot does not have; it and others like it are above all of its links: the robot is made to be attached
/// there.
fn above_fragment(robot: &Robot) -> Option<&EcoString> {
    let missing = robot.naming().missing_parent.as_ref()?;
    let is_fragment = !robot.links.is_empty() && robot.kinematics().roots(robot).is_empty();
    is_fragment.then_some(missing)
}

/// Whether a link is missing whose name is like that of another.
fn has_misspelled_link(findings: &[Finding]) -> bool {
    findings
        .iter()
        .any(|finding| finding.rule == named::UNDEFINED_LINK && finding.fix.is_some())
}

#[cfg(test)]
#[path = "roles_tests.rs"]
mod tests;

//! One expansion, and what the rules say about it.
use std::cell::OnceCell;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::calls::as_called;
use super::check_task::{CheckReason, CheckTask};
use super::configs::Settings;
use super::cut::Cut;
use super::options::CheckOptions;
use super::read_as_yaml::read_as_yaml;
use super::roles::{CheckedExpansion, nameless, settle_by_role};
use super::root_result::RootResult;
use super::session::Session;
use super::set_aside::settle_set_aside;
use base::{CancelFlag, FastSet, FileId, Span, TextRange};
use expand::{Expansion, FileUse, Forced, FrameKind, Origin, Read, Request, Sources, expand_again};
use model::Robot;
use rules::consumers::{self, Tally};
use rules::{
    Activation, Category, Chosen, Finding, RootKind, Rule, Selector, Settled, Suppressions, all,
    check_expansion, check_files, holds_for_semantic, include_tags, is_semantic, missing_packages,
    named,
};
use vfs::{LoadError, LoadErrorKind};

/// Expand a file and check the result.
pub(super) fn run(session: &Session, options: &CheckOptions, task: CheckTask) -> RootResult {
    let request = request(session, &options.cancel, &task);
    let (expansion, is_as_called) = expanded(session, &task, &request, None);
    let robot = Robot::of(&expansion);
    let none = Settled::default();
    let result = run_rules(session, options, task, (&expansion, robot.as_ref()), &none);
    RootResult {
        is_as_called,
        ..result
    }
}

/// Expand a file, for somebody who keeps the result; `before` is what was kept of the last time.
pub(super) fn expansion(
    session: &Session,
    cancel: &CancelFlag,
    task: &CheckTask,
    before: Option<&Expansion>,
) -> Expansion {
    expanded(
        session,
        task,
        &Request {
            keep: true,
            ..request(session, cancel, task)
        },
        before,
    )
    .0
}

/// Expand a file with the outcome of conditions given.
pub(super) fn forced(
    session: &Session,
    cancel: &CancelFlag,
    task: &CheckTask,
    forced: Vec<Forced>,
) -> Expansion {
    expanded(
        session,
        task,
        &Request {
            keep: true,
            forced,
            ..request(session, cancel, task)
        },
        None,
    )
    .0
}

/// The expansion, and whether its arguments are those of a caller, since it fails with the defaults.
pub(super) fn expanded(
    session: &Session,
    task: &CheckTask,
    request: &Request,
    before: Option<&Expansion>,
) -> (Expansion, bool) {
    let first = expand_again(sources(session), request, before);
    // what a call does not give is missing
    match task.called {
        Some(_) => (first, false),
        None => as_called(session, sources(session), &task.file, request, first),
    }
}

pub(super) fn sources(session: &Session) -> Sources<'_> {
    Sources {
        vfs: &session.vfs,
        packages: &session.packages,
        env: &session.env,
    }
}

pub(super) fn request(session: &Session, cancel: &CancelFlag, task: &CheckTask) -> Request {
    let settings = session.settings(&task.file);
    Request {
        // messages name files as the user would
        file: vfs::slashed(
            task.file
                .strip_prefix(&session.env.cwd)
                .unwrap_or(&task.file),
        ),
        args: task.args.clone(),
        probe: true,
        ros_shell: true,
        limits: settings.config.limits.expansion(),
        cancel: cancel.clone(),
        ..Request::default()
    }
}

/// Check an expansion and its robot; `before` is what was settled the last time. When cancelled, findings are missing.
pub(super) fn run_rules(
    session: &Session,
    options: &CheckOptions,
    task: CheckTask,
    (expansion, robot): (&Expansion, Option<&Robot>),
    before: &Settled,
) -> RootResult {
    let settings = session.settings(&task.file);
    let around = session.rule_env(&settings.config);
    let kind = kind(expansion, robot, &task);
    let explicit = task.reason != CheckReason::Walked;
    let mut rules = wanted(session, expansion, settings.clone());
    rules.retain(|rule| kind != RootKind::Semantic || holds_for_semantic(rule));
    let found = OnceCell::new();
    let tally = counts_consumers(&settings, options, &task).then_some(&found);
    let chosen = Chosen {
        rules: &rules,
        cancel: &options.cancel,
        tally,
    };
    let (mut findings, settled) =
        check_expansion(expansion, robot, (kind, explicit), around, chosen, before);
    findings.append(&mut check_files(expansion, around, chosen));
    say_once(&mut findings);
    leave_out_consequences(&mut findings);
    if let Some(error) = &expansion.root_error {
        findings.extend(unreadable(session.vfs.file_id(&task.file), error));
    }
    if rules.contains(&named::DESCRIPTION_READ_AS_YAML) {
        findings.extend(read_as_yaml(session, &task.file, expansion));
    }
    let checked = CheckedExpansion {
        task: &task,
        kind,
        expansion,
        robot,
    };
    findings.extend(nameless(session, &checked));
    settle_by_role(session, &checked, &mut findings);
    settle_set_aside(session, &task, (expansion, robot), &mut findings);
    let is_meant = is_meant_as_robot(expansion, kind);
    RootResult {
        is_robot: kind == RootKind::Robot,
        is_nameless: kind == RootKind::Library && robot.is_some_and(Robot::lacks_only_a_name),
        unfound: if is_meant {
            missing_packages(expansion, around)
        } else {
            BTreeSet::new()
        },
        cut: if is_meant {
            Cut::of(expansion, robot, &rules, &findings)
        } else {
            None
        },
        is_context: task.reason == CheckReason::Root,
        is_as_called: false,
        complete: expansion.whole
            && expansion
                .files
                .iter()
                .all(|file| file.source.document.errors().is_empty()),
        reads: reads(expansion),
        files: expansion
            .files
            .iter()
            .map(|file| file.source.clone())
            .collect(),
        findings,
        arguments: expansion.arguments.clone(),
        includes: include_tags(expansion, around),
        called: called(expansion),
        settled: Arc::new(settled),
        consumers: wanted_of(found.into_inner().unwrap_or_default(), &settings, &task),
        task,
    }
}

/// A missing `$` is said once: by the rule about the number or the name in which it is missing.
fn say_once(findings: &mut Vec<Finding>) {
    let is_whole = |finding: &&Finding| {
        finding.rule == named::INVALID_NUMBER || finding.rule == named::INVALID_NAME
    };
    let whole: Vec<Span> = findings
        .iter()
        .filter(is_whole)
        .map(|finding| finding.span)
        .collect();
    let holds =
        |own: Span, span: &Span| span.file == own.file && span.range.contains_range(own.range);
    findings.retain(|finding| {
        finding.rule != named::MISSING_DOLLAR || !whole.iter().any(|span| holds(finding.span, span))
    });
}

/// What the content of an element is wrong for without the element is not said again where that is lost.
fn leave_out_consequences(findings: &mut Vec<Finding>) {
    let lost = findings
        .iter()
        .filter(|finding| finding.rule == named::DROPPED_ROOT_ELEMENT);
    let lost: Vec<FileId> = lost.map(|finding| finding.span.file).collect();
    if lost.is_empty() {
        return;
    }
    let is_lost = |span: &Span| lost.contains(&span.file);
    findings.retain(|finding| {
        let is_about_elements =
            [Category::Xml, Category::Structure, Category::Joint].contains(&finding.rule.category);
        let mut places = finding.related.iter().map(|related| &related.span);
        !is_about_elements || !(is_lost(&finding.span) || places.any(is_lost))
    });
}

/// Whether to count what programs reject or change: where somebody asked and named none.
fn counts_consumers(settings: &Settings, options: &CheckOptions, task: &CheckTask) -> bool {
    let is_named = !settings.config.consumers.is_empty() || settings.config.oldest_reader.is_some();
    let runs = [consumers::Outcome::Rejects, consumers::Outcome::Changes]
        .into_iter()
        .any(|outcome| settings.runs(consumers::rule_of(outcome), &task.file));
    options.count_consumers && !is_named && runs && task.called.is_none()
}

/// What is counted, without what a rule would say that is left out.
fn wanted_of(mut found: Tally, settings: &Settings, task: &CheckTask) -> Tally {
    found.retain(|_, worst| settings.runs(consumers::rule_of(*worst), &task.file));
    found
}

/// Whether a file is a robot, or says so by its name and lacks only what it includes.
fn is_meant_as_robot(expansion: &Expansion, kind: RootKind) -> bool {
    let root = expansion
        .files
        .first()
        .and_then(|file| file.source.document.root());
    let name = root.and_then(|root| root.attr("name"));
    let is_named = name.is_some_and(|name| !name.raw().is_empty());
    kind == RootKind::Robot || kind == RootKind::Library && is_named && !expansion.whole
}

/// Where the macros are defined that were called.
fn called(expansion: &Expansion) -> FastSet<Span> {
    let calls = expansion
        .frames
        .iter()
        .filter(|frame| frame.kind == FrameKind::Macro);
    let mut origins: Vec<Origin> = calls.filter_map(|frame| frame.definition).collect();
    // most calls in a row are of one macro
    origins.dedup();
    let origins: FastSet<Origin> = origins.into_iter().collect();
    let span = |origin: Origin| {
        let place = expansion.place(origin)?;
        let file = expansion.files.get(place.file)?;
        Some(Span {
            file: file.source.id,
            range: place.range,
        })
    };
    origins.into_iter().filter_map(span).collect()
}

/// The rules that run somewhere in what an expansion read, or for the packages around it.
fn wanted(session: &Session, expansion: &Expansion, root: Arc<Settings>) -> Vec<&'static Rule> {
    let mut found = vec![root];
    let mut folders: FastSet<&Path> = FastSet::default();
    let sources = expansion.files.iter().map(|file| &*file.source.path);
    for file in sources.filter(|file| file.parent().is_some_and(|folder| folders.insert(folder))) {
        let package = session
            .packages
            .containing(file)
            .map(|package| package.folder);
        let around = package.map(|folder| session.folder_settings(&folder));
        for settings in std::iter::once(session.settings(file)).chain(around) {
            if !found.iter().any(|known| Arc::ptr_eq(known, &settings)) {
                found.push(settings);
            }
        }
    }
    let left_out = |rule: &Rule| rule.default == Activation::On && !is_selected(rule, &found);
    let suppressed = if all().any(left_out) {
        suppressed(expansion)
    } else {
        Vec::new()
    };
    let wanted = |rule: &&Rule| {
        is_selected(rule, &found) || left_out(rule) && suppressed.iter().any(|s| s.names(rule))
    };
    all().filter(wanted).collect()
}

fn is_selected(rule: &Rule, settings: &[Arc<Settings>]) -> bool {
    settings.iter().any(|settings| settings.selects(rule))
}

/// What comments in the files switch off: whether it would hide something is only known when it runs, whatever a
/// command line leaves out this time.
fn suppressed(expansion: &Expansion) -> Vec<Selector> {
    let comments = expansion
        .files
        .iter()
        .flat_map(|file| Suppressions::of(&file.source.document).list);
    comments.flat_map(|suppression| suppression.rules).collect()
}

/// A file is a robot when it is configured as one, calls itself plain URDF, or gives one by itself.
pub(super) fn kind(expansion: &Expansion, robot: Option<&Robot>, task: &CheckTask) -> RootKind {
    let uses_xacro = |file: &FileUse| {
        file.source
            .document
            .root()
            .is_some_and(|root| root.attr("xmlns:xacro").is_some())
    };
    let plain = task
        .file
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("urdf"))
        && !expansion.files.first().is_some_and(uses_xacro);
    if is_semantic(expansion) {
        return RootKind::Semantic;
    }
    let gives_robot = task.reason == CheckReason::Root
        || robot.is_some_and(Robot::is_entry)
        || plain && !is_of_a_simulator(expansion, robot) && !is_blank(expansion, robot)
        || is_bare(expansion) && !has_content(expansion, robot);
    if gives_robot {
        RootKind::Robot
    } else {
        RootKind::Library
    }
}

/// Whether a file is well-formed and holds neither a name nor an element: it takes the place of one that others write.
fn is_blank(expansion: &Expansion, robot: Option<&Robot>) -> bool {
    let is_empty = |robot: &Robot| {
        robot.name.is_none() && expansion.tree.elements(robot.element).next().is_none()
    };
    let well_formed = |file: &FileUse| file.source.document.errors().is_empty();
    robot.is_some_and(is_empty) && expansion.files.first().is_some_and(well_formed)
}

/// Whether a file has content, and none of it is a link or a joint: materials, settings.
fn has_content(expansion: &Expansion, robot: Option<&Robot>) -> bool {
    robot.is_some_and(|robot| {
        let mut elements = expansion.tree.elements(robot.element);
        robot.links.is_empty() && robot.joints.is_empty() && elements.next().is_some()
    })
}

/// Whether such content is that of a simulator or driver: elements that describe no body.
fn is_of_a_simulator(expansion: &Expansion, robot: Option<&Robot>) -> bool {
    let tree = &expansion.tree;
    let elements = robot
        .into_iter()
        .flat_map(|robot| tree.elements(robot.element));
    let mut others =
        elements.filter(|&id| !["material", "transmission"].contains(&tree.get(id).text.as_str()));
    has_content(expansion, robot) && others.next().is_some()
}

/// A robot with a name and without a single tag of xacro is no library: its links are missing.
fn is_bare(expansion: &Expansion) -> bool {
    let Some(file) = expansion.files.first() else {
        return false;
    };
    let document = &file.source.document;
    let named = document
        .root()
        .is_some_and(|root| root.name() == "robot" && root.attr("name").is_some());
    let mut nodes = document.parts().flat_map(|(_, item)| item.all_nodes());
    named && document.errors().is_empty() && !nodes.any(|node| node.name().starts_with("xacro:"))
}

fn reads(expansion: &Expansion) -> Vec<PathBuf> {
    let files = expansion.record.iter().filter_map(|read| match read {
        Read::File(path, _) | Read::Missing(path) => Some(path.clone()),
        _ => None,
    });
    files.skip(1).collect()
}

/// A file that cannot be read is not well-formed either.
fn unreadable(file: FileId, error: &LoadError) -> Option<Finding> {
    let message = format!("cannot read the file: {}", error.reason());
    let span = Span {
        file,
        range: TextRange::default(),
    };
    let help = match error.kind {
        LoadErrorKind::TooLarge { .. } => {
            "raise `file-mb` under `[limits]` in xacro-lint.toml if the file is really that large"
        }
        LoadErrorKind::PermissionDenied => "make the file readable for this user",
        _ => "check that the path is a file on this disk",
    };
    Some(Finding {
        help: Some(help.to_owned()),
        ..Finding::new(named::XML_SYNTAX_ERROR, span, message)
    })
}

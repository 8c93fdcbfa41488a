//! What is wrong in files that nobody uses, such as copies and old versions, or that are for another program.
use std::path::Path;

use super::check_task::{CheckReason, CheckTask};
use super::includers::{holds_above, is_for_tests};
use super::kept::{is_kept, words_in, words_of};
use super::left_over::is_left_over;
use super::lowered::{lower_to_infos, lower_where};
use super::made_elsewhere::settle_made_elsewhere;
use super::outside_packages::{is_of_rosbuild, settle_outside_packages};
use super::session::Session;
use super::uses::{is_named_in_use, settle_by_purpose, settle_by_use};
use base::{FastMap, FileId};
use expand::{Expansion, ProblemKind};
use model::{Joint, Robot};
use packages::RosVersion;
use rules::{Category, Edit, Finding, Group, Severity, Trait, named};
use workspace::{Caller, Era};
use xml::NodeKind;

/// Folders of tests.
const TESTS: [&str; 4] = ["fixtures", "test", "testdata", "tests"];

/// Words in the name of a file for a test that say that it has to be refused.
const REFUSED: [&str; 9] = [
    "bad",
    "broken",
    "error",
    "fail",
    "failing",
    "fails",
    "invalid",
    "malformed",
    "wrong",
];

/// How many folders above a file a model of Gazebo begins at most.
const MODEL_DEPTH: usize = 3;

/// What is wrong in a file that was set aside is an info. Not when somebody asks for this very file.
pub(super) fn settle_set_aside(
    session: &Session,
    task: &CheckTask,
    (expansion, robot): (&Expansion, Option<&Robot>),
    findings: &mut [Finding],
) {
    let is_news = |finding: &Finding| finding.severity > Severity::Info;
    if task.reason != CheckReason::Walked || !findings.iter().any(is_news) {
        return;
    }
    if robot.is_some_and(is_list_of_joints)
        || is_wrong_on_purpose(session, &task.file)
        || is_for_tests(session, &task.file)
        || session.packages.is_never_built(&task.file) && !is_named_in_use(session, &task.file)
    {
        lower_to_infos(findings);
    } else if is_set_aside(session, &task.file) {
        lower_unused(session, &task.file, findings);
    }
    let is_impossible = |finding: &Finding| finding.rule == named::INERTIA_TRIANGLE_INEQUALITY;
    let is_negative = |finding: &Finding| finding.rule == named::INERTIA_NOT_POSITIVE_DEFINITE;
    // PhysX takes them, too
    let is_taken = |finding: &Finding| is_impossible(finding) || is_negative(finding);
    lower_where(findings, is_taken, || {
        let callers = &session.callers;
        let none_refuses = callers.never_refuse(&task.file) || callers.load_in_isaac(&task.file);
        none_refuses.then_some(Severity::Warning)
    });
    group_by_file(findings, |finding| {
        finding.severity == Severity::Warning && is_impossible(finding)
    });
    // Bullet computes inertia from the shapes unless it is told otherwise
    let about_bullet = |finding: &Finding| {
        let is_taken = is_before_declaration(finding)
            || has_dashes(finding)
            || finding.rule.has(Trait::AcceptedByBullet)
            || finding.rule.has(Trait::Gazebo)
            || finding.rule == named::MESH_NOT_FOUND && is_above(session, &task.file, finding);
        is_taken || finding.rule.category == Category::Inertia
    };
    lower_where(findings, about_bullet, || {
        session
            .callers
            .load_in_bullet(&task.file)
            .then_some(Severity::Info)
    });
    // a file without content that nobody names is not begun yet
    let is_blank = |finding: &Finding| {
        let text = || session.vfs.text(&task.file);
        finding.rule == named::XML_SYNTAX_ERROR
            && text().is_ok_and(|text| text.text.trim().is_empty())
    };
    lower_where(findings, is_blank, || {
        (!session.callers.name(&task.file)).then_some(Severity::Info)
    });
    // an element of URDF by itself is a piece of a robot
    let is_piece = |finding: &Finding| {
        finding.rule == named::UNKNOWN_ROOT_ELEMENT
            && ["`link`", "`joint`"]
                .iter()
                .any(|name| finding.message.contains(name))
    };
    lower_where(findings, is_piece, || {
        (!session.callers.load(&task.file)).then_some(Severity::Info)
    });
    let is_mesh = |finding: &Finding| {
        [named::MESH_NOT_FOUND, named::MISSING_XACRO_NAMESPACE].contains(&finding.rule)
    };
    lower_where(findings, is_mesh, || {
        session
            .callers
            .load_in_matlab(&task.file)
            .then_some(Severity::Info)
    });
    // Isaac Gym looks for meshes in the folders above too, and computes an inertia that is not there
    let about_isaac = |finding: &Finding| {
        finding.rule == named::MESH_NOT_FOUND && is_above(session, &task.file, finding)
            || finding.rule == named::MISSING_ELEMENT && finding.message.contains("`inertia`")
    };
    lower_where(findings, about_isaac, || {
        session
            .callers
            .load_in_isaac(&task.file)
            .then_some(Severity::Info)
    });
    let about_raisim = |finding: &Finding| {
        is_before_declaration(finding) || finding.rule.has(Trait::AcceptedByRaiSim)
    };
    lower_where(findings, about_raisim, || {
        session
            .callers
            .load_in_raisim(&task.file)
            .then_some(Severity::Info)
    });
    // tf before tf2 takes such names
    let is_slashed = |finding: &Finding| finding.rule == named::LEADING_SLASH_NAME;
    lower_where(findings, is_slashed, || {
        session
            .callers
            .is_for_old_ros(&task.file)
            .then_some(Severity::Info)
    });
    // urdfdom and the readers that use it skip what is blank
    lower_where(findings, is_before_declaration, || {
        is_read_without_xacro(session, &task.file).then_some(Severity::Warning)
    });
    let about_prefixes = |finding: &Finding| {
        finding.rule == named::UNPREFIXED_XACRO_TAG
            || finding.rule == named::UNPREFIXED_MACRO_CALL
            || finding.rule == named::UNKNOWN_GEOMETRY_TYPE
                && finding.message.starts_with("`insert_block`")
            || finding.rule == named::MISSING_JOINT_LIMIT && holds_bare_block(session, finding)
    };
    if let Some(most) = lower_where(findings, about_prefixes, || {
        severity_of_bare_tags(session, &task.file)
    }) {
        // all of them are for another xacro
        let of_old_xacro =
            |finding: &&mut Finding| finding.severity == most && about_prefixes(finding);
        findings
            .iter_mut()
            .filter(of_old_xacro)
            .for_each(|finding| {
                finding.group = Some(Group::Value("for an old xacro".into()));
            });
    }
    let about_order = |finding: &Finding| finding.problem == Some(ProblemKind::UseBeforeDefinition);
    let is_unordered =
        || (session.callers.era(&task.file) == Era::Unordered).then_some(Severity::Info);
    lower_where(findings, about_order, is_unordered);
    // a library of which the robots that are launched use a part
    let is_uncalled = |finding: &Finding| finding.probed;
    let is_library = || {
        session
            .callers
            .launch_any(&task.file)
            .then_some(Severity::Info)
    };
    lower_where(findings, is_uncalled, is_library);
    let is_placeholder = |finding: &Finding| match finding.problem {
        Some(ProblemKind::ExpressionError) => is_replaced(session, &task.file, finding),
        _ if finding.rule == named::MESH_NOT_FOUND => names_a_blank(&finding.message),
        _ => finding.rule == named::INVALID_NUMBER && is_filled_in(session, &task.file, finding),
    };
    lower_where(findings, is_placeholder, || Some(Severity::Info));
    settle_made_elsewhere(session, task, findings);
    settle_by_use(session, task, findings);
    settle_by_purpose(session, &task.file, (expansion, robot), findings);
    settle_outside_packages(session, &task.file, findings);
}

/// Make one finding of those in a file: the program that wrote one of them wrote all of them. A few may be copies.
fn group_by_file(findings: &mut [Finding], is_it: impl Fn(&Finding) -> bool) {
    let mut count: FastMap<FileId, usize> = FastMap::default();
    for finding in findings.iter().filter(|finding| is_it(finding)) {
        *count.entry(finding.span.file).or_default() += 1;
    }
    let is_habit = |finding: &&mut Finding| {
        is_it(finding) && count.get(&finding.span.file) >= Some(&Group::File.least())
    };
    for finding in findings.iter_mut().filter(is_habit) {
        finding.group = Some(Group::File);
    }
}

/// Whether a file is plain URDF and nothing that names it runs xacro.
fn is_read_without_xacro(session: &Session, file: &Path) -> bool {
    let is_plain = file
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("urdf"));
    is_plain && !session.callers.of(file).iter().any(Caller::runs_xacro)
}

/// Make infos of what is wrong in a robot that was set aside, but for what is wrong in files that are loaded without it.
fn lower_unused(session: &Session, file: &Path, findings: &mut [Finding]) {
    let own = session.vfs.file_id(file);
    let mut known: FastMap<FileId, bool> = FastMap::default();
    for finding in findings
        .iter_mut()
        .filter(|finding| finding.severity > Severity::Info)
    {
        let at = finding.span.file;
        let is_used = || session.callers.load(&session.vfs.path(at));
        if at == own || !*known.entry(at).or_insert_with(is_used) {
            finding.severity = Severity::Info;
        }
    }
}

/// Whether the element that a finding is about inserts a block by a tag without its prefix.
fn holds_bare_block(session: &Session, finding: &Finding) -> bool {
    let Ok(source) = session.vfs.document(&session.vfs.path(finding.span.file)) else {
        return false;
    };
    let start = finding.span.range.start;
    source.document.parts().any(|(base, item)| {
        let mut nodes = item.all_nodes();
        let own = nodes.find(|node| {
            node.kind() == NodeKind::Element && node.range().shift(base).start == start
        });
        own.is_some_and(|own| own.children().any(|child| child.name() == "insert_block"))
    })
}

/// Whether a path has a name in braces, as in `{FOLDER}/arm.stl`: a program fills it in.
fn names_a_blank(message: &str) -> bool {
    let inside = message
        .split_once('{')
        .and_then(|(_, rest)| rest.split_once('}'));
    inside.is_some_and(|(name, _)| {
        let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
        !name.is_empty() && name.chars().all(is_letter)
    })
}

/// Whether the text that is wrong is a word that a program puts something else for: it names the file and the word.
fn is_filled_in(session: &Session, file: &Path, finding: &Finding) -> bool {
    let source = session.vfs.document(&session.vfs.path(finding.span.file));
    let word = source
        .map(|source| source.document.slice(finding.span.range))
        .unwrap_or_default();
    let is_word =
        word.chars().all(|c| c.is_alphanumeric() || c == '_') && word.contains(char::is_alphabetic);
    is_word && session.callers.mention(file, &word)
}

/// Whether a program that names the file has the text that is wrong, such as `$(controllers)`, word for word: it puts something
/// else for it.
fn is_replaced(session: &Session, file: &Path, finding: &Finding) -> bool {
    let source = session.vfs.document(&session.vfs.path(finding.span.file));
    let Ok(text) = source.map(|source| source.document.slice(finding.span.range)) else {
        return false;
    };
    text.starts_with("$(") && session.callers.quote(file, &text)
}

/// How bad tags without their prefix are where the xacro that a file is for takes them.
fn severity_of_bare_tags(session: &Session, file: &Path) -> Option<Severity> {
    match session.callers.era(file) {
        _ if is_of_rosbuild(session, file) => Some(Severity::Info),
        Era::Unordered | Era::Old => Some(Severity::Info),
        Era::Melodic if session.callers.is_for_old_ros(file) => Some(Severity::Info),
        Era::Melodic => Some(Severity::Warning),
        // to read all pages takes longer than to expand the robot
        Era::Any if session.packages.generation(file) == Some(RosVersion::Ros2) => None,
        Era::Any => session
            .callers
            .is_for_old_ros(file)
            .then_some(Severity::Info),
    }
}

/// Whether a file is not in use, and only such files include it.
pub(super) fn is_set_aside(session: &Session, file: &Path) -> bool {
    holds_above(session, file, |file| is_unnamed(session, file))
}

/// Whether nobody names a file though its path says that it is old or a copy, or the launch files of its package load
/// others. A template is filled by a script that names it.
fn is_unnamed(session: &Session, file: &Path) -> bool {
    !is_named_in_use(session, file) && is_given_up(session, file)
        || is_template(file) && !session.callers.launch(file)
        || session.callers.only_write(file)
}

/// Whether a file is old or a copy, others are loaded in its place, or it has no text.
fn is_given_up(session: &Session, file: &Path) -> bool {
    is_kept(session, file)
        || is_left_over(session, file)
        || session.callers.pass_over(file)
        || is_beside_model(session, file)
        || session.callers.spawn_models_instead(file)
        || (session.vfs.text(file)).is_ok_and(|file| file.text.trim().is_empty())
}

/// Whether the folder of a relative mesh lies in one above the file, where Bullet looks as well.
fn is_above(session: &Session, file: &Path, finding: &Finding) -> bool {
    const MOST_FOLDERS: usize = 4;
    let source = session.vfs.document(&session.vfs.path(finding.span.file));
    let name = source
        .map(|source| source.document.slice(finding.span.range))
        .unwrap_or_default();
    let folder = Path::new(name.trim_start_matches("./"))
        .parent()
        .map(Path::to_owned);
    let Some(folder) =
        folder.filter(|folder| folder.iter().next().is_some() && !name.contains(':'))
    else {
        return false;
    };
    let above = file.ancestors().skip(2).take(MOST_FOLDERS);
    above
        .into_iter()
        .any(|top| session.vfs.is_dir(&top.join(&folder)))
}

/// Whether a file is one of a test, which has to be refused.
fn is_wrong_on_purpose(session: &Session, file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let is_refused = words_in(&name)
        .iter()
        .any(|word| REFUSED.contains(&word.as_str()));
    is_refused
        && words_of(session, file)
            .iter()
            .any(|word| TESTS.contains(&word.as_str()))
}

/// Whether a file lies in a model of Gazebo, whose `model.config` names another one.
fn is_beside_model(session: &Session, file: &Path) -> bool {
    let config = file
        .ancestors()
        .skip(1)
        .take(MODEL_DEPTH)
        .map(|folder| folder.join("model.config"));
    let Some(config) = config
        .into_iter()
        .find(|config| session.vfs.is_file(config))
    else {
        return false;
    };
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    session
        .vfs
        .text(&config)
        .is_ok_and(|config| config.text.contains("</sdf>") && !config.text.contains(&*name))
}

/// Whether a file has the form of a robot and only lists joints with their limits, as `joint_state_publisher` shows them.
fn is_list_of_joints(robot: &Robot) -> bool {
    let is_bare =
        |joint: &Joint| joint.kind.is_none() && joint.parent.is_none() && joint.child.is_none();
    robot.links.is_empty() && !robot.joints.is_empty() && robot.joints.iter().all(is_bare)
}

/// Whether the name of a file says that it is to be filled in.
fn is_template(file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    words_in(&name)
        .iter()
        .any(|word| ["template", "tmpl"].contains(&word.as_str()))
}

/// Whether a finding is about text in front of the XML declaration: its fix removes the start of the file.
fn is_before_declaration(finding: &Finding) -> bool {
    let removes_start = |edit: &Edit| edit.span.range.start == 0 && edit.content.is_empty();
    let mut edits = finding.fix.iter().flat_map(|fix| &fix.edits);
    finding.rule == named::XML_SYNTAX_ERROR && edits.any(removes_start)
}

/// Whether a finding is about two dashes in a comment, which Bullet reads up to its end.
fn has_dashes(finding: &Finding) -> bool {
    finding.rule == named::XML_SYNTAX_ERROR && finding.message.starts_with("`--` is not allowed")
}

//! What is right, and of no account for those who use the file.
use std::cell::LazyCell;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::beside::robot_name;
use super::check_task::CheckTask;
use super::generated::generated_from;
use super::includers::holds_above;
use super::kept::{is_kept, is_launch_left_over};
use super::left_over::is_built_for_moveit;
use super::lowered::lower_where;
use super::session::Session;
use expand::{Expansion, ProblemKind, XTree};
use model::Robot;
use packages::workspace_of;
use rules::{Category, Finding, Rule, Severity, Trait, named};
use vfs::without_parents;
use workspace::{Purpose, RobotCall, is_ignored_by_git, is_page};

/// What breaks nothing for the launch files and programs that use a file is an info.
pub(super) fn settle_by_use(session: &Session, task: &CheckTask, findings: &mut [Finding]) {
    let file = &task.file;
    let info = || Some(Severity::Info);
    // both blocks meet in a robot whose controllers nothing starts
    lower_where(findings, about(named::ROS2_CONTROL_DUPLICATE_JOINT), || {
        let is_idle = is_for_assistant(session, file) && session.callers.control_another(file);
        is_idle.then_some(Severity::Info)
    });
    lower_where(findings, about(named::XACRO_TAGS_IN_URDF), || {
        is_run_through_xacro(session, file).then_some(Severity::Info)
    });
    lower_where(findings, about(named::MISSING_ROBOT_NAME), || {
        session.callers.only_spawn(file).then_some(Severity::Info)
    });
    // what runs here does not need its packages
    let is_far = |finding: &Finding| {
        finding.rule == named::PACKAGE_NOT_FOUND && finding.message.starts_with("none of")
    };
    lower_where(findings, is_far, || {
        (!session.callers.launch(file) && session.callers.run_something(file))
            .then_some(Severity::Info)
    });
    let is_of_classic = |finding: &Finding| finding.rule.has(Trait::GazeboClassic);
    lower_where(findings, is_of_classic, || {
        (!session.callers.run_gazebo_classic(file)).then_some(Severity::Info)
    });
    let is_of_gazebo = |finding: &Finding| {
        let is_inside = finding.message.starts_with("unknown element `gazebo`");
        finding.rule.has(Trait::Gazebo) || finding.rule == named::UNKNOWN_ELEMENT && is_inside
    };
    lower_where(findings, is_of_gazebo, || {
        session
            .callers
            .run_isaac_alone(file)
            .then_some(Severity::Info)
    });
    // a launch file or program may place the frame that Gazebo makes up
    lower_where(findings, about(named::SENSOR_WITHOUT_FRAME), || {
        let callers = &session.callers;
        let is_placed = callers.quote(file, "frame_id") || callers.place_frames(file);
        is_placed.then_some(Severity::Info)
    });
    // what xacro made on another computer is often kept, and no simulator reads it
    let is_elsewhere = |finding: &Finding| {
        finding.rule == named::PLUGIN_FILE_NOT_FOUND && finding.message.starts_with("file `/")
    };
    lower_where(findings, is_elsewhere, || {
        let mut simulators = ["gazebo", "ros_gz", "gz_sim", "ignition"].into_iter();
        let is_run = simulators.any(|name| session.callers.quote(file, name));
        (!is_run).then_some(Severity::Info)
    });
    let is_contained = |finding: &Finding| {
        let rules = [named::PLUGIN_FILE_NOT_FOUND, named::ABSOLUTE_MESH_PATH];
        rules.contains(&finding.rule) && is_in_container(session, file, finding)
    };
    lower_where(findings, is_contained, info);
    // Gazebo takes paths as they are, and colors from elements of its own
    let is_for_viewers = |finding: &Finding| {
        finding.rule == named::MESH_PATH_WITHOUT_SCHEME
            || finding.rule == named::UNKNOWN_ELEMENT
                && finding.message.starts_with("unknown element `material`")
                && session.callers.launch(file)
    };
    lower_where(findings, is_for_viewers, || {
        let mut shows = ["rviz", "moveit"].into_iter();
        (!shows.any(|program| session.callers.quote(file, program))).then_some(Severity::Info)
    });
    // another publisher of the frame is needed for two of them to be at odds
    lower_where(findings, about(named::RESERVED_FRAME_NAME), || {
        (!session.callers.localize_any(file)).then_some(Severity::Info)
    });
    // where it is no link, a program may publish it
    let is_published = |finding: &Finding| {
        let frame = finding.message.split('`').nth(1);
        finding.rule == named::PLUGIN_UNKNOWN_FRAME
            && frame.is_some_and(|frame| session.callers.say_name(file, frame))
    };
    lower_where(findings, is_published, info);
    let is_spaced = |finding: &Finding| {
        finding.rule == named::INVALID_NAME && is_name_of_no_controller(session, file, finding)
    };
    lower_where(findings, is_spaced, info);
    let is_unmade = |finding: &Finding| {
        finding.problem == Some(ProblemKind::ExpressionError)
            && is_made_by_a_program(session, file, finding)
    };
    lower_where(findings, is_unmade, info);
    let is_of_system = |finding: &Finding| {
        finding.problem == Some(ProblemKind::ExpressionError)
            && missing_file(finding).is_some_and(|path| path.starts_with("/opt/ros/"))
    };
    lower_where(findings, is_of_system, info);
    // others may load what nothing here loads, and give it
    let is_for_others =
        || session.packages.containing(file).is_some() && !session.callers.load(file);
    let is_given = |finding: &Finding| {
        let name = finding.message.split('`').nth(1).unwrap_or_default();
        finding.problem == Some(ProblemKind::UseBeforeDefinition)
            && finding.message.starts_with("argument")
            && (session.callers.always_give(file, name) || is_for_others())
    };
    lower_where(findings, is_given, info);
    let is_unread = |finding: &Finding| {
        finding.rule == named::MISSING_PACKAGE_DEPENDENCY
            && is_in_idle_default(session, file, finding)
    };
    lower_where(findings, is_unread, info);
}

/// What matters only to simulators and planners is an info where none of them gets the robot, and so is what is wrong in a robot
/// that nothing loads while others are loaded; that it cannot be loaded only where these are of its package. What
/// loads one of the `parts` of a robot gets that part.
pub(super) fn settle_by_purpose(
    session: &Session,
    file: &Path,
    (expansion, robot): (&Expansion, Option<&Robot>),
    findings: &mut [Finding],
) {
    let parts = &expansion.files;
    let is_news = |finding: &Finding| finding.severity > Severity::Info;
    let is_about_use =
        |finding: &Finding| is_news(finding) && is_without_effect(finding, Purpose::default());
    // to read all texts takes longer than to ask those that name descriptions
    let is_unnamed = || session.callers.move_any(file) && !is_named_in_use(session, file);
    let may_be_unreached = findings.iter().any(is_news) && is_unnamed();
    if !may_be_unreached && !findings.iter().any(is_about_use) {
        return;
    }
    let Some(own) = purpose(session, file) else {
        return;
    };
    let loaded = parts
        .iter()
        .skip(1)
        .filter(|part| session.callers.load(&part.source.path))
        .filter_map(|part| purpose(session, &part.source.path));
    let mut purpose = loaded.fold(own, Purpose::or);
    // whoever gives it a plugin or sensor of Gazebo has it simulated
    let mut files = parts.iter().map(|part| &part.source.path);
    let is_for_gazebo = robot.is_some_and(|robot| runs_in_gazebo(&expansion.tree, robot))
        || files.any(|part| session.callers.is_for_gazebo(part));
    let is_shown = purpose.is_loaded && !purpose.is_weighed;
    if is_for_gazebo && is_shown && simulate_a_twin(session, file) {
        let for_gazebo = |finding: &Finding| finding.rule.has(Trait::Gazebo);
        lower_where(findings, for_gazebo, || Some(Severity::Info));
    } else if is_for_gazebo {
        // where launch files plan or control and none simulates, nothing weighs it
        let is_only_applied = purpose.is_applied && purpose.is_loaded;
        purpose.is_met = true;
        purpose.is_weighed |= !is_only_applied || session.callers.simulate_any(file);
    }
    // where robots are only shown, others may load what nothing here does, or simulate it
    let is_used = purpose.is_loaded || session.callers.load_any(file);
    if !(purpose.is_applied && is_used) {
        let is_idle = |finding: &Finding| {
            finding.rule.has(Trait::Transmission) && is_without_effect(finding, purpose)
        };
        lower_where(findings, is_idle, || is_used.then_some(Severity::Warning));
        // a mesh that is slow to collide with is right all the same
        let is_slow = |finding: &Finding| {
            finding.rule.has(Trait::Contact) && is_without_effect(finding, purpose)
        };
        lower_where(findings, is_slow, || {
            session.callers.name(file).then_some(Severity::Info)
        });
        // in a viewer, a joint that follows another one has no slider
        let is_shown = is_shown && !purpose.is_met && !purpose.is_controlled;
        let is_range = about(named::MIMIC_RANGE_EXCEEDS_LIMITS);
        lower_where(findings, is_range, || is_shown.then_some(Severity::Info));
        return;
    }
    let is_unreached = may_be_unreached && !purpose.is_loaded && is_unreached(session, file);
    let is_passed_over = LazyCell::new(|| is_unreached && is_another_loaded(session, file));
    for finding in findings.iter_mut().filter(|finding| is_news(finding)) {
        if is_unreached && !is_about_loading(finding)
            || is_without_effect(finding, purpose)
            || *is_passed_over
        {
            finding.severity = Severity::Info;
        }
    }
}

/// What is done with a description. MoveIt finds one by the name of its package.
fn purpose(session: &Session, file: &Path) -> Option<Purpose> {
    // where the file is kept itself, so is all around it
    let is_left_over = |by: &Path| is_kept(session, by) && !is_kept(session, file);
    let mut purpose = session.callers.purpose(file, is_left_over)?;
    let package = session.packages.containing(file);
    if !purpose.is_loaded
        && package.is_some_and(|package| is_built_for_moveit(session, file, &package.folder))
    {
        // its launch files run a controller manager as well
        (purpose.is_loaded, purpose.is_met, purpose.is_controlled) = (true, true, true);
    }
    Some(purpose)
}

/// With more descriptions than these around it, it is not looked which one is a twin of a robot: that takes their product.
const MOST_DESCRIPTIONS: usize = 200;
/// Twins that are looked at.
const MOST_TWINS: usize = 4;

/// Whether a simulator gets the same robot from another file: by its name, that is a copy, or what a plain URDF was made of.
fn simulate_a_twin(session: &Session, file: &Path) -> bool {
    let Some(name) = robot_name(session, file) else {
        return false;
    };
    let all = session.callers.descriptions(file);
    // robots that a program wrote in series may be thousands of one name
    if all.len() > MOST_DESCRIPTIONS {
        return false;
    }
    let others = all.iter().filter(|other| *other != file);
    let mut twins = others
        .filter(|other| robot_name(session, other).as_deref() == Some(&*name))
        .take(MOST_TWINS);
    twins.any(|twin| {
        let purpose = purpose(session, twin);
        purpose.is_some_and(|purpose| purpose.is_loaded && purpose.is_weighed)
    })
}

/// Whether a launch file or program leads to another description of the package of a file.
fn is_another_loaded(session: &Session, file: &Path) -> bool {
    let Some(package) = session.packages.containing(file) else {
        return false;
    };
    let all = session.callers.descriptions(file);
    let mut others = all
        .iter()
        .filter(|other| *other != file && other.starts_with(&package.folder));
    others.any(|other| purpose(session, other).is_some_and(|purpose| purpose.is_loaded))
}

/// Whether no text leads to a description, nor to what includes it.
fn is_unreached(session: &Session, file: &Path) -> bool {
    let is_passed = |file: &Path| {
        purpose(session, file).is_some_and(|purpose| !purpose.is_loaded)
            && !is_named_in_use(session, file)
            && !is_for_assistant(session, file)
    };
    holds_above(session, file, is_passed)
}

/// Whether a text names a file that is not left over. Where all descriptions are kept, that says nothing about them.
pub(super) fn is_named_in_use(session: &Session, file: &Path) -> bool {
    let are_all_kept = || {
        session
            .callers
            .descriptions(file)
            .iter()
            .all(|other| is_kept(session, other))
    };
    // a page that is no instruction says of a file that is kept just this
    let mentions =
        |by: &Path| is_page(by) && is_kept(session, file) && !has_path(session, by, file);
    // a text that loads it from the folder in which it was before finds nothing there
    let means_old = |by: &Path| {
        is_kept(session, file)
            && session
                .packages
                .is_text(by, |text| is_elsewhere(text, file))
    };
    let counts = |by: &Path| !(is_launch_left_over(session, by) || mentions(by) || means_old(by));
    session.callers.name_where(file, counts) || session.callers.name(file) && are_all_kept()
}

/// Whether a text has the path of a file with its folder, as a command would.
fn has_path(session: &Session, text: &Path, file: &Path) -> bool {
    let folder = file.parent().and_then(Path::file_name);
    let tail = Path::new(folder.unwrap_or_default()).join(file.file_name().unwrap_or_default());
    let tail = vfs::slashed(&tail);
    session.packages.is_text(text, |text| text.contains(&tail))
}

/// Whether a launch file comes with a driver of ros2_control, which has no robot of its own, and no text names it: it is an example,
/// and robots of other packages use the driver.
pub(super) fn is_example_of_driver(session: &Session, launch: &Path) -> bool {
    const EXPORT: &str = "pluginlib_export_plugin_description_file(hardware_interface";
    let Some(package) = session.packages.containing(launch) else {
        return false;
    };
    let build = session.vfs.text(&package.folder.join("CMakeLists.txt"));
    let all = session.callers.descriptions(launch);
    let has_robot = all.iter().any(|file| file.starts_with(&package.folder));
    build.is_ok_and(|build| build.text.contains(EXPORT))
        && !all.is_empty()
        && !has_robot
        && !is_named_in_use(session, launch)
}

/// Whether a launch file runs xacro on a file, whatever its ending is, or somebody ran it and kept the result beside it.
fn is_run_through_xacro(session: &Session, file: &Path) -> bool {
    let calls = session.callers.calls(file);
    calls
        .iter()
        .any(|call| call.target.as_deref() == Some(file))
        || has_result_beside(session, file)
}

/// Whether a URDF in the same folder says that xacro made it of a file.
fn has_result_beside(session: &Session, file: &Path) -> bool {
    let folder = file.parent().unwrap_or(file);
    let own = file.file_name().map(OsStr::to_string_lossy);
    let is_made_of_it = |path: PathBuf| {
        let source = session.vfs.document(&path).ok();
        source.and_then(|source| generated_from(&source)).as_deref() == own.as_deref()
    };
    let entries = session.vfs.list_dir(folder);
    entries
        .iter()
        .filter(|entry| !entry.is_dir && entry.name.ends_with(".urdf"))
        .any(|entry| is_made_of_it(folder.join(&entry.name)))
}

/// Whether a file is one that the setup assistant of MoveIt wrote around a description. That of ROS 1 wrote one for Gazebo as
/// well, which nothing can load in ROS 2.
fn is_for_assistant(session: &Session, file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    if name.starts_with("gazebo_") && session.packages.is_for_ament(file) {
        return false;
    }
    let package = session.packages.containing(file);
    package.is_some_and(|package| {
        session
            .vfs
            .is_file(&package.folder.join(".setup_assistant"))
    })
}

/// Whether whitespace in the name of a joint splits no arguments: launch files use the robot, and no text that starts controllers
/// has the name. Launch files of ROS 1 do not count in a package for ROS 2.
fn is_name_of_no_controller(session: &Session, file: &Path, finding: &Finding) -> bool {
    const WHAT: &str = "contains whitespace";
    let name = finding.message.split('`').nth(1).unwrap_or_default();
    let is_joint = finding.message.starts_with("name of joint");
    if !is_joint || !finding.message.contains(WHAT) || !session.callers.load(file) {
        return false;
    }
    let is_run = |path: &&PathBuf| {
        // an exporter of CAD programs writes it beside each robot
        let is_export = path.ends_with("controller.launch") && !session.callers.mention_file(path);
        !(session.callers.is_launch_of_ros1(path) || is_export)
    };
    let has_it = |path: &PathBuf| {
        session
            .vfs
            .text(path)
            .is_ok_and(|file| file.text.contains(name))
    };
    !session
        .callers
        .starters(file)
        .iter()
        .filter(is_run)
        .any(has_it)
}

/// Whether a finding is about a path into the workspace of a container: one that is described beside the sources, or that what
/// loads the file has as well.
fn is_in_container(session: &Session, file: &Path, finding: &Finding) -> bool {
    let Ok(source) = session.vfs.document(&session.vfs.path(finding.span.file)) else {
        return false;
    };
    let path = source.document.slice(finding.span.range);
    let is_loaded_there = || {
        finding.rule == named::PLUGIN_FILE_NOT_FOUND
            && workspace_of(&path).is_some_and(|folder| session.callers.quote(file, folder))
    };
    session.packages.is_in_container(file, &path) || is_loaded_there()
}

/// Whether an expression reads a file that is missing here and that `.gitignore` leaves out: a program makes it.
fn is_made_by_a_program(session: &Session, file: &Path, finding: &Finding) -> bool {
    let Some(path) = missing_file(finding) else {
        return false;
    };
    let folder = file.parent().unwrap_or(file);
    let beside = without_parents(&folder.join(path));
    let here = without_parents(&session.vfs.absolute(Path::new(path)));
    is_ignored_by_git(&session.packages, &beside) || is_ignored_by_git(&session.packages, &here)
}

/// Whether a finding is in the default of an argument that all calls of the file give.
fn is_in_idle_default(session: &Session, file: &Path, finding: &Finding) -> bool {
    let own = session.vfs.path(finding.span.file);
    let Ok(source) = session.vfs.document(&own) else {
        return false;
    };
    let is_it = |at: u32| at == finding.span.range.start;
    let node = source.document.parts().find_map(|(base, item)| {
        item.all_nodes()
            .find(|node| {
                node.attr("default").is_some_and(|value| {
                    let range = value.value_range().shift(base);
                    node.name() == "xacro:arg" && (range.start..range.end).any(is_it)
                })
            })
            .and_then(|node| Some(node.attr("name")?.raw().to_owned()))
    });
    let Some(name) = node else { return false };
    let all = session.callers.calls(file);
    let mut calls = all
        .iter()
        .filter(|call| call.target.as_deref() == Some(file))
        .peekable();
    let gives = |call: &RobotCall| call.call.args.iter().any(|argument| argument.name == name);
    calls.peek().is_some() && calls.all(gives)
}

/// Whether a text names a file in other folders than that in which it is, and nowhere without a folder.
fn is_elsewhere(text: &str, file: &Path) -> bool {
    let part = |path: Option<&OsStr>| path.and_then(OsStr::to_str).unwrap_or_default().to_owned();
    let (name, own) = (
        part(file.file_name()),
        part(file.parent().and_then(Path::file_name)),
    );
    let is_of_name = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.');
    let mut places = text
        .match_indices(&*name)
        .filter_map(|(at, _)| text.get(..at))
        .filter(|before| !before.ends_with(is_of_name))
        .peekable();
    places.peek().is_some()
        && places.all(|before| {
            let folder = before.strip_suffix('/').map(|rest| {
                let mut parts = rest.rsplit(|c| !is_of_name(c));
                parts.next().unwrap_or_default()
            });
            folder.is_some_and(|folder| !folder.is_empty() && folder != own)
        })
}

/// Whether a robot has a plugin or sensor of Gazebo.
fn runs_in_gazebo(tree: &XTree, robot: &Robot) -> bool {
    let mut inside = robot
        .gazebo
        .iter()
        .flat_map(|block| tree.elements(block.element));
    inside.any(|element| ["plugin", "sensor"].contains(&tree.get(element).text.as_str()))
}

/// Whether a finding is about something that no program needs that gets the robot. A value of the wrong sign is a slip, whoever
/// reads it.
fn is_without_effect(finding: &Finding, purpose: Purpose) -> bool {
    let rule = finding.rule;
    let about_masses = rule.category == Category::Inertia && !rule.has(Trait::WrongSign);
    about_masses && !purpose.is_weighed
        || rule.has(Trait::Contact) && !purpose.is_met
        || rule.has(Trait::Simulation) && !purpose.is_weighed && !purpose.is_met
        || rule.has(Trait::Transmission) && !purpose.is_weighed && !purpose.is_controlled
        || is_for_controllers(finding) && !purpose.is_controlled
}

/// Whether a finding is about a limit that only controllers keep: a soft one, or one of -1, which SDF reads as none.
fn is_for_controllers(finding: &Finding) -> bool {
    finding.rule == named::SAFETY_LIMITS_OUTSIDE_LIMITS
        || finding.rule == named::JOINT_LIMIT_NEGATIVE && finding.severity == Severity::Warning
}

/// Whether a finding is an error for whoever loads the file at all, whatever it is used for: xacro or a parser stops, or a file is
/// missing.
fn is_about_loading(finding: &Finding) -> bool {
    let is_of_xacro = finding.problem.is_some() || finding.rule.has(Trait::Reveals);
    finding.severity == Severity::Error && (is_of_xacro || finding.rule == named::MESH_NOT_FOUND)
}

/// The file that an expression reads and that is missing.
fn missing_file(finding: &Finding) -> Option<&str> {
    const MISSING: &str = "No such file or directory: '";
    let path = finding.message.split(MISSING).nth(1)?;
    path.split('\'').next()
}

/// Whether a finding is of a rule.
fn about(rule: &'static Rule) -> impl Fn(&Finding) -> bool {
    move |finding| finding.rule == rule
}

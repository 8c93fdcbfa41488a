//! Robots as launch files call them: each distinct call is expanded and checked as well.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use ecow::EcoString;

use super::check_task::{CheckTask, LaunchCallSites};
use super::declared::KnownArguments;
use super::root_config::RootConfig;
use super::root_result::RootResult;
use super::session::Session;
use base::limits::CALL_RUNS;
use base::{FastMap, FastSet, Span};
use rules::{Finding, missing_launch_argument};
use workspace::RobotCall;
use workspace::config::XacroArgs;

/// One way in which launch files call a robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Launched {
    /// The name of the launch file that is started, with a number from its second call on.
    pub name: String,
    /// All arguments.
    pub args: XacroArgs,
    /// Where the launch files make these calls.
    pub calls: Vec<Span>,
}

/// The distinct calls of a robot of which all arguments are known, in the order of the paths of the launch files.
/// `own` are arguments that the robot is known to read.
pub(super) fn distinct_calls(
    session: &Session,
    robot: &Path,
    own: &[(EcoString, EcoString)],
) -> Vec<Launched> {
    let mut found: Vec<Launched> = Vec::new();
    let mut known = None;
    for call in session
        .robot_calls(robot)
        .iter()
        .filter(|call| call.target.as_deref() == Some(robot))
    {
        let Some(mut args) = known_args(session, call) else {
            continue;
        };
        // what the robot does not read makes no difference
        args.retain(|(name, _)| {
            if own.iter().any(|(own, _)| own == name) {
                return true;
            }
            let known = known.get_or_insert_with(|| KnownArguments::of(session, robot));
            !known.complete || known.names.contains(name.as_str())
        });
        let site = Span {
            file: session.vfs.file_id(&call.call.caller),
            range: call.call.range,
        };
        match found
            .iter_mut()
            .find(|launched| same(&launched.args, &args))
        {
            Some(launched) if launched.calls.contains(&site) => {}
            Some(launched) => launched.calls.push(site),
            None => {
                let file = call.call.through.first().unwrap_or(&call.call.caller);
                let name = file
                    .file_name()
                    .unwrap_or_default()
                    .to_string_lossy()
                    .into_owned();
                let further = format!("{name} (");
                let is_of_file =
                    |known: &&Launched| known.name == name || known.name.starts_with(&further);
                let name = match found.iter().filter(is_of_file).count() {
                    0 => name,
                    before => format!("{further}{})", before + 1),
                };
                found.push(Launched {
                    name,
                    args,
                    calls: vec![site],
                });
            }
        }
    }
    found
}

/// The distinct calls of a robot, for somebody who picks one.
pub fn launched_roots(session: &Session, robot: &Path) -> Vec<RootConfig> {
    let choice = |launched: Launched| RootConfig {
        file: robot.to_owned(),
        args: launched.args,
        preset: Some(launched.name),
    };
    distinct_calls(session, robot, &[])
        .into_iter()
        .take(CALL_RUNS)
        .map(choice)
        .collect()
}

/// The arguments of a call, where all of them are known.
fn known_args(session: &Session, call: &RobotCall) -> Option<XacroArgs> {
    let value = |argument: &workspace::launch::CallArgument| {
        let value = argument.given(&session.packages, &call.call.caller)?;
        Some((argument.name.clone(), value))
    };
    if call.call.open {
        None
    } else {
        let given = call
            .call
            .args
            .iter()
            .filter(|argument| !argument.is_left_out());
        given.map(value).collect()
    }
}

/// The expansions to be made for calls, beside those with defaults: at most [`CALL_RUNS`] for each robot.
pub(super) fn launched_tasks(session: &Session, results: &[RootResult]) -> Vec<CheckTask> {
    let with_arguments = results.iter().filter(|result| {
        let reads_some = !result.arguments.is_empty() || result.findings.iter().any(is_not_given);
        reads_some && !is_configured(session, &result.task.file)
    });
    with_arguments
        .flat_map(|result| launched_tasks_of(session, result))
        .collect()
}

/// Whether the configuration says with which arguments a file is expanded.
fn is_configured(session: &Session, file: &Path) -> bool {
    let settings = session.settings(file);
    settings
        .config
        .roots
        .iter()
        .any(|root| root.files(&session.vfs).iter().any(|own| own == file))
}

fn launched_tasks_of(session: &Session, result: &RootResult) -> Vec<CheckTask> {
    let has = |(name, value): &(String, String)| {
        result
            .arguments
            .iter()
            .any(|(own, default)| own == name && default == value)
    };
    let is_other = |launched: &Launched| result.is_as_called || !launched.args.iter().all(has);
    let (mut others, defaults): (Vec<_>, Vec<_>) =
        distinct_calls(session, &result.task.file, &result.arguments)
            .into_iter()
            .partition(is_other);
    let are_all = others.len() <= CALL_RUNS
        && defaults.is_empty()
        && is_loaded_by_known_calls(session, &result.task.file);
    others.truncate(CALL_RUNS);
    let of = others
        .iter()
        .chain(&defaults)
        .map(|launched| launched.calls.len())
        .sum();
    let task = |launched: Launched| CheckTask {
        args: launched.args,
        preset: Some(launched.name),
        called: Some(LaunchCallSites {
            calls: launched.calls,
            of,
            are_all,
        }),
        ..result.task.clone()
    };
    others.into_iter().map(task).collect()
}

/// Whether launch files and programs load a robot only by calls of which all arguments are known.
fn is_loaded_by_known_calls(session: &Session, robot: &Path) -> bool {
    let all = session.robot_calls(robot);
    let mut own = all
        .iter()
        .filter(|call| call.target.as_deref() == Some(robot));
    let calls = |path: &Path| all.iter().any(|call| call.call.caller == path);
    own.all(|call| known_args(session, call).is_some())
        && !session.callers.load_where(robot, |path| !calls(path))
}

/// Take the errors about arguments that a call does not give out of the robots: they belong to the launch files. A robot
/// that no call gives an argument has the error itself.
pub(super) fn missing_arguments(results: &mut [RootResult]) -> Vec<Finding> {
    let lacking = |result: &RootResult| -> Vec<(PathBuf, Span)> {
        let findings = result
            .findings
            .iter()
            .filter(|finding| is_not_given(finding));
        findings
            .map(|finding| (result.task.file.clone(), finding.span))
            .collect()
    };
    let as_written = results.iter().filter(|result| result.task.called.is_none());
    let always: FastSet<(PathBuf, Span)> = as_written.flat_map(lacking).collect();
    let mut found: FastMap<(Span, String), Finding> = FastMap::default();
    for result in results {
        let Some(called) = &result.task.called else {
            continue;
        };
        let file = &result.task.file;
        result.findings.retain(|finding| {
            let Some(name) = not_given(finding) else {
                return true;
            };
            if always.contains(&(file.clone(), finding.span)) {
                return true;
            }
            for &call in &called.calls {
                let missing = || missing_launch_argument(call, name, file, finding.span);
                found.entry((call, name.to_owned())).or_insert_with(missing);
            }
            false
        });
    }
    found.into_values().collect()
}

/// Of robots that fail with their defaults, what the calls say counts.
pub(super) fn prefer_calls(results: &mut [RootResult]) {
    let works = |result: &&RootResult| {
        result.task.called.is_some() && !result.findings.iter().any(is_not_given)
    };
    let working = results
        .iter()
        .filter(works)
        .map(|result| result.task.file.clone());
    let working: FastSet<PathBuf> = working.collect();
    for result in results.iter_mut().filter(|result| result.is_as_called) {
        if working.contains(&result.task.file) {
            result.findings.clear();
        }
    }
}

/// The argument that is read and not given; a misspelled name is another mistake.
fn not_given(finding: &Finding) -> Option<&str> {
    match &finding.outside {
        Some(expand::Outside::Argument(name))
            if finding.problem == Some(expand::ProblemKind::UndefinedArg) =>
        {
            (!finding.probed && finding.fix.is_none()).then_some(name)
        }
        _ => None,
    }
}

fn is_not_given(finding: &Finding) -> bool {
    not_given(finding).is_some()
}

/// Whether two lists give the same arguments the same values.
fn same(a: &XacroArgs, b: &XacroArgs) -> bool {
    by_name(a) == by_name(b)
}

fn by_name(args: &XacroArgs) -> BTreeMap<&str, &str> {
    let args = args.iter();
    args.map(|(name, value)| (name.as_str(), value.as_str()))
        .collect()
}

#[cfg(test)]
mod tests {
    use crate::{CheckOptions, Session, Setup};
    use vfs::testing::Tree;

    /// An unknown type with `side:=right`; and an argument without a default unless `sim` is true.
    const ROBOT: &str = "<robot name='r' xmlns:xacro='x'><xacro:arg name='side' default='left'/>\
                         <xacro:arg name='sim' default='true'/><link name='a'/>\
                         <xacro:property name='type' value=\"${'fix' if '$(arg side)' == 'right' else 'fixed'}\"/>\
                         <joint name='j' type='${type}'><parent link='a'/><child link='b'/></joint><link name='b'/>\
                         <xacro:unless value='$(arg sim)'><gazebo><p>$(arg ip)</p></gazebo></xacro:unless></robot>";

    /// Check a robot with a script: severity, message and lines of the related places of all that is an error.
    fn check_script(robot: &str, script: &str, args: &[(&str, &str)], expected: &[&str]) {
        let tree = Tree::new();
        tree.write("r.xacro", robot);
        tree.write("a.sh", script);
        let (about, folders) = (tree.root().to_owned(), vec![tree.root().to_owned()]);
        let session = Session::new(
            &tree.environment(&[]),
            Setup {
                about,
                folders,
                ..Setup::default()
            },
        )
        .unwrap();
        let args = args
            .iter()
            .map(|(name, value)| ((*name).to_owned(), (*value).to_owned()))
            .collect();
        let options = CheckOptions {
            paths: vec![tree.root().to_owned()],
            args,
            ..CheckOptions::default()
        };
        let report = crate::check(&session, &options);
        let found = report
            .findings
            .iter()
            .filter(|finding| finding.severity > rules::Severity::Info);
        let found: Vec<String> = found
            .map(|finding| {
                let in_script = |span: base::Span| report.path(span.file).ends_with("a.sh");
                let places = finding
                    .related
                    .iter()
                    .filter(|related| in_script(related.span));
                let places = places.map(|related| related.message.as_str());
                let own = if in_script(finding.span) {
                    " at the call"
                } else {
                    ""
                };
                let places: Vec<&str> = std::iter::once(own)
                    .chain(places)
                    .filter(|s| !s.is_empty())
                    .collect();
                format!(
                    "{}{}",
                    finding.message,
                    places.join("; ").replace("in this call", " in this call")
                )
            })
            .collect();
        assert_eq!(found, expected, "{script}");
        assert_eq!(report.robots, 1);
    }

    #[test]
    fn what_no_call_has_is_a_note() {
        let robot = ROBOT.replace("default='left'", "default='right'");
        let unknown = "joint `j` has unknown type `fix`";
        check_script(&robot, "xacro r.xacro side:=left\n", &[], &[]);
        // one of the calls gives nothing, or nobody knows what it gives
        let plain = "xacro r.xacro side:=left\nxacro r.xacro\n";
        check_script(&robot, plain, &[], &[unknown]);
        let open = "xacro r.xacro side:=left\nxacro r.xacro $ARGS\n";
        check_script(&robot, open, &[], &[unknown]);
    }

    #[test]
    fn findings_of_some_calls() {
        let unknown = "joint `j` has unknown type `fix`";
        check_script(ROBOT, "xacro r.xacro side:=left\n", &[], &[]);
        check_script(
            ROBOT,
            "xacro r.xacro side:=left\nxacro r.xacro side:=right\n",
            &[],
            &[&format!(
                "{unknown} [in 1 of 2 calls] in this call: side:=right"
            )],
        );
        check_script(
            ROBOT,
            "xacro r.xacro side:=right sim:=true\n",
            &[],
            &[&format!(
                "{unknown} [in the only call] in this call: side:=right"
            )],
        );
        // what the robot does not know makes no other call
        check_script(
            ROBOT,
            "xacro r.xacro side:=right\nxacro r.xacro side:=right n:=2\n",
            &[],
            &[&format!(
                "{unknown} [in all 2 calls] in this call: side:=right;  in this call: side:=right"
            )],
        );
        // a value that is not known
        check_script(ROBOT, "xacro r.xacro side:=right sim:=$1\n", &[], &[]);
        // with the defaults as well
        let always = ROBOT.replace("'left'", "'right'");
        check_script(
            &always,
            "xacro r.xacro side:=right\nxacro r.xacro sim:=True\n",
            &[],
            &[unknown],
        );
    }

    #[test]
    fn arguments_of_the_command_line_are_all_that_count() {
        check_script(
            ROBOT,
            "xacro r.xacro side:=right\n",
            &[("sim", "true")],
            &[],
        );
    }

    #[test]
    fn arguments_that_a_call_does_not_give() {
        let missing = "missing argument `ip` of `r.xacro` at the call";
        check_script(ROBOT, "xacro r.xacro sim:=false\n", &[], &[missing]);
        check_script(ROBOT, "xacro r.xacro sim:=false ip:=1\n", &[], &[]);
        check_script(ROBOT, "xacro r.xacro sim:=false $MORE\n", &[], &[]);
        // the robot fails with its defaults
        let real = ROBOT.replace("'true'", "'false'");
        check_script(
            &real,
            "xacro r.xacro ip:=1\nxacro r.xacro side:=left\n",
            &[],
            &[missing],
        );
        check_script(
            &real,
            "xacro r.xacro side:=left\n",
            &[],
            &["argument `ip` is not defined"],
        );
    }
}

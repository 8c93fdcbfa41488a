//! Robots that the defaults of their arguments do not give: expanded with what launch files and scripts pass.
use std::path::Path;

use super::session::Session;
use base::FastSet;
use expand::{Expansion, Outside, Problem, ProblemKind, Request, Severity, Sources, expand};
use workspace::GivenArg;

/// Callers that are tried.
const MOST_CALLERS: usize = 6;

/// The expansion of a file as it is called, when with its defaults (`first`) something fails that an argument may
/// decide and a call is known with which less fails. Else `first`, and `false`.
pub(super) fn as_called(
    session: &Session,
    sources: Sources<'_>,
    file: &Path,
    request: &Request,
    first: Expansion,
) -> (Expansion, bool) {
    let mut fails = Failures::of(&first);
    if fails.count() == 0 || request.cancel.is_cancelled() {
        return (first, false);
    }
    let (mut best, mut is_called) = (first, false);
    let mut tried: Vec<Request> = Vec::new();
    for args in session.given_args(file).take(MOST_CALLERS) {
        for with_all in [false, true] {
            let Some(request) = called(request, &args, &fails, with_all) else {
                continue;
            };
            let is_known = |old: &Request| {
                (&old.args, &old.unknown_args) == (&request.args, &request.unknown_args)
            };
            if tried.iter().any(is_known) {
                continue;
            }
            let next = expand(sources, &request);
            tried.push(request);
            let left = Failures::of(&next);
            if left.count() < fails.count() && left.errors <= fails.errors {
                (best, fails, is_called) = (next, left, true);
            }
            if fails.count() == 0 {
                return (best, is_called);
            }
        }
    }
    (best, is_called)
}

/// What an expansion lacks that an argument may give.
struct Failures {
    /// Arguments that are read and not given.
    arguments: FastSet<String>,
    /// Files and packages that are not there.
    files: usize,
    /// Keys that a YAML file does not have: another file may have them.
    keys: usize,
    /// Everything else that may depend on a value.
    others: usize,
    /// All errors.
    errors: usize,
}

impl Failures {
    fn of(expansion: &Expansion) -> Self {
        let mut found = Self {
            arguments: FastSet::default(),
            files: 0,
            keys: 0,
            others: 0,
            errors: 0,
        };
        let is_error = |problem: &&Problem| !problem.probed && problem.severity == Severity::Error;
        for problem in expansion.problems.iter().filter(is_error) {
            found.errors += 1;
            match &problem.outside {
                Some(Outside::Argument(name)) => drop(found.arguments.insert(name.to_string())),
                Some(Outside::File) => found.files += 1,
                _ if problem.reference.contains("yaml dictionary has no key") => found.keys += 1,
                _ if is_value(problem.kind) => found.others += 1,
                _ => {}
            }
        }
        found
    }

    fn count(&self) -> usize {
        self.arguments.len() + self.files + self.keys + self.others
    }
}

/// Whether a value is wrong that others may give.
fn is_value(kind: ProblemKind) -> bool {
    matches!(
        kind,
        ProblemKind::ExpressionError | ProblemKind::InvalidCondition
    )
}

/// The request with the arguments of a caller. Those whose values the caller computes are unknown where nothing else is
/// known of them; `with_all`, also where the file has a default that names a file that is not there.
fn called(
    request: &Request,
    args: &[GivenArg],
    fails: &Failures,
    with_all: bool,
) -> Option<Request> {
    let own: FastSet<&str> = request.args.iter().map(|(name, _)| name.as_str()).collect();
    let mut next = request.clone();
    let mut seen = FastSet::default();
    for arg in args.iter().filter(|arg| !own.contains(arg.name.as_str())) {
        let is_wanted =
            fails.arguments.contains(&arg.name) || with_all && fails.files + fails.keys > 0;
        match &arg.value {
            Some(value) if seen.insert(&arg.name) => {
                next.args.push((arg.name.clone(), value.clone()))
            }
            None if is_wanted && seen.insert(&arg.name) => next.unknown_args.push(arg.name.clone()),
            _ => {}
        }
    }
    (!seen.is_empty()).then_some(next)
}

#[cfg(test)]
mod tests {
    use crate::{CheckOptions, Session, Setup};
    use vfs::testing::Tree;

    /// Check `r.urdf.xacro` with these contents beside further files: errors, warnings and notes about arguments.
    fn check_called(robot: &str, files: &[(&str, &str)], expected: &[&str]) {
        let tree = Tree::new();
        let around = format!("<robot name='r' xmlns:xacro='x'><link name='base'/>{robot}</robot>");
        tree.write(
            "r.urdf.xacro",
            if robot.starts_with("<robot") {
                robot
            } else {
                &around
            },
        );
        for (name, text) in files {
            tree.write(name, text);
        }
        let setup = Setup {
            about: tree.root().to_owned(),
            folders: vec![tree.root().to_owned()],
            ..Setup::default()
        };
        let session = Session::new(&tree.environment(&[]), setup).unwrap();
        let options = CheckOptions {
            paths: vec![tree.root().to_owned()],
            ..CheckOptions::default()
        };
        let report = crate::check(&session, &options);
        let found = report
            .findings
            .iter()
            .filter(|f| f.rule.code.starts_with("XAC0") && !f.rule.name.starts_with("unused"));
        let found: Vec<String> = found
            .map(|finding| format!("{} {}", finding.severity, finding.rule.name))
            .collect();
        assert_eq!(found, expected, "{robot} {files:?}");
    }

    #[test]
    fn arguments_that_a_launch_file_gives() {
        let robot = "<xacro:property name='p' value='$(arg side)' lazy_eval='false'/>";
        check_called(robot, &[], &["error undefined-arg"]);
        // in a package, others may use the robot
        let manifest = ("package.xml", "<package><name>p</name></package>");
        check_called(robot, &[manifest], &["info undefined-arg"]);
        check_called(
            robot,
            &[manifest, ("README.md", "see r.urdf.xacro")],
            &["error undefined-arg"],
        );
        check_called(
            robot,
            &[manifest, ("README.md", "└── r.urdf.xacro")],
            &["info undefined-arg"],
        );
        for launch in [
            "xacro r.urdf.xacro side:=left",
            "'r.urdf.xacro', ' side:=', compute()",
            "r.urdf.xacro side:=$(eval x)",
        ] {
            check_called(robot, &[("launch/r.launch.py", launch)], &[]);
        }
        // through another launch file, which alone names the robot
        let outer = (
            "launch/outer.launch.xml",
            "<launch><include file='$(dirname)/inner.launch.py'><arg name='robot' value='r.urdf.xacro'/></include></launch>",
        );
        let inner = |name: &str| {
            format!(
                "robot = LaunchConfiguration('robot')\npath = os.path.join(os.path.dirname(__file__), '..', robot)\n\
                 Command(['xacro ', path, ' {name}:=', 'left'])"
            )
        };
        let through = |name, expected: &[&str]| {
            check_called(
                robot,
                &[outer, ("launch/inner.launch.py", &inner(name))],
                expected,
            );
        };
        through("side", &[]);
        through("sight", &["error undefined-arg"]);
        check_called(
            robot,
            &[("launch/r.launch.py", "xacro r.urdf.xacro sight:=left")],
            &["error undefined-arg"],
        );
        check_called(
            robot,
            &[("launch/s.launch.py", "xacro s.urdf.xacro side:=left")],
            &["error undefined-arg"],
        );
        // a similar name is declared: a launch file does not excuse it
        let misspelled = "<xacro:arg name='prefix' default=''/><xacro:property name='p' value='$(arg prefx)' lazy_eval='false'/>";
        check_called(misspelled, &[], &["error undefined-arg"]);
    }

    #[test]
    fn arguments_of_files_that_are_no_robots_are_notes() {
        let library =
            "<robot xmlns:xacro='x'><link name='$(arg side)'/><joint name='$(arg side)'/></robot>";
        check_called(library, &[], &["info undefined-arg"]);
    }

    #[test]
    fn the_name_of_a_robot_may_be_an_argument() {
        let robot = "<robot name='$(arg name)' xmlns:xacro='x'><xacro:arg name='name' default='r'/><link name='b'/></robot>";
        check_called(robot, &[], &["warning use-before-definition"]);
        // in a package, others may give it
        let manifest = ("package.xml", "<package><name>p</name></package>");
        check_called(robot, &[manifest], &["info use-before-definition"]);
        check_called(robot, &[("README.md", "xacro r.urdf.xacro name:=arm")], &[]);
    }

    #[test]
    fn defaults_that_name_no_file() {
        let robot =
            "<xacro:arg name='kind' default='none'/><xacro:include filename='$(arg kind).xacro'/>";
        let part = ("big.xacro", "<robot/>");
        let given = (
            "r.launch",
            "<launch><arg name='kind' default='big'/>xacro r.urdf.xacro kind:=$(arg kind)</launch>",
        );
        check_called(robot, &[part, given], &[]);
        // given, with a value that is unknown
        check_called(
            robot,
            &[("r.launch", "xacro r.urdf.xacro kind:=$(arg kind)")],
            &[],
        );
        // given to a file that is computed as well
        let script =
            "doc = xacro.parse(open(path))\nxacro.process_doc(doc, mappings={'kind': kind})";
        check_called(robot, &[part, ("r.launch.py", script)], &[]);
        // given, and wrong
        check_called(
            robot,
            &[("r.launch", "xacro r.urdf.xacro kind:=small")],
            &["error include-not-found"],
        );
        // the file is missing whatever is given
        let literal =
            "<xacro:arg name='kind' default='none'/><xacro:include filename='gone.xacro'/>";
        check_called(literal, &[given], &["error include-not-found"]);
    }

    #[test]
    fn keys_of_a_file_that_the_caller_computes() {
        let robot = "<xacro:arg name='config' default='a.yaml'/>\
                     <xacro:property name='all' value=\"${xacro.load_yaml('$(arg config)')}\"/>\
                     <xacro:property name='own' value=\"${all['size']}\" lazy_eval='false'/>";
        let yaml = ("a.yaml", "length: 1");
        check_called(robot, &[yaml], &["error undefined-property"]);
        let computed = (
            "r.launch.py",
            "Command(['xacro r.urdf.xacro', ' config:=', made_file])",
        );
        check_called(robot, &[yaml, computed], &[]);
        let given = (
            "r.launch.py",
            "Command(['xacro r.urdf.xacro', ' config:=a.yaml'])",
        );
        check_called(robot, &[yaml, given], &["error undefined-property"]);
    }

    #[test]
    fn branches_of_a_value_that_is_not_known() {
        let robot = |condition: &str| {
            format!(
                "<xacro:arg name='kind' default='none'/>\
                 <xacro:property name='all' value=\"${{xacro.load_yaml('$(arg kind).yaml')}}\"/>\
                 <xacro:if value='{condition}'><xacro:property name='own' value=\"${{all['a']}}\"/></xacro:if>\
                 <xacro:unless value='{condition}'><xacro:property name='own' value=''/></xacro:unless>\
                 <link name=\"${{own['x']}}\"/>"
            )
        };
        let given = [("r.launch", "xacro r.urdf.xacro kind:=$(arg kind)")];
        check_called(&robot("${'a' in all}"), &given, &[]);
        // known whatever the file holds
        check_called(&robot("${1 > 2}"), &given, &["error expression-error"]);
    }

    #[test]
    fn values_from_empty_arguments() {
        let number = "<xacro:arg name='width' default=''/><xacro:property name='w' value='$(arg width)'/><link name='${w / 2}'/>";
        check_called(number, &[], &["info expression-error"]);
        check_called(number, &[("r.launch", "xacro r.urdf.xacro width:=2")], &[]);
        check_called(
            &number.replace("default=''", "default='wide'"),
            &[],
            &["error expression-error"],
        );
        let package = "<xacro:arg name='config' default=''/><xacro:property name='c' value='$(arg config)'/><link name='$(find ${c})'/>";
        check_called(package, &[], &["info expression-error"]);
        check_called(
            &package.replace("${c}", ""),
            &[],
            &["error expression-error"],
        );
    }

    #[test]
    fn variables_of_the_environment() {
        let robot = "<xacro:if value='${$(env ROS_VERSION) == 2}'><link name='b'/></xacro:if>";
        check_called(
            robot,
            &[("package.xml", "<package><name>p</name></package>")],
            &[],
        );
        check_called(robot, &[], &[]);
        check_called(
            "<link name='$(env ROBOT_SERIAL)'/>",
            &[],
            &["info expression-error"],
        );
    }
}

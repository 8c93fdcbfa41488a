//! What a file is for: a robot of its own, or a part of others.
//!
//! Much of what is wrong in a file by itself is right in the file that includes it: names that are defined there, links
//! that are added there. So such findings are judged by the role of the file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;
use rayon::prelude::*;

use super::graph;
use super::includes::Included;
use super::roots::{Job, Reason};
use super::session::Session;
use super::walk;
use base::FastSet;
use expand::{Expansion, Outside, ProblemKind};
use model::{Kinematics, Robot};
use rules::{Check, Finding, RootKind, Severity, is_plain_urdf, missing_robot_name, named};
use workspace::RobotCall;
use workspace::launch::Argument;

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
enum Verdict {
    Keep,
    /// It has another severity.
    Set(Severity),
    /// It may be right elsewhere: worth a note, once in a file.
    Note,
    Drop,
}

/// An expansion of a file that was checked.
pub(super) struct Checked<'a> {
    pub(super) job: &'a Job,
    pub(super) kind: RootKind,
    pub(super) expansion: &'a Expansion,
    pub(super) robot: Option<&'a Robot>,
}

impl Session {
    /// Of findings that hold only as long as a file stands alone, keep what is true in its role.
    pub(super) fn settle_by_role(&self, checked: &Checked<'_>, findings: &mut Vec<Finding>) {
        if !findings.iter().any(depends_on_role) {
            return;
        }
        let role = self.role(checked, findings);
        let is_alone = checked.job.reason == Reason::Alone;
        let mut noted = FastSet::default();
        findings.retain_mut(|finding| match verdict(role, finding) {
            // what has no value here: the answer to whether the file works
            Verdict::Note if is_alone && finding.outside == Some(Outside::Environment) => true,
            Verdict::Keep if role == Role::Root && self.may_get_elsewhere(checked.job, finding) => {
                finding.severity = finding.severity.min(Severity::Info);
                noted.insert((finding.rule.code, finding.span.file, finding.message.clone()))
            }
            Verdict::Keep => true,
            Verdict::Drop => false,
            Verdict::Set(severity) => {
                finding.severity = finding.severity.min(severity);
                true
            }
            Verdict::Note => {
                finding.severity = finding.severity.min(Severity::Info);
                noted.insert((finding.rule.code, finding.span.file, finding.message.clone()))
            }
        });
    }

    /// What to report of a file that is a robot but for its name: it gives one tree, which is of more than one link unless the
    /// file is checked by itself, and nothing includes it.
    pub(super) fn nameless(&self, checked: &Checked<'_>) -> Option<Finding> {
        let Checked { job, kind, expansion, robot } = *checked;
        let robot = robot.filter(|robot| kind == RootKind::Library && robot.lacks_only_a_name())?;
        let is_tree = (!robot.joints.is_empty() || job.reason == Reason::Alone)
            && robot.names_are_known()
            && above_fragment(robot).is_none()
            && Kinematics::of(robot).roots(robot).len() == 1;
        let is_open = !expansion.whole || !is_tree || self.is_included(&job.file);
        if is_open { None } else { missing_robot_name(expansion, robot) }
    }

    fn role(&self, checked: &Checked<'_>, findings: &[Finding]) -> Role {
        match self.role_by_itself(checked, findings) {
            Role::Root if checked.job.reason == Reason::Walked && self.is_for_another(&checked.job.file) => {
                Role::Part
            }
            role => role,
        }
    }

    /// The role of a file, whatever launch files give to other robots.
    fn role_by_itself(&self, checked: &Checked<'_>, findings: &[Finding]) -> Role {
        let Checked { job, kind, expansion, robot } = *checked;
        if job.reason == Reason::Root {
            return Role::Root;
        }
        let is_called = || self.is_named(&job.file);
        let document = expansion.files.first().map(|file| &file.source.document);
        let gives_robot = kind == RootKind::Robot || document.is_some_and(graph::gives_robot);
        if self.is_included(&job.file) {
            return if gives_robot && is_called() { Role::Root } else { Role::Part };
        }
        if job.reason == Reason::Alone {
            return Role::Root;
        }
        let misspelled =
            || findings.iter().any(|finding| finding.rule == named::UNDEFINED_LINK && finding.fix.is_some());
        // a file in xacro without content is one that somebody has yet to write
        let is_begun = |robot: &Robot| {
            !robot.links.is_empty() || !robot.joints.is_empty() || document.is_some_and(graph::gives_robot)
        };
        if !is_plain_urdf(&job.file) && robot.is_some_and(|robot| !is_begun(robot)) && !is_called() {
            return Role::Unknown;
        }
        let missing = robot.and_then(above_fragment);
        // whoever names the file together with the link attaches it there
        let is_whole = |link: &EcoString| misspelled() || is_called() && !self.is_named_with(&job.file, link);
        match gives_robot {
            true if missing.is_none_or(is_whole) => Role::Root,
            _ => Role::Unknown,
        }
    }

    /// Whether what a robot lacks may come from somewhere else: nobody in the workspace names the file, and it is of a
    /// package, so that others may give its arguments, or other files define the property that it reads.
    fn may_get_elsewhere(&self, job: &Job, finding: &Finding) -> bool {
        if matches!(job.reason, Reason::Root | Reason::Alone) || finding.fix.is_some() {
            return false;
        }
        let is_open = match (&finding.outside, finding.problem) {
            (Some(Outside::Argument(_)), Some(ProblemKind::UndefinedArg)) => {
                self.packages.containing(&job.file).is_some()
            }
            (Some(Outside::Includer), Some(ProblemKind::UndefinedProperty)) => {
                let name = self.vfs.document(&self.vfs.path(finding.span.file));
                let name = name.map(|source| source.document.slice(finding.span.range));
                name.is_ok_and(|name| self.included_around(&job.file).is_some_and(|all| all.defines(&name)))
            }
            _ => false,
        };
        is_open && !self.is_named(&job.file)
    }

    /// Whether a file of the workspace includes this one, whatever the condition around the include.
    pub(super) fn is_included(&self, file: &Path) -> bool {
        self.included_around(file).is_some_and(|included| included.has(file))
    }

    /// Whether a launch file gives a file to another robot, which includes what it is given.
    fn is_for_another(&self, file: &Path) -> bool {
        let given = || -> Vec<String> {
            let all = self.included_around(file);
            all.iter().flat_map(|all| all.given()).map(|name| format!("{name}:=")).collect()
        };
        let is_called = || self.calls_around(file).iter().any(|call| call.target.as_deref() == Some(file));
        self.is_passed(file) || !is_called() && given().iter().any(|given| self.is_quoted(file, given))
    }

    /// Whether a launch file gives a file to another robot, as the value of an argument.
    fn is_passed(&self, file: &Path) -> bool {
        let is_it = |call: &RobotCall, argument: &Argument| {
            let value = argument.value.path(&self.packages, &call.call.caller);
            call.target.as_deref() != Some(file) && value.as_deref() == Some(file)
        };
        let calls = self.calls_around(file);
        calls.iter().any(|call| call.call.args.iter().any(|argument| is_it(call, argument)))
    }

    /// The files of the workspace that include this one.
    pub(super) fn includers(&self, file: &Path) -> Vec<PathBuf> {
        let all = self.included_around(file);
        all.iter().flat_map(|all| all.includers(file)).map(Path::to_owned).collect()
    }

    /// What the descriptions of the workspace around a file include.
    fn included_around(&self, file: &Path) -> Option<Arc<Included>> {
        let top = self.packages.sources_around(file)?;
        Some(self.included_below(&top, || {
            let files = walk::all_descriptions(&top, &self.vfs, &self.env);
            let sources = files.par_iter().filter_map(|file| self.vfs.document(file).ok());
            Arc::new(Included::of_files(sources.collect(), &self.packages))
        }))
    }
}

/// Whether a finding may be false in a file that is not expanded by itself, or with other arguments.
fn depends_on_role(finding: &Finding) -> bool {
    finding.outside.is_some() || matches!(finding.rule.check, Check::Whole(_))
}

fn verdict(role: Role, finding: &Finding) -> Verdict {
    let is_misspelled = finding.fix.is_some() && !finding.probed;
    match (&finding.outside, role) {
        (None, _) if !depends_on_role(finding) => Verdict::Keep,
        (Some(Outside::File), _) => Verdict::Keep,
        (Some(Outside::Environment), _) => Verdict::Note,
        (_, Role::Part) => Verdict::Drop,
        (Some(Outside::Argument(_)), _) if is_misspelled => Verdict::Keep,
        (_, Role::Unknown) => Verdict::Note,
        (None, Role::Root) => Verdict::Keep,
        (Some(_), Role::Root) if finding.probed => Verdict::Note,
        (Some(Outside::Argument(_)), Role::Root) => match finding.problem {
            Some(ProblemKind::UndefinedArg) => Verdict::Keep,
            // the robot works as soon as the argument is given
            Some(ProblemKind::UseBeforeDefinition) => Verdict::Set(Severity::Warning),
            _ => Verdict::Note,
        },
        (Some(Outside::Includer), Role::Root) => Verdict::Keep,
    }
}

/// A link that a robot does not have; it and others like it are above all of its links: the robot is made to be attached
/// there.
fn above_fragment(robot: &Robot) -> Option<&EcoString> {
    let names: FastSet<&EcoString> =
        robot.links.iter().filter_map(|link| link.name.as_ref()?.name()).collect();
    let parents = robot.joints.iter().filter_map(|joint| joint.parent.as_ref()?.name());
    let missing = parents.filter(|parent| !names.contains(parent)).min()?;
    let is_fragment = !robot.links.is_empty() && Kinematics::of(robot).roots(robot).is_empty();
    is_fragment.then_some(missing)
}

#[cfg(test)]
mod tests {
    use crate::{CheckOptions, Session, Setup};
    use vfs::testing::Tree;

    /// Check a workspace of files (name and text; `robot` stands around texts of descriptions) and compare what is
    /// found of names, links and joints: `file severity rule`, in order.
    fn check_roles(files: &[(&str, &str)], expected: &[&str]) {
        check_roles_of("", files, expected);
    }

    /// The same of one path of the workspace alone.
    fn check_roles_of(path: &str, files: &[(&str, &str)], expected: &[&str]) {
        let tree = Tree::new();
        for (name, text) in files {
            let is_description = name.ends_with("xacro") && !text.is_empty() && !text.starts_with("<robot");
            let around = |text: &str| format!("<robot name='r' xmlns:xacro='x'>{text}</robot>");
            tree.write(name, &if is_description { around(text) } else { (*text).to_owned() });
        }
        let setup = Setup {
            about: tree.root().to_owned(),
            folders: vec![tree.root().to_owned()],
            ..Setup::default()
        };
        let session = Session::new(&tree.environment(&[]), setup).unwrap();
        let options = CheckOptions { paths: vec![tree.root().join(path)], ..CheckOptions::default() };
        let report = session.check(&options);
        let about_names = ["XAC0", "STR", "CTL", "XML001", "XML010"];
        let passed_over = ["nonstandard-xacro-namespace", "unused"];
        let found = report.findings.iter().filter(|finding| {
            let is_other = passed_over.iter().any(|name| finding.rule.name.starts_with(name));
            !is_other && about_names.iter().any(|code| finding.rule.code.starts_with(code))
        });
        let found: Vec<String> = found
            .map(|finding| {
                let path = session.vfs.path(finding.span.file);
                let name = path.strip_prefix(tree.root()).unwrap_or(&path).display().to_string();
                format!("{name} {} {}", finding.severity, finding.rule.name)
            })
            .collect();
        assert_eq!(found, expected, "{files:#?}");
    }

    const ARM: &str = "<link name='base'/><link name='arm'/><joint name='j' type='fixed'><parent link='base'/>\
                       <child link='arm'/></joint>";

    #[test]
    fn parts_of_robots_are_not_judged_as_robots() {
        let part = "<link name='hand'/><joint name='h' type='fixed'><parent link='arm'/><child link='hand'/>\
                    <origin xyz='${reach} 0 0'/></joint>\
                    <transmission name='t'><type>x</type><joint name='j'><hardwareInterface>y</hardwareInterface></joint>\
                    </transmission>";
        let robot =
            format!("<xacro:arg name='hand' default='false'/><xacro:property name='reach' value='1'/>{ARM}");
        let behind_condition =
            format!("{robot}<xacro:if value='$(arg hand)'><xacro:include filename='hand.xacro'/></xacro:if>");
        check_roles(&[("r.urdf.xacro", &behind_condition), ("hand.xacro", part)], &[]);
        let computed = format!(
            "{robot}<xacro:arg name='kind' default='none'/><xacro:include filename='$(arg kind).xacro'/>"
        );
        check_roles(&[("r.urdf.xacro", &computed), ("hand.xacro", part), ("none.xacro", "<robot/>")], &[]);
        let unprefixed = format!("{robot}<include filename='hand.xacro'/>");
        check_roles(
            &[("r.urdf.xacro", &unprefixed), ("hand.xacro", part)],
            &["r.urdf.xacro error unprefixed-xacro-tag"],
        );
        // the same file under a robot that does not define what it needs
        let lacking = format!("{ARM}<xacro:include filename='hand.xacro'/>");
        check_roles(
            &[("r.urdf.xacro", &lacking), ("hand.xacro", part)],
            &["hand.xacro error undefined-property"],
        );
        // a launch file expands the part by itself
        let launch = ("see.launch", "<param command='xacro hand.xacro'/>");
        check_roles(
            &[("r.urdf.xacro", &behind_condition), ("hand.xacro", part), launch],
            &[
                "hand.xacro error undefined-link",
                "hand.xacro error undefined-property",
                "hand.xacro error transmission-unknown-joint",
            ],
        );
    }

    #[test]
    fn a_chain_below_a_missing_link_is_made_to_be_attached() {
        let hand = "<robot name='hand'><link name='palm'/><joint name='h' type='fixed'><parent link='tool0'/>\
                    <child link='palm'/></joint></robot>";
        check_roles(&[("hand.urdf", hand)], &["hand.urdf info undefined-link"]);
        // named by somebody, it is a robot
        check_roles(
            &[("hand.urdf", hand), ("README.md", "see hand.urdf")],
            &["hand.urdf error undefined-link"],
        );
        // named together with the link to which it is attached
        check_roles(
            &[("hand.urdf", hand), ("a.launch", "send hand.urdf -l tool0")],
            &["hand.urdf info undefined-link"],
        );
        // two chains below two links of another robot
        let second = "<link name='tip'/><joint name='t' type='fixed'><parent link='flange'/><child link='tip'/></joint></robot>";
        let both = hand.replace("</robot>", second);
        let found = ["hand.urdf info undefined-link", "hand.urdf info undefined-link"];
        check_roles(&[("hand.urdf", &both)], &found);
        // the robot has a root: the parent of one link is misspelled
        let robot = "<robot name='r'><link name='base'/><link name='arm'/><joint name='j' type='fixed'>\
                     <parent link='bse'/><child link='arm'/></joint></robot>";
        check_roles(&[("r.urdf", robot)], &["r.urdf error undefined-link"]);
    }

    #[test]
    fn files_without_links() {
        let device = "<robot name='d'><webots><device reference='x'/></webots><ros2_control name='c' type='system'>\
                      <hardware><plugin>p</plugin></hardware><joint name='wheel'><command_interface name='velocity'/></joint>\
                      </ros2_control></robot>";
        check_roles(&[("device.urdf", device)], &[]);
        check_roles(&[("empty.urdf", "<robot name='e'/>")], &["empty.urdf error no-links"]);
        // one that stands in for parts that others add
        check_roles(&[("none.urdf", "<robot><!-- further links --></robot>")], &[]);
        // somebody has begun a description
        check_roles(&[("begun.xacro", "<robot name='e'/>")], &["begun.xacro info no-links"]);
        check_roles(
            &[("joints.urdf", "<robot name='e'><joint name='j' type='fixed'/></robot>")],
            &["joints.urdf error no-links"],
        );
    }

    #[test]
    fn empty_files() {
        check_roles(&[("yet.urdf.xacro", "")], &["yet.urdf.xacro info xml-syntax-error"]);
        check_roles(&[("yet.urdf", "")], &["yet.urdf info xml-syntax-error"]);
        check_roles(&[("yet.urdf", ""), ("a.launch", "yet.urdf")], &["yet.urdf error xml-syntax-error"]);
        let includes =
            "<robot name='r' xmlns:xacro='x'><link name='b'/><xacro:include filename='yet.xacro'/></robot>";
        check_roles(&[("r.urdf.xacro", includes), ("yet.xacro", "")], &["yet.xacro error xml-syntax-error"]);
    }

    #[test]
    fn a_file_that_is_asked_for_alone_has_to_work() {
        let begun = [("begun.xacro", "")];
        check_roles_of("begun.xacro", &begun, &["begun.xacro error xml-syntax-error"]);
        let reads = "<link name='a'/><link name='$(env NO_SUCH_VARIABLE)'/>";
        check_roles_of("r.xacro", &[("r.xacro", reads)], &["r.xacro error expression-error"]);
        let chain = "<link name='palm'/><joint name='h' type='fixed'><parent link='tool0'/><child link='palm'/></joint>";
        let hand = [("hand.xacro", chain)];
        check_roles_of("hand.xacro", &hand, &["hand.xacro error undefined-link"]);
        // but for what other files include
        let robot = format!("{ARM}<xacro:include filename='hand.xacro'/>");
        check_roles_of("hand.xacro", &[("r.urdf.xacro", &robot), ("hand.xacro", chain)], &[]);
    }

    #[test]
    fn transmissions_are_read_by_ros_1() {
        let manifest = |tool: &str| {
            format!("<package><name>p</name><buildtool_depend>{tool}</buildtool_depend></package>")
        };
        let transmission = |joint: &str| {
            format!(
                "<transmission name='{joint}'><type>x</type><joint name='{joint}'><hardwareInterface>y</hardwareInterface>\
                 </joint></transmission>"
            )
        };
        let none_fits = format!("{ARM}{}", transmission("k"));
        let one_fits = format!("{ARM}{}{}", transmission("k"), transmission("j"));
        for (tool, robot, severity) in [
            ("catkin", &none_fits, "error"),
            ("catkin", &one_fits, "error"),
            ("ament_cmake", &none_fits, "info"),
            ("ament_cmake", &one_fits, "warning"),
        ] {
            let files = [("package.xml", &*manifest(tool)), ("r.urdf.xacro", robot)];
            check_roles(&files, &[&format!("r.urdf.xacro {severity} transmission-unknown-joint")]);
        }
    }

    #[test]
    fn names_that_a_caller_may_define() {
        let library = "<robot xmlns:xacro='x'><xacro:macro name='m' params='x'><link name='${prefix}${x}${prefix}'/>\
                       <xacro:insert_block name='origin'/><xacro:other/></xacro:macro></robot>";
        let notes = [
            "lib.xacro info undefined-property",
            "lib.xacro info undefined-block",
            "lib.xacro info undefined-macro",
        ];
        check_roles(&[("lib.xacro", library)], &notes);
        // a macro that nothing calls, in a file that a robot includes
        let robot = format!("{ARM}<xacro:include filename='lib.xacro'/>");
        check_roles(&[("r.urdf.xacro", &robot), ("lib.xacro", library)], &notes);
        // called, what is missing is missing
        let calls = format!("{robot}<xacro:m x='1'/>");
        check_roles(
            &[("r.urdf.xacro", &calls), ("lib.xacro", library)],
            &[
                "lib.xacro error undefined-property",
                "lib.xacro error undefined-property",
                "lib.xacro error undefined-block",
                "lib.xacro error undefined-macro",
            ],
        );
        // a robot that consists of one misspelled call
        check_roles(&[("r.urdf.xacro", "<xacro:rm/>")], &["r.urdf.xacro error undefined-macro"]);
    }

    #[test]
    fn blocks_that_a_macro_passes_on() {
        let inner = "<xacro:macro name='inner' params='*origin *shape'><joint name='j' type='fixed'>\
                     <xacro:insert_block name='origin'/></joint><link name='l'><visual><geometry>\
                     <xacro:insert_block name='shape'/></geometry></visual></link></xacro:macro>";
        let library = |call: &str| {
            format!(
                "<robot xmlns:xacro='x'>{inner}<xacro:macro name='outer' params='*origin'>{call}</xacro:macro></robot>"
            )
        };
        let passes =
            library("<xacro:inner><xacro:insert_block name='origin'/><box size='1 1 1'/></xacro:inner>");
        check_roles(&[("lib.xacro", &passes)], &[]);
        // one that nobody defines is said by itself
        let undefined =
            "<xacro:inner><xacro:insert_block name='calibration'/><box size='1 1 1'/></xacro:inner>";
        check_roles(&[("lib.xacro", &library(undefined))], &["lib.xacro info undefined-block"]);
        let forgets = library("<xacro:inner><xacro:insert_block name='origin'/></xacro:inner>");
        check_roles(&[("lib.xacro", &forgets)], &["lib.xacro error macro-block-mismatch"]);
    }

    #[test]
    fn one_cause_is_one_finding() {
        let uses =
            "<link name='${prefix}base'/><xacro:arm/><xacro:insert_block name='b'/><link name='$(arg a)'/>";
        let missing =
            format!("<xacro:include filename='gone.xacro'/><xacro:property name='prefix_' value=''/>{uses}");
        check_roles(&[("r.urdf.xacro", &missing)], &["r.urdf.xacro error include-not-found"]);
        // nothing that is missing makes a slip of the fingers right
        let slip = missing.replace("prefix_", "prefx");
        let found = ["r.urdf.xacro error include-not-found", "r.urdf.xacro error undefined-property"];
        check_roles(&[("r.urdf.xacro", &slip)], &found);
        // a parameter of another macro is no definition that comes too late
        let late = format!(
            "<xacro:macro name='m'><link name='${{p}}'/></xacro:macro>{ARM}<xacro:m/>\
             <xacro:macro name='n' params='p'/><xacro:n p='1'/>"
        );
        check_roles(&[("r.urdf.xacro", &late)], &["r.urdf.xacro error undefined-property"]);
        let late = format!(
            "<xacro:property name='q' value='${{p}}' lazy_eval='false'/>{ARM}<xacro:property name='p' value='1'/>"
        );
        check_roles(&[("r.urdf.xacro", &late)], &["r.urdf.xacro error use-before-definition"]);
    }

    #[test]
    fn built_in_functions_are_no_values() {
        let robot = format!("{ARM}<link name='x'><inertial><mass value='${{len}}'/></inertial></link>");
        check_roles(
            &[("r.urdf.xacro", &robot)],
            &["r.urdf.xacro error orphan-link", "r.urdf.xacro error undefined-property"],
        );
        let part = "<robot xmlns:xacro='x'><link name='x'><inertial><mass value='${len}'/></inertial></link></robot>";
        check_roles(&[("part.xacro", part)], &["part.xacro info undefined-property"]);
    }
}

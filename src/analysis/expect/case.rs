//! One robot with one set of arguments, expanded and compared with what is expected of it.
use std::sync::Arc;

use super::super::configs::Settings;
use super::super::root_config::RootConfig;
use super::super::run_task;
use super::super::session::Session;
use super::context::ExpectationContext;
use super::evaluate::evaluate;
use super::outcome::{RULE, TestOptions};
use super::snapshot::Snapshot;
use base::{Span, TextRange};
use expand::{Expansion, Request, expand};
use model::{Kinematics, Robot};
use rules::{
    Category, Chosen, Finding, Related, RootKind, Rule, Settled, Severity, all, check_expansion,
    include_tags, rejections,
};
use vfs::SourceFile;
use workspace::config::{Axes, Expectation};

/// One robot with one set of arguments.
pub(super) struct Case {
    pub(super) root: RootConfig,
    pub(super) settings: Arc<Settings>,
    /// The number of the entry of `roots`.
    pub(super) number: usize,
}

/// What a test gave.
#[derive(Default)]
pub(super) struct Ran {
    pub(super) root: RootConfig,
    /// What failed.
    pub(super) findings: Vec<Finding>,
    /// The numbers of the expectations that apply.
    pub(super) applied: Vec<usize>,
    /// What files of `expands-to` are to hold.
    pub(super) snapshots: Vec<Snapshot>,
    /// The files that findings may be in.
    pub(super) files: Vec<Arc<SourceFile>>,
}

impl Case {
    /// What is expected of the robots of the root, also where it does not apply to this one.
    pub(super) fn expectations(&self) -> &[Expectation] {
        self.settings
            .config
            .roots
            .get(self.number)
            .map_or(&[], |root| &root.expect)
    }

    /// Expand the robot and compare it.
    pub(super) fn run(&self, session: &Session, options: &TestOptions) -> Ran {
        let expansion = expand(run_task::sources(session), &self.request(session, options));
        let robot = Robot::of(&expansion);
        let mut findings = self.rejections(session, options, &expansion, robot.as_ref());
        let applies =
            |(_, expected): &(usize, &Expectation)| has_values(&expansion, &expected.when);
        let applying: Vec<(usize, &Expectation)> = self
            .expectations()
            .iter()
            .enumerate()
            .filter(applies)
            .collect();
        let mut snapshots = Vec::new();
        // of what xacro rejects nothing can be expected
        if let Some(robot) = robot.filter(|_| findings.is_empty()) {
            let kinematics = Kinematics::of(&robot);
            for (_, expected) in &applying {
                let mut evaluation = ExpectationContext::new(
                    &self.root,
                    session,
                    (&expansion, &robot, &kinematics),
                    expected,
                );
                evaluate(&mut evaluation, options.update);
                findings.append(&mut evaluation.findings);
                snapshots.append(&mut evaluation.snapshots);
            }
        }
        for finding in &mut findings {
            self.show_includes(session, &expansion, finding);
        }
        let files = if findings.is_empty() {
            Vec::new()
        } else {
            sources(&expansion)
        };
        let applied = applying.into_iter().map(|(number, _)| number).collect();
        Ran {
            root: self.root.clone(),
            findings,
            applied,
            snapshots,
            files,
        }
    }

    fn request(&self, session: &Session, options: &TestOptions) -> Request {
        let file = self
            .root
            .file
            .strip_prefix(&session.env.cwd)
            .unwrap_or(&self.root.file);
        Request {
            file: vfs::slashed(file),
            args: self.root.args.clone(),
            ros_shell: true,
            limits: self.settings.config.limits.expansion(),
            cancel: options.check.cancel.clone(),
            ..Request::default()
        }
    }

    /// What makes xacro or urdfdom reject the robot.
    fn rejections(
        &self,
        session: &Session,
        options: &TestOptions,
        expansion: &Expansion,
        robot: Option<&Robot>,
    ) -> Vec<Finding> {
        let start = Span {
            file: session.vfs.file_id(&self.root.file),
            range: TextRange::default(),
        };
        if let Some(error) = &expansion.root_error {
            let message = format!("cannot read the file: {}", error.reason());
            let help = Some("check the path and the permissions of the file".to_owned());
            return vec![Finding {
                help,
                ..Finding::new(&RULE, start, message)
            }];
        }
        let mut findings = rejections(expansion, &session.vfs);
        if findings.is_empty() && expansion.has_errors() {
            let help = Some("run `xacro-lint check` on it".to_owned());
            findings.push(Finding {
                help,
                ..Finding::new(&RULE, start, "xacro rejects the file")
            });
        }
        if robot.is_none() && findings.is_empty() {
            let help = Some("list a robot description in `roots`".to_owned());
            findings.push(Finding {
                help,
                ..Finding::new(&RULE, start, "the root element is not `robot`")
            });
        }
        if findings.is_empty() {
            let is_of_tree = |rule: &&Rule| {
                rule.category == Category::Structure && rule.severity == Severity::Error
            };
            let rules: Vec<&'static Rule> = all().filter(is_of_tree).collect();
            let chosen = Chosen {
                rules: &rules,
                cancel: &options.check.cancel,
                tally: None,
            };
            let around = session.rule_env(&self.settings.config);
            let (kind, none) = ((RootKind::Robot, true), Settled::default());
            (findings, _) = check_expansion(expansion, robot, kind, around, chosen, &none);
            findings.retain(|finding| finding.severity == Severity::Error);
        }
        findings
    }

    /// A finding in another file says which include led there.
    fn show_includes(&self, session: &Session, expansion: &Expansion, finding: &mut Finding) {
        let own = session.vfs.file_id(&self.root.file);
        if finding.span.file == own
            || finding
                .related
                .iter()
                .any(|related| related.span.file == own)
        {
            return;
        }
        let around = session.rule_env(&self.settings.config);
        let tags = include_tags(expansion, around);
        let tag = tags.iter().find(|(file, _)| *file == finding.span.file);
        finding.related.extend(tag.map(|(_, span)| Related {
            span: *span,
            message: "included here".to_owned(),
            is_call: true,
        }));
    }
}

/// Whether each of these arguments has one of the values in the robot.
fn has_values(expansion: &Expansion, when: &Axes) -> bool {
    when.iter().all(|(name, values)| {
        let own = expansion.arguments.iter().find(|(own, _)| own == name);
        own.is_some_and(|(_, own)| values.iter().any(|value| is_value(value, own)))
    })
}

/// Whether a value of the configuration is that of an argument: `true` is also written `True` in xacro.
fn is_value(wanted: &str, own: &str) -> bool {
    let is_boolean = ["true", "false"]
        .iter()
        .any(|word| word.eq_ignore_ascii_case(wanted));
    wanted == own || is_boolean && wanted.eq_ignore_ascii_case(own)
}

fn sources(expansion: &Expansion) -> Vec<Arc<SourceFile>> {
    expansion
        .files
        .iter()
        .map(|file| file.source.clone())
        .collect()
}

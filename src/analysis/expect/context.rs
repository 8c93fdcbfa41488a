//! One expectation and one robot, and how what is not as expected is reported.
use std::cell::OnceCell;
use std::path::Path;

use ecow::EcoString;

use super::super::root_config::RootConfig;
use super::super::session::Session;
use super::outcome::{RULE, span_of_place};
use super::snapshot::Snapshot;
use base::Span;
use expand::{Expansion, Origin, Written, XId, write_mapped};
use model::{Kinematics, Robot, tag_start};
use packages::nearest;
use rules::{Finding, Related, calls, span_of};
use workspace::config::Expectation;

/// An expectation that applies to a robot.
pub(super) struct ExpectationContext<'a> {
    pub(super) root: &'a RootConfig,
    pub(super) session: &'a Session,
    pub(super) expansion: &'a Expansion,
    pub(super) robot: &'a Robot,
    pub(super) kinematics: &'a Kinematics,
    pub(super) expected: &'a Expectation,
    written: OnceCell<Written>,
    pub(super) findings: Vec<Finding>,
    pub(super) snapshots: Vec<Snapshot>,
}

impl<'a> ExpectationContext<'a> {
    pub(super) fn new(
        root: &'a RootConfig,
        session: &'a Session,
        (expansion, robot, kinematics): (&'a Expansion, &'a Robot, &'a Kinematics),
        expected: &'a Expectation,
    ) -> Self {
        let (findings, snapshots) = (Vec::new(), Vec::new());
        let written = OnceCell::new();
        Self {
            root,
            session,
            expansion,
            robot,
            kinematics,
            expected,
            written,
            findings,
            snapshots,
        }
    }

    /// The robot as text, with its sources.
    pub(super) fn written(&self) -> &Written {
        self.written.get_or_init(|| {
            let folder = self.expected.place.path.parent();
            let name = folder.map_or_else(String::new, |folder| banner_name(self.root, folder));
            write_mapped(&self.expansion.tree, &name)
        })
    }

    /// The text of the configuration with the values of arguments in it; none when one is not known, which is reported.
    pub(super) fn filled(&mut self, text: &str) -> Option<String> {
        match filled(text, &self.expansion.arguments) {
            Ok(text) => Some(text),
            Err(name) => {
                let known = self
                    .expansion
                    .arguments
                    .iter()
                    .map(|(name, _)| name.as_str());
                let help = match nearest(&name, known) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => "use an argument that the robot declares".to_owned(),
                };
                let mut finding = Finding::new(
                    &RULE,
                    self.place(),
                    format!("unknown argument `{name}` in the expectation"),
                );
                finding.help = Some(help);
                self.findings.push(finding);
                None
            }
        }
    }

    pub(super) fn place(&self) -> Span {
        span_of_place(&self.session.vfs, &self.expected.place)
    }

    /// Report something that is not as expected, at the text that makes it so.
    pub(super) fn fail(&mut self, origin: Origin, message: String, help: Option<String>) {
        let span = span_of(self.expansion, origin).unwrap_or(self.place());
        let mut finding = Finding::new(&RULE, span, message);
        finding.related = calls(self.expansion, origin);
        let label = match &self.expected.name {
            Some(name) => format!("expected here: {name}"),
            None => "expected here".to_owned(),
        };
        finding.related.push(Related {
            span: self.place(),
            message: label,
            is_call: false,
        });
        finding.help =
            Some(help.unwrap_or_else(|| "correct the robot or the expectation".to_owned()));
        self.findings.push(finding);
    }

    /// The same of the whole robot.
    pub(super) fn fail_robot(&mut self, message: String, help: Option<String>) {
        self.fail(self.tag(self.robot.element), message, help);
    }

    pub(super) fn tag(&self, element: XId) -> Origin {
        tag_start(self.expansion, element)
    }
}

/// The name that xacro would write into the banner when it runs in the folder of the configuration.
fn banner_name(root: &RootConfig, folder: &Path) -> String {
    vfs::slashed(root.file.strip_prefix(folder).unwrap_or(&root.file))
}

/// A text in which `$(arg NAME)` is replaced by the value of the argument; the name of one that there is not.
pub(crate) fn filled(text: &str, arguments: &[(EcoString, EcoString)]) -> Result<String, String> {
    const OPEN: &str = "$(arg ";
    let mut out = String::new();
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once(OPEN) {
        out.push_str(before);
        let Some((name, behind)) = behind.split_once(')') else {
            out.push_str(OPEN);
            rest = behind;
            continue;
        };
        let name = name.trim();
        let known = arguments.iter().find(|(own, _)| own == name);
        out.push_str(&known.ok_or_else(|| name.to_owned())?.1);
        rest = behind;
    }
    out.push_str(rest);
    Ok(out)
}

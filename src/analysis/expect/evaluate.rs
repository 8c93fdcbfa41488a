//! One expectation and one robot: each thing that is not as expected, with the source text that is responsible.
use std::cell::OnceCell;

use ecow::EcoString;

use super::super::session::Session;
use super::RULE;
use super::case::Case;
use super::snapshot::Snapshot;
use base::Span;
use expand::{Expansion, Origin, Written, XId, write_mapped};
use model::{AttrValue, ControlJoint, Joint, JointType, Kinematics, Link, Robot, tag_start};
use packages::nearest;
use rules::{Finding, Related, calls, span_of};
use workspace::config::{Expectation, ExpectedJoint};

/// An expectation that applies to a robot.
pub(super) struct ExpectationContext<'a> {
    pub(super) case: &'a Case,
    pub(super) session: &'a Session,
    pub(super) expansion: &'a Expansion,
    robot: &'a Robot,
    kinematics: &'a Kinematics,
    pub(super) expected: &'a Expectation,
    written: OnceCell<Written>,
    pub(super) findings: Vec<Finding>,
    pub(super) snapshots: Vec<Snapshot>,
}

impl<'a> ExpectationContext<'a> {
    pub(super) fn new(
        case: &'a Case,
        session: &'a Session,
        (expansion, robot, kinematics): (&'a Expansion, &'a Robot, &'a Kinematics),
        expected: &'a Expectation,
    ) -> Self {
        let (findings, snapshots) = (Vec::new(), Vec::new());
        let written = OnceCell::new();
        Self {
            case,
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

    /// Compare everything.
    pub(super) fn run(&mut self, update: bool) {
        let expected = self.expected;
        self.names();
        self.counts();
        if let Some(root) = &expected.root {
            self.root(root);
        }
        for chain in &expected.chains {
            self.chain(chain);
        }
        if let Some(mass) = expected.mass {
            self.mass(mass);
        }
        for (name, joint) in &expected.joint {
            self.joint(name, joint);
        }
        for (kind, interfaces) in [
            ("command", &expected.command_interfaces),
            ("state", &expected.state_interfaces),
        ] {
            for (joint, names) in interfaces {
                self.interfaces(kind, joint, names);
            }
        }
        if let Some(file) = &expected.expands_to {
            self.snapshot(file, update);
        }
    }

    /// The robot as text, with its sources.
    pub(super) fn written(&self) -> &Written {
        self.written.get_or_init(|| {
            let folder = self.expected.place.path.parent();
            let name = folder.map_or_else(String::new, |folder| self.case.banner_name(folder));
            write_mapped(&self.expansion.tree, &name)
        })
    }

    // What is reported.

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

    fn place(&self) -> Span {
        self.session.span_of_place(&self.expected.place)
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
    fn fail_robot(&mut self, message: String, help: Option<String>) {
        self.fail(self.tag(self.robot.element), message, help);
    }

    fn tag(&self, element: XId) -> Origin {
        tag_start(self.expansion, element)
    }

    // Links and joints.

    fn names(&mut self) {
        let expected = self.expected;
        for name in &expected.links {
            self.link(name);
        }
        for name in &expected.joints {
            self.find_joint(name);
        }
        for name in &expected.no_links {
            let Some(name) = self.filled(name) else {
                continue;
            };
            if let Some(link) = self.robot.link(&name) {
                self.fail(
                    self.name_of(link.element, &link.name),
                    format!("link `{name}` is not expected"),
                    None,
                );
            }
        }
        for name in &expected.no_joints {
            let Some(name) = self.filled(name) else {
                continue;
            };
            if let Some(joint) = self.robot.joint(&name) {
                let at = self.name_of(joint.element, &joint.name);
                self.fail(at, format!("joint `{name}` is not expected"), None);
            }
        }
    }

    fn name_of(&self, element: XId, name: &Option<AttrValue>) -> Origin {
        name.as_ref().map_or_else(|| self.tag(element), whole)
    }

    /// The link of an expected name; that it is missing is reported.
    fn link(&mut self, name: &str) -> Option<&'a Link> {
        let name = self.filled(name)?;
        let found = self.robot.link(&name);
        if found.is_none() {
            let names = self
                .robot
                .links
                .iter()
                .filter_map(|link| link.name.as_ref());
            let help = similar(&name, names);
            self.fail_robot(format!("missing link `{name}`"), help);
        }
        found
    }

    /// The joint of an expected name; that it is missing is reported.
    fn find_joint(&mut self, name: &str) -> Option<&'a Joint> {
        let name = self.filled(name)?;
        let found = self.robot.joint(&name);
        if found.is_none() {
            let names = self
                .robot
                .joints
                .iter()
                .filter_map(|joint| joint.name.as_ref());
            let help = similar(&name, names);
            self.fail_robot(format!("missing joint `{name}`"), help);
        }
        found
    }

    fn counts(&mut self) {
        let is_moving = |joint: &&Joint| !joint.is(&[JointType::Fixed]);
        let moving = self.robot.joints.iter().filter(is_moving).count();
        for (what, count, expected) in [
            ("links", self.robot.links.len(), self.expected.link_count),
            ("joints", self.robot.joints.len(), self.expected.joint_count),
            ("moving joints", moving, self.expected.moving_joint_count),
        ] {
            if let Some(expected) = expected.filter(|expected| *expected != count) {
                self.fail_robot(
                    format!("robot has {count} {what}, expected {expected}"),
                    None,
                );
            }
        }
    }

    fn root(&mut self, name: &str) {
        let Some(name) = self.filled(name) else {
            return;
        };
        let roots = self.kinematics.roots(self.robot);
        let Some(root) = roots.first().and_then(|&root| self.robot.links.get(root)) else {
            return;
        };
        let own = root.name.as_ref().map_or("", |name| name.value.as_str());
        if own != name {
            let at = self.name_of(root.element, &root.name);
            self.fail(at, format!("root link is `{own}`, expected `{name}`"), None);
        }
    }

    /// Each link of a chain is below the one before.
    fn chain(&mut self, names: &[String]) {
        let links: Vec<Option<&Link>> = names.iter().map(|name| self.link(name)).collect();
        for pair in links.windows(2) {
            let [Some(above), Some(below)] = pair else {
                continue;
            };
            let (Some(top), Some(end)) = (&above.name, &below.name) else {
                continue;
            };
            let ends = self
                .kinematics
                .link(&top.value)
                .zip(self.kinematics.link(&end.value));
            let Some((from, to)) = ends else { continue };
            let mut parents = self
                .kinematics
                .ancestor_joints(to)
                .filter_map(|joint| self.kinematics.ends(joint));
            if !parents.any(|(parent, _)| parent == from) {
                let message = format!("link `{}` is not below link `{}`", end.value, top.value);
                let joint = self
                    .kinematics
                    .ancestor_joints(to)
                    .next()
                    .and_then(|joint| self.robot.joints.get(joint));
                let parent = joint.and_then(|joint| joint.parent.as_ref());
                let help = parent.map(|parent| format!("its parent link is `{}`", parent.value));
                self.fail(self.name_of(below.element, &below.name), message, help);
            }
        }
    }

    fn mass(&mut self, expected: f64) {
        const SHOWN: usize = 3;
        let mass = |link: &Link| {
            link.inertial
                .as_ref()
                .and_then(|inertial| inertial.mass())
                .unwrap_or(0.0)
        };
        let total: f64 = self.robot.links.iter().map(mass).sum();
        let tolerance = self.expected.mass_tolerance;
        if is_near(total, expected, tolerance) {
            return;
        }
        let mut heaviest: Vec<(f64, &str)> = (self.robot.links.iter())
            .filter_map(|link| Some((mass(link), link.name.as_ref()?.value.as_str())))
            .filter(|(mass, _)| *mass > 0.0)
            .collect();
        heaviest.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
        let shown = heaviest
            .iter()
            .take(SHOWN)
            .map(|(mass, name)| format!("`{name}` {} kg", short(*mass)));
        let shown = shown.collect::<Vec<_>>().join(", ");
        let help = (!shown.is_empty()).then(|| format!("the links with the most mass are {shown}"));
        let message = format!(
            "total mass is {} kg, expected {} kg{}",
            short(total),
            short(expected),
            within(tolerance)
        );
        self.fail_robot(message, help);
    }

    fn joint(&mut self, name: &str, expected: &ExpectedJoint) {
        let Some(joint) = self.find_joint(name) else {
            return;
        };
        let name = joint.shown().to_owned();
        for (what, own, wanted) in [
            ("type", &joint.kind, &expected.kind),
            ("parent link", &joint.parent, &expected.parent),
            ("child link", &joint.child, &expected.child),
            (
                "mimicked joint",
                &joint.mimic.as_ref().and_then(|mimic| mimic.joint.clone()),
                &expected.mimic,
            ),
        ] {
            let Some(wanted) = wanted.as_ref().and_then(|wanted| self.filled(wanted)) else {
                continue;
            };
            let value = own.as_ref().map_or("", |own| own.value.as_str());
            if value != wanted {
                let at = own.as_ref().map_or_else(|| self.tag(joint.element), whole);
                let value = if value.is_empty() {
                    "missing".to_owned()
                } else {
                    format!("`{value}`")
                };
                self.fail(
                    at,
                    format!("{what} of joint `{name}` is {value}, expected `{wanted}`"),
                    None,
                );
            }
        }
        let limit = joint.limit.as_ref();
        let is_linear = joint.is(&[JointType::Prismatic]);
        let units = if is_linear {
            ["m", "N", "m/s"]
        } else {
            ["rad", "N m", "rad/s"]
        };
        let [position, force, speed] = units;
        for (what, unit, own, wanted) in [
            (
                "lower limit",
                position,
                limit.and_then(|limit| limit.lower.as_ref()),
                expected.lower,
            ),
            (
                "upper limit",
                position,
                limit.and_then(|limit| limit.upper.as_ref()),
                expected.upper,
            ),
            (
                "effort limit",
                force,
                limit.and_then(|limit| limit.effort.as_ref()),
                expected.effort,
            ),
            (
                "velocity limit",
                speed,
                limit.and_then(|limit| limit.velocity.as_ref()),
                expected.velocity,
            ),
        ] {
            let Some(wanted) = wanted else { continue };
            let value = own.and_then(AttrValue::number);
            if value.is_some_and(|value| is_near(value, wanted, expected.tolerance)) {
                continue;
            }
            let element = limit.map_or(joint.element, |limit| limit.element);
            let at = own.map_or_else(|| self.tag(element), whole);
            let shown = value.map_or_else(
                || "missing".to_owned(),
                |value| format!("{} {unit}", short(value)),
            );
            let wanted = format!("{} {unit}{}", short(wanted), within(expected.tolerance));
            self.fail(
                at,
                format!("{what} of joint `{name}` is {shown}, expected {wanted}"),
                None,
            );
        }
    }

    /// The interfaces of a joint in all `ros2_control` elements.
    fn interfaces(&mut self, kind: &str, joint: &str, expected: &[String]) {
        let Some(joint) = self.filled(joint) else {
            return;
        };
        let expected: Vec<Option<String>> = expected.iter().map(|name| self.filled(name)).collect();
        let Some(mut expected): Option<Vec<String>> = expected.into_iter().collect() else {
            return;
        };
        let all = self
            .robot
            .controls
            .iter()
            .flat_map(|control| &control.joints);
        let own: Vec<&ControlJoint> = all.filter(|own| own.shown() == joint).collect();
        let interfaces = own.iter().flat_map(|own| {
            if kind == "command" {
                &own.commands
            } else {
                &own.states
            }
        });
        let name = |text: &AttrValue| text.value.to_string();
        let mut names: Vec<String> = interfaces
            .filter_map(|interface| interface.name.as_ref().map(name))
            .collect();
        for list in [&mut names, &mut expected] {
            list.sort();
            list.dedup();
        }
        if names == expected {
            return;
        }
        let at = own.first().map_or(self.robot.element, |own| own.element);
        let message = format!(
            "{kind} interfaces of joint `{joint}` are {}, expected {}",
            listed(&names),
            listed(&expected)
        );
        let help = own
            .is_empty()
            .then(|| format!("add joint `{joint}` to a `ros2_control` element"));
        self.fail(self.tag(at), message, help);
    }
}

/// The source of a whole value.
fn whole(text: &AttrValue) -> Origin {
    text.part(0..text.value.len())
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

fn similar<'t>(name: &str, names: impl Iterator<Item = &'t AttrValue>) -> Option<String> {
    let near = nearest(name, names.map(|text| text.value.as_str()));
    near.map(|near| format!("did you mean `{near}`?"))
}

fn is_near(value: f64, expected: f64, tolerance: f64) -> bool {
    // numbers that are written the same are the same
    (value - expected).abs() <= tolerance + f64::EPSILON * expected.abs().max(1.0)
}

/// A number with as many digits as people want to read.
fn short(number: f64) -> String {
    let text = format!("{number:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

fn within(tolerance: f64) -> String {
    if tolerance > 0.0 {
        format!(" ± {tolerance}")
    } else {
        String::new()
    }
}

fn listed(names: &[String]) -> String {
    match names {
        [] => "none".to_owned(),
        _ => names
            .iter()
            .map(|name| format!("`{name}`"))
            .collect::<Vec<_>>()
            .join(", "),
    }
}

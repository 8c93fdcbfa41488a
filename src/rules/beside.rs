//! What rules see of a file beside a robot, such as its SRDF: the file, and the robots that it is for.
use std::cell::OnceCell;

use ecow::EcoString;

use super::context::RuleEnv;
use super::finding::Help;
use super::grouping::Group;
use super::names::{JointConnection, OfferedInterface, RobotNames, may_be};
use super::rule::Severity;
use super::sink::{Reported, Sink, span_of};
use base::{FileId, Span};
use expand::{Expansion, Origin};
use model::{AttrValue, Joint, Kinematics, Robot};
use packages::nearest;
use project::{ProjectNameKind, SpannedName, Srdf, YamlSettings};

/// A file beside a robot.
pub struct BesideCx<'a> {
    /// The SRDF or YAML that is checked.
    pub file: FileId,
    /// What it says.
    pub content: BesideContent<'a>,
    /// The expansion of the file, and of the robot where the file is not expanded.
    pub expansion: &'a Expansion,
    /// The robots that the file is for; all their links and joints are there. Without one, the file is compared with
    /// SRDFs only.
    pub robots: &'a [PairedRobot<'a>],
    /// All files beside these robots.
    pub all: &'a [BesideContent<'a>],
    /// What lies around it.
    pub world: RuleEnv<'a>,
    /// Whether the package of the file is for ROS 2.
    pub(super) is_ros2: bool,
    /// Whether hardware of ROS 1 in the workspace registers joints by itself.
    pub(super) registers_joints: bool,
    /// Whether an SRDF of the robots depends on arguments.
    pub(super) has_variants: bool,
    /// Whether everything of the SRDFs is there.
    pub(super) has_all_groups: bool,
    /// Names in further expansions of the robots, asked for only when a name is in none of them.
    pub further: &'a dyn Fn() -> RobotNames,
    /// What these gave.
    pub(super) known: OnceCell<RobotNames>,
    /// The names in the robots.
    pub(super) names: RobotNames,
}

/// What a file beside a robot says.
#[derive(Clone, Copy)]
pub enum BesideContent<'a> {
    /// A semantic description.
    Srdf(&'a Srdf),
    /// YAML for controllers or MoveIt.
    Settings(&'a YamlSettings),
}

/// A robot that a file is for.
#[derive(Clone, Copy)]
pub struct PairedRobot<'a> {
    /// The expansion that it was taken from.
    pub expansion: &'a Expansion,
    /// Its links and joints.
    pub robot: &'a Robot,
    /// How its links hang together.
    pub kinematics: &'a Kinematics,
    /// The controllers of the file that launch files of this robot name; none for the only robot.
    pub started: &'a [EcoString],
}

impl<'a> BesideCx<'a> {
    /// A file with what is around it.
    pub fn new(
        (file, content, expansion): (FileId, BesideContent<'a>, &'a Expansion),
        robots: &'a [PairedRobot<'a>],
        all: &'a [BesideContent<'a>],
        further: &'a dyn Fn() -> RobotNames,
        world: RuleEnv<'a>,
    ) -> Self {
        let mut names = RobotNames::default();
        robots.iter().for_each(|paired| names.add(paired.robot));
        for content in all {
            if let BesideContent::Srdf(srdf) = content {
                names.groups.extend(
                    srdf.groups
                        .iter()
                        .filter_map(|group| group.name.as_ref()?.name().cloned()),
                );
            }
        }
        Self {
            file,
            content,
            expansion,
            robots,
            all,
            further,
            world,
            known: OnceCell::new(),
            names,
            is_ros2: false,
            registers_joints: false,
            has_variants: false,
            has_all_groups: true,
        }
    }

    /// The same, with SRDFs that depend on arguments or not.
    #[must_use]
    pub fn with_variants(mut self, has_variants: bool) -> Self {
        self.has_variants = has_variants;
        self
    }

    /// The same, with SRDFs of which everything is there or not.
    #[must_use]
    pub fn with_all_groups(mut self, has_all_groups: bool) -> Self {
        self.has_all_groups = has_all_groups;
        self
    }

    /// The same, in a package for ROS 2 or another one.
    #[must_use]
    pub fn in_ros2(mut self, is_ros2: bool) -> Self {
        self.is_ros2 = is_ros2;
        self
    }

    /// The same, in a workspace whose hardware of ROS 1 registers joints by itself or not.
    #[must_use]
    pub fn with_own_joints(mut self, registers_joints: bool) -> Self {
        self.registers_joints = registers_joints;
        self
    }

    /// The SRDF, when the file is one.
    pub(super) fn srdf(&self) -> Option<&'a Srdf> {
        match self.content {
            BesideContent::Srdf(srdf) => Some(srdf),
            BesideContent::Settings(_) => None,
        }
    }

    /// The settings, when the file holds some.
    pub(super) fn settings(&self) -> Option<&'a YamlSettings> {
        match self.content {
            BesideContent::Settings(settings) => Some(settings),
            BesideContent::Srdf(_) => None,
        }
    }

    /// Whether a link or joint is in none of the robots, or a group in none of their SRDFs, however they are expanded. What
    /// other arguments give counts, unless the robots themselves are meant to have it.
    pub(super) fn lacks(&self, kind: ProjectNameKind, name: &str) -> bool {
        !self.names.may_have(kind, name)
            && !self.is_virtual(kind, name)
            && (!self
                .known
                .get_or_init(|| (self.further)())
                .may_have(kind, name)
                || self.is_torn(kind, name)
                || self.is_renamed(kind, name))
    }

    /// Whether a joint of the robots hangs on a link that they do not have.
    fn is_torn(&self, kind: ProjectNameKind, name: &str) -> bool {
        let joints = self.robots.iter().flat_map(|paired| &paired.robot.joints);
        let mut joints = joints.filter(|_| kind == ProjectNameKind::Link);
        joints.any(|joint| is_text(&joint.parent, name) || is_text(&joint.child, name))
    }

    /// Whether the robots have something in the place of a link or joint that other arguments give, with a name that no file
    /// beside them knows: one of the two was renamed. Of joints that is one of the same type and child, of links the child of
    /// the same joint that moves.
    fn is_renamed(&self, kind: ProjectNameKind, name: &str) -> bool {
        let further = self.known.get_or_init(|| (self.further)());
        let mut places = further.places.iter();
        match kind {
            ProjectNameKind::Joint => {
                places.any(|place| place.joint == name && self.is_taken(place))
            }
            ProjectNameKind::Link => {
                places.any(|place| place.child == name && self.is_moved(place))
            }
            ProjectNameKind::Group => false,
        }
    }

    /// Whether the robots have another joint where a joint is with other arguments.
    fn is_taken(&self, place: &JointConnection) -> bool {
        let is_same = |own: &&JointConnection| own.child == place.child && own.kind == place.kind;
        let mut same = self.names.places.iter().filter(is_same);
        same.any(|own| !self.is_named(ProjectNameKind::Joint, &own.joint))
            || self.is_loose(&place.child)
    }

    /// Whether a joint moves another link of the robots than with other arguments.
    fn is_moved(&self, place: &JointConnection) -> bool {
        let is_same = |own: &&JointConnection| own.joint == place.joint && own.kind == place.kind;
        let mut same = self.names.places.iter().filter(is_same);
        place.kind != "fixed" && same.any(|own| !self.is_named(ProjectNameKind::Link, &own.child))
    }

    /// Whether no joint leads to a link of a robot that has another root.
    fn is_loose(&self, link: &str) -> bool {
        let is_link = |paired: &&PairedRobot<'_>| paired.robot.link(link).is_some();
        let robots = self.robots.iter().filter(is_link);
        let mut robots = robots.map(|paired| paired.robot);
        robots.any(|robot| {
            let is_child = |joint: &Joint| is_text(&joint.child, link);
            !robot.joints.iter().any(is_child) && robot.links.len() > 1 + robot.joints.len()
        })
    }

    /// Whether a file beside the robots has a name.
    fn is_named(&self, kind: ProjectNameKind, name: &str) -> bool {
        self.all.iter().any(|content| match content {
            BesideContent::Srdf(srdf) => srdf
                .names()
                .iter()
                .any(|(text, own, _)| *own == kind && text.value == name),
            BesideContent::Settings(settings) => settings
                .names()
                .iter()
                .any(|(own, its)| *its == kind && own.name == name),
        })
    }

    /// Whether hardware of the robots offers an interface of a joint with other arguments.
    pub(super) fn may_offer(&self, joint: &str, interface: &str, is_command: bool) -> bool {
        let offered = &self.known.get_or_init(|| (self.further)()).interfaces;
        let is_it = |one: &OfferedInterface| {
            one.is_command == is_command
                && one.name == interface
                && one.joint.as_deref().is_none_or(|own| may_be(own, joint))
        };
        offered.iter().any(is_it)
    }

    /// Whether hardware of the robots has a joint with other arguments.
    pub(super) fn may_drive(&self, joint: &str) -> bool {
        let offered = &self.known.get_or_init(|| (self.further)()).interfaces;
        let mut joints = offered.iter().filter_map(|one| one.joint.as_deref());
        joints.any(|own| may_be(own, joint))
    }

    /// Whether the robots may include a file of a package that is absent, with other arguments.
    pub(super) fn is_open(&self) -> bool {
        self.known.get_or_init(|| (self.further)()).is_open
    }

    /// Whether a joint is a virtual joint of an SRDF.
    fn is_virtual(&self, kind: ProjectNameKind, name: &str) -> bool {
        let mut joints = self.srdfs().flat_map(|srdf| &srdf.virtual_joints);
        kind == ProjectNameKind::Joint && joints.any(|joint| is_text(&joint.name, name))
    }

    /// The SRDFs of the robots.
    pub(super) fn srdfs(&self) -> impl Iterator<Item = &'a Srdf> + '_ {
        self.all.iter().filter_map(|content| match content {
            BesideContent::Srdf(srdf) => Some(*srdf),
            BesideContent::Settings(_) => None,
        })
    }

    /// All settings of the robots.
    pub(super) fn all_settings(&self) -> impl Iterator<Item = &'a YamlSettings> + '_ {
        self.all.iter().filter_map(|content| match content {
            BesideContent::Settings(settings) => Some(*settings),
            BesideContent::Srdf(_) => None,
        })
    }

    /// The joints of a name, one of each robot that has it.
    pub(super) fn joints<'s>(
        &'s self,
        name: &'s str,
    ) -> impl Iterator<Item = (&'a PairedRobot<'a>, &'a Joint)> + 's {
        self.robots
            .iter()
            .filter_map(move |paired| Some((paired, paired.robot.joint(name)?)))
    }

    /// Whether the name of an unknown link, joint or group is close to one that is known.
    pub(super) fn is_misspelled(&self, kind: ProjectNameKind, name: &str) -> bool {
        let names = self.names.of(kind).into_iter().flatten();
        nearest(name, names.map(EcoString::as_str)).is_some()
    }

    /// What to do about the name of a link, joint or group that is not there.
    pub(super) fn advice(&self, kind: ProjectNameKind, name: &str) -> Help {
        let names = self.names.of(kind).into_iter().flatten();
        match (nearest(name, names.map(EcoString::as_str)), kind) {
            (Some(near), _) => Help::did_you_mean(near),
            (None, ProjectNameKind::Link) => {
                "use the name of a link of the robot, including its prefix".into()
            }
            (None, ProjectNameKind::Joint) => {
                "use the name of a joint of the robot, including its prefix".into()
            }
            (None, ProjectNameKind::Group) => "use the name of a group of the SRDF".into(),
        }
    }

    /// Report a name in YAML.
    pub(super) fn report<'s, 'e>(
        &self,
        out: &'s mut Sink<'e>,
        name: &SpannedName,
        message: impl Into<String>,
    ) -> Reported<'s, 'e> {
        out.report_span(
            Span {
                file: self.file,
                range: name.range,
            },
            message,
        )
    }
}

impl PairedRobot<'_> {
    /// Where a text of the robot stands.
    pub(super) fn span(&self, origin: Origin) -> Option<Span> {
        span_of(self.expansion, origin)
    }
}

/// Whether a text is there and is this name.
fn is_text(text: &Option<AttrValue>, name: &str) -> bool {
    text.as_ref().is_some_and(|text| text.value == name)
}

/// A name in an SRDF that is not there.
pub(super) fn unknown(
    cx: &BesideCx<'_>,
    out: &mut Sink<'_>,
    (text, kind): (&AttrValue, ProjectNameKind),
    severity: Severity,
    message: String,
) {
    let advice = cx.advice(kind, &text.value);
    let group = match advice.similar {
        Some(_) => Group::Name(text.value.clone()),
        None => Group::OtherRobot,
    };
    let report = out.report(text.origin, message).group(group);
    report.severity(severity).help(advice).done();
}

//! Names in robots: what files beside them may use.
use ecow::EcoString;

use base::FastSet;
use model::Robot;
use project::ProjectNameKind;

/// Names of links and joints.
#[derive(Clone, Debug, Default)]
pub struct RobotNames {
    /// Names of links.
    pub links: FastSet<EcoString>,
    /// Names of joints.
    pub joints: FastSet<EcoString>,
    /// The places of joints.
    pub places: FastSet<JointConnection>,
    /// Groups of SRDFs; asked for only where these are expanded in one of several ways.
    pub groups: FastSet<EcoString>,
    /// Interfaces of hardware that conditions decide on.
    pub interfaces: FastSet<OfferedInterface>,
    /// Whether other arguments bring in a file of a package that is absent: nobody knows what names it brings.
    pub is_open: bool,
}

/// The place of a joint in a robot.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct JointConnection {
    /// The name of the joint.
    pub joint: EcoString,
    /// The name of its child link.
    pub child: EcoString,
    /// Its type.
    pub kind: EcoString,
}

/// An interface that hardware may offer.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct OfferedInterface {
    /// Whether it is for commands.
    pub is_command: bool,
    /// Its joint as the text spells it, expressions and all; none where it is in no joint.
    pub joint: Option<EcoString>,
    /// Its name.
    pub name: EcoString,
}

impl RobotNames {
    /// Add the names in a robot.
    pub fn add(&mut self, robot: &Robot) {
        self.links.extend(
            robot
                .links
                .iter()
                .filter_map(|link| link.name.as_ref()?.name().cloned()),
        );
        self.joints.extend(
            robot
                .joints
                .iter()
                .filter_map(|joint| joint.name.as_ref()?.name().cloned()),
        );
        for joint in &robot.joints {
            let texts = [&joint.name, &joint.child, &joint.kind];
            let names = texts.map(|text| Some(text.as_ref()?.name()?.clone()));
            if let [Some(joint), Some(child), Some(kind)] = names {
                self.places.insert(JointConnection { joint, child, kind });
            }
        }
    }

    /// Add the names of others.
    pub fn extend(&mut self, other: &Self) {
        self.links.extend(other.links.iter().cloned());
        self.joints.extend(other.joints.iter().cloned());
        self.groups.extend(other.groups.iter().cloned());
        self.interfaces.extend(other.interfaces.iter().cloned());
        self.places.extend(other.places.iter().cloned());
        self.is_open |= other.is_open;
    }

    pub(super) fn of(&self, kind: ProjectNameKind) -> Option<&FastSet<EcoString>> {
        match kind {
            ProjectNameKind::Link => Some(&self.links),
            ProjectNameKind::Joint => Some(&self.joints),
            ProjectNameKind::Group => Some(&self.groups),
        }
    }

    /// Whether a name is there, or nobody knows.
    pub(super) fn may_have(&self, kind: ProjectNameKind, name: &str) -> bool {
        self.of(kind).is_none_or(|names| names.contains(name))
    }
}

/// Whether a name may come of a text with expressions: `left_elbow` of `${side}_elbow`.
pub(super) fn may_be(text: &str, name: &str) -> bool {
    let Some((start, mut text)) = text.split_once('$') else {
        return text == name;
    };
    let Some(mut name) = name.strip_prefix(start) else {
        return false;
    };
    loop {
        let close = if text.starts_with('{') { '}' } else { ')' };
        let Some((_, behind)) = text.split_once(close) else {
            return true;
        };
        let Some((literal, after)) = behind.split_once('$') else {
            return name.ends_with(behind);
        };
        let Some(at) = name.find(literal) else {
            return false;
        };
        name = name.get(at + literal.len()..).unwrap_or_default();
        text = after;
    }
}

#[cfg(test)]
mod tests {
    use super::may_be;

    #[test]
    fn names_that_texts_with_expressions_may_give() {
        for (text, name) in [
            ("elbow", "elbow"),
            ("${side}_elbow", "left_elbow"),
            ("${name}", "elbow"),
            ("$(arg side)_${part}", "left_elbow"),
            ("arm_${side}_elbow_${n}", "arm_left_elbow_2"),
            ("${broken", "elbow"),
        ] {
            assert!(may_be(text, name), "{text} {name}");
        }
        for (text, name) in [
            ("elbow", "wrist"),
            ("${side}_elbow", "left_wrist"),
            ("arm_${side}", "left_arm"),
            ("arm_${side}_elbow_${n}", "arm_left_wrist_2"),
        ] {
            assert!(!may_be(text, name), "{text} {name}");
        }
    }
}

//! Settings that are one of a few words.

use base::Severity;
use packages::RosVersion;

/// A setting that is one of a few words.
pub(super) trait Choice: Copy + PartialEq + 'static {
    /// The words, in the order of the documentation.
    const NAMES: &'static [&'static str];
    /// What each word stands for.
    const ALL: &'static [Self];

    /// The value that a word stands for.
    fn named(name: &str) -> Option<Self> {
        let mut pairs = Self::NAMES.iter().zip(Self::ALL);
        pairs
            .find(|(word, _)| **word == name)
            .map(|(_, value)| *value)
    }

    /// The word for a value.
    fn word(self) -> &'static str {
        let mut pairs = Self::NAMES.iter().zip(Self::ALL);
        pairs
            .find(|(_, value)| **value == self)
            .map_or("", |(word, _)| word)
    }
}

/// Words and what they stand for, said once.
macro_rules! choices {
    ($type:ident { $($word:literal => $value:ident),* $(,)? }) => {
        impl Choice for $type {
            const NAMES: &'static [&'static str] = &[$($word),*];
            const ALL: &'static [Self] = &[$(Self::$value),*];
        }
    };
}

/// Groups of rules for a kind of user.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Profile {
    RosIndustrial,
    Mobile,
    Gazebo,
    Pedantic,
}

/// What a rule is set to: a severity, or a word more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum RuleLevel {
    /// The rule does not run.
    Off,
    /// Its findings have this severity.
    At(Severity),
}

/// Line breaks between attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AttributeLayout {
    /// They stay, aligned.
    Keep,
    /// They are set where the line is full.
    Auto,
}

choices!(RosVersion { "ros2" => Ros2, "ros1" => Ros1 });
choices!(Profile {
    "ros-industrial" => RosIndustrial,
    "mobile" => Mobile,
    "gazebo" => Gazebo,
    "pedantic" => Pedantic,
});
choices!(AttributeLayout { "keep" => Keep, "auto" => Auto });

impl Profile {
    /// The profile of that name.
    pub fn named(name: &str) -> Option<Profile> {
        Choice::named(name)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        self.word()
    }
}

impl Choice for RuleLevel {
    const NAMES: &'static [&'static str] = &[
        Severity::Error.name(),
        Severity::Warning.name(),
        Severity::Info.name(),
        Severity::Hint.name(),
        "off",
    ];
    const ALL: &'static [Self] = &[
        Self::At(Severity::Error),
        Self::At(Severity::Warning),
        Self::At(Severity::Info),
        Self::At(Severity::Hint),
        Self::Off,
    ];
}

impl RuleLevel {
    /// Its name.
    pub fn name(self) -> &'static str {
        self.word()
    }

    /// The severity; none switches the rule off.
    pub fn severity(self) -> Option<Severity> {
        match self {
            RuleLevel::Off => None,
            RuleLevel::At(severity) => Some(severity),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Profile, RuleLevel};
    use base::Severity;

    #[test]
    fn names() {
        let levels = [
            RuleLevel::Off,
            RuleLevel::At(Severity::Hint),
            RuleLevel::At(Severity::Info),
            RuleLevel::At(Severity::Warning),
            RuleLevel::At(Severity::Error),
        ];
        let names = levels.map(RuleLevel::name);
        assert_eq!(names, ["off", "hint", "info", "warning", "error"]);
        assert_eq!(Profile::named("gazebo"), Some(Profile::Gazebo));
        assert_eq!(Profile::RosIndustrial.name(), "ros-industrial");
    }
}

//! The version of URDF that a robot is written in.

use super::attr_value::AttrValue;
use expand::XTree;

/// A version of the format; urdfdom 5.1 reads up to 1.1, 6.0 up to 1.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Version(pub u32, pub u32);

impl Version {
    /// What a robot is written in that does not say.
    pub const V1_0: Self = Self(1, 0);
    /// With capsules and quaternions.
    pub const V1_1: Self = Self(1, 1);
    /// With acceleration, deceleration and jerk in limits.
    pub const V1_2: Self = Self(1, 2);

    /// The version that a text names as urdfdom reads it: two numbers with a point between, nothing behind them.
    pub fn parse(text: &str) -> Option<Self> {
        let (major, minor) = text.trim_start().split_once('.')?;
        Some(Self(whole_number(major)?, whole_number(minor)?))
    }

    /// The version of a document; none when it cannot be told.
    pub fn of(tree: &XTree) -> Option<Self> {
        match AttrValue::attr(tree, tree.root()?, "version") {
            Some(text) if !text.is_known() => None,
            Some(text) => Self::parse(&text.value),
            None => Some(Self::V1_0),
        }
    }

    /// Whether a document is of this version or a later one.
    pub fn is_in(self, tree: &XTree) -> bool {
        Self::of(tree).is_some_and(|version| version >= self)
    }
}

/// The number that a text of digits alone is.
fn whole_number(text: &str) -> Option<u32> {
    text.bytes()
        .all(|byte| byte.is_ascii_digit())
        .then(|| text.parse().ok())?
}

impl std::fmt::Display for Version {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}.{}", self.0, self.1)
    }
}

#[cfg(test)]
mod tests {
    use super::Version;

    #[test]
    fn versions_are_read_as_urdfdom_reads_them() {
        let read = ["1.0", " 1.1", "01.2", "1.00"].map(Version::parse);
        assert_eq!(
            read,
            [Version::V1_0, Version::V1_1, Version::V1_2, Version::V1_0].map(Some)
        );
        assert_eq!(
            ["", "1", "1.", ".1", "1.0 ", "1.0.0", "x", "-1.0"].map(Version::parse),
            [None; 8]
        );
    }
}

//! The table: what each consumer makes of each construct.
//!
//! It is data, in `table/*.toml`; `tests/consumers` loads a robot for each construct with the real readers and
//! compares.
use std::sync::LazyLock;

use serde::Deserialize;

use super::consumer::{CONSUMERS, Consumer};
use base::FastMap;

/// What a consumer does with a construct.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// It reads what is written.
    Accepts,
    /// It loads the robot, but takes something for something else or leaves it out, mostly without a word.
    Changes,
    /// It does not load the robot.
    Rejects,
}

impl Outcome {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Accepts => "accepts",
            Self::Changes => "changes",
            Self::Rejects => "rejects",
        }
    }
}

/// A construct that some consumer does not read as it is written.
#[derive(Debug, Deserialize)]
pub struct Construct {
    /// Its name.
    pub name: String,
    /// What it is, for messages.
    pub title: String,
    /// What to write instead.
    #[serde(default)]
    pub help: Option<String>,
    /// The oldest urdfdom that reads it, where it is not all of them.
    #[serde(default)]
    pub oldest: Option<String>,
    /// Of numbers: what is wrong with them.
    #[serde(default)]
    pub(super) fault: Option<String>,
    /// Of numbers: the attributes in which it is, as `limit/upper` or `visual/box/size`.
    #[serde(default)]
    pub(super) attributes: Vec<String>,
    /// The consumers that do not load the robot, separated by spaces.
    #[serde(default)]
    rejects: String,
    /// The consumers that change or leave out something.
    #[serde(default)]
    changes: String,
}

impl Construct {
    /// What a consumer does with it.
    pub fn outcome(&self, consumer: &Consumer) -> Outcome {
        match () {
            () if lists(&self.rejects, consumer) => Outcome::Rejects,
            () if lists(&self.changes, consumer) => Outcome::Changes,
            () => Outcome::Accepts,
        }
    }

    /// The worst that a consumer does with it.
    pub fn worst(&self) -> Outcome {
        match () {
            () if !self.rejects.is_empty() => Outcome::Rejects,
            () if !self.changes.is_empty() => Outcome::Changes,
            () => Outcome::Accepts,
        }
    }

    /// The titles of the consumers that do this with it.
    pub fn who(&self, outcome: Outcome) -> Vec<&'static str> {
        let who = CONSUMERS
            .iter()
            .filter(|consumer| self.outcome(consumer) == outcome);
        who.map(|consumer| consumer.title).collect()
    }
}

/// Whether a consumer is among names that are separated by spaces.
fn lists(names: &str, consumer: &Consumer) -> bool {
    names.split(' ').any(|name| name == consumer.row_name())
}

#[derive(Deserialize)]
struct TableFile {
    construct: Vec<Construct>,
}

/// All constructs, in the order of the table.
pub static CONSTRUCTS: LazyLock<Vec<Construct>> = LazyLock::new(|| {
    let files = [
        include_str!("table/xml.toml"),
        include_str!("table/tree.toml"),
        include_str!("table/joints.toml"),
        include_str!("table/inertia.toml"),
        include_str!("table/geometry.toml"),
        include_str!("table/meshes.toml"),
        include_str!("table/numbers.toml"),
    ];
    // a unit test reads each file: none is left out
    files
        .iter()
        .filter_map(|text| toml::from_str::<TableFile>(text).ok())
        .flat_map(|file| file.construct)
        .collect()
});

/// A construct by its name.
pub(super) fn construct(name: &str) -> Option<&'static Construct> {
    static BY_NAME: LazyLock<FastMap<&str, &Construct>> = LazyLock::new(|| {
        CONSTRUCTS
            .iter()
            .map(|construct| (construct.name.as_str(), construct))
            .collect()
    });
    BY_NAME.get(name).copied()
}

/// The construct of numbers with a fault in an attribute.
pub(super) fn fault(fault: &str, attribute: &str) -> Option<&'static Construct> {
    static BY_ATTRIBUTE: LazyLock<FastMap<(&str, &str), &Construct>> = LazyLock::new(|| {
        let pairs = CONSTRUCTS
            .iter()
            .filter_map(|construct| Some((construct.fault.as_deref()?, construct)));
        pairs
            .flat_map(|(fault, construct)| {
                construct
                    .attributes
                    .iter()
                    .map(move |attribute| ((fault, attribute.as_str()), construct))
            })
            .collect()
    });
    BY_ATTRIBUTE.get(&(fault, attribute)).copied()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::super::consumer::{CONSUMERS, Consumer};
    use super::CONSTRUCTS;

    #[test]
    fn every_row_is_read_and_names_consumers() {
        let mut names = BTreeSet::new();
        for construct in CONSTRUCTS.iter() {
            assert!(names.insert(&construct.name), "{} twice", construct.name);
            assert!(!construct.title.ends_with('.'), "{}", construct.name);
            let lists = [&construct.rejects, &construct.changes];
            let named = lists.iter().flat_map(|list| list.split_whitespace());
            for name in named {
                assert!(
                    CONSUMERS.iter().any(|consumer| consumer.name == name),
                    "{}: {name}",
                    construct.name
                );
            }
        }
        assert!(names.len() > 200, "{} rows", names.len());
    }

    #[test]
    fn consumers_have_names_of_their_own() {
        for consumer in CONSUMERS {
            assert!(std::ptr::eq(
                Consumer::named(consumer.name).unwrap(),
                consumer
            ));
            for alias in consumer.aliases {
                assert!(
                    std::ptr::eq(Consumer::named(alias).unwrap(), consumer),
                    "{alias}"
                );
            }
            assert!(
                CONSUMERS
                    .iter()
                    .any(|other| other.name == consumer.row_name())
            );
        }
    }
}

//! What the programs that read URDF make of the robot that is shown.

use serde::Serialize;

use super::locations::{Location, LocationMapper};
use analysis::{RootAnalysis, Session};
use rules::consumers::{CONSUMERS, Consumer, Outcome, Row, constructs, is_readable, rows};

/// Places of a construct that are sent.
const MOST_PLACES: usize = 3;

/// What programs make of a robot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Programs {
    /// The titles of the programs: those of the configuration, or all.
    pub names: Vec<&'static str>,
    /// What some of them reject or change, the worst first.
    pub constructs: Vec<AffectedConstruct>,
}

/// Something in a robot that some program rejects or changes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AffectedConstruct {
    /// What it is.
    pub title: &'static str,
    /// What to write instead.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub help: Option<&'static str>,
    /// The programs that do not load the robot because of it.
    pub rejected: Vec<&'static str>,
    /// The programs that load it, and change or ignore this.
    pub changed: Vec<&'static str>,
    /// How many places have it.
    pub count: usize,
    /// The first of them.
    pub places: Vec<Owner>,
}

/// An element that has a construct.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Owner {
    /// "joint `elbow`"
    pub of: String,
    /// Where it is.
    pub location: Location,
}

/// What programs make of a robot; none when no program is given it, since it has errors.
pub(super) fn programs(
    session: &Session,
    analyzed: &RootAnalysis,
    places: &LocationMapper<'_>,
) -> Option<Programs> {
    let expansion = &analyzed.expansion;
    if !is_readable(expansion) {
        return None;
    }
    let settings = session.settings(&analyzed.root.file);
    let wanted = &settings.config.consumers;
    let is_wanted = |consumer: &&Consumer| {
        wanted.is_empty()
            || wanted
                .iter()
                .any(|name| Consumer::named(name).is_some_and(|named| named.name == consumer.name))
    };
    let consumers: Vec<&Consumer> = CONSUMERS.iter().filter(is_wanted).collect();
    let rule_env = session.rule_env(&settings.config);
    let met = constructs(expansion, analyzed.robot.as_ref(), rule_env);
    let listed = rows(&met, false)
        .iter()
        .map(|row| construct(row, &consumers, places))
        .filter(|found| !found.rejected.is_empty() || !found.changed.is_empty())
        .collect();
    Some(Programs {
        names: consumers.iter().map(|consumer| consumer.title).collect(),
        constructs: listed,
    })
}

fn construct(
    row: &Row<'_>,
    consumers: &[&Consumer],
    places: &LocationMapper<'_>,
) -> AffectedConstruct {
    let owners = row.met.iter().filter_map(|met| {
        Some(Owner {
            of: met.owner.clone(),
            location: places.of(met.origin)?,
        })
    });
    AffectedConstruct {
        title: &row.construct.title,
        help: row.construct.help.as_deref(),
        rejected: who(row, consumers, Outcome::Rejects),
        changed: who(row, consumers, Outcome::Changes),
        count: row.met.len(),
        places: owners.take(MOST_PLACES).collect(),
    }
}

/// The programs for which a construct has an outcome.
fn who(row: &Row<'_>, consumers: &[&Consumer], outcome: Outcome) -> Vec<&'static str> {
    consumers
        .iter()
        .filter(|consumer| row.construct.outcome(consumer) == outcome)
        .map(|consumer| consumer.title)
        .collect()
}

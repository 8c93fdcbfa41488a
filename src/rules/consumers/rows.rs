//! The constructs of one robot, each once.
use indexmap::IndexMap;

use super::met::Met;
use super::table::{Construct, Outcome};

/// A construct of a robot with all places that have it.
pub struct Row<'a> {
    /// The construct.
    pub construct: &'static Construct,
    /// Where it is, in document order.
    pub met: Vec<&'a Met>,
}

/// The constructs that some program rejects or changes, the worst first; with `all`, those that every program accepts too.
pub fn rows(met: &[Met], all: bool) -> Vec<Row<'_>> {
    let mut rows: IndexMap<&str, Row<'_>> = IndexMap::new();
    for met in met {
        let construct = met.construct;
        rows.entry(&construct.name)
            .or_insert(Row {
                construct,
                met: Vec::new(),
            })
            .met
            .push(met);
    }
    let mut rows: Vec<Row<'_>> = rows
        .into_values()
        .filter(|row| all || row.construct.worst() > Outcome::Accepts)
        .collect();
    rows.sort_by_key(|row| std::cmp::Reverse(row.construct.worst()));
    rows
}

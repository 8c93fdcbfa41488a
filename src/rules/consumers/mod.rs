//! What the programs that read URDF make of a robot: a table of constructs and outcomes, and what finds them.

mod bodies;
mod consumer;
mod control;
mod detect;
mod facts;
mod fix;
mod geometry;
mod inertia;
mod joints;
mod materials;
mod meshes;
mod met;
mod mimic;
mod names;
mod numbers;
mod other_mesh;
mod remedy;
mod rows;
mod table;
mod tree;
mod verdict;

use super::rule::Rule;

pub use consumer::{CONSUMERS, Consumer};
pub(super) use detect::tally;
pub use detect::{Tally, constructs, is_readable};
pub use met::Met;
pub use rows::{Row, rows};
pub use table::{CONSTRUCTS, Construct, Outcome};

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[&verdict::REJECTS, &verdict::CHANGES];

/// The rule that says that a program rejects or changes something.
pub fn rule_of(outcome: Outcome) -> &'static Rule {
    if outcome == Outcome::Rejects {
        &verdict::REJECTS
    } else {
        &verdict::CHANGES
    }
}

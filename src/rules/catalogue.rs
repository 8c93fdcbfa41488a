//! The list of all rules for programs.
use serde::Serialize;

use super::registry::all;
use super::rule::{Rule, Safety};

#[derive(Serialize)]
struct CatalogEntry {
    code: &'static str,
    name: &'static str,
    category: &'static str,
    severity: &'static str,
    default: String,
    since: &'static str,
    fix: Option<&'static str>,
    summary: String,
}

/// All rules as a JSON array.
pub fn catalogue() -> String {
    catalogue_of(all())
}

/// Rules as a JSON array.
pub fn catalogue_of(rules: impl Iterator<Item = &'static Rule>) -> String {
    let entries: Vec<CatalogEntry> = rules
        .map(|rule| CatalogEntry {
            code: rule.code,
            name: rule.name,
            category: rule.category.name(),
            severity: rule.severity.name(),
            default: rule.default.to_string(),
            since: rule.since,
            fix: rule.fix.map(Safety::name),
            summary: rule.summary().replace('\n', " "),
        })
        .collect();
    let text = serde_json::to_string_pretty(&entries).unwrap_or_default();
    format!("{text}\n")
}

//! The numbers of rules that `thresholds.*` of the configuration can change.

use crate::workspace::config::Config;

/// A number of a rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    /// Its name in the configuration; the unit is in the name.
    pub name: &'static str,
    /// The rule it belongs to, by name.
    pub rule: &'static str,
    /// Its value when nothing is configured.
    pub default: f64,
    /// What it bounds.
    pub docs: &'static str,
}

/// All thresholds, by name.
pub static THRESHOLDS: &[Threshold] = &[];

impl Threshold {
    /// The value that holds under a configuration.
    pub fn value(&self, config: &Config) -> f64 {
        config.thresholds.get(self.name).copied().unwrap_or(self.default)
    }
}

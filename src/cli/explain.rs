//! `xacro-lint explain` and `xacro-lint rules`.

use super::args::Plain;
use super::io::Io;
use super::render::visible;
use crate::rules::{self, Rule};

/// Print the page of a rule; without one, the list of all.
pub(super) fn explain(rule: Option<&str>, io: &mut Io<'_>) -> u8 {
    let Some(selector) = rule else { return rules(Plain::Text, io) };
    let found = rules::find(selector).find(|rule| rule.name == selector || rule.code == selector);
    match found {
        Some(rule) => {
            io.out(rule.docs);
            0
        }
        None => {
            io.line(&format!("error: {}", visible(&rules::unknown_selector(selector))));
            2
        }
    }
}

/// Print all rules.
pub(super) fn rules(format: Plain, io: &mut Io<'_>) -> u8 {
    match format {
        Plain::Json => io.out(&rules::catalogue()),
        Plain::Text => {
            let width = rules::all().map(|rule| rule.name.len()).max().unwrap_or(0);
            for rule in rules::all() {
                let Rule { code, name, severity, .. } = rule;
                io.out(&format!("{code}  {name:width$}  {:7}  {}\n", severity.name(), rule.default));
            }
        }
    }
    0
}

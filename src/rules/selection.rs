//! Which rules run, and how bad their findings are.
use super::finding::Finding;
use super::registry::all;
use super::rule::{Activation, Rule, Severity};
use base::{FastMap, FastSet};

/// What was configured; lists hold codes, beginnings of codes, or names.
#[derive(Clone, Debug, Default)]
pub struct SelectionOptions {
    /// These rules instead of the default ones.
    pub select: Option<Vec<String>>,
    /// These rules in addition.
    pub extend_select: Vec<String>,
    /// Not these rules.
    pub ignore: Vec<String>,
    /// Switch on the rules of these profiles.
    pub profiles: Vec<String>,
    /// What of `select` and `extend_select` was said on the command line: it wins over what a configuration leaves out.
    pub commanded: Vec<String>,
    /// Whether `ignore` was said there too.
    pub ignore_is_commanded: bool,
    /// Another severity; none switches off.
    pub severity: Vec<(String, Option<Severity>)>,
}

/// The rules that run.
#[derive(Clone, Debug)]
pub struct RuleSelection {
    /// By code: the configured severity of the rules that run.
    rules: FastMap<&'static str, Option<Severity>>,
    /// The codes of those that were asked for.
    named: FastSet<&'static str>,
}

impl RuleSelection {
    /// The rules that options choose. Selectors that mean no rule have no effect.
    ///
    /// As in ruff, the longer of two selectors for one rule wins, a name counting as longest: `--select STR
    /// --ignore STR008` and `--ignore STR --select orphan-link` both do what they say.
    pub fn new(options: &SelectionOptions) -> Self {
        let mut rules = FastMap::with_capacity_and_hasher(all().count(), Default::default());
        rules.extend(all().filter_map(|rule| Some((rule.code, setting(rule, options)?))));
        let is_named = |rule: &&Rule| {
            let selectors = options.select.iter().flatten();
            let mut selectors = selectors.chain(&options.extend_select);
            selectors.any(|selector| weight(rule, selector).is_some())
        };
        let named = all().filter(is_named).map(|rule| rule.code).collect();
        Self { rules, named }
    }

    /// Whether a rule was asked for, by whatever selector.
    pub fn names(&self, rule: &Rule) -> bool {
        self.named.contains(rule.code)
    }

    /// The severity of a finding as configured; none when its rule does not run.
    pub fn severity(&self, finding: &Finding) -> Option<Severity> {
        self.rules
            .get(finding.rule.code)
            .map(|configured| configured.unwrap_or(finding.severity))
    }

    /// Whether a rule runs.
    #[inline]
    pub fn runs(&self, rule: &Rule) -> bool {
        self.rules.contains_key(rule.code)
    }
}

/// None: the rule does not run; else its severity, where one is configured.
fn setting(rule: &Rule, options: &SelectionOptions) -> Option<Option<Severity>> {
    let by_default = match (&options.select, rule.default) {
        (Some(_), _) | (None, Activation::Off) => false,
        (None, Activation::On) => true,
        (None, Activation::Profiles(profiles)) => profiles
            .iter()
            .any(|p| options.profiles.iter().any(|o| o == p)),
    };
    let select = options
        .select
        .iter()
        .flatten()
        .chain(&options.extend_select);
    let on = select.filter_map(|selector| weight(rule, selector)).max();
    let is_commanded = options
        .commanded
        .iter()
        .any(|selector| weight(rule, selector).is_some());
    let off = options
        .ignore
        .iter()
        .filter_map(|selector| weight(rule, selector))
        .max();
    let off = off.filter(|_| !is_commanded || options.ignore_is_commanded);
    let runs = match (on, off) {
        (Some(on), Some(off)) => on > off,
        (Some(_), None) => true,
        (None, Some(_)) => false,
        (None, None) => by_default,
    };
    let overrides = options
        .severity
        .iter()
        .filter(|(selector, _)| rule.is_named(selector));
    let configured = overrides
        .max_by_key(|(selector, _)| weight(rule, selector))
        .map(|(_, severity)| *severity);
    match configured {
        _ if !runs => None,
        Some(None) => is_commanded.then_some(None),
        Some(severity) => Some(severity),
        None => Some(None),
    }
}

/// How exactly a selector means a rule; none when it does not.
fn weight(rule: &Rule, selector: &str) -> Option<usize> {
    if selector == "ALL" {
        return Some(0);
    }
    rule.is_named(selector).then(|| {
        if selector == rule.name {
            6
        } else {
            selector.len()
        }
    })
}

#[cfg(test)]
mod tests {
    use super::super::registry::by_code;
    use super::super::rule::Severity;
    use super::{RuleSelection, SelectionOptions};

    fn list(text: &str) -> Vec<String> {
        text.split_whitespace().map(str::to_owned).collect()
    }

    /// Whether a rule runs, by code.
    #[inline]
    fn runs(options: &SelectionOptions, code: &str) -> bool {
        RuleSelection::new(options).runs(by_code(code).unwrap())
    }

    #[test]
    fn longer_selectors_win() {
        for (select, ignore, code, expected) in [
            ("", "", "STR008", true),
            ("", "STR", "STR008", false),
            ("", "orphan-link", "STR008", false),
            ("", "orphan-link", "STR007", true),
            ("STR", "STR008", "STR008", false),
            ("STR", "STR008", "STR007", true),
            ("orphan-link", "STR", "STR008", true),
            ("STR008", "ALL", "STR008", true),
            ("XAC", "", "STR008", false),
            ("ALL", "", "STR008", true),
            ("STR00", "", "STR008", true),
            ("ST", "", "STR008", false),
        ] {
            let select = (!select.is_empty()).then(|| list(select));
            let options = SelectionOptions {
                select,
                ignore: list(ignore),
                ..SelectionOptions::default()
            };
            assert_eq!(runs(&options, code), expected, "{options:?} {code}");
        }
    }

    #[test]
    fn the_command_line_wins() {
        let configured = SelectionOptions {
            select: Some(list("orphan-link no-links")),
            ignore: list("STR"),
            severity: vec![("no-links".to_owned(), None)],
            ..SelectionOptions::default()
        };
        let no_links = "STR009";
        assert_eq!(
            [runs(&configured, "STR008"), runs(&configured, no_links)],
            [true, false],
            "in a configuration alone, the more exact selector wins, and a severity of none always does"
        );
        let ignored = SelectionOptions {
            select: Some(list("STR")),
            ..configured
        };
        assert!(!runs(&ignored, "STR008"));
        let commanded = SelectionOptions {
            commanded: list("STR"),
            ..ignored
        };
        assert!(runs(&commanded, "STR008") && runs(&commanded, no_links));
        assert!(!runs(
            &SelectionOptions {
                ignore_is_commanded: true,
                ..commanded
            },
            "STR008"
        ));
    }

    #[test]
    fn configured_severity() {
        let severity = vec![
            ("STR".to_owned(), Some(Severity::Info)),
            ("orphan-link".to_owned(), Some(Severity::Warning)),
            ("no-links".to_owned(), None),
        ];
        let selection = RuleSelection::new(&SelectionOptions {
            severity,
            ..SelectionOptions::default()
        });
        let of = |code| selection.rules.get(code).copied();
        assert_eq!(of("STR008"), Some(Some(Severity::Warning)));
        assert_eq!(of("STR007"), Some(Some(Severity::Info)));
        assert_eq!(of("STR009"), None);
        assert_eq!(of("XAC001"), Some(None));
    }
}

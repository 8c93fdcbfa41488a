//! Which rules run, and how bad their findings are.

use super::finding::Finding;
use super::registry::{Activation, Rule, Severity, all, find};
use crate::base::FastMap;

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
    /// Another severity; none switches off.
    pub severity: Vec<(String, Option<Severity>)>,
}

/// The rules that run.
#[derive(Clone, Debug)]
pub struct Selection {
    /// By code: the configured severity of the rules that run.
    rules: FastMap<&'static str, Option<Severity>>,
}

/// A selector that means no rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownSelector(pub String);

impl Selection {
    /// The rules that options choose; and the selectors that mean nothing.
    ///
    /// As in ruff, the longer of two selectors for one rule wins, a name counting as longest: `--select STR
    /// --ignore STR008` and `--ignore STR --select orphan-link` both do what they say.
    pub fn new(options: &SelectionOptions) -> (Self, Vec<UnknownSelector>) {
        let rules = all().filter_map(|rule| Some((rule.code, setting(rule, options)?))).collect();
        let lists = [options.select.as_deref().unwrap_or(&[]), &options.extend_select, &options.ignore];
        let selectors =
            lists.into_iter().flatten().chain(options.severity.iter().map(|(selector, _)| selector));
        let unknown = selectors.filter(|s| *s != "ALL" && find(s).next().is_none());
        let unknown = unknown.map(|selector| UnknownSelector(selector.clone())).collect();
        (Self { rules }, unknown)
    }

    /// The severity of a finding as configured; none when its rule does not run.
    pub fn severity(&self, finding: &Finding) -> Option<Severity> {
        self.rules.get(finding.rule.code).map(|configured| configured.unwrap_or(finding.severity))
    }

    /// Whether a rule runs.
    pub fn runs(&self, rule: &Rule) -> bool {
        self.rules.contains_key(rule.code)
    }
}

/// None: the rule does not run; else its severity, where one is configured.
fn setting(rule: &Rule, options: &SelectionOptions) -> Option<Option<Severity>> {
    let by_default = match (&options.select, rule.default) {
        (Some(_), _) | (None, Activation::Off) => false,
        (None, Activation::On) => true,
        (None, Activation::Profiles(profiles)) => {
            profiles.iter().any(|p| options.profiles.iter().any(|o| o == p))
        }
    };
    let select = options.select.iter().flatten().chain(&options.extend_select);
    let on = select.filter_map(|selector| weight(rule, selector)).max();
    let off = options.ignore.iter().filter_map(|selector| weight(rule, selector)).max();
    let runs = match (on, off) {
        (Some(on), Some(off)) => on > off,
        (Some(_), None) => true,
        (None, Some(_)) => false,
        (None, None) => by_default,
    };
    let overrides = options.severity.iter().filter(|(selector, _)| rule.is_named(selector));
    let configured =
        overrides.max_by_key(|(selector, _)| weight(rule, selector)).map(|(_, severity)| *severity);
    match configured {
        _ if !runs => None,
        Some(None) => None,
        Some(severity) => Some(severity),
        None => Some(None),
    }
}

/// How exactly a selector means a rule; none when it does not.
fn weight(rule: &Rule, selector: &str) -> Option<usize> {
    if selector == "ALL" {
        return Some(0);
    }
    rule.is_named(selector).then(|| if selector == rule.name { 6 } else { selector.len() })
}

impl std::fmt::Display for UnknownSelector {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "`{}` is no rule", self.0)?;
        match super::nearest_selector(&self.0) {
            Some(near) => write!(f, "; a similar one is `{near}`"),
            None => write!(f, "; `xacro-lint rules` lists them"),
        }
    }
}

//! Many expansions, one list of findings.
use super::contexts::{ContextRun, Contexts};
use super::root_result::RootResult;
use base::{FastMap, Span};
use rules::{Finding, Severity, Trait, named};

/// A finding, and where it occurred.
struct Merged {
    finding: Finding,
    /// Numbers of the results that have it.
    results: Vec<usize>,
    /// The same for each call of the finding, once there are several results.
    by_call_site: Vec<Vec<usize>>,
}

/// All findings; one that several expansions have is kept once, with the places of all of them.
pub(super) fn merge(results: Vec<RootResult>) -> Vec<Finding> {
    let mut merged: Vec<Merged> = Vec::new();
    let mut by_place: FastMap<(&'static str, Span), Vec<usize>> = FastMap::default();
    let mut runs: Vec<ContextRun> = Vec::new();
    for (number, result) in results.into_iter().enumerate() {
        runs.push(ContextRun::of(&result));
        for finding in result.findings {
            let places = by_place
                .entry((finding.rule.code, finding.span))
                .or_default();
            let same = |&&i: &&usize| {
                merged
                    .get(i)
                    .is_some_and(|old| old.admits(&finding, number))
            };
            match places.iter().find(same).and_then(|&i| merged.get_mut(i)) {
                Some(old) => old.add(finding, number),
                None => {
                    places.push(merged.len());
                    merged.push(Merged::new(finding, number));
                }
            }
        }
    }
    let contexts = Contexts::of(runs);
    merged
        .into_iter()
        .filter_map(|merged| merged.finish(&contexts))
        .collect()
}

impl Merged {
    fn new(finding: Finding, number: usize) -> Self {
        Self {
            finding,
            results: vec![number],
            by_call_site: Vec::new(),
        }
    }

    /// Whether a finding at the same place is the same: two expansions may word one defect differently, one
    /// expansion says different things at one place only when they are different.
    fn admits(&self, finding: &Finding, number: usize) -> bool {
        self.finding.message == finding.message || !self.results.contains(&number)
    }

    fn add(&mut self, finding: Finding, number: usize) {
        const MOST_RELATED: usize = 12;
        let (calls, first) = (self.finding.call_sites.len(), self.results.clone());
        self.by_call_site.resize(calls, first);
        self.results.push(number);
        self.finding.severity = self.finding.severity.max(finding.severity);
        self.finding.partial |= finding.partial;
        for call_site in finding.call_sites {
            match self
                .finding
                .call_sites
                .iter()
                .position(|known| known.call == call_site.call)
            {
                Some(known) => self
                    .by_call_site
                    .get_mut(known)
                    .into_iter()
                    .for_each(|own| own.push(number)),
                None => {
                    self.finding.call_sites.push(call_site);
                    self.by_call_site.push(vec![number]);
                }
            }
        }
        for related in finding.related {
            if !self.finding.related.contains(&related) && self.finding.related.len() < MOST_RELATED
            {
                self.finding.related.push(related);
            }
        }
    }

    /// Say in which contexts the finding occurs, when not in all of them. What is unused in some of them only is not
    /// unused.
    fn finish(mut self, contexts: &Contexts) -> Option<Finding> {
        if self.finding.rule == named::GAZEBO_UNKNOWN_REFERENCE
            && (contexts.other_robots(self.finding.span.file, &self.results) > 0
                || contexts.is_in_some_calls(&self.results))
        {
            // a shared file is written for the robot that has the link, or for the call that asks for it
            self.finding.severity = self.finding.severity.min(Severity::Info);
        }
        if self.finding.rule == named::TRANSMISSION_UNKNOWN_JOINT {
            // a shared file lists the joints of the largest robot; what a smaller one lacks, ROS 1 passes over
            let most = match contexts.other_robots(self.finding.span.file, &self.results) {
                0 => Severity::Error,
                1 => Severity::Warning,
                _ => Severity::Info,
            };
            self.finding.severity = self.finding.severity.min(most);
        }
        // a name that is misspelled is wrong, whoever gives another value
        if self.finding.fix.is_none() && contexts.is_in_no_call(&self.results) {
            self.finding.severity = self.finding.severity.min(Severity::Info);
        }
        let has = |number: &usize| self.results.contains(number);
        if self.finding.rule.has(Trait::Unnecessary)
            && !contexts
                .of_called(self.finding.span.file, &self.results)
                .iter()
                .all(has)
        {
            return None;
        }
        if let Some(suffix) = contexts.calls(&self.results) {
            self.finding.message.push_str(&suffix);
            self.finding
                .related
                .extend(contexts.call_places(&self.results));
            return Some(self.finding);
        }
        let possible = contexts.that_read(self.finding.span.file, &self.results);
        if possible.iter().all(has) {
            // what holds in all contexts may still blame a call that only some of them make
            return Some(self.finding);
        }
        if self.finding.rule.has(Trait::Unnecessary) {
            return None;
        }
        let call_sites = self.finding.call_sites.make_mut().iter_mut();
        for (number, call_site) in call_sites.enumerate() {
            let own = self.by_call_site.get(number).unwrap_or(&self.results);
            call_site.message.push_str(&contexts.suffix(own));
        }
        self.finding
            .message
            .push_str(&contexts.suffix(&self.results));
        self.finding.related.extend(contexts.places(&self.results));
        Some(self.finding)
    }
}
